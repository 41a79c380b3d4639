/* proxy_set.h: the bounds of many shapes, in an order in which overlaps are found quickly. Which
 * order that is, is the broadphase's to choose. */
#ifndef TD_PROXY_SET_H
#define TD_PROXY_SET_H

#include "constraint/block.h"
#include "broadphase/grid.h"
#include "base/memory.h"

/* A shape's least x, bounds quanta from the proxy set's reference. */
typedef struct td_sweep_key {
    double least;
    int32_t shape, padding;
} td_sweep_key;

typedef struct td_proxy_set {
    td_array list;                       /* int: the shapes, in the order that callers give */
    td_array ids;                        /* int: shapes, in the broadphase's order */
    td_array min_x, min_y, max_x, max_y; /* int32, in the order of ids, eight more at the end */
    td_array moved;                      /* int32: -1 where the shape is on the moved list */
    int moved_count;                     /* of its shapes, when last brought up to date */
    bool listed;                         /* `list` is the present proxy set */
    bool loose;                          /* small changes can be followed */
    bool valid;                          /* holds the present bounds */

    td_array cells;              /* grid: int, cell of each, within its level */
    td_array starts;             /* grid: int */
    td_array spot;               /* grid: int, by shape: its index in ids; while `loose` */
    td_array anchor_x, anchor_y; /* grid: int32, centres when cells were chosen; while `loose` */
    td_level levels[TD_LEVELS];
    int64_t origin_x, origin_y; /* bounds quanta: no centre is less */
    int64_t end_x, end_y;       /* bounds quanta: no centre is greater */

    td_array keys;     /* plane sweep: td_sweep_key, in the order of ids */
    int64_t reference; /* plane sweep: where keys count from, bounds quanta */
    double widest;     /* plane sweep: no shape is wider, bounds quanta */
} td_proxy_set;

struct thud_world;

/* Hears of what overlaps a shape; false ends the sweep. */
typedef bool td_hits_fn(void *context, int shape, const int *hits, int count);

/* Finds each pair of shapes whose bounds overlap and of which one moved, once, and tells of those
 * of each shape together; `hits` is room for them. `every`: look at every shape rather than at
 * those that moved, which pays when most did. */
typedef bool td_sweep_fn(const td_proxy_set *set, td_memory *memory, const td_shape_proxy *proxy,
                         bool every, td_array *hits, td_hits_fn *tell, void *context);
/* Appends every shape whose bounds overlap `bounds`, which lie near the place. */
typedef bool td_find_fn(const td_proxy_set *set, td_memory *memory, const td_bounds *bounds,
                        td_position near_place, td_array *hits);

/* The broadphases; [1] of a pair of functions is for AVX2. */
struct thud_broadphase {
    const char *name;
    /* Orders the shapes in `list`. `quiet`: little moves, so that it pays to be able to follow.
     * False when memory is short; the proxy set is then not valid. */
    bool (*build)(struct thud_world *w, td_proxy_set *set, bool quiet);
    /* Writes the bounds of moved shapes in place; false where that is not possible. Null: never. */
    bool (*follow)(struct thud_world *w, td_proxy_set *set, const int *moved, int count);
    td_sweep_fn *sweep[2];
    td_find_fn *find[2];
};

#if defined(TD_HAS_AVX2)
#define TD_BOTH_WIDE(name) \
    { TD_JOIN(name, base), TD_JOIN(name, avx2) }
#else
#define TD_BOTH_WIDE(name) \
    { TD_JOIN(name, base), TD_JOIN(name, base) }
#endif

/* Fills bounds and moved flags of the ordered shapes from the proxies and marks of all; returns how
 * many moved. */
typedef int td_proxy_set_fill_fn(td_proxy_set *set, const td_shape_proxy *proxy,
                                 const uint8_t *marks);

void td_proxy_set_init(td_proxy_set *set); /* proxy_set.c */

/* proxy_set.c: room for the shapes in `list`, as many ids, and what filling writes beyond. */
bool td_proxy_set_reserve(struct thud_world *w, td_proxy_set *set);
void td_proxy_set_free(td_memory *memory, td_proxy_set *set);

/* Its shapes have changed. */
static inline void td_proxy_set_forget(td_proxy_set *set) {
    set->listed = set->valid = set->loose = false;
}

#endif
