/* oracle_support.h: helpers for the tests of the oracle. Include it after cmocka.h. */
#ifndef THUD_ORACLE_SUPPORT_H
#define THUD_ORACLE_SUPPORT_H

#include "oracle.h"

#include <math.h>

/* Fails also for NaN. */
#define assert_near(actual, expected, tolerance)                                            \
    do {                                                                                    \
        double actual_ = (actual), expected_ = (expected), tolerance_ = (tolerance);        \
        if (!(fabs(actual_ - expected_) <= tolerance_))                                     \
            fail_msg("%s is %.12g, not within %.3g of %.12g", #actual, actual_, tolerance_, \
                     expected_);                                                            \
    } while (0)

/* A body in its state at the scene's start. */
static inline engine_body body_at_start(const scene *s, int index) {
    const scene_body *b = &s->bodies[index];
    return (engine_body){.x = b->x,
                         .y = b->y,
                         .cosine = cos(b->angle),
                         .sine = sin(b->angle),
                         .vx = b->vx,
                         .vy = b->vy,
                         .angular_velocity = b->angular_velocity};
}

#endif
