/* bisect.h: time of collision by bisection over an overlap test, for pairs of shapes (bisect.c) and
 * for shapes and terrains (terrain/terrain_bisect.c). */
#ifndef TD_BISECT_H
#define TD_BISECT_H

#include "geometry/shape_instance.h"

/* Whether a pair overlaps at a time of its motion, 0 to 1. `pair` is the argument of td_bisect. */
typedef bool td_overlap_at_fn(const void *pair, double time);

/* Whether a pair that is apart at time 0 overlaps at time 1. If so, the pair is still apart at
 * *time, and overlaps at some time at most `tolerance` later; otherwise *time is 1. */
bool td_bisect(td_overlap_at_fn *overlap_at, const void *pair, double tolerance, double *time);

/* Whether a tolerance, a share of the motion, is in range. Below 2^-53 (1.1e-16) the midpoint may
 * round to one of the ends, and the bisection would not end; THUD_TOLERANCE_MIN leaves some margin.
 */
static inline bool td_tolerance_valid(double tolerance) {
    return tolerance >= THUD_TOLERANCE_MIN && tolerance <= 1.0;
}

#endif
