/* thud_events.h: the events of the last step, or of all steps of the last thud_world_advance.
 * Included by thud.h.
 *
 * Events are in a deterministic order, and valid until the next step or thud_world_advance. Inside
 * a callback of a step they are still those of the step before.
 *
 * Begin and end: of one pair of shapes begin and end events alternate, and each begin is followed
 * by an end, also when a shape or its body is destroyed, moved or changed, or falls asleep. Where
 * an edit ended a contact, the end event comes with the next step. A pair that is in both lists of
 * one step has ended and begun again if it touched before the step, and else begun and ended.
 *
 * Shapes without events: a pair makes begin, end, hit and sensor events only where both shapes have
 * `events` set (thud_shape_def, thud_shape_set_events; the default). A begin and a hit depend on
 * the setting at that time; an end is reported if its begin was, whatever has been set since.
 * Callbacks, rules, lists, quarantine and joints do not depend on the setting.
 *
 * Hits: a hit may come without a begin. Shapes that meet and bounce off within a step
 * (thud_detection_swept) touch neither before nor after it, and make a hit event only.
 *
 * Sensors: a sensor reports every shape of another body that it overlaps and that the filters of
 * both allow, sensors included, of dynamic, kinematic and static bodies, awake or asleep; it does
 * not wake them. Sensor and shape of two static bodies make no events, since neither moves:
 * thud_world_overlap_shape finds such overlaps. Of two sensors each reports the other. Overlap is
 * tested with bodies where they are at the end of the step, so that a body that moves into or out
 * of a sensor is reported by that step. A step reserves room for 512 new pairs of sensors, one for
 * each awake body, and as many as there are pairs of sensors already. Where more come up in a step,
 * all new pairs of that step are reported by the next step instead, so that a step allocates no
 * memory once bodies have moved.
 *
 * Passing through: a shape that enters and leaves a sensor within one step is reported as begun and
 * ended where a detection tests the motion: thud_detection_continuous that of bodies past sensors
 * of static bodies, thud_detection_bisect and thud_detection_swept that of all bodies which move
 * further than half their smallest half extent in a step. The time of such an event is the time of
 * the overlap within the step, exact up to rounding where nothing rotates. The time of other events
 * is 1, and of those where an edit ended the pair before the step 0. */
#ifndef THUD_EVENTS_H
#define THUD_EVENTS_H

#include "thud_ids.h"
#include "thud_math.h"

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Two shapes that began or ceased to touch. */
typedef struct thud_contact_event {
    thud_shape_id shape_a, shape_b; /* in an end event either may have been destroyed */
} thud_contact_event;

/* Two shapes that met at more than thud_world_def.hit_speed. */
typedef struct thud_hit_event {
    thud_shape_id shape_a, shape_b;
    thud_pos point;   /* of the contact, in the world */
    thud_vec2 normal; /* unit, from a to b */
    float speed;      /* of approach along the normal, length/s; always finite */
} thud_hit_event;

/* Lists of events, each with its count below. */
typedef struct thud_events {
    const thud_contact_event *begin, *end;
    const thud_contact_event *sensor_begin, *sensor_end; /* shape_a is the sensor that reports */
    /* For each element of sensor_begin and sensor_end, the time in [0, 1] of the step at which the
     * overlap began or ended. */
    const float *sensor_begin_time, *sensor_end_time;
    const thud_hit_event *hit;
    const thud_body_id *quarantined; /* bodies that became non-finite, and were stopped */
    int begin_count, end_count, sensor_begin_count, sensor_end_count, hit_count, quarantined_count;
} thud_events;

/* THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_events(const thud_world *world, thud_events *out);

static inline thud_events thud_events_of(const thud_world *world) {
    thud_events events;
    memset(&events, 0, sizeof events);
    thud_world_get_events(world, &events);
    return events;
}

#ifdef __cplusplus
}
#endif

#endif
