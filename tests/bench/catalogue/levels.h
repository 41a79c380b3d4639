/* levels.h: counts how many pairs pass each test of a pipeline: bounding volumes in the order of
 * their cost, and the tests of a narrowphase that creates contacts for shapes within a margin. */
#ifndef THUD_BENCH_LEVELS_H
#define THUD_BENCH_LEVELS_H

#include <thud/thud_volumes.h>

typedef struct levels {
    long pairs;    /* pairs of shapes of which at least one is movable */
    long circles;  /* ... whose bounding circles overlap, ... */
    long boxes;    /* ... and whose AABBs overlap, ... */
    long oriented; /* ... and whose OBBs overlap, ... */
    long exact;    /* ... and that overlap themselves */
    long sieved;   /* pairs whose separation along each axis is below the margin, ... */
    long near;     /* ... and whose exact distance is below it */
} levels;

/* Adds the counts of all pairs of the shapes to `sum`. False if a shape is not valid or memory runs
 * out. */
bool levels_count(const thud_geometry *shapes, const bool *movable, int count, double margin,
                  levels *sum);

#endif
