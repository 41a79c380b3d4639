/* levels.h: how many pairs get how far: through bounding volumes in the order of their price, and
 * through the tests of a narrowphase that keeps contacts of what is near. */
#ifndef THUD_BENCH_LEVELS_H
#define THUD_BENCH_LEVELS_H

#include <thud/thud_volumes.h>

typedef struct levels {
    long pairs;    /* of two shapes of which one is movable */
    long circles;  /* ... whose bounding circles meet, ... */
    long boxes;    /* ... whose AABBs meet as well, ... */
    long oriented; /* ... whose OBBs meet as well, ... */
    long exact;    /* ... and that overlap themselves */
    long sieved;   /* pairs that no separating axis parts by the margin, ... */
    long near;     /* ... and that are nearer than it */
} levels;

/* Adds one look at all pairs of the shapes. False for a shape that is not valid, or without
 * memory. */
bool levels_count(const thud_shape_instance *shapes, const bool *movable, int count, double margin,
                  levels *sum);

#endif
