/* seen.h: the contacts of a block as listeners see them. What td_contact_view works out for one
 * lane is worked out for eight at once here, with the same bits: a step with listeners asks for
 * all. */
#ifndef TD_SEEN_H
#define TD_SEEN_H

#include "constraint/block.h"

/* What is to be seen. */
typedef struct td_seeing {
    bool solved, places; /* impulses; points */
    float skin;          /* length */
    double to_fixed;     /* position quanta of a length */
} td_seeing;

typedef struct td_seen_block {
    f8 separation;
    i8 points;                          /* 0 where the pair does nothing */
    f8 normal_impulse, tangent_impulse; /* where td_seeing.solved */
    l4 x[2],
        y[2]; /* where td_seeing.places: of the point, from b's centre of mass; position quanta */
} td_seen_block;

/* wide_seen.c: of a block with so many points. */
typedef void td_see_fn(td_block *block, int points, const td_seeing *how, td_seen_block *seen);
TD_DECLARE_WIDE(td_see_fn, td_see_block);

#endif
