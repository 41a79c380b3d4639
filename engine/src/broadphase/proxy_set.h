/* proxy_set.h: the fat bounds of many shapes as a structure of arrays, in an order that the
 * broadphase chooses so that overlaps are found quickly; and the operations of a broadphase.
 * A world has two sets: thud_world.awake_shapes and .rest_shapes. */
#ifndef TD_PROXY_SET_H
#define TD_PROXY_SET_H

#include "constraint/block.h"
#include "broadphase/grid.h"
#include "base/memory.h"

/* The axes along which a plane sweep sorts. */
typedef enum td_axis { TD_AXIS_X, TD_AXIS_Y, TD_AXES } td_axis;

/* Sort key of plane_sweep.c. */
typedef struct td_sweep_key {
    double min; /* of the shape's fat bounds along the list's axis, bounds quanta from
                   td_proxy_set.reference */
    int32_t shape;
    int32_t at; /* the shape's index in td_proxy_set.ids */
} td_sweep_key;

typedef struct td_proxy_set {
    td_array list; /* int: the shapes, in the order in which broadphase.c lists them */
    td_array ids;  /* int: the same shapes, in the broadphase's order; TD_NONE for one that left
                      since the set was built */
    td_array min_x, min_y, max_x, max_y; /* int32, in the order of ids, and eight more of room */
    td_array moved;                      /* int32: -1 where the shape is on the moved list */
    int moved_count;                     /* how many of `moved` are -1 */
    int head, tail; /* how many shapes at the start and at the end of `ids` do not search in a
                       sweep. Both are 0, except in the copy of the set that a worker gets for its
                       part (shared_sweep.c) */
    bool woken;     /* set of resting shapes only: `ids` still has shapes of bodies that woke */
    bool listed;    /* `list` is up to date: no shape has entered or left the set since */
    bool loose;     /* built so that thud_broadphase.follow can update it */
    bool valid;     /* the arrays hold the present bounds */

    td_array cells;    /* grid: int, index of each shape's cell within its level */
    td_array starts;   /* grid: int, by level and cell: index in ids of the cell's first shape */
    td_array index_of; /* grid: int, by shape: its index in ids; while `loose` */
    td_array anchor_x, anchor_y; /* grid: int32, centres when cells were chosen; while `loose` */
    td_level levels[TD_LEVELS];
    int64_t origin_x, origin_y; /* bounds quanta: the least coordinates of the centres */
    int64_t end_x, end_y;       /* bounds quanta: the greatest */

    /* Plane sweep: td_sweep_key in the order of ids, along `axis`; of a sweep along both axes those
     * along y follow, so that there are twice as many keys as ids. */
    td_array keys;
    int64_t reference[TD_AXES]; /* plane sweep, by axis: origin of the keys, bounds quanta */
    double widest[TD_AXES]; /* plane sweep, by axis: greatest extent of a shape, bounds quanta */
    td_axis axis;           /* plane sweep: of the first list of keys */
    int64_t sort_moves; /* plane sweep: keys that insertion sort moved since the last broadphase */
} td_proxy_set;

/* What the broadphase did in a step; see thud_broadphase_counts. */
typedef struct td_broadphase_counts {
    int64_t tested, found, sort_moves;
    int moved;
} td_broadphase_counts;

struct thud_world;

/* Called with the shapes (hits) that overlap `shape`. If it returns false, the sweep ends and
 * returns false, too. */
typedef bool td_hits_fn(void *context, int shape, const int *hits, int count);

/* Whether every shape searches in a sweep, and looks only at shapes after it in the order; this
 * takes less time where most shapes moved. Otherwise only shapes that moved search, among the
 * shapes before and after them in the order. */
static inline bool td_sweeps_every(const td_proxy_set *set) {
    return set->moved_count * 2 > set->ids.count;
}

/* Finds each pair of shapes whose bounds overlap and of which one moved, once. Calls `report` for
 * each shape that searches, with all the shapes that it found; `hits` is memory for them. False
 * when memory is short, or where `report` returned false. Adds the number of compared pairs of
 * bounds to *tested, also where it returns false. */
typedef bool td_sweep_fn(const td_proxy_set *set, td_memory *memory, const td_shape_proxy *proxy,
                         td_array *hits, td_hits_fn *report, void *context, int64_t *tested);
/* Appends every shape whose bounds overlap `bounds`, which lie near near_place (td_unwrap). False
 * when memory is short. Adds the number of bounds that it compared to *tested, unless that is
 * null. */
typedef bool td_find_fn(const td_proxy_set *set, td_memory *memory, const td_bounds *bounds,
                        td_position near_place, td_array *hits, int64_t *tested);

/* The operations of a broadphase. Of a pair of functions [1] is compiled for AVX2. */
struct thud_broadphase {
    const char *name;
    /* Orders the shapes in `list` and fills the set's arrays. `few_moved`: few shapes move, so that
     * preparing for `follow` pays. False when memory is short; the set is then not valid. */
    bool (*build)(struct thud_world *w, td_proxy_set *set, bool few_moved);
    /* Writes the bounds of the moved shapes in place, keeping the order. False where that is not
     * possible, so that the set has to be built. Null where it is never possible. */
    bool (*follow)(struct thud_world *w, td_proxy_set *set, const int *moved, int count);
    /* Adds a shape to the valid set of shapes at rest without sorting. False where that is not
     * possible, so that the set has to be built. Null where it is never possible. */
    bool (*enter)(struct thud_world *w, td_proxy_set *set, int shape);
    td_sweep_fn *sweep[2];
    td_find_fn *find[2];
};

/* Initialiser of `sweep` or `find`: the function of a wide file for each instruction set. */
#if defined(TD_HAS_AVX2)
#define TD_BOTH_WIDE(name) \
    { TD_JOIN(name, base), TD_JOIN(name, avx2) }
#else
#define TD_BOTH_WIDE(name) \
    { TD_JOIN(name, base), TD_JOIN(name, base) }
#endif

/* Fills bounds and moved flags of the shapes in `ids` from the proxies and marks of all shapes;
 * returns how many moved. */
typedef int td_proxy_set_fill_fn(td_proxy_set *set, const td_shape_proxy *proxy,
                                 const uint8_t *marks);

void td_proxy_set_init(td_proxy_set *set); /* proxy_set.c */

/* proxy_set.c: makes room for `count` ids, bounds and cells, and for eight more. False when memory
 * is short. */
bool td_proxy_set_reserve(struct thud_world *w, td_proxy_set *set, int count);
void td_proxy_set_free(td_memory *memory, td_proxy_set *set);

/* proxy_set.c: tells the world's sets that bodies (a list of td_body_index) have fallen asleep, or
 * have woken. Shapes of woken bodies stay in the set of resting shapes until
 * td_proxy_set_drop_woken, since the rest of the step still uses the sets as its broadphase has
 * filled them. */
void td_proxy_sets_asleep(struct thud_world *w, const td_array *bodies);
void td_proxy_sets_woken(struct thud_world *w, const td_array *bodies);
/* Takes the shapes that are awake out of the set of shapes at rest. */
void td_proxy_set_drop_woken(struct thud_world *w);

/* Room for the hits of one query among so many shapes. The query finds each shape once at most, and
 * before it tests a range of shapes it reserves room as if all of them were hits (reserve_hits,
 * wide_scan.h). */
static inline int td_query_room(int shapes) {
    return 2 * shapes + 4 * TD_LANES;
}

/* Invalidates the set after a shape has entered or left it. */
static inline void td_proxy_set_forget(td_proxy_set *set) {
    set->listed = set->valid = set->loose = false;
}

/* Writes the bounds of the shape at one index of ids. */
static inline void td_proxy_set_put(td_proxy_set *set, int at, const td_bounds *b) {
    ((int32_t *)set->min_x.data)[at] = b->min_x;
    ((int32_t *)set->min_y.data)[at] = b->min_y;
    ((int32_t *)set->max_x.data)[at] = b->max_x;
    ((int32_t *)set->max_y.data)[at] = b->max_y;
}

#endif
