/* step.c: a step of a world: the order of its stages (run_stages). docs/architecture.md describes
 * them one by one.
 *
 * Everything that can fail for want of memory comes first, and leaves every body as it was. From
 * ask_listeners on a step cannot fail. Textures, rules, listeners, joints, direct islands, sensors
 * and detection are plugged in by tables of functions that are null in worlds that do not use them.
 */
#include "constraint/joint_hooks.h"
#include "contact/sensors.h"
#include "listeners/listener_hooks.h"
#include "rules/rule_hooks.h"
#include "state/handles.h"
#include "state/sleep_hooks.h"
#include "textures/texture_hooks.h"
#include "api/step.h"

/* Makes the events of this step the ones that callers read, and begins empty lists. The lists hold
 * the events of a whole step: those of contacts that edits ended before it, and those of a step
 * that ran out of memory, are in `events` until the next step that succeeds. */
static void publish_events(thud_world *w) {
    td_event_lists published = w->events;
    w->events = w->published;
    w->published = published;
    w->gathers = false;
    w->scratch.begins.count = 0;
    td_event_lists *next = &w->events;
    next->begin.count = next->end.count = next->hit.count = next->quarantined.count = 0;
    next->sensor_begin.count = next->sensor_end.count = 0;
    next->sensor_begin_time.count = next->sensor_end_time.count = 0;
}

/* If the caller has given a clock, stores the time since *last as the stage's, and sets *last to
 * the present time. */
static void record_time(thud_world *w, thud_stage stage, double *last) {
    if (w->def.clock) {
        double now = w->def.clock(w->def.clock_context);
        w->stats.stage_seconds[stage] = now - *last;
        *last = now;
    }
}

/* The stage of the detection of a rank, or null where a detection of a lower rank has the same one:
 * a stage that several detections share runs once. */
static const td_detection_stage *stage_of(const thud_world *w, int rank) {
    const td_detection_stage *stage = w->detections[rank] ? w->detections[rank]->stage : NULL;
    for (int lower = 0; lower < rank && stage; lower++) {
        if (w->detections[lower] && w->detections[lower]->stage == stage) {
            return NULL;
        }
    }
    return stage;
}

/* Reserves memory for the stages of detection. False when it is short. */
static bool reserve_detection(thud_world *w) {
    bool done = true;
    for (int rank = 0; rank < TD_RANK_COUNT && done; rank++) {
        const td_detection_stage *stage = stage_of(w, rank);
        done = !stage || stage->reserve(w);
    }
    return done;
}

/* Runs what the stages of detection do at this moment of the step. */
static void detect(thud_world *w, td_moment moment) {
    for (int rank = 0; rank < TD_RANK_COUNT; rank++) {
        const td_detection_stage *stage = stage_of(w, rank);
        if (stage && stage->run[moment]) {
            stage->run[moment](w);
        }
    }
}

/* Clears the statistics and lists that detection fills. */
static void clear_detection(thud_world *w) {
    w->stats.impacts = w->stats.held_bodies = w->stats.unbisectable = 0;
    w->stats.motion_pairs = w->stats.motion_circles = w->stats.motion_boxes = 0;
    w->stats.motion_exact = 0;
    w->stats.held_seconds = 0.0;
    w->scratch.legs.count = w->scratch.first_legs.count = 0;
}

/* Reserves memory for sensors. False when it is short. */
static bool reserve_sensing(thud_world *w) {
    w->scratch.sensed_room = 0;
    return w->sensors == 0 || w->sensor_hooks->reserve(w);
}

/* Finds the islands that are solved directly. False when memory is short. */
static bool find_islands(thud_world *w) {
    return !w->quality.islands || w->quality.islands->find(w);
}

/* Runs the soft solver on all islands, then the direct solver on some of them, which keeps the
 * better result of each. Of joints, clear_yielded first drops warm-start impulses that pressed
 * bodies into static shapes, share_caps bounds springs and motors of two directions, and yield at
 * last takes back the motion by which a joint pressed a body into a static shape. */
static void solve(thud_world *w) {
    w->stats.direct_islands = w->stats.direct_bodies = w->stats.soft_islands = w->stats.factorings =
        0;
    w->stats.island_work = 0;
    if (w->joint_hooks) {
        w->joint_hooks->clear_yielded(w);
        w->joint_hooks->share_caps(w);
    }
    td_solve_begin(w);
    if (w->quality.islands) {
        w->quality.islands->begin(w);
    }
    td_solve(w);
    if (w->quality.islands) {
        w->quality.islands->end(w);
    }
    if (w->joint_hooks) {
        w->joint_hooks->yield(w);
    }
}

/* Reads textures, applies rules, then asks listeners (the prologue, pre-solve), whose answer
 * overrules both. */
static void ask_listeners(thud_world *w) {
    w->errors.energy_decided = 0.0;
    if (w->texture_hooks) {
        w->texture_hooks->settle(w);
    }
    if (w->rule_hooks) {
        w->rule_hooks->decide(w);
    }
    if (w->asks) {
        w->listener_hooks->ask(w);
    }
}

/* Makes the events of rules, then calls listeners (the epilogue, post-solve). */
static void tell_listeners(thud_world *w) {
    if (w->rule_hooks) {
        w->rule_hooks->tell(w);
    }
    if (w->tells) {
        w->listener_hooks->tell(w);
    }
}

/* All stages. THUD_ERROR_MEMORY: no body has moved. */
static thud_result run_stages(thud_world *w) {
    double start = w->def.clock ? w->def.clock(w->def.clock_context) : 0.0, last = start;

    /* These stages may run out of memory. */
    bool done = td_changes_apply(w);
    record_time(w, THUD_STAGE_CHANGES, &last);
    done = done && (w->paired || td_broadphase(w));
    w->paired |= done;
    record_time(w, THUD_STAGE_BROADPHASE, &last);
    done = done && td_broadphase_refresh(w) && td_narrowphase(w) && find_islands(w) &&
           td_finalize_reserve(w) && reserve_detection(w) && reserve_sensing(w) &&
           (!w->sleep_hooks || w->sleep_hooks->reserve(w)) &&
           (!w->rule_hooks || w->rule_hooks->reserve(w)) &&
           (!w->listener_hooks || w->listener_hooks->reserve(w)) && (!w->gather || w->gather(w));
    record_time(w, THUD_STAGE_NARROWPHASE, &last);
    if (!done) {
        return td_refuse(w, THUD_ERROR_MEMORY, "step: out of memory; nothing has moved");
    }

    /* From here on the step cannot fail. A step that fails leaves these two as they are, and the
     * next step goes on with the stage that they name. */
    w->paired = false;
    w->narrowed = 0;
    ask_listeners(w);
    detect(w, TD_BEFORE_SOLVING);
    td_contacts_hit(w);
    record_time(w, THUD_STAGE_CONTACTS, &last);
    w->stats.substeps = w->substeps;
    solve(w);
    detect(w, TD_BEFORE_MOVING);
    record_time(w, THUD_STAGE_SOLVE, &last);
    td_finalize(w);
    record_time(w, THUD_STAGE_FINALIZE, &last);
    clear_detection(w);
    detect(w, TD_AFTER_MOVING);
    record_time(w, THUD_STAGE_CONTINUOUS, &last);
    if (w->scratch.sensed_room > 0) {
        w->sensor_hooks->test(w);
    }
    tell_listeners(w);
    if (w->joint_hooks) {
        w->joint_hooks->break_up(w);
    }
    record_time(w, THUD_STAGE_EVENTS, &last);
    if (w->sleep_hooks) {
        w->sleep_hooks->sleep(w);
    }
    record_time(w, THUD_STAGE_SLEEP, &last);
    publish_events(w);
    w->stats.step_seconds = last - start;
    if (w->def.parts) {
        w->def.parts->keep_budget(w);
    }
    return THUD_OK;
}

thud_result td_step(thud_world *w) {
    uint64_t allocations = w->memory.allocations;
    /* The caller's functions (callbacks, log, clock, job system, allocator) must not edit the
     * world. */
    w->locked = true;
    thud_result result = run_stages(w);
    w->locked = false;
    w->steps += result == THUD_OK;
    w->stats.step_allocations = w->memory.allocations - allocations;
    return result;
}

thud_result thud_world_step(thud_world *w) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked || w->advancing) {
        return td_refuse(w, THUD_ERROR_LOCKED, "step: not inside a callback");
    }
    return td_step(w);
}
