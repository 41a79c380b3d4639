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
} td_sensing;

extern const td_sensing td_sensing_on_ways;

/* Null where no detection of the world brings it. */
static inline const td_sensing *td_sensing_of(const thud_world *w) {
    const td_sensing *found = NULL;
    for (int rank = 0; rank < TD_RANK_COUNT && !found; rank++) {
        found = w->detections[rank] ? w->detections[rank]->sensing : NULL;
    }
    return found;
}

#endif
