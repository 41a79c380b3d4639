/* lists.h: what the lists of thud_lists.h share: the check of their arguments, and which bodies and
 * shapes they contain. */
#ifndef TD_LISTS_H
#define TD_LISTS_H

#include "state/body.h"
#include "state/handles.h"

/* Refuses null pointers and a negative capacity. `out` may be null where capacity is 0. */
static inline thud_result td_list_check(const thud_world *w, const void *out, int capacity,
                                        const int *count) {
    if (!w || !count || (!out && capacity > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "list: world, out or count is null");
    }
    return capacity >= 0 ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, "list: capacity is negative");
}

/* Whether the slot has a shape. */
static inline bool td_shape_lives(const thud_world *w, int shape) {
    return td_shape_at(w, shape)->flags & TD_SHAPE_LIVE;
}

#endif
