/* lists.h: what the lists of thud_lists.h share: which shapes they contain. */
#ifndef TD_LISTS_H
#define TD_LISTS_H

#include "state/body.h"
#include "state/handles.h"

/* Whether the slot has a shape. */
static inline bool td_shape_lives(const thud_world *w, int shape) {
    return td_shape_at(w, shape)->flags & TD_SHAPE_LIVE;
}

#endif
