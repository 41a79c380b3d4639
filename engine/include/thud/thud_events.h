/* thud_events.h: what happened in the last step, or in all steps of the last thud_world_advance.
 * Included by thud.h.
 *
 * Events come in a deterministic order, and are valid until the next step or thud_world_advance.
 *
 * Of one pair of shapes, begin and end come in turn, and each begin has its end: also when a shape,
 * its body or the ground goes, moves or falls asleep. Where an edit ended a pair, the end comes
 * with the next step. A pair listed in both has ended and begun again, or begun and ended, as it
 * was open before or not. Inside a callback the events are still those of the step before.
 *
 * A pair has begin, end, hit and sensor events only where both shapes make events, as all do unless
 * their def or thud_shape_set_events says otherwise. A begin goes by what holds as it happens, and
 * so does a hit; an end is told exactly where its begin was, whatever has been set since.
 * Callbacks, rules and lists go on as ever, and so do quarantine and joints.
 *
 * A hit needs no begin: what meets and bounces off within a step, as detection on the way has it
 * (thud_detection_swept), touches neither before nor after, and is told as a hit alone.
 *
 * A sensor reports every shape of another body that it overlaps and that the filters of both let
 * meet, sensors too: of dynamic, kinematic and static bodies, awake or asleep, whose sleep it does
 * not disturb. Two static bodies alone are nothing to each other, since neither ever comes or goes:
 * thud_world_overlap_shape tells what stands where. Of two sensors each reports the other. They go
 * by where bodies stand as a step ends: what moves in or out within a step is told by that step.
 * Where more come near sensors at once than 512, one for each body that is awake and as many as are
 * near some already, all that do so in that step are told of by the next one, so that a step asks
 * for no memory once bodies have moved.
 *
 * What passes a sensor altogether within a step is told as begun and ended where a detection looks
 * at ways: thud_detection_continuous at those of bodies past the sensors of static ones,
 * thud_detection_bisect and thud_detection_swept at all, of bodies that move further than half
 * their smallest half extent in a step. There the time of an event is that on the way, exact but
 * for rounding where nothing turns; of a pair that is not looked at so it is 1, and of one that an
 * edit ended before the step 0. */
#ifndef THUD_EVENTS_H
#define THUD_EVENTS_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct thud_contact_event {
    thud_shape_id shape_a, shape_b; /* of an end event they may have been destroyed since */
} thud_contact_event;

typedef struct thud_hit_event {
    thud_shape_id shape_a, shape_b;
    thud_pos point;
    thud_vec2 normal; /* from a to b */
    float speed;      /* of approach; finite, however fast they were */
} thud_hit_event;

typedef struct thud_events {
    const thud_contact_event *begin, *end;
    const thud_contact_event *sensor_begin, *sensor_end; /* shape_a is the sensor that reports */
    /* Of each of those, in [0, 1] of the step: when the two came to overlap, or ceased to. */
    const float *sensor_begin_time, *sensor_end_time;
    const thud_hit_event *hit;
    const thud_body_id *quarantined; /* frozen because they became non-finite */
    int begin_count, end_count, sensor_begin_count, sensor_end_count, hit_count, quarantined_count;
} thud_events;

THUD_API thud_events thud_world_events(const thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
