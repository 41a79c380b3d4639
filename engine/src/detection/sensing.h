/* sensing.h: overlaps of sensors on the paths of bodies within a step. Detections that test paths
 * provide it; in a world without them sensors report overlap by the poses at the end of the step
 * only. Called by api/step.c after detection, and by contact/sensor_events.c. */
#ifndef TD_SENSING_H
#define TD_SENSING_H

#include "state/world.h"

typedef struct td_sensing {
    /* Reserves memory for a step; false: out of memory. */
    bool (*reserve)(thud_world *w);
    /* Reports pairs that began and ended to overlap within the step, of fast bodies. */
    void (*pass)(thud_world *w);
    /* The time in the step, in [0, 1], at which the shapes began to overlap, or ended to; 1 where
     * the detection of the pair does not test its paths. */
    float (*when)(const thud_world *w, int shape_a, int shape_b, bool begins);
    /* Reports the same for a fast body against awake bodies; null: against resting ones only. */
    void (*test_awake)(thud_world *w, td_awake_slot slot);
} td_sensing;

/* For detections that test paths against sensors of static bodies only (continuous.c), and against
 * all. */
extern const td_sensing td_sensing_at_rest, td_sensing_on_ways;

/* see the fields of td_sensing */
bool td_sensing_reserve(thud_world *w);
void td_sensing_find_passed(thud_world *w);
float td_sensing_time(const thud_world *w, int shape_a, int shape_b, bool begins);
/* Reports the pair if one is a sensor and the two overlapped on their paths, but not at the start
 * and the end of the step. */
void td_sensing_test_pair(thud_world *w, int shape_a, int shape_b);
/* Whether the body's path has one leg only: nothing stopped or turned it in this step. */
bool td_sensing_is_straight(const thud_world *w, td_awake_slot slot);
/* Whether the body moved further than half its smallest half extent, or its path has several legs.
 */
bool td_sensing_is_fast(const thud_world *w, td_awake_slot slot);

/* The td_sensing of the highest detection in use, which tests the most pairs; null where no
 * detection has one. */
static inline const td_sensing *td_sensing_of(const thud_world *w) {
    const td_sensing *found = NULL;
    for (int rank = TD_RANK_COUNT - 1; rank >= 0 && !found; rank--) {
        found = w->detections[rank] ? w->detections[rank]->sensing : NULL;
    }
    return found;
}

#endif
