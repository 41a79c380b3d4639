/* volumes_support.h: shapes whose bounding volumes are known, for the tests of volumes. */
#ifndef VOLUMES_SUPPORT_H
#define VOLUMES_SUPPORT_H

#include "thud/thud_volumes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-12)
#define OK(call) assert_int_equal(call, THUD_OK)
#define INVALID(call) assert_int_equal(call, THUD_ERROR_INVALID)
#define MISSING(call) assert_int_equal(call, THUD_ERROR_NULL)

static const thud_geometry square = {
    .kind = THUD_SHAPE_AABB, .x = 3.0, .y = 4.0, .c = 1.0, .hx = 1.0, .hy = 1.0};

static inline thud_geometry turned(double hx, double hy, double angle) {
    return (thud_geometry){THUD_SHAPE_OBB, 0.0, 0.0, cos(angle), sin(angle), hx, hy};
}

#endif
