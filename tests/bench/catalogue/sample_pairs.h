/* sample_pairs.h: random pairs of shapes, as inputs for timing geometry functions. */
#ifndef THUD_BENCH_SAMPLE_PAIRS_H
#define THUD_BENCH_SAMPLE_PAIRS_H

#include <thud/thud_minkowski.h>
#include <thud/thud_geometry.h>

enum { SAMPLE_PAIRS = 256 }; /* a power of two, for wrapping indices */

/* Sizes are 0.2 to 1 m, and OBBs have any angle. */
typedef struct sample_pairs {
    /* The distance of the centres is up to twice the sum of the bounding radii: some pairs overlap.
     */
    thud_geometry a[SAMPLE_PAIRS], b[SAMPLE_PAIRS];
    /* Pairs that are apart, and a motion of the second shape that ends in the first, so that they
     * collide. */
    thud_geometry far_b[SAMPLE_PAIRS];
    thud_motion motion[SAMPLE_PAIRS];
    thud_minkowski sum[SAMPLE_PAIRS];
    double tolerance; /* tolerance of the bisection */
} sample_pairs;

void sample_pairs_make(thud_shape_kind a, thud_shape_kind b, sample_pairs *out);

#endif
