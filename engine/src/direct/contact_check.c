/* contact_check.c: compares the separations of contacts under two results, to first order. */
#include "direct/contact_check.h"

#include "constraint/constraint.h"
#include "direct/elimination_order.h"

/* The motion of a body in the step, from the soft solver's result or the direct one. A body outside
 * of the island has the soft solver's motion. */
static void motion_of(const td_island_work *work, td_awake_slot slot, bool soft, double out[3]) {
    int local = slot.at ? *td_island_local_at(work->w, slot) : 0;
    bool here =
        !soft && local > 0 && local <= work->island->bodies && work->slots[local - 1].at == slot.at;
    const float *delta = td_row(&work->w->delta, slot);
    for (int k = 0; k < 3; k++) {
        out[k] = here ? work->problem.bodies[local - 1].moved[k] : (double)delta[k];
    }
}

/* Whether one of the contact's points ends the step deeper than td_island_sinks allows. `slack` is
 * a length. */
static bool sinks_in(const td_island_work *work, td_lane at, int points, double slack) {
    const td_block *block = at.block;
    double x = (double)block->nx[at.lane], y = (double)block->ny[at.lane];
    double a[2][3], b[2][3];
    for (int soft = 0; soft < 2; soft++) {
        motion_of(work, td_slot_of_side(block->a[at.lane]), soft, a[soft]);
        motion_of(work, td_slot_of_side(block->b[at.lane]), soft, b[soft]);
    }
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        double gap[2], start = (double)p->start_separation[at.lane];
        for (int soft = 0; soft < 2; soft++) {
            gap[soft] = start + x * (b[soft][0] - a[soft][0]) + y * (b[soft][1] - a[soft][1]) +
                        (double)p->cross_b[at.lane] * b[soft][2] -
                        (double)p->cross_a[at.lane] * a[soft][2];
        }
        double min = td_min_double(0.0, td_min_double(start, gap[1]));
        if (p->normal_mass[at.lane] > 0.0f && !(gap[0] >= min - slack)) {
            return true;
        }
    }
    return false;
}

bool td_island_sinks(const td_island_work *work, double slack) {
    const thud_world *w = work->w;
    for (int i = 0; i < work->island->bodies; i++) {
        int e = td_body_at(w, td_body_of(w, work->slots[i]))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            if (constraint->state == TD_TOUCHING && td_is_contact(constraint) &&
                sinks_in(work, td_lane_of(w, constraint), td_island_points(w, constraint), slack)) {
                return true;
            }
        }
    }
    return false;
}
