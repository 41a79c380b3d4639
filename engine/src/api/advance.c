/* advance.c: thud_world_advance, a fixed time step driven by a variable frame time (an accumulator;
 * G. Fiedler, Fix Your Timestep!, 2004). A call runs as many steps as fit into the time left over
 * by earlier calls plus `elapsed`: none, one or several.
 *
 * Neither events nor forces may depend on how many steps a call runs.
 *
 * Events: thud_world.gathered collects the events of all steps of a call. The hook
 * thud_world.gather copies the events of step n while step n + 1 reserves its memory, before any
 * body moves, and also reserves room for the events of step n + 1. So the copy at the end of the
 * call cannot run out of memory, and a call that runs one step copies nothing. The events of
 * quarantines (a body whose numbers are not finite is taken out of the world) are the exception.
 * Their list grows in finalize.c, after that reservation; an event for which there is no memory
 * then is dropped, there and in the copy.
 *
 * Forces: the forces that the caller applies between two calls act for the `elapsed` of the second
 * call. A step applies their mean over its own time:
 *
 *     force = now + (mean - now) * waited
 *
 *     waited  fraction of the step's time that earlier calls left over, [0, 1]
 *     mean    mean force over that left-over time
 *     now     force of the present call
 *
 * Where mean = now the sum is exactly now: a constant force gives the same motion, bit for bit, at
 * any frame rate. td_force_record stores now, mean and due (forces for the next step alone) by
 * body. */
#include "api/step.h"
#include "rules/rules.h"
#include "state/body.h"
#include "state/handles.h"

#include <limits.h>
#include <string.h>

/* ---- events ---- */

/* One kind of event: its gathered list, the list of the last step, and the list that the step under
 * way fills. */
typedef struct td_event_copy {
    td_array *to;
    const td_array *from, *own;
} td_event_copy;

enum { EVENT_KINDS = sizeof(td_gathered) / sizeof(td_array) };

/* Lists all kinds of events. */
static void list_event_copies(thud_world *w, td_event_copy copies[EVENT_KINDS]) {
    static const td_array none;
    td_gathered *g = &w->gathered;
    const td_event_lists *last = &w->published, *own = &w->events;
    const td_array *impulses = w->rules ? &w->rules->impulses : &none;
    const td_event_copy lists[] = {
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
    static_assert(sizeof lists == EVENT_KINDS * sizeof *lists, "every list is gathered");
    memcpy(copies, lists, sizeof lists);
}

/* Empties the gathered lists. */
static void clear_gathered_events(thud_world *w) {
    td_event_copy copies[EVENT_KINDS];
    list_event_copies(w, copies);
    for (int i = 0; i < EVENT_KINDS; i++) {
        copies[i].to->count = 0;
    }
}

/* Appends the events of the last step to the gathered lists. There is room for all of them except
 * for those of quarantines, whose list is made longer here. */
static void append_events(thud_world *w) {
    td_event_copy copies[EVENT_KINDS];
    list_event_copies(w, copies);
    for (int i = 0; i < EVENT_KINDS; i++) {
        const td_array *from = copies[i].from;
        if (from->count > 0 &&
            td_array_reserve(&w->memory, copies[i].to, copies[i].to->count + from->count)) {
            memcpy(td_at(copies[i].to, copies[i].to->count), from->data,
                   (size_t)from->count * (size_t)from->stride);
            copies[i].to->count += from->count;
        }
    }
}

/* The hook thud_world.gather: gathers the events of the step before the one under way, which has
 * reserved everything else. False when memory is short. */
static bool gather_events(thud_world *w) {
    td_event_copy copies[EVENT_KINDS];
    list_event_copies(w, copies);
    for (int i = 0; i < EVENT_KINDS; i++) {
        int room = copies[i].to->count + copies[i].from->count + copies[i].own->capacity;
        if (!td_array_reserve(&w->memory, copies[i].to, room)) {
            return false;
        }
    }
    append_events(w);
    return true;
}

/* ---- forces ---- */

/* The force record of a body, by body index. */
static td_force_record *force_record_at(const thud_world *w, int body) {
    return TD_AT(td_force_record, &w->force_records, body);
}

/* Whether the next step applies forces to the body: it is dynamic, enabled, not quarantined, and
 * awake or on the list of changes, by which an edit wakes it. */
static bool accepts_force(const td_body *body) {
    return (body->flags & TD_BODY_LIVE) && body->kind == THUD_BODY_DYNAMIC &&
           !(body->flags & (TD_BODY_QUARANTINED | TD_BODY_DISABLED)) &&
           (body->awake.at > 0 || body->changes);
}

/* Reserves a force record for every body, and clears the records of bodies that are new or accept
 * no force. False when memory is short. thud_world.begun is the number of the step that ran out of
 * memory and that the next call tries again, else 0. */
static bool reserve_force_records(thud_world *w) {
    int old_count = w->force_records.count, bodies = w->bodies.count;
    /* thud_world_step has run the step that failed: its forces are no longer due. */
    bool retried = w->begun && w->begun <= w->steps;
    if (!td_array_reserve(&w->memory, &w->force_records, td_slots_capacity(&w->bodies))) {
        return false;
    }
    if (bodies > old_count) {
        memset(force_record_at(w, old_count), 0,
               (size_t)(bodies - old_count) * sizeof(td_force_record));
    }
    for (td_body_index i = {0}; i.at < bodies; i.at++) {
        const td_body *body = td_body_at(w, i);
        td_force_record *record = force_record_at(w, i.at);
        if (record->generation != body->generation || !accepts_force(body)) {
            *record = (td_force_record){.generation = body->generation};
        }
        if (retried) {
            memset(record->due, 0, sizeof record->due);
        }
    }
    w->force_records.count = bodies;
    return true;
}

/* Moves the forces of all bodies into their records: `at` is the offset of `now` or `due` in
 * td_force_record. A body without a record (made since the last reserve_force_records) keeps its
 * force for the next call. */
static void store_forces(thud_world *w, size_t at) {
    for (td_body_index i = {0}; i.at < w->force_records.count; i.at++) {
        td_body *body = td_body_at(w, i);
        if (accepts_force(body)) {
            memcpy((char *)force_record_at(w, i.at) + at, body->force, sizeof body->force);
        }
        memset(body->force, 0, sizeof body->force);
    }
}

/* now + (mean - now) * waited, the force of the head of this file. */
static float mean_force(float now, float mean, double waited) {
    return waited < 1.0 ? (float)((double)now + ((double)mean - (double)now) * waited) : mean;
}

/* Applies the forces of the next step to the bodies. `waited`: see the head of this file. `retry`:
 * the step is a failed one, all forces of which are stored as due. */
static void apply_forces(thud_world *w, double waited, bool retry) {
    for (td_body_index i = {0}; i.at < w->force_records.count; i.at++) {
        td_force_record *record = force_record_at(w, i.at);
        td_body *body = td_body_at(w, i);
        for (int k = 0; k < 3 && accepts_force(body); k++) {
            float mean = retry ? 0.0f : mean_force(record->now[k], record->mean[k], waited);
            body->force[k] += mean + record->due[k];
            w->substep_gain_stale |= body->force[k] != 0.0f;
        }
        memset(record->due, 0, sizeof record->due);
    }
}

/* At the end of a call: computes the mean force over the time that the call leaves over, of which
 * the fraction `waited` was left over by earlier calls. Drops all records where no force is left.
 */
static void keep_mean_forces(thud_world *w, double waited) {
    bool any = false;
    for (int i = 0; i < w->force_records.count; i++) {
        td_force_record *record = force_record_at(w, i);
        for (int k = 0; k < 3; k++) {
            record->mean[k] = mean_force(record->now[k], record->mean[k], waited);
            any |= record->mean[k] != 0.0f || record->due[k] != 0.0f;
        }
        memset(record->now, 0, sizeof record->now);
    }
    w->force_records.count = any ? w->force_records.count : 0;
}

/* ---- time ---- */

/* Runs one step. The callback `before` is called once a step, and not again when a failed step is
 * tried again: its edits are in the world, and its forces are stored as due. */
static thud_result run_step(thud_world *w, const thud_step_calls *calls, double waited) {
    bool retry = w->begun == w->steps + 1;
    apply_forces(w, waited, retry);
    if (calls && calls->before && !retry) {
        calls->before(w, calls->context);
    }
    thud_result result = td_step(w);
    w->begun = result == THUD_OK ? 0 : w->steps + 1;
    if (result != THUD_OK) {
        store_forces(w, offsetof(td_force_record, due));
    }
    return result;
}

/* Undoes store_forces at the start of a call whose first step failed: the forces wait on the bodies
 * for the next call. */
static void restore_forces(thud_world *w) {
    for (td_body_index i = {0}; i.at < w->force_records.count; i.at++) {
        memcpy(td_body_at(w, i)->force, force_record_at(w, i.at)->now, sizeof(float[3]));
    }
}

/* The time in [0, h) that is left of `spare` after whole steps of length h are dropped, s. */
static double time_left(double spare, double h) {
    double steps_left = spare / h;
    double rest = steps_left < 0x1p62 ? spare - h * (double)(int64_t)steps_left : 0.0;
    return rest >= 0.0 && rest < h ? rest : 0.0;
}

/* The call after its checks; *done: the number of steps it ran. `spare`: time that steps have not
 * used yet, s; `waiting`: the part of it that earlier calls left over, s. */
static thud_result advance(thud_world *w, double elapsed, int max_steps,
                           const thud_step_calls *calls, int *done) {
    bool forces = w->substep_gain_stale || w->force_records.count > 0 || calls;
    if (forces && !reserve_force_records(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "advance: out of memory");
    }
    store_forces(w, offsetof(td_force_record, now));
    bool gathered = w->gathers;
    w->gathers = false;
    double waiting = w->spare_time, spare = waiting + elapsed;
    thud_result result = THUD_OK;
    while (spare >= w->def.time_step && *done < max_steps) {
        result = run_step(w, calls, td_min_double(waiting / w->def.time_step, 1.0));
        if (result != THUD_OK) {
            break;
        }
        spare = td_max_double(spare - w->def.time_step, 0.0);
        waiting = td_max_double(waiting - w->def.time_step, 0.0);
        w->spare_time = spare;
        if (++*done == 1) {
            clear_gathered_events(w);
            w->gather = gather_events;
        }
        if (calls && calls->after) {
            calls->after(w, calls->context);
        }
    }
    w->gather = NULL;
    if (result != THUD_OK && *done == 0) {
        w->gathers = gathered;
        restore_forces(w);
        return result;
    }
    if (*done > 1) {
        append_events(w);
    } else if (*done == 0) {
        clear_gathered_events(w);
    }
    w->gathers = *done != 1;
    if (result == THUD_OK) {
        w->spare_time = time_left(spare, w->def.time_step);
        waiting = td_max_double(waiting - (spare - w->spare_time), 0.0);
        if (*done > 0 && calls && calls->after && reserve_force_records(w)) {
            store_forces(w, offsetof(td_force_record, due));
        }
    }
    keep_mean_forces(w, waiting > 0.0 ? waiting / w->spare_time : 0.0);
    return result;
}

thud_result thud_world_advance_with(thud_world *w, double elapsed, int max_steps,
                                    const thud_step_calls *calls, int *out_steps,
                                    double *out_alpha) {
    TD_IN_OWN_FLOAT_MODE;
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
    if (out_steps) {
        *out_steps = done;
    }
    if (out_alpha) {
        *out_alpha = td_min_double(w->spare_time / w->def.time_step, 0x1.fffffffffffffp-1);
    }
    return result;
}

thud_result thud_world_advance(thud_world *w, double elapsed, int max_steps, int *out_steps,
                               double *out_alpha) {
    return thud_world_advance_with(w, elapsed, max_steps, NULL, out_steps, out_alpha);
}
