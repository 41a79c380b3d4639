/* wake.c: breadth-first search over the constraints of sleeping bodies; see wake.h. */
#include "islands/wake.h"

#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "state/awake.h"
#include "state/shape.h"

bool td_wake_reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.bodies, w->bodies.count) &&
           td_array_reserve(&w->memory, &w->scratch.constraints, w->constraints.count);
}

/* Marks the shapes of a body that wakes, so that the broadphase searches for their pairs. The
 * broadphase makes no pairs of two resting bodies (but for sensors), so that pairs with bodies that
 * fell asleep after this one may be missing. Does nothing if the set of resting shapes has not
 * changed since the body fell asleep: then no pair is missing. */
static void find_new_pairs(thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    if (body->rest_epoch == w->rest_epoch) {
        return;
    }
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_mark_moved(w, i);
        *td_marks_at(w, i) |= TD_MARK_WOKEN;
    }
}

bool td_wake_island(thud_world *w, td_body_index index) {
    td_array *bodies = &w->scratch.bodies, *constraints = &w->scratch.constraints;
    if (!td_wake_reserve(w)) {
        return false;
    }
    bodies->count = constraints->count = 0;
    td_awake_add(w, index);
    td_push_body(bodies, index);
    for (int i = 0; i < bodies->count; i++) {
        td_body_index body = td_body_in(bodies, i);
        for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
            td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            if (constraint->state != TD_TOUCHING || constraint->bin != TD_SLEEPING ||
                constraint->listed) {
                continue;
            }
            constraint->listed = 1;
            td_push_int(constraints, td_edge_constraint(e));
            td_body_index other = td_other_body(w, e);
            if (td_may_wake(td_body_at(w, other))) {
                td_awake_add(w, other);
                td_push_body(bodies, other);
            }
        }
    }
    for (int i = 0; i < constraints->count; i++) {
        td_constraint_at(w, td_int_at(constraints, i))->listed = 0;
    }
    if (!td_lanes_place(w, constraints->data, constraints->count)) {
        for (int i = bodies->count - 1; i >= 0; i--) {
            td_awake_remove(w, td_body_in(bodies, i));
        }
        return false;
    }
    for (int i = 0; i < bodies->count; i++) {
        td_body_index body = td_body_in(bodies, i);
        for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
            if (td_constraint_at(w, td_edge_constraint(e))->state == TD_RESTING) {
                td_constraint_wait(w, td_edge_constraint(e));
            }
        }
        find_new_pairs(w, body);
    }
    td_proxy_sets_woken(w, bodies);
    return true;
}
