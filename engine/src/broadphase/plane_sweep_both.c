/* plane_sweep_both.c: the broadphase that keeps two sorted lists, along x and along y. Two shapes
 * are a pair where their intervals overlap in both lists. For each shape the shapes whose intervals
 * may overlap its own are a range of either list; the shorter range is tested, one by one.
 *
 * Main invariant: td_proxy_set.keys has the list along x, which is the order of ids, and behind it
 * as many keys along y; td_sweep_key.at is the shape's index in ids. Each shape tests its whole
 * range, so that both shapes of a pair find it, and the one that is first in ids reports it. */
#include "broadphase/plane_sweep.h"
#include "state/kinds.h"

/* thud_broadphase.build: sorts both lists. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    if (!td_sweep_list(w, set, 2)) {
        return false;
    }
    td_sweep_fill(w, set, TD_AXIS_X);
    int count = set->list.count;
    td_sweep_key *first = set->keys.data, *second = first + count;
    int32_t *ids = set->ids.data;
    td_sweep_sort(w, set, second, TD_AXIS_Y);
    int32_t *index_of = w->scratch.order.data; /* by shape; td_sweep_list made room */
    for (int i = 0; i < count; i++) {
        index_of[ids[i]] = i;
    }
    for (int i = 0; i < count; i++) {
        second[i].at = index_of[second[i].shape];
    }
    return true;
}

/* The number of keys that lie below `value`, or, with `at_most`, at or below it. */
static int count_below(const td_sweep_key *keys, int count, double value, bool at_most) {
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (at_most ? keys[middle].min <= value : keys[middle].min < value) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* Keys of one list, from `first` on. */
typedef struct range {
    const td_sweep_key *first;
    int count;
} range;

/* The keys along an axis whose intervals may overlap the interval of length `extent` from `min` on:
 * a key is at most the end of the interval, and not below `min` by more than the extent of the
 * widest shape. */
static range range_along(const td_proxy_set *set, td_axis axis, double min, int32_t extent) {
    int count = set->ids.count;
    if (count == 0) { /* then there may be no array to point into */
        return (range){NULL, 0};
    }
    const td_sweep_key *keys =
        (const td_sweep_key *)set->keys.data + (axis == TD_AXIS_Y ? count : 0);
    int from = count_below(keys, count, min - set->widest[axis], false);
    int to = count_below(keys, count, min + (double)extent, true);
    return (range){keys + from, to - from};
}

/* The keys that the shape with bounds b has to be tested against: those whose intervals may overlap
 * its own along x, or those along y, whichever are fewer; along x where the numbers are equal.
 * `near_place`: a position near b, by which its wrapped coordinates are unwrapped. */
static range shorter_range(const td_proxy_set *set, const td_bounds *b, td_position near_place) {
    double x = (double)(td_unwrap(b->min_x, near_place.x) - set->reference[TD_AXIS_X]);
    double y = (double)(td_unwrap(b->min_y, near_place.y) - set->reference[TD_AXIS_Y]);
    range along_x = range_along(set, TD_AXIS_X, x, td_wrap_sub(b->max_x, b->min_x));
    range along_y = range_along(set, TD_AXIS_Y, y, td_wrap_sub(b->max_y, b->min_y));
    return along_y.count < along_x.count ? along_y : along_x;
}

/* The bounds of the i-th shape of the set. */
static td_bounds bounds_at(const td_proxy_set *set, int i) {
    return (td_bounds){td_int_at(&set->min_x, i), td_int_at(&set->min_y, i),
                       td_int_at(&set->max_x, i), td_int_at(&set->max_y, i)};
}

/* A td_sweep_fn. Either all shapes search or those that moved (td_sweeps_every). A pair is found by
 * each of its two shapes that searches, and reported by that one of these that comes first in ids.
 */
static bool sweep(const td_proxy_set *set, td_memory *memory, const td_shape_proxy *proxy,
                  td_array *hits, td_hits_fn *report, void *context, int64_t *tested) {
    const int32_t *ids = set->ids.data, *moved = set->moved.data;
    bool every = td_sweeps_every(set);
    for (int i = set->head; i < set->ids.count - set->tail; i++) {
        if (!every && !moved[i]) {
            continue;
        }
        td_bounds b = bounds_at(set, i);
        range r = shorter_range(set, &b, proxy[ids[i]].center);
        hits->count = 0;
        if (!td_array_reserve(memory, hits, r.count)) {
            return false;
        }
        for (int k = 0; k < r.count; k++) {
            int other = r.first[k].at;
            bool finds = (moved[i] || moved[other]) && (other > i || (!every && !moved[other]));
            td_bounds c = bounds_at(set, other);
            if (other != i && finds && td_bounds_overlap(&b, &c)) {
                td_push_int(hits, ids[other]);
            }
        }
        *tested += r.count - 1;
        if (hits->count && !report(context, ids[i], hits->data, hits->count)) {
            return false;
        }
    }
    return true;
}

/* td_find_fn. */
static bool find(const td_proxy_set *set, td_memory *memory, const td_bounds *bounds,
                 td_position near_place, td_array *hits, int64_t *tested) {
    range r = shorter_range(set, bounds, near_place);
    if (!td_array_reserve(memory, hits, hits->count + r.count)) {
        return false;
    }
    for (int k = 0; k < r.count; k++) {
        td_bounds b = bounds_at(set, r.first[k].at);
        if (td_bounds_overlap(&b, bounds)) {
            td_push_int(hits, r.first[k].shape);
        }
    }
    if (tested) {
        *tested += r.count;
    }
    return true;
}

const thud_broadphase thud_broadphase_sweep_both = {
    .name = "plane sweep both",
    .build = build,
    .sweep = {sweep, sweep},
    .find = {find, find},
};
