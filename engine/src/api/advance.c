/* advance.c: steps by the time that has passed: none in one call, several in the next.
 *
 * A program calls it once a picture, and two things must not depend on how many steps that makes.
 *
 * Events: those of all steps of a call are gathered. The events of a step are copied where the next
 * step of the call has all its memory and nothing has moved, with room for that step's own; so
 * copying cannot fail afterwards, and a call that makes one step copies nothing.
 *
 * Forces: those applied between two calls act for the time that the second is given. The force of
 * a step is the mean over its time, of which the part `waited` was left over by earlier calls:
 *
 *     force = now + (mean - now) * waited
 *
 * with `mean` over the time that was left over and `now` of the present call. Where both are the
 * same the sum is so to the bit: a constant force gives the same motion at any display rate. */
#include "api/step.h"
#include "rules/rules.h"
#include "state/body.h"
#include "state/handles.h"

#include <limits.h>
#include <string.h>

/* ---- events ---- */

/* A list of the last step, where it is gathered, and the one that the present step fills. */
typedef struct td_told {
    td_array *to;
    const td_array *from, *own;
} td_told;

enum { TOLD = sizeof(td_gathered) / sizeof(td_array) };

static void list_told(thud_world *w, td_told told[TOLD]) {
    static const td_array none;
    td_gathered *g = &w->gathered;
    const td_event_lists *last = &w->published, *own = &w->events;
    const td_array *impulses = w->rules ? &w->rules->impulses : &none;
    const td_told lists[] = {
        {&g->lists.begin, &last->begin, &own->begin},
        {&g->lists.end, &last->end, &own->end},
        {&g->lists.sensor_begin, &last->sensor_begin, &own->sensor_begin},
        {&g->lists.sensor_end, &last->sensor_end, &own->sensor_end},
        {&g->lists.sensor_begin_time, &last->sensor_begin_time, &own->sensor_begin_time},
        {&g->lists.sensor_end_time, &last->sensor_end_time, &own->sensor_end_time},
        {&g->lists.hit, &last->hit, &own->hit},
        {&g->lists.quarantined, &last->quarantined, &own->quarantined},
        {&g->broken, &w->broken, &w->broken},
        {&g->impulses, impulses, impulses},
    };
    static_assert(sizeof lists == TOLD * sizeof *lists, "every list is gathered");
    memcpy(told, lists, sizeof lists);
}

static void forget_events(thud_world *w) {
    td_told told[TOLD];
    list_told(w, told);
    for (int i = 0; i < TOLD; i++) {
        told[i].to->count = 0;
    }
}

static void add_events(thud_world *w) {
    td_told told[TOLD];
    list_told(w, told);
    for (int i = 0; i < TOLD; i++) {
        const td_array *from = told[i].from;
        if (from->count > 0) {
            memcpy(td_at(told[i].to, told[i].to->count), from->data,
                   (size_t)from->count * (size_t)from->stride);
            told[i].to->count += from->count;
        }
    }
}

/* In a step that has reserved all else: the events of the one before. */
static bool gather(thud_world *w) {
    td_told told[TOLD];
    list_told(w, told);
    for (int i = 0; i < TOLD; i++) {
        int room = told[i].to->count + told[i].from->count + told[i].own->capacity;
        if (!td_array_reserve(&w->memory, told[i].to, room)) {
            return false;
        }
    }
    add_events(w);
    return true;
}

/* ---- forces ---- */

static td_pull *pull_at(const thud_world *w, int body) {
    return TD_AT(td_pull, &w->pulls, body);
}

/* Whether a step pushes it: fields leave alone what sleeps, and what an edit wakes is on the list
 * of changes. */
static bool heeds(const td_body *body) {
    return (body->flags & TD_BODY_LIVE) && body->kind == THUD_DYNAMIC &&
           !(body->flags & (TD_BODY_QUARANTINED | TD_BODY_DISABLED)) &&
           (body->awake.at > 0 || body->changes);
}

/* A record for every body that there is, all zero where it is new or heeds no force. */
static bool reserve_pulls(thud_world *w) {
    int had = w->pulls.count, bodies = w->bodies.count;
    bool made = w->begun && w->begun <= w->steps; /* by thud_world_step: nothing is due any more */
    if (!td_array_reserve(&w->memory, &w->pulls, td_slots_capacity(&w->bodies))) {
        return false;
    }
    if (bodies > had) {
        memset(pull_at(w, had), 0, (size_t)(bodies - had) * sizeof(td_pull));
    }
    for (td_body_index i = {0}; i.at < bodies; i.at++) {
        const td_body *body = td_body_at(w, i);
        td_pull *pull = pull_at(w, i.at);
        if (pull->generation != body->generation || !heeds(body)) {
            *pull = (td_pull){.generation = body->generation};
        }
        if (made) {
            memset(pull->due, 0, sizeof pull->due);
        }
    }
    w->pulls.count = bodies;
    return true;
}

/* Moves the forces on all bodies to `now` or `due`, that is `at` in a td_pull. A body that was made
 * since there was last room keeps its own, for the next call. */
static void take_forces(thud_world *w, size_t at) {
    for (td_body_index i = {0}; i.at < w->pulls.count; i.at++) {
        td_body *body = td_body_at(w, i);
        if (heeds(body)) {
            memcpy((char *)pull_at(w, i.at) + at, body->force, sizeof body->force);
        }
        memset(body->force, 0, sizeof body->force);
    }
}

static float blend(float now, float mean, double waited) {
    return waited < 1.0 ? (float)((double)now + ((double)mean - (double)now) * waited) : mean;
}

/* Puts the forces of the next step on the bodies. `waited`: the part of its time that was left over
 * by earlier calls; of a step that has failed, all of its forces are due. */
static void push(thud_world *w, double waited, bool begun) {
    for (td_body_index i = {0}; i.at < w->pulls.count; i.at++) {
        td_pull *pull = pull_at(w, i.at);
        td_body *body = td_body_at(w, i);
        for (int k = 0; k < 3 && heeds(body); k++) {
            float held = begun ? 0.0f : blend(pull->now[k], pull->mean[k], waited);
            body->force[k] += held + pull->due[k];
            w->push_stale |= body->force[k] != 0.0f;
        }
        memset(pull->due, 0, sizeof pull->due);
    }
}

/* At the end of a call: `mean` of the time that it leaves over, of which the part `waited` was left
 * over before. Where no force is left there are no records. */
static void keep_forces(thud_world *w, double waited) {
    bool any = false;
    for (int i = 0; i < w->pulls.count; i++) {
        td_pull *pull = pull_at(w, i);
        for (int k = 0; k < 3; k++) {
            pull->mean[k] = blend(pull->now[k], pull->mean[k], waited);
            any |= pull->mean[k] != 0.0f || pull->due[k] != 0.0f;
        }
        memset(pull->now, 0, sizeof pull->now);
    }
    w->pulls.count = any ? w->pulls.count : 0;
}

/* ---- time ---- */

/* `before` is called once for each step, also for one that fails and is tried again: what it asked
 * for is in the world, and the step's forces are kept. */
static thud_result make_step(thud_world *w, const thud_step_calls *calls, double waited) {
    bool begun = w->begun == w->steps + 1;
    push(w, waited, begun);
    if (calls && calls->before && !begun) {
        calls->before(w, calls->context);
    }
    thud_result result = td_step(w);
    w->begun = result == THUD_OK ? 0 : w->steps + 1;
    if (result != THUD_OK) {
        take_forces(w, offsetof(td_pull, due));
    }
    return result;
}

/* As if the call had not been made: its forces wait for the next one. */
static void give_back(thud_world *w) {
    for (td_body_index i = {0}; i.at < w->pulls.count; i.at++) {
        memcpy(td_body_at(w, i)->force, pull_at(w, i.at)->now, sizeof(float[3]));
    }
}

/* Of the time that max_steps leaves over, whole steps are dropped. */
static double rest_of(double spare, double h) {
    double steps_left = spare / h;
    double rest = steps_left < 0x1p62 ? spare - h * (double)(int64_t)steps_left : 0.0;
    return rest >= 0.0 && rest < h ? rest : 0.0;
}

static thud_result advance(thud_world *w, double elapsed, int max_steps,
                           const thud_step_calls *calls, int *done) {
    bool forces = w->push_stale || w->pulls.count > 0 || calls;
    if (forces && !reserve_pulls(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "advance: out of memory");
    }
    take_forces(w, offsetof(td_pull, now));
    bool gathered = w->gathers;
    w->gathers = false;
    double waiting = w->spare_time, spare = waiting + elapsed;
    thud_result result = THUD_OK;
    while (spare >= w->def.time_step && *done < max_steps) {
        result = make_step(w, calls, td_min_double(waiting / w->def.time_step, 1.0));
        if (result != THUD_OK) {
            break;
        }
        spare = td_max_double(spare - w->def.time_step, 0.0);
        waiting = td_max_double(waiting - w->def.time_step, 0.0);
        w->spare_time = spare;
        if (++*done == 1) {
            forget_events(w);
            w->gather = gather;
        }
        if (calls && calls->after) {
            calls->after(w, calls->context);
        }
    }
    w->gather = NULL;
    if (result != THUD_OK && *done == 0) {
        w->gathers = gathered;
        give_back(w);
        return result;
    }
    if (*done > 1) {
        add_events(w);
    } else if (*done == 0) {
        forget_events(w);
    }
    w->gathers = *done != 1;
    if (result == THUD_OK) {
        w->spare_time = rest_of(spare, w->def.time_step);
        waiting = td_max_double(waiting - (spare - w->spare_time), 0.0);
        if (*done > 0 && calls && calls->after && reserve_pulls(w)) {
            take_forces(w, offsetof(td_pull, due));
        }
    }
    keep_forces(w, waiting > 0.0 ? waiting / w->spare_time : 0.0);
    return result;
}

thud_result thud_world_advance_with(thud_world *w, double elapsed, int max_steps,
                                    const thud_step_calls *calls, int *steps, double *alpha) {
    TD_IN_OWN_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked || w->advancing) {
        return td_refuse(w, THUD_ERROR_LOCKED, "advance: not inside a callback");
    }
    thud_result result = td_check(w, "advance: elapsed", elapsed, 0.0, THUD_ADVANCE_MAX);
    if (result == THUD_OK) {
        result = td_check(w, "advance: max_steps", max_steps, 1.0, (double)INT_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    int done = 0;
    w->advancing = true;
    result = advance(w, elapsed, max_steps, calls, &done);
    w->advancing = false;
    if (steps) {
        *steps = done;
    }
    if (alpha) {
        *alpha = td_min_double(w->spare_time / w->def.time_step, 0x1.fffffffffffffp-1);
    }
    return result;
}

thud_result thud_world_advance(thud_world *w, double elapsed, int max_steps, int *steps,
                               double *alpha) {
    return thud_world_advance_with(w, elapsed, max_steps, NULL, steps, alpha);
}
