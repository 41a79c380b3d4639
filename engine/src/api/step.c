/* step.c: the whole engine at a glance. Data flows one way; stages meet in the world's state. */
#include "constraint/joint_hooks.h"
#include "detection/sensing.h"
#include "listeners/listener_hooks.h"
#include "rules/rule_hooks.h"
#include "solver/budget.h"
#include "state/handles.h"
#include "api/step.h"

/* Events are handed over whole: what edits ended before the step, and what a step met that ran out
 * of memory, waits in `events` for the first step that is done. */
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

/* Time since the last mark goes to the stage. */
static void mark(thud_world *w, thud_stage stage, double *last) {
    if (w->def.clock) {
        double now = w->def.clock(w->def.clock_context);
        w->stats.stage_seconds[stage] = now - *last;
        *last = now;
    }
}

/* The stage that the detection of a rank runs in, or null where one of a lower rank has the same:
 * each stage runs once, whichever detections share it. */
static const td_detection_stage *stage_of(const thud_world *w, int rank) {
    const td_detection_stage *stage = w->detections[rank] ? w->detections[rank]->stage : NULL;
    for (int lower = 0; lower < rank && stage; lower++) {
        if (w->detections[lower] && w->detections[lower]->stage == stage) {
            return NULL;
        }
    }
    return stage;
}

static bool reserve_detection(thud_world *w) {
    bool done = true;
    for (int rank = 0; rank < TD_RANK_COUNT && done; rank++) {
        const td_detection_stage *stage = stage_of(w, rank);
        done = !stage || stage->reserve(w);
    }
    return done;
}

static void detect(thud_world *w, td_moment moment) {
    for (int rank = 0; rank < TD_RANK_COUNT; rank++) {
        const td_detection_stage *stage = stage_of(w, rank);
        if (stage && stage->run[moment]) {
            stage->run[moment](w);
        }
    }
}

static void forget_motions(thud_world *w) {
    w->stats.impacts = w->stats.held_bodies = w->stats.unbisectable = 0;
    w->stats.motion_pairs = w->stats.motion_circles = w->stats.motion_boxes = 0;
    w->stats.motion_exact = 0;
    w->stats.held_seconds = 0.0;
    w->scratch.legs.count = w->scratch.first_legs.count = 0;
}

/* A sensor that a callback makes takes part from the next step on. */
static bool reserve_sensing(thud_world *w) {
    const td_sensing *sensing = td_sensing_of(w);
    w->scratch.sensed_room = 0;
    return w->sensors == 0 ||
           (td_sensed_reserve(w) && td_sensors_reserve(w) && (!sensing || sensing->reserve(w)));
}

/* Sensors go by where bodies stand now: what was passed on the way first, then what is there. */
static void sense(thud_world *w) {
    if (w->scratch.sensed_room == 0) {
        return;
    }
    td_sensed_list(w);
    const td_sensing *sensing = td_sensing_of(w);
    if (sensing) {
        sensing->pass(w);
    }
    td_sensed_pairs(w);
    td_sensors_test(w);
}

static bool find_islands(thud_world *w) {
    return !w->quality.islands || w->quality.islands->find(w);
}

/* Direct islands are solved twice: by the soft solver like all others, and then as a whole. */
static void solve(thud_world *w) {
    w->stats.direct_islands = w->stats.direct_bodies = w->stats.soft_islands = w->stats.factorings =
        0;
    w->stats.island_work = 0;
    if (w->joint_hooks) {
        w->joint_hooks->forget(w);
        w->joint_hooks->share_caps(w);
    }
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

/* The rules first, so that the prologue has the last word. */
static void ask(thud_world *w) {
    if (w->rule_hooks) {
        w->rule_hooks->decide(w);
    }
    if (w->asks) {
        w->listener_hooks->ask(w);
    }
}

static void tell(thud_world *w) {
    if (w->rule_hooks) {
        w->rule_hooks->tell(w);
    }
    if (w->tells) {
        w->listener_hooks->tell(w);
    }
}

static thud_result run_stages(thud_world *w) {
    double start = w->def.clock ? w->def.clock(w->def.clock_context) : 0.0, last = start;

    /* May run out of memory, and then leave every body as it was. */
    bool done = td_changes_apply(w);
    mark(w, THUD_STAGE_CHANGES, &last);
    done = done && (w->paired || td_broadphase(w));
    w->paired |= done;
    mark(w, THUD_STAGE_BROADPHASE, &last);
    done = done && td_broadphase_refresh(w) && td_narrowphase(w) && find_islands(w) &&
           td_finalize_reserve(w) && reserve_detection(w) && reserve_sensing(w) &&
           td_sleep_reserve(w) && (!w->rule_hooks || w->rule_hooks->reserve(w)) &&
           (!w->listener_hooks || w->listener_hooks->reserve(w)) && (!w->gather || w->gather(w));
    mark(w, THUD_STAGE_NARROWPHASE, &last);
    if (!done) {
        return td_refuse(w, THUD_ERROR_MEMORY, "step: out of memory; nothing has moved");
    }

    w->paired = false; /* a step that runs out of memory goes on where these two say */
    w->narrowed = 0;
    ask(w);
    detect(w, TD_BEFORE_SOLVING);
    td_contacts_hit(w);
    mark(w, THUD_STAGE_CONTACTS, &last);
    w->stats.substeps = w->substeps;
    solve(w);
    detect(w, TD_BEFORE_MOVING);
    mark(w, THUD_STAGE_SOLVE, &last);
    td_finalize(w);
    mark(w, THUD_STAGE_FINALIZE, &last);
    forget_motions(w);
    detect(w, TD_AFTER_MOVING);
    mark(w, THUD_STAGE_CONTINUOUS, &last);
    sense(w);
    tell(w);
    if (w->joint_hooks) {
        w->joint_hooks->break_up(w);
    }
    mark(w, THUD_STAGE_EVENTS, &last);
    td_sleep(w);
    mark(w, THUD_STAGE_SLEEP, &last);
    publish_events(w);
    w->stats.step_seconds = last - start;
    td_budget_keep(w);
    return THUD_OK;
}

thud_result td_step(thud_world *w) {
    uint64_t allocations = w->memory.allocations;
    w->locked =
        true; /* whatever of the caller's it calls: callbacks, log, clock, job system, allocator */
    thud_result result = run_stages(w);
    w->locked = false;
    w->steps += result == THUD_OK;
    w->stats.step_allocations = w->memory.allocations - allocations;
    return result;
}

thud_result thud_world_step(thud_world *w) {
    TD_IN_OWN_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked || w->advancing) {
        return td_refuse(w, THUD_ERROR_LOCKED, "step: not inside a callback");
    }
    return td_step(w);
}
