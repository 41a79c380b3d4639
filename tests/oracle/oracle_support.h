/* oracle_support.h: what the oracle's tests share. Include after cmocka.h. */
#ifndef THUD_ORACLE_SUPPORT_H
#define THUD_ORACLE_SUPPORT_H

#include "oracle.h"

#include <math.h>

/* False for what is not a number, too. */
#define assert_near(actual, expected, tolerance)                                            \
    do {                                                                                    \
        double actual_ = (actual), expected_ = (expected), tolerance_ = (tolerance);        \
        if (!(fabs(actual_ - expected_) <= tolerance_))                                     \
            fail_msg("%s is %.12g, not within %.3g of %.12g", #actual, actual_, tolerance_, \
                     expected_);                                                            \
    } while (0)

/* A body as the scene has it at the start. */
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
