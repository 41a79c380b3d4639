/* sleep.c: the stage of a step that puts islands to sleep, each as a whole.
 *
 * An island sleeps when every body of it has been idle for TD_SLEEP_TIME. The idle time of a body
 * is counted in solver/wide_finalize.c. The islands are found (td_islands_label) only when some
 * body has been idle for that long, and then only in every eighth step, so that a world where no
 * body rests pays nothing. The constraints of a sleeping island keep their impulses: their lanes
 * (constraint/lanes.h) are moved into bins that no stage visits. */
#include "state/awake.h"
#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "islands/label.h"
#include "islands/wake.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/sleep_hooks.h"

#include <string.h>

/* Puts the bodies in scratch.bodies, which are whole islands, to sleep. The caller has reserved the
 * memory. */
static void put_to_sleep(thud_world *w) {
    td_array *bodies = &w->scratch.bodies, *constraints = &w->scratch.constraints;
    constraints->count = 0;
    for (int i = 0; i < bodies->count; i++) {
        int e = td_body_at(w, td_body_in(bodies, i))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            if (constraint->state == TD_TOUCHING && !constraint->listed) {
                constraint->listed = 1;
                td_push_int(constraints, td_edge_constraint(e));
            }
        }
    }
    for (int i = 0; i < constraints->count; i++) {
        td_constraint_at(w, td_int_at(constraints, i))->listed = 0;
    }
    td_lanes_put_to_sleep(w, constraints->data, constraints->count);
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
            if (td_constraint_at(w, td_edge_constraint(e))->state == TD_WAITING &&
                other->awake.at < 0) {
                td_constraint_rest(w, td_edge_constraint(e));
            }
        }
    }
    w->rest_epoch++;
    for (int i = 0; i < bodies->count; i++) {
        /* thud_world.rest_epoch counts changes of the set of resting shapes. If the rest_epoch of a
         * body is older than that of the world, the broadphase searches for the body's pairs when
         * the body wakes (wake.c). If the broadphase could not list all pairs in this step
         * (scratch.crowded), the body gets an older epoch at once, so that its pairs are searched
         * when it wakes. */
        td_body_at(w, td_body_in(bodies, i))->rest_epoch =
            w->rest_epoch - (w->scratch.crowded.count > 0);
    }
    td_proxy_sets_asleep(w, bodies);
}

/* Whether this step looks for islands to put to sleep. `bodies`: the number of bodies that have
 * been idle long enough. */
static bool is_due(const thud_world *w, int bodies) {
    return w->def.sleeping && bodies > 0 && w->steps % 8 == 0;
}

static bool reserve_lists(thud_world *w) {
    td_proxy_set *rest = &w->rest_shapes;
    return td_wake_reserve(w) && td_lanes_reserve_sleeping(w) &&
           td_proxy_set_reserve(w, rest, rest->ids.count + TD_STRAYS_MAX) &&
           td_array_reserve(&w->memory, &w->scratch.parents, w->body_of.count);
}

static bool reserve_sleep(thud_world *w) {
    /* A body that is added or wakes in this step is not counted in drowsy_bodies; if one step is as
     * long as TD_SLEEP_TIME, it may already fall asleep at the end of this step. */
    bool long_step = (float)w->def.time_step >= TD_SLEEP_TIME;
    /* Reserving memory for sleeping lanes may move the blocks in memory, so that scratch.blocks has
     * to list them again. */
    return !is_due(w, long_step ? w->body_of.count : w->drowsy_bodies) ||
           (reserve_lists(w) && td_lanes_sequence(w));
}

/* Whether a body moved in this step by at least the sleep speed times the time step. Position
 * correction of joint gaps and overlaps moves a body without a velocity, so that the idle time,
 * which is computed from the velocity, would miss it. */
static bool is_corrected(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot);
    double max = (double)(TD_SLEEP_SPEED * w->length_scale) * w->def.time_step;
    double x = (double)delta[0], y = (double)delta[1];
    double turn = (double)delta[2] * (double)td_row(&w->reach, slot)[1];
    return x * x + y * y >= max * max || turn * turn >= max * max;
}

/* The idle time of a body, s; 0 for a body that must not sleep now. */
static float idle_time(const thud_world *w, td_awake_slot slot) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    bool restless = body->flags & TD_BODY_RESTLESS || body->kind != THUD_BODY_DYNAMIC;
    return restless || is_corrected(w, slot) ? 0.0f : *td_row(&w->idle, slot);
}

static void sleep_islands(thud_world *w) {
    /* reserve_sleep has reserved memory only if some body was expected to fall asleep. If memory is
     * short now, bodies fall asleep in a later step. */
    if (!is_due(w, w->idle_bodies) || !reserve_lists(w) || !td_islands_label(w, true)) {
        return;
    }
    const td_awake_slot *root = w->scratch.parents.data;
    /* The idle time of an island is the minimum of its bodies' idle times, and is stored at the
     * slot of its root. */
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        float *island_idle = td_row(&w->idle, root[slot.at]);
        *island_idle = td_min_float(*island_idle, idle_time(w, slot));
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

const td_sleep_hooks td_sleep_stages = {reserve_sleep, sleep_islands, td_wake_island,
                                        td_proxy_set_drop_woken};

thud_result thud_world_set_sleeping(thud_world *w, bool sleeping) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "set sleeping: not inside a callback");
    }
    w->def.sleeping = sleeping;
    if (sleeping) {
        w->sleep_hooks = &td_sleep_stages;
    } else {
        td_wake_all(w);
    }
    return THUD_OK;
}
