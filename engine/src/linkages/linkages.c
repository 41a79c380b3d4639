/* linkages.c: what joints hold in islands that are left to the soft solver, because they are too
 * dear for the quality or something in them bounces. Where joints give way there, the bodies that
 * they tie are solved directly by themselves. Contacts give them what the soft solver has made of
 * them, and more where they would close further than it has them, beside bodies that move as it has
 * them: what lies on a bridge does not sink through it as its joints close. Where both cannot be,
 * the soft solver's result stands. That is for machines among a heap: in the thick of one contacts
 * rule, and do not answer. */
#include "linkages/joint_islands.h"

#include "constraint/constraint.h"
#include "islands/island_order.h"

/* Matrices that a linkage may take whatever else the step has taken; island_joints.c doubles it.
 * With a third of them the wrecking ball's chain opens by over 10 mm as the ball meets the wall. */
enum { PATIENCE = 32 };
/* A linkage that could not be solved n times in succession is tried in one of 2^n steps, and in one
 * of 2^REST at least. */
enum { REST = 5 };
/* Where more joints than this give way they are a crowd, which this would cost much and mend
 * little. */
enum { FEW = 64 };
/* At least one in so many of a linkage's joints gives way. */
enum { WEAK = 2 };
/* The value of td_islands.local where a linkage is left as it is. */
enum { UNFIT = -5 };

bool td_linkages_may_come(const thud_world *w) {
    const uint8_t *direct_steps = w->direct_steps.data;
    const uint16_t *slow_steps = w->slow_steps.data;
    int any = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        any |= (direct_steps[slot.at] > TD_DIRECT_COOLDOWN) | TD_SLOW_LEFT(slow_steps[slot.at]);
    }
    return any != 0;
}

/* ---- which ---- */

/* Failures are counted where an island that is left alone needs no count: td_slow_steps_at. */
static bool rests(const thud_world *w, td_awake_slot slot) {
    int failures = *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN
                       ? *td_slow_steps_at(w, slot) % TD_SLOW_ONCE
                       : 0;
    return w->steps % (1ull << td_min_int(failures, REST)) != 0;
}

static void note_outcome(thud_world *w, const td_island *linkage, bool solved) {
    for (int i = 0; i < linkage->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, i);
        if (*td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN) {
            uint16_t *slow_steps = td_slow_steps_at(w, slot);
            int failures = *slow_steps % TD_SLOW_ONCE, left = *slow_steps - failures;
            *slow_steps = (uint16_t)(left + (solved ? 0 : td_min_int(failures + 1, REST)));
        }
    }
}

static bool is_soft(const thud_world *w, td_awake_slot slot) {
    int local = *td_island_local_at(w, slot);
    bool left = *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN && local != UNFIT;
    return td_row(&w->velocity, slot)[3] > 0.0f && local <= 0 && (left || local == TD_ISLAND_SOFT);
}

static bool gives_way(const thud_world *w, const td_block *block, int lane, int kind) {
    td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
    float size = td_islands_size(w, a, b), off = 0.0f;
    float load = w->kinds[kind]->lanes->load(w, block, lane, size, &off);
    return load > td_islands_most(w, size);
}

/* Adds the joints of a body, and whom they bring; counts its contacts with others that move, and
 * joints that give way. False: the linkage is too large. */
static bool spread(thud_world *w, td_island *linkage, td_awake_slot slot, int *contacts,
                   int *weak) {
    td_body_index body = td_body_of(w, slot);
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, e / 2);
        if (constraint->state != TD_TOUCHING) {
            continue;
        }
        td_awake_slot other = td_island_neighbour(w, constraint, e & 1);
        if (td_is_contact(constraint)) {
            *contacts += other.at > 0;
            continue;
        }
        if (other.at && *td_island_local_at(w, other) == UNFIT) {
            return false;
        }
        if (other.at && *td_island_local_at(w, other) <= 0) {
            td_island_add(w, linkage, other);
        }
        if (!other.at || !(e & 1)) {
            td_lane at = td_lane_of(w, constraint);
            td_push_int(&w->islands.constraints, e / 2);
            linkage->constraints++;
            *weak += gives_way(w, at.block, at.lane, constraint->kind);
        }
    }
    return linkage->bodies <= TD_LATE_BODIES && linkage->constraints <= TD_LATE_CONSTRAINTS;
}

/* False: it is too large, in the thick of a heap, or gives way in few places, which is nothing that
 * the soft solver will not mend. */
static bool follow(thud_world *w, td_awake_slot seed, td_island *linkage) {
    td_islands *s = &w->islands;
    bool whole = true;
    int contacts = 0, weak = 0;
    s->slots.count = s->constraints.count = 0;
    *linkage = (td_island){0};
    td_island_add(w, linkage, seed);
    for (int i = 0; whole && i < s->slots.count; i++) {
        whole = spread(w, linkage, td_slot_in(&s->slots, i), &contacts, &weak);
    }
    whole = whole && contacts <= linkage->bodies && WEAK * weak >= linkage->constraints;
    for (int i = 0; !whole && i < s->slots.count; i++) {
        *td_island_local_at(w, td_slot_in(&s->slots, i)) = UNFIT;
    }
    return whole;
}

/* ---- what contacts give ---- */

/* An impulse along (x, y), half of which is there by the middle of the step. */
static void give(td_direct_body *b, double x, double y, double cross, double impulse) {
    b->free[0] += 0.5 * b->inverse_mass * x * impulse;
    b->free[1] += 0.5 * b->inverse_mass * y * impulse;
    b->free[2] += 0.5 * b->inverse_inertia * cross * impulse;
}

static void give_contact(td_direct_body *b, td_awake_slot slot, td_lane at, int points) {
    td_block *block = at.block;
    bool first = td_slot_of_side(block->a[at.lane]).at == slot.at;
    double sign = first ? -1.0 : 1.0;
    double x = sign * (double)block->nx[at.lane], y = sign * (double)block->ny[at.lane];
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        double cross = sign * (double)(first ? p->cross_a[at.lane] : p->cross_b[at.lane]);
        bool acts = p->normal_mass[at.lane] > 0.0f;
        double impulse = (double)td_history_of(block, points)[k].total[at.lane];
        give(b, x, y, cross, acts ? impulse : 0.0);
    }
    double cross =
        sign * (double)(first ? block->tangent_cross_a : block->tangent_cross_b)[at.lane];
    bool rubs = block->friction[at.lane] > 0.0f;
    double impulse = (double)td_surface_at(block, points)->total[at.lane];
    give(b, y, -x, cross, rubs ? impulse : 0.0);
}

/* Lists the contacts of a linkage behind its joints, each once. False: there are too many. */
static bool list_contacts(thud_world *w, td_island *linkage) {
    for (int i = 0; i < linkage->bodies; i++) {
        td_body_index body = td_body_of(w, td_slot_in(&w->islands.slots, i));
        for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, e / 2);
            td_awake_slot other = td_island_neighbour(w, constraint, e & 1);
            bool first = !(e & 1) || !other.at || td_island_number(w, linkage, other) == TD_NONE;
            if (constraint->state == TD_TOUCHING && td_is_contact(constraint) && first) {
                if (linkage->constraints == TD_LATE_CONSTRAINTS) {
                    return false;
                }
                td_push_int(&w->islands.constraints, e / 2);
                linkage->constraints++;
            }
        }
    }
    return true;
}

/* Contacts are given their impulses; what they may give on top keeps them from closing further than
 * the soft solver has them, beside bodies that move as that has it. */
static void keep_contacts(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        if (!td_is_contact(td_constraint_at(work->w, work->constraints[i]))) {
            continue;
        }
        td_lane at = td_island_lane(work, i);
        c->keeps = true;
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            double gap = (double)at.block->point[k].base[at.lane];
            c->row[k].impulse = 0.0;
            c->row[k].wanted = gap > 0.0 ? -gap / work->time : 0.0;
        }
        c->row[TD_DIRECT_TANGENT].used = false;
    }
}

static void give_contacts(td_island_work *work) {
    const thud_world *w = work->w;
    for (int i = 0; i < work->island->bodies; i++) {
        td_awake_slot slot = work->slots[i];
        int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, e / 2);
            if (constraint->state == TD_TOUCHING && td_is_contact(constraint)) {
                give_contact(&work->problem.bodies[i], slot, td_lane_of(w, constraint),
                             td_island_points(w, constraint));
            }
        }
    }
}

/* ---- how ---- */

static double energy_of(const td_direct_body *b, const double v[3]) {
    double turning = b->own_inverse_inertia > 0.0 ? v[2] * v[2] / b->own_inverse_inertia : 0.0;
    return (v[0] * v[0] + v[1] * v[1]) / b->inverse_mass + turning;
}

/* What contacts give does not answer to what joints do here. Where that adds up to more energy than
 * there was before and than the soft solver has left, but for gaps that close, it would do so again
 * and again. */
static bool gains(const td_island_work *work, double pushed) {
    double before = 0.0, soft = 0.0, after = 0.0, mass = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        const float *v = td_row(&work->w->velocity, work->slots[i]);
        const float *start = td_row(&work->w->islands.start, work->slots[i]);
        before += energy_of(b, (double[]){(double)start[0], (double)start[1], (double)start[2]});
        soft += energy_of(b, (double[]){(double)v[0], (double)v[1], (double)v[2]});
        after += energy_of(b, b->velocity);
        mass += 1.0 / b->inverse_mass;
    }
    return after > td_max_double(before, soft) + mass * pushed * pushed;
}

/* The joints' own impulses stay the soft solver's, which goes on from them. */
static void solve_one(thud_world *w, td_awake_slot seed) {
    td_island linkage;
    bool counted = *td_island_local_at(w, seed) == TD_ISLAND_SOFT; /* among those that were tried */
    if (!follow(w, seed, &linkage) || !list_contacts(w, &linkage) ||
        !td_joint_island_begin(w, &linkage)) {
        return;
    }
    td_island_work work = td_island_take(w, &linkage);
    work.problem.patience = PATIENCE;
    double pushed = work.pushed + work.problem.unit_speed;
    give_contacts(&work);
    keep_contacts(&work);
    bool solved = td_island_work_out(&work) && !gains(&work, pushed);
    note_outcome(w, &linkage, solved);
    if (solved) {
        td_island_write_bodies(&work);
        w->stats.direct_islands++;
        w->stats.direct_bodies += counted ? 0 : linkage.bodies;
    }
}

/* Lists the bodies by which joints give way; false where there are more than FEW. */
static bool list_seeds(thud_world *w, td_awake_slot *seeds, int *count) {
    *count = 0;
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int kind = block->used ? td_constraint_at(w, block->constraint[0])->kind : 0;
        for (int lane = 0; kind >= TD_PAIR_COUNT && lane < block->used; lane++) {
            td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
            td_awake_slot seed = is_soft(w, a) ? a : b;
            if (is_soft(w, seed) && gives_way(w, block, lane, kind)) {
                if (*count == FEW) {
                    return false;
                }
                seeds[(*count)++] = seed;
            }
        }
    }
    return true;
}

void td_linkages_solve(thud_world *w, td_system last) {
    td_islands *s = &w->islands;
    int rows = s->matrix.row.count, count = 0;
    td_awake_slot seeds[FEW];
    bool few = list_seeds(w, seeds, &count);
    for (int i = 0; few && i < count; i++) {
        if (is_soft(w, seeds[i]) && !rests(w, seeds[i])) {
            s->matrix.now = last;
            solve_one(w, seeds[i]);
            s->matrix.row.count = rows;
        }
    }
}
