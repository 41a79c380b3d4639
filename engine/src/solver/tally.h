/* tally.h: error statistics of contact points after the last relax pass.
 *
 * Sums are of whole numbers, so that the order in which workers add them does not matter. A lane
 * without a point has the separation TD_APART, which adds to no sum; it is not counted as a point,
 * since its effective mass is 0. */
#ifndef TD_TALLY_H
#define TD_TALLY_H

#include "constraint/block.h"

/* The statistics of the blocks that one worker has solved, one value a lane of the blocks. All
 * zeros: no points yet. */
typedef struct td_tally {
    d4 depth;        /* sum of penetration depths, in whole position quanta */
    f8 min_distance; /* the least distance of the two shapes at a point, length; negative: they
                        overlap. Never above 0 */
    f8 min_speed;    /* normal speed of a point before the last relax pass corrects it, length/s;
                        negative: closing. Of an equality row -|speed|. Never above 0 */
    i8 points, overlaps; /* number of points, and of those deeper than td_tally_context.overlap */
} td_tally;

typedef struct td_tally_context {
    float skin; /* distance at which contacts rest, a length: points have a separation of 0 there */
    float overlap;   /* a point that is deeper than this, a length, counts as an overlap */
    double to_fixed; /* position quanta in one unit of length */
} td_tally_context;

/* Adds the points of at most TD_TALLY_BLOCKS blocks to `to`. The first block is at a multiple of
 * TD_CHUNK_UNIT in its run, so that the groups whose sums are rounded are the same for any number
 * of workers. It runs right after the pass that writes the separations, while they are in the
 * cache. */
typedef void td_tally_fn(td_tally *to, td_block *const *blocks, int count, int points,
                         const td_tally_context *context);

/* Adds the normal speeds of the points of blocks to td_tally.min_speed, from the velocities of the
 * bodies (thud_world.velocity) and the present separations. As in the last relax pass
 * (wide_solve.h), an open gap may close within a substep; inv_h: substeps a second. */
typedef void td_tally_speeds_fn(td_tally *to, td_block *const *blocks, int count, int points,
                                const float (*velocity)[4], float inv_h);

#endif
