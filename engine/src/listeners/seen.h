/* seen.h: the contacts of a block as listeners see them, computed for all eight lanes at once with
 * the same bits as td_contact_view does for one: a step with listeners needs all of them. */
#ifndef TD_SEEN_H
#define TD_SEEN_H

#include "constraint/block.h"

/* What is to be computed. */
typedef struct td_seeing {
    bool solved, places; /* the impulses; the contact points */
    float skin;          /* thud_world.skin, which is added to separations */
    double to_fixed;     /* position quanta per unit of length of the caller */
} td_seeing;

/* By lane. */
typedef struct td_seen_block {
    f8 separation; /* least of the points, caller's unit */
    i8 points;     /* number of points; 0: the pair does not act in this step */
    f8 normal_impulse, tangent_impulse; /* where td_seeing.solved */
    /* Where td_seeing.places: the mean of the points, from b's centre of mass, position quanta. */
    l4 x[2], y[2];
} td_seen_block;

/* wide_seen.c. `points`: of the block's kind, 1 or 2. */
typedef void td_see_fn(td_block *block, int points, const td_seeing *how, td_seen_block *seen);
TD_DECLARE_WIDE(td_see_fn, td_see_block);

#endif
