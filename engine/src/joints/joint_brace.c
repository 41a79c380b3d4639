/* joint_brace.c: joints that are torn must not tear further.
 *
 * The solver begins with the impulses of the substep before. One pass over the rows corrects little
 * of what all rows of a mechanism share where it is stiff against them one by one: long arms, loops
 * that have to fold. There these impulses swing, grow as directions turn, and add energy without
 * end. Each row's own correction takes energy out; only the warm start can bring it in. For
 * impulses p of all the locks of a ring (constraint/rings.h) and relative speeds u that they act
 * on, with u' after them, it brings p.(u + u') / 2. Where that is more than nothing the share s of
 * p is kept that brings least: E(s) = s p.u + s^2 p.(u' - u) / 2 is least at s = -p.u / p.(u' - u),
 * within
 * 0 .. 1. The gaps of such a ring close at TD_JOINT_CLOSING for the rest of the step, since a bias
 * in many rows that hardly move would add as much. Steps that begin with no joint torn do without
 * all this, and so do substeps in which p.u' is not positive in any ring. */
#include "constraint/joining.h"
#include "constraint/lanes.h"
#include "constraint/rings.h"

static double *powers_at(const thud_world *w, td_awake_slot slot) {
    return (double *)w->scratch.powers.data + (size_t)2 * (size_t)slot.at;
}

/* scratch.parents gets the first slot of the ring of each. */
static void name_rings(thud_world *w) {
    td_awake_slot *name = w->scratch.parents.data;
    td_joints_ring(w);
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        powers_at(w, slot)[0] = powers_at(w, slot)[1] = 0.0;
        name[slot.at] = (td_awake_slot){TD_NONE};
    }
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        for (td_awake_slot i = slot; name[i.at].at == TD_NONE; i = td_next_tied(w, i)) {
            name[i.at] = slot;
        }
    }
}

/* Of the ring of a lane's dynamic side. */
static double *powers_of(const thud_world *w, const td_block *block, int lane) {
    const td_awake_slot *name = w->scratch.parents.data;
    td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
    return powers_at(w, name[(td_row(&w->velocity, b)[3] > 0.0f ? b : a).at]);
}

static void add_powers_before(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        powers_of(w, block, lane)[0] += (double)block->point[0].separation[lane];
    }
}

static void add_powers_after(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        powers_of(w, block, lane)[1] += (double)block->point[1].separation[lane];
    }
}

static float share_of(const double power[2]) {
    double share = -power[0] / (power[1] - power[0]);
    bool adds = power[0] + power[1] > 0.0 && power[1] > power[0];
    return !adds || share > 1.0 ? 1.0f : share > 0.0 ? (float)share : 0.0f;
}

static void set_shares(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        float share = share_of(powers_of(w, block, lane));
        block->point[0].separation[lane] = share;
        td_hold_rows_of(block)->haste[lane] = share < 1.0f ? 1.0f : TD_JOINT_HASTE;
    }
}

static void walk(thud_world *w, void (*visit)(const thud_world *w, td_block *block)) {
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int kind = block->used ? td_constraint_at(w, block->constraint[0])->kind : 0;
        if (kind == TD_CONSTRAINT_ROD || kind == TD_CONSTRAINT_HOLD) {
            visit(w, block);
        }
    }
}

/* p.(u + u') is less than 2 p.u', since impulses do not slow down what they act along. */
bool td_joints_add_energy(thud_world *w) {
    bool any = false;
    name_rings(w);
    walk(w, add_powers_after);
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count && !any; slot.at++) {
        any = powers_at(w, slot)[1] > 0.0;
    }
    return any;
}

void td_joints_weigh(thud_world *w) {
    walk(w, add_powers_before);
    walk(w, set_shares);
}
