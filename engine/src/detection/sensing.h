/* sensing.h: overlaps of sensors on the paths of bodies within a step. Detections that test paths
 * provide it; in a world without them sensors report overlap by the poses at the end of the step
 * only. Called by api/sensor_stages.c after detection, and by contact/sensor_events.c. */
#ifndef TD_SENSING_H
#define TD_SENSING_H

#include "state/world.h"

/* Reserves memory for a step; false: out of memory. */
bool td_sensing_reserve(thud_world *w);
/* Appends a leg to the path of each body that continuous.c held: from the start of the step to the
 * time at which the body stopped after all its holds, at the velocity that it had. */
void td_sensing_note_held(thud_world *w);
/* Reports pairs of fast bodies and sensors whose overlap began and ended within the step. */
void td_sensing_find_passed(thud_world *w);
/* The time in the step, in [0, 1], at which the overlap of the shapes began (`begins`) or ended; 1
 * if the detection of the pair does not test its paths. */
float td_sensing_time(const thud_world *w, int shape_a, int shape_b, bool begins);
/* sensing_awake.c: reports the pairs of fast bodies with awake bodies. */
void td_sensing_test_awake(thud_world *w);
/* Reports the pair if one is a sensor and the two overlapped on their paths, but not at the start
 * and the end of the step, unless an edit ended an overlap of them before the step. */
void td_sensing_test_pair(thud_world *w, int shape_a, int shape_b);
/* Sets *bounds to a square that contains the whole path of the body in the step. False: the path is
 * too long for bounds. */
bool td_sensing_path_bounds(const thud_world *w, td_awake_slot slot, td_bounds *bounds);
/* Whether the body moved further than half its smallest half extent, or its path has several legs.
 */
bool td_sensing_is_fast(const thud_world *w, td_awake_slot slot);

/* The highest detection in use that tests paths against sensors, which tests the most pairs; null
 * where none does. */
static inline const thud_detection *td_sensing_of(const thud_world *w) {
    const thud_detection *found = NULL;
    for (int rank = TD_RANK_COUNT - 1; rank >= 0 && !found; rank--) {
        found = w->detections[rank] && w->detections[rank]->senses ? w->detections[rank] : NULL;
    }
    return found;
}

#endif
