/* levels.h: bounding volumes in the order of their price: how many pairs each lets through to the
 * next. */
#ifndef THUD_BENCH_LEVELS_H
#define THUD_BENCH_LEVELS_H

#include <thud/thud_volumes.h>

typedef struct levels {
    long pairs;    /* of two shapes of which one is movable */
    long circles;  /* ... whose bounding circles meet, ... */
    long boxes;    /* ... whose AABBs meet as well, ... */
    long oriented; /* ... whose OBBs meet as well, ... */
    long exact;    /* ... and that overlap themselves */
} levels;

/* Adds one look at all pairs of the shapes. False for a shape that is not valid or without memory.
 */
bool levels_count(const thud_placed *shapes, const bool *movable, int count, levels *sum);

#endif
