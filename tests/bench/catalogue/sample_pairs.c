/* sample_pairs.c: see sample_pairs.h. */
#include "catalogue/sample_pairs.h"

#include "random.h"

#include <math.h>

static const double TURN = 6.28318530717959;

static thud_geometry random_shape(thud_shape_kind kind, scene_random *random) {
    thud_geometry shape = {.kind = kind, .c = 1};
    shape.hx = scene_random_range(random, 0.2, 1);
    shape.hy = kind == THUD_SHAPE_CIRCLE ? 0 : scene_random_range(random, 0.2, 1);
    if (kind == THUD_SHAPE_OBB) {
        double angle = scene_random_range(random, 0, TURN);
        shape.c = cos(angle);
        shape.s = sin(angle);
    }
    return shape;
}

static void place(thud_geometry *shape, double distance, scene_random *random) {
    double direction = scene_random_range(random, 0, TURN);
    shape->x = distance * cos(direction);
    shape->y = distance * sin(direction);
}

void sample_pairs_make(thud_shape_kind kind_a, thud_shape_kind kind_b, sample_pairs *out) {
    scene_random random = {12};
    out->tolerance = 0x1p-10;
    for (int i = 0; i < SAMPLE_PAIRS; i++) {
        thud_geometry a = random_shape(kind_a, &random), b = random_shape(kind_b, &random);
        double reach = hypot(a.hx, a.hy) + hypot(b.hx, b.hy);
        out->a[i] = a;
        place(&b, scene_random_range(&random, 0, 2) * reach, &random);
        out->b[i] = b;
        place(&b, scene_random_range(&random, 1.5, 4) * reach, &random);
        out->far_b[i] = b;
        /* A place near the origin, at which the second shape overlaps the first whatever their
         * sizes. */
        thud_geometry end = b;
        place(&end, 0.3 * scene_random_range(&random, 0, 1), &random);
        out->motion[i] =
            (thud_motion){end.x - b.x, end.y - b.y,
                          kind_b == THUD_SHAPE_OBB ? scene_random_range(&random, -1, 1) : 0};
        thud_minkowski_sum(&a, &b, &out->sum[i]);
    }
}
