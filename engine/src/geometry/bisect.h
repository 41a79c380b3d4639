/* bisect.h: the bisection that shapes and the ground share. */
#ifndef TD_BISECT_H
#define TD_BISECT_H

#include "geometry/shape_instance.h"

/* Whether what meets overlaps at a time of its motion. */
typedef bool td_overlap_at_fn(const void *meeting, double time);

/* Whether what is apart at first overlaps at time 1. At *time, at most `tolerance` before they
 * collide, they are still apart; 1 where they do not collide. */
bool td_bisect(td_overlap_at_fn *overlap_at, const void *meeting, double tolerance, double *time);

/* Halves of less are lost in rounding, and bisection would not end. */
static inline bool td_tolerance_valid(double tolerance) {
    return tolerance >= THUD_TOLERANCE_MIN && tolerance <= 1.0;
}

#endif
