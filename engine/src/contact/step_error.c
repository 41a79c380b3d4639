/* step_error.c: the error statistics of a step (solver/error.h) where detection changed motions
 * after the solver. The separations that the solver has stored are then out of date, and contact
 * points are counted anew when a caller reads the statistics. */
#include "solver/error.h"

#include "constraint/lanes.h"
#include "geometry/shape_instance.h"
#include "state/kinds.h"
#include "state/shape.h"

/* The separation of a contact point after the step's motions, to first order, with normal n and
 * lever arms of the start of the step:
 *
 *     separation = start_separation + n . (d_b - d_a) + turn_b (r_b x n) - turn_a (r_a x n) */
static float separation_by_rows(const thud_world *w, const td_lane *at, int point) {
    const td_block *block = at->block;
    const td_point *p = &block->point[point];
    const float *a = td_row(&w->delta, td_slot_of_side(block->a[at->lane]));
    const float *b = td_row(&w->delta, td_slot_of_side(block->b[at->lane]));
    return p->start_separation[at->lane] + (b[0] - a[0]) * block->nx[at->lane] +
           (b[1] - a[1]) * block->ny[at->lane] + b[2] * p->cross_b[at->lane] -
           a[2] * p->cross_a[at->lane];
}

/* The exact distance of a contact's shapes, for a point that overlaps to first order: its shapes
 * may have slid off each other's faces since. `known`, the first-order separation from surface to
 * surface, is returned where a terrain does overlap, which has no exact depth here. */
static float exact_distance(const thud_world *w, const td_constraint *contact, float known) {
    td_position origin = td_shape_proxy_at(w, contact->shape_a)->center;
    thud_geometry shape = td_shape_instance(w, contact->shape_b, origin);
    thud_closest closest;
    if (td_kind_is_line(td_shape_at(w, contact->shape_a)->kind)) {
        return w->ground->overlap(w, contact->shape_a, &shape) ? known : 0.0f;
    }
    thud_geometry other = td_shape_instance(w, contact->shape_a, origin);
    td_closest(&other, &shape, &closest);
    return (float)closest.distance;
}

float td_errors_separation(const thud_world *w, const td_constraint *contact, int point) {
    td_lane at = td_lane_of(w, contact);
    const td_block *block = at.block;
    /* No side has an awake slot: both bodies sleep, or one sleeps and the other is static. */
    if (block->a[at.lane] + block->b[at.lane] == 0) {
        return block->point[point].separation[at.lane];
    }
    float separation = separation_by_rows(w, &at, point);
    if (separation + w->skin < 0.0f) {
        float known = separation + w->skin;
        separation = td_max_float(known, exact_distance(w, contact, known)) - w->skin;
    }
    return separation;
}

/* Whether one of the bodies is awake. */
static bool is_awake(const thud_world *w, const td_constraint *contact) {
    return td_body_at(w, contact->body[0])->awake.at > 0 ||
           td_body_at(w, contact->body[1])->awake.at > 0;
}

td_errors td_errors_of_step(const thud_world *w) {
    td_errors e = w->errors;
    if (!td_errors_points_stale(w)) {
        return e;
    }
    e.points = e.overlaps = 0;
    e.depth = 0.0;
    e.deepest = 0.0f;
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *contact = td_constraint_at(w, i);
        if (!td_is_contact(contact) || !contact->live || contact->state != TD_TOUCHING ||
            !is_awake(w, contact)) {
            continue;
        }
        td_lane at = td_lane_of(w, contact);
        for (int k = 0; k < td_form_points(w->kinds[contact->kind]->form); k++) {
            if (at.block->point[k].normal_mass[at.lane] > 0.0f) {
                float depth = -(td_errors_separation(w, contact, k) + w->skin);
                depth = td_max_float(depth, 0.0f);
                e.points++;
                e.overlaps += depth > td_overlap_depth_min(w);
                e.depth += (double)depth * w->to_fixed;
                e.deepest = td_max_float(e.deepest, depth);
            }
        }
    }
    return e;
}
