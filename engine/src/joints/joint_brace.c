/* joint_brace.c: joints that are torn must not tear further.
 *
 * The solver begins with the impulses of the substep before. One pass over the rows corrects little
 * of what all rows of a mechanism share where it is stiff against them one by one: long arms, loops
 * that have to fold. There these impulses swing, grow as directions turn, and add energy without
 * end. Each row's own correction takes energy out; the warm start can bring it in, and so can the
 * bias that closes gaps, which one relax pass takes back in part.
 *
 * For impulses p of all the locks of a ring (constraint/tied_bodies.h) and relative speeds u that
 * they act on, with u' after them, the energy that they bring is p.(u + u') / 2. The share s of
 * them brings E(s) = s p.u + s^2 p.(u' - u) / 2. Where a warm start would bring more than nothing,
 * the share is kept that brings least, s = -p.u / p.(u' - u) within 0 .. 1, and gaps of such a ring
 * close at TD_JOINT_CLOSING for the rest of the step, since a bias in many rows that hardly move
 * would add as much.
 *
 * After the relax pass p is all that the locks gave in the substep. A ring that gapes keeps the
 * greatest share of it that brings nothing, s = -2 p.u / p.(u' - u); what rows then miss another
 * relax pass corrects, contacts too. Other rings may bring energy then: their gaps are springs,
 * which give back what opened them.
 *
 * Steps that begin with no joint torn do without all this. */
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "constraint/tied_bodies.h"
#include "joints/joint.h"

#include <string.h>

/* What is known of a ring, in scratch.powers: p.u, p.u', and 1 where it gapes. */
enum { BEFORE, AFTER, GAPES };

static double *ring_at(const thud_world *w, float number) {
    return (double *)w->scratch.powers.data + 3 * (size_t)number;
}

/* Calls for the blocks of what joints lock; whether any call returned true. */
static bool walk(thud_world *w, bool (*visit)(thud_world *w, td_block *block)) {
    bool any = false;
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int kind = block->used ? td_constraint_at(w, block->constraint[0])->kind : 0;
        if (kind == TD_CONSTRAINT_ROD || kind == TD_CONSTRAINT_LOCK) {
            any |= visit(w, block);
        }
    }
    return any;
}

/* Lanes know their ring by its number, a float. */
static float *rings_of(td_block *block) {
    return (float *)&td_history_of(block, 2)[0].approach;
}

/* 1 where all lanes have the same one. */
static float *same_ring(td_block *block) {
    return (float *)&td_history_of(block, 2)[1].approach;
}

/* Rings get their numbers as lanes ask for them; scratch.parents has -1 minus the number. */
static float number_of(thud_world *w, td_awake_slot slot) {
    td_awake_slot *number = w->scratch.parents.data;
    if (number[slot.at].at >= 0) {
        td_awake_slot applied = {-1 - w->scratch.powers.count++};
        for (td_awake_slot i = slot; number[i.at].at >= 0; i = td_next_tied(w, i)) {
            number[i.at] = applied;
        }
        ring_at(w, (float)(-1 - applied.at))[GAPES] = 0.0;
    }
    return (float)(-1 - number[slot.at].at);
}

/* The lane is open by more than even haste closes in a substep: what it pulls with grows no more
 * with its gap. */
static bool gapes(const thud_world *w, td_block *block, int lane) {
    float most =
        TD_JOINT_HASTE * TD_JOINT_CLOSING / TD_JOINT_PULL * (float)(w->def.time_step / w->substeps);
    bool rod = td_constraint_at(w, block->constraint[0])->kind == TD_CONSTRAINT_ROD;
    bool turns = !rod && block->tangent_mass[lane] > 0.0f;
    float gap = td_max_float(td_joint_size(block->point[0].base[lane]),
                             rod ? 0.0f : td_joint_size(block->point[1].separation[lane]));
    float turn = turns ? td_joint_size(td_lock_rows_of(block)->turn_base[lane]) : 0.0f;
    return gap > most * w->unit || turn > most;
}

/* By the dynamic side of each lane. */
static bool number_lanes(thud_world *w, td_block *block) {
    float *ring = rings_of(block);
    *same_ring(block) = 1.0f;
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        ring[lane] = number_of(w, td_row(&w->velocity, b)[3] > 0.0f ? b : a);
        *same_ring(block) = ring[lane] == ring[0] ? *same_ring(block) : 0.0f;
        if (gapes(w, block, lane)) {
            ring_at(w, ring[lane])[GAPES] = 1.0;
        }
    }
    return false;
}

/* Once a step, in its first substep, while gaps are those at its start. */
static void number_rings(thud_world *w) {
    td_awake_slot *number = w->scratch.parents.data;
    if (w->scratch.powers.count > 0) {
        return;
    }
    td_joints_tie(w);
    for (int i = 0; i < w->body_of.count; i++) {
        number[i] = (td_awake_slot){0};
    }
    walk(w, number_lanes);
}

/* Adds powers of a block's lanes to those of their rings. */
static void add_powers(const thud_world *w, td_block *block, int which) {
    const float *ring = rings_of(block);
    const float *power = (const float *)&td_history_of(block, 2)[which].total;
    if (*same_ring(block) > 0.0f) {
        double sum = 0.0;
        for (int lane = 0; lane < block->used; lane++) {
            sum += (double)power[lane];
        }
        ring_at(w, ring[0])[which] += sum;
        return;
    }
    for (int lane = 0; lane < block->used; lane++) {
        ring_at(w, ring[lane])[which] += (double)power[lane];
    }
}

static bool add_powers_before(thud_world *w, td_block *block) {
    add_powers(w, block, BEFORE);
    return false;
}

static bool add_powers_after(thud_world *w, td_block *block) {
    add_powers(w, block, AFTER);
    return false;
}

/* `most`: times the share that brings least, which brings nothing where it is 2. */
static float share_of(const double *ring, double most) {
    double share = -most * ring[BEFORE] / (ring[AFTER] - ring[BEFORE]);
    bool adds = ring[BEFORE] + ring[AFTER] > 0.0 && ring[AFTER] > ring[BEFORE];
    return !adds || share > 1.0 ? 1.0f : share > 0.0 ? (float)share : 0.0f;
}

static bool set_shares(thud_world *w, td_block *block, bool relaxed) {
    const float *ring = rings_of(block);
    float *share = (float *)&td_history_of(block, 2)[0].total;
    float *haste = (float *)&td_lock_rows_of(block)->haste;
    bool any = false;
    for (int lane = 0; lane < block->used; lane++) {
        const double *own = ring_at(w, ring[lane]);
        share[lane] = !relaxed ? share_of(own, 1.0) : own[GAPES] > 0.0 ? share_of(own, 2.0) : 1.0f;
        haste[lane] = share[lane] < 1.0f ? 1.0f : haste[lane];
        any |= share[lane] < 1.0f;
    }
    return any;
}

static bool set_first_shares(thud_world *w, td_block *block) {
    return set_shares(w, block, false);
}

static bool set_last_shares(thud_world *w, td_block *block) {
    return set_shares(w, block, true);
}

/* p.(u + u') is less than 2 p.u', since impulses do not slow down what they act along. */
bool td_joints_add_energy(thud_world *w, bool relaxed) {
    bool any = false;
    number_rings(w);
    for (int ring = 0; ring < w->scratch.powers.count; ring++) {
        ring_at(w, (float)ring)[BEFORE] = ring_at(w, (float)ring)[AFTER] = 0.0;
    }
    walk(w, add_powers_after);
    for (int ring = 0; ring < w->scratch.powers.count && !any; ring++) {
        const double *own = ring_at(w, (float)ring);
        any = own[AFTER] > 0.0 && (!relaxed || own[GAPES] > 0.0);
    }
    return any;
}

void td_joints_weigh(thud_world *w, bool relaxed) {
    walk(w, add_powers_before);
    walk(w, relaxed ? set_last_shares : set_first_shares);
}

bool td_joints_gape(const thud_world *w) {
    bool any = false;
    for (int ring = 0; ring < w->scratch.powers.count; ring++) {
        any |= ring_at(w, (float)ring)[GAPES] > 0.0;
    }
    return any;
}
