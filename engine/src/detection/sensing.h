/* sensing.h: what bodies meet of sensors on their ways through a step. Detections that look at ways
 * bring it; a world without them goes by where bodies stand as the step ends. */
#ifndef TD_SENSING_H
#define TD_SENSING_H

#include "state/world.h"

typedef struct td_sensing {
    bool (*reserve)(thud_world *w);
    /* Tells of what quick bodies passed altogether, and are out of again. */
    void (*pass)(thud_world *w);
    /* When in the step, in [0, 1], the shapes came to overlap, or ceased to; 1 where the detection
     * of the pair does not look at its ways. */
    float (*when)(const thud_world *w, int shape_a, int shape_b, bool begins);
    /* What a quick body passed of all that is awake; null: it looks at what rests alone. */
    void (*test_awake)(thud_world *w, td_awake_slot slot);
} td_sensing;

/* For detections that look at static sensors alone, and for those that look at all. */
extern const td_sensing td_sensing_at_rest, td_sensing_on_ways;

/* sensing.c */
bool td_sensing_reserve(thud_world *w);
void td_sensing_find_passed(thud_world *w);
float td_sensing_time(const thud_world *w, int shape_a, int shape_b, bool begins);
/* Tells of two shapes if one is a sensor, and they overlapped on their ways alone. */
void td_sensing_test_pair(thud_world *w, int shape_a, int shape_b);
/* Whether the body's way has no turn in this step. */
bool td_sensing_is_straight(const thud_world *w, td_awake_slot slot);
/* Whether it moved further than half its smallest half extent, or met something on its way. */
bool td_sensing_is_fast(const thud_world *w, td_awake_slot slot);

/* That of the highest detection, which looks at the most; null where none of the world brings it.
 */
static inline const td_sensing *td_sensing_of(const thud_world *w) {
    const td_sensing *found = NULL;
    for (int rank = TD_RANK_COUNT - 1; rank >= 0 && !found; rank--) {
        found = w->detections[rank] ? w->detections[rank]->sensing : NULL;
    }
    return found;
}

#endif
