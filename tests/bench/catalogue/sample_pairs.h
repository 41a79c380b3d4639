/* sample_pairs.h: pairs of shapes to time geometry on. */
#ifndef THUD_BENCH_SAMPLE_PAIRS_H
#define THUD_BENCH_SAMPLE_PAIRS_H

#include <thud/thud_minkowski.h>
#include <thud/thud_shapes.h>

enum { SAMPLE_PAIRS = 256 }; /* a power of two */

/* Sizes from 0.2 to 1, boxes at any angle. */
typedef struct sample_pairs {
    /* Centres up to twice as far apart as the bounding circles reach: some overlap, some do not. */
    thud_shape_instance a[SAMPLE_PAIRS], b[SAMPLE_PAIRS];
    /* Apart, and a motion of the second that ends within the first: they meet on the way. */
    thud_shape_instance far_b[SAMPLE_PAIRS];
    thud_motion motion[SAMPLE_PAIRS];
    thud_minkowski sum[SAMPLE_PAIRS];
    double tolerance; /* of bisection */
} sample_pairs;

void sample_pairs_make(thud_shape_kind a, thud_shape_kind b, sample_pairs *out);

#endif
