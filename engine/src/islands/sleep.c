/* sleep.c: islands fall asleep as a whole.
 *
 * Islands are only worked out when a body has been at rest for long enough, and then at most every
 * eighth step: a world in which nothing rests pays nothing. Who rests, and for how long, is counted
 * where motion becomes pose, in solver/wide_finalize.c. The lanes of a sleeping island lie,
 * with their impulses, in bins that no stage visits. */
#include "state/awake.h"
#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "islands/label.h"
#include "islands/wake.h"
#include "api/step.h"

#include <string.h>

/* Puts the bodies listed to sleep; false, and nothing has changed, when memory is short. */
static bool put_to_sleep(thud_world *w) {
    td_array *bodies = &w->scratch.bodies, *constraints = &w->scratch.constraints;
    constraints->count = 0;
    for (int i = 0; i < bodies->count; i++) {
        int e = td_body_at(w, td_body_in(bodies, i))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            td_constraint *constraint = td_constraint_at(w, e / 2);
            if (constraint->state == TD_TOUCHING && !constraint->listed) {
                constraint->listed = 1;
                td_push_int(constraints, e / 2);
            }
        }
    }
    for (int i = 0; i < constraints->count; i++) {
        td_constraint_at(w, td_int_at(constraints, i))->listed = 0;
    }
    if (!td_lanes_place(w, constraints->data, constraints->count, true)) {
        return false;
    }
    for (int i = 0; i < bodies->count; i++) {
        td_body_index index = td_body_in(bodies, i);
        td_body *body = td_body_at(w, index);
        td_awake_remove(w, index);
        memset(body->velocity, 0, sizeof body->velocity);
    }
    for (int i = 0; i < bodies->count; i++) {
        td_body *body = td_body_at(w, td_body_in(bodies, i));
        for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_body *other = td_body_at(w, td_other_body(w, e));
            if (td_constraint_at(w, e / 2)->state == TD_WAITING && other->awake.at < 0) {
                td_constraint_rest(w, e / 2);
            }
        }
    }
    w->rest_epoch++;
    for (int i = 0; i < bodies->count; i++) {
        /* In a crowd pairs may be missing. An older epoch makes the body look around when it wakes.
         */
        td_body_at(w, td_body_in(bodies, i))->rest_epoch =
            w->rest_epoch - (w->scratch.crowded.count > 0);
    }
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    return true;
}

static bool is_due(const thud_world *w, int bodies) {
    return w->def.sleeping && bodies > 0 && w->steps % 8 == 0;
}

bool td_sleep_reserve(thud_world *w) {
    /* A body that enters or wakes has not been counted: a long step by itself may be enough for it.
     */
    bool long_step = (float)w->def.time_step >= TD_SLEEP_TIME;
    /* Making room for sleepers may move the blocks, so they are listed again. */
    return !is_due(w, long_step ? w->body_of.count : w->drowsy_bodies) ||
           (td_wake_reserve(w) && td_lanes_reserve_sleeping(w) && td_lanes_sequence(w) &&
            td_array_reserve(&w->memory, &w->scratch.parents, w->body_of.count));
}

/* Gaps of joints and overlaps are closed by motion that velocity knows nothing of, and idle time
 * with it: whether a body still moved in this step. */
static bool is_mended(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot);
    double most = (double)(TD_SLEEP_SPEED * w->unit) * w->def.time_step;
    double x = (double)delta[0], y = (double)delta[1];
    double turn = (double)delta[2] * (double)td_row(&w->reach, slot)[1];
    return x * x + y * y >= most * most || turn * turn >= most * most;
}

/* The idle time of a body as its island counts it: 0 of what is not to sleep now. */
static float idle_time(const thud_world *w, td_awake_slot slot) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    bool restless = body->flags & TD_BODY_RESTLESS || body->kind != THUD_DYNAMIC;
    return restless || is_mended(w, slot) ? 0.0f : *td_row(&w->idle, slot);
}

void td_sleep(thud_world *w) {
    if (!is_due(w, w->idle_bodies) || !td_islands_label(w, true)) {
        return;
    }
    const td_awake_slot *root = w->scratch.parents.data;
    /* The least idle time of an island, kept at its root's slot; a restless body keeps it up. */
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        float *least = td_row(&w->idle, root[slot.at]);
        *least = td_min_float(*least, idle_time(w, slot));
    }
    w->scratch.bodies.count = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (*td_row(&w->idle, root[slot.at]) >= TD_SLEEP_TIME) {
            td_push_body(&w->scratch.bodies, td_body_of(w, slot));
        }
    }
    if (w->scratch.bodies.count) {
        put_to_sleep(w);
    }
}
