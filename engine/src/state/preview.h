/* preview.h: shapes as pending edits will place them, for queries between steps.
 *
 * Edits take effect together, as the next step begins (changes.c): the order in which bodies enter,
 * wake and get awake slots, lanes and colours depends on which edits are applied at once. A query
 * that applied them would therefore change the bits of later steps. Instead it leaves the edits
 * pending, and reads copies of the proxies that they will produce. */
#ifndef TD_PREVIEW_H
#define TD_PREVIEW_H

#include "state/shape.h"

/* Brings the copies up to date. Edits deferred by callbacks are not in them. Must not be called
 * while the world is locked. False when memory is short: then there are no copies. */
bool td_preview_make(thud_world *w);

/* Whether there is a copy of the shape; *number is its index then. */
static inline bool td_preview_has(const thud_world *w, int shape, int *number) {
    const td_preview *p = &w->preview;
    *number = p->shape.count > 0 && shape < p->number.capacity ? td_int_at(&p->number, shape) : 0;
    return *number < p->shape.count && td_int_at(&p->shape, *number) == shape;
}

/* The shape's proxy: the copy if there is one, else that of the world. */
static inline const td_shape_proxy *td_preview_proxy(const thud_world *w, int shape) {
    int number;
    return td_preview_has(w, shape, &number) ? TD_AT(td_shape_proxy, &w->preview.proxy, number)
                                             : td_shape_proxy_at(w, shape);
}

/* Appends every shape, but for lines, whose bounds overlap `bounds`, which lie near near_place
 * (td_unwrap). td_preview_make and td_broadphase_refresh must have been called. False when memory
 * is short. */
bool td_preview_find(const thud_world *w, td_memory *memory, const td_bounds *bounds,
                     td_position near_place, td_array *hits);

#endif
