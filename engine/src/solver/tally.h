/* tally.h: the errors of contact points, as the last relax pass leaves them.
 *
 * Sums are of whole numbers, so that the order in which workers add up does not matter. A point
 * that is not there lies TD_APART apart, and so shows in no figure but the count, which looks at
 * its mass. */
#ifndef TD_TALLY_H
#define TD_TALLY_H

#include "constraint/block.h"

/* The errors that a worker found, lane by lane. In a td_tally of zeros there are none. */
typedef struct td_tally {
    d4 depth;            /* sum of penetrations, whole position quanta */
    f8 least;            /* separation, <= 0 */
    f8 slowest;          /* normal speed before the last correction, <= 0: approach */
    i8 points, overlaps; /* overlaps: points deeper than td_tally_context.overlap */
} td_tally;

typedef struct td_tally_context {
    float skin;      /* separations are measured from here */
    float overlap;   /* deeper points count as overlaps */
    double to_fixed; /* position quanta a caller's unit */
} td_tally_context;

/* Adds the points of at most TD_CHUNK_BLOCKS blocks, whose separations have just been written: they
 * are near at hand, which is what makes it cheap. */
typedef void td_tally_fn(td_tally *to, td_block *const *blocks, int count, int points,
                         const td_tally_context *context);

#endif
