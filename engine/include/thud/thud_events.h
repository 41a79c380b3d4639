/* thud_events.h: the events of the last step, or of all steps of the last thud_world_advance.
 * Included by thud.h.
 *
 * Events are in a deterministic order, and valid until the next step or thud_world_advance. Inside
 * a callback of a step the previous step's events are still returned.
 *
 * Touching: two shapes touch, here and in callbacks, lists of contacts and statistics, if they are
 * nearer to each other than 0.02 length scales; thud_contact.separation is their distance. Sensors
 * and queries need an overlap, or a touch without any gap.
 *
 * Begin and end: begin and end events of a pair of shapes alternate, and each begin is followed by
 * an end, even if a shape or its body is destroyed, moved or changed, or falls asleep. If an edit
 * ended a contact, the end event comes with the next step. If a pair is in both lists of one step,
 * it has ended and begun again if it touched before the step; otherwise it has begun and ended.
 *
 * Shapes without events: a pair makes begin, end, hit and sensor events only if both shapes have
 * `events` set (thud_shape_def, thud_shape_set_events; the default). A begin and a hit depend on
 * the setting at that time; an end is reported if its begin was, even if the setting has changed
 * since. Callbacks, rules, lists, quarantine and joints do not depend on the setting.
 *
 * Hits: a hit may come without a begin. Shapes that meet and bounce off within a step
 * (thud_detection_swept) touch neither before nor after it, and make only a hit event.
 *
 * Sensors: a sensor reports every shape of another body that it overlaps and that the filters of
 * both allow, sensors included, of dynamic, kinematic and static bodies, awake or asleep; it does
 * not wake them. Sensor and shape of two static bodies make no events, since neither moves:
 * thud_world_overlap_shape finds such overlaps. Two overlapping sensors report each other. Overlap
 * is tested at the poses at the end of the step, so that a body that moves into or out of a sensor
 * is reported by that step. A step reserves memory for new pairs of sensors: 512, plus one for each
 * awake body, plus the present number of pairs. If more begin in a step, all new pairs of that step
 * are reported by the next step instead, since a step allocates no memory after bodies have moved.
 *
 * Passing through: a shape that enters and leaves a sensor within one step is reported as begun and
 * ended if detection tests the motion: thud_detection_continuous tests bodies that pass sensors of
 * static bodies; thud_detection_bisect and thud_detection_swept test all bodies that move further
 * than half their smallest half extent in a step. A pair that an edit ended before the step is
 * reported as ended only.
 *
 * Times of sensor events: the time of a begin or end is that of the overlap within the step, exact
 * up to rounding where nothing rotates, if detection tests the motion of the pair: always under
 * bisect and swept, and for sensors of static bodies under continuous. It is 1 for other pairs, and
 * 0 if an edit ended the pair before the step. */
#ifndef THUD_EVENTS_H
#define THUD_EVENTS_H

#include "thud_ids.h"
#include "thud_math.h"

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Two shapes that began to touch, or stopped touching. */
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
    const thud_contact_event *begin; /* pairs that began to touch; sensors are not among them */
    const thud_contact_event *end;   /* pairs that stopped touching */
    const thud_contact_event *sensor_begin; /* overlaps that began; shape_a is the sensor */
    const thud_contact_event *sensor_end;   /* overlaps that ended; shape_a is the sensor */
    /* For each element of sensor_begin and sensor_end, the time in [0, 1] of the step at which the
     * overlap began or ended. */
    const float *sensor_begin_time, *sensor_end_time;
    const thud_hit_event *hit;       /* pairs that met faster than thud_world_def.hit_speed */
    const thud_body_id *quarantined; /* bodies that became non-finite, and were stopped */
    int begin_count;                 /* number of elements of `begin` */
    int end_count;                   /* of `end` */
    int sensor_begin_count;          /* of `sensor_begin` and `sensor_begin_time` */
    int sensor_end_count;            /* of `sensor_end` and `sensor_end_time` */
    int hit_count;                   /* of `hit` */
    int quarantined_count;           /* of `quarantined` */
} thud_events;

/* The events of the last step or thud_world_advance. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_events(const thud_world *world, thud_events *out);

/* The same as a return value; no events for a null world. */
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
