/* preview.h: shapes as edits that wait will place them, for queries between steps.
 *
 * Edits take effect together, as the next step begins: in which order bodies enter, wake and get
 * awake slots, lanes and colours depends on which edits are applied at once. A query that had them
 * applied would thus change the bits of the steps that follow. It leaves them waiting, and looks at
 * a copy of the shapes that they place. */
#ifndef TD_PREVIEW_H
#define TD_PREVIEW_H

#include "state/shape.h"

/* Brings the copies up to date; edits that callbacks made wait for the next step, and are not seen.
 * False when memory is short, and there are none. Not while the world is locked. */
bool td_preview_make(thud_world *w);

/* There is a copy of the shape; *number is its index. */
static inline bool td_preview_has(const thud_world *w, int shape, int *number) {
    const td_preview *p = &w->preview;
    *number = p->shape.count > 0 && shape < p->number.capacity ? td_int_at(&p->number, shape) : 0;
    return *number < p->shape.count && td_int_at(&p->shape, *number) == shape;
}

/* Where a shape will be; of a shape that no edit places, where it is. */
static inline const td_shape_proxy *td_preview_proxy(const thud_world *w, int shape) {
    int number;
    return td_preview_has(w, shape, &number) ? TD_AT(td_shape_proxy, &w->preview.proxy, number)
                                             : td_shape_proxy_at(w, shape);
}

/* Appends every shape but lines whose bounds overlap `bounds`, which lie near the place; after
 * td_preview_make and td_broadphase_refresh. False when memory is short. */
bool td_preview_find(const thud_world *w, td_memory *memory, const td_bounds *bounds,
                     td_position near_place, td_array *hits);

#endif
