/* plane_sweep.c: sort and sweep (sweep and prune) along an axis: shapes are kept sorted by the
 * least coordinate of their fat bounds, so that a shape can only overlap those whose least
 * coordinate is below its own greatest one. plane_sweep_x.c and its neighbours are the broadphases
 * that are made of it.
 *
 * Motion is coherent: the order hardly changes from step to step, and insertion sort, which moves
 * each key past those that it has overtaken, takes little more than one comparison a shape (D.
 * Baraff, "Dynamic Simulation of Non-penetrating Rigid Bodies", 1992). Where the keys are far from
 * sorted, at the start or after great changes, passes of insertion sort over every 701st, 301st ...
 * key come first: Shell's sort with the gaps of M. Ciura ("Best Increments for the Average Case of
 * Shellsort", 2001), which bounds the work. */
#include "broadphase/plane_sweep.h"

#include "broadphase/sorted_axis.h"
#include "state/kinds.h"

#include <string.h>

/* Replaces the `count` keys by those of the shapes in set->list: shapes that have a key already
 * keep their order, so that little is left to sort, and new ones are appended. */
static void update_keys(thud_world *w, const td_proxy_set *set, td_sweep_key *keys, int count) {
    int32_t *present = w->scratch.order.data;
    const int32_t *list = set->list.data;
    int kept_count = 0;
    memset(present, 0, (size_t)w->shapes.count * sizeof *present);
    for (int i = 0; i < set->list.count; i++) {
        present[list[i]] = 1;
    }
    for (int i = 0; i < count; i++) {
        if (keys[i].shape < w->shapes.count && present[keys[i].shape]) {
            present[keys[i].shape] = 0;
            keys[kept_count++] = keys[i];
        }
    }
    for (int i = 0; i < set->list.count; i++) {
        if (present[list[i]]) {
            keys[kept_count++] = (td_sweep_key){.shape = list[i]};
        }
    }
}

bool td_sweep_list(thud_world *w, td_proxy_set *set, int lists) {
    td_array *keys = &set->keys;
    int before = keys->count / lists, after = set->list.count;
    int room = td_max_int(td_max_int(before, after), 1);
    w->scratch.order.stride = (int)sizeof(int32_t);
    set->valid = false;
    if (!td_proxy_set_reserve(w, set, set->list.count) ||
        !td_array_reserve(&w->memory, keys, lists * room) ||
        !td_array_reserve(&w->memory, &w->scratch.order, td_max_int(w->shapes.count, 1))) {
        return false;
    }
    set->ids.count = set->list.count;
    td_sweep_key *first = keys->data, *second = first + room;
    if (lists == 2) {
        memmove(second, first + before, (size_t)before * sizeof *second);
        update_keys(w, set, second, before);
    }
    update_keys(w, set, first, before);
    if (lists == 2) {
        memmove(first + after, second, (size_t)after * sizeof *second);
    }
    keys->count = lists * after;
    return true;
}

/* Sets each key to the least coordinate of its shape's bounds along the axis, relative to the
 * centre of the first key's shape, and set->widest to the maximum extent of a shape; both in bounds
 * quanta. */
static void update_key_values(const thud_world *w, td_proxy_set *set, td_sweep_key *keys, int count,
                              td_axis axis) {
    double widest = 0.0;
    int64_t reference = 0;
    for (int i = 0; i < count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, keys[i].shape);
        const td_bounds *b = &proxy->fat;
        bool along_x = axis == TD_AXIS_X;
        int64_t place = along_x ? proxy->center.x : proxy->center.y;
        int32_t min = along_x ? b->min_x : b->min_y, max = along_x ? b->max_x : b->max_y;
        reference = i ? reference : place >> TD_COARSE_SHIFT;
        keys[i].min = (double)(td_unwrap(min, place) - reference);
        widest = td_max_double(widest, (double)td_wrap_sub(max, min));
    }
    set->reference[axis] = reference;
    set->widest[axis] = widest;
}

/* Whether more than an eighth of the neighbouring keys (and 8 more) are in the wrong order, so that
 * insertion sort alone may take time of count^2. Chosen; not tuned. */
static bool is_disordered(const td_sweep_key *keys, int count) {
    int descents = 0;
    for (int i = 1; i < count; i++) {
        descents += keys[i].min < keys[i - 1].min;
    }
    return descents > count / 8 + 8;
}

/* Insertion sort within each sequence of keys that are `gap` apart. Returns how often a key was
 * moved past another: with a gap of 1 the number of inversions, pairs in the wrong order. */
static int64_t insertion_sort(td_sweep_key *keys, int count, int gap) {
    int64_t moves = 0;
    for (int i = gap; i < count; i++) {
        td_sweep_key key = keys[i];
        int to = i;
        for (; to >= gap && keys[to - gap].min > key.min; to -= gap, moves++) {
            keys[to] = keys[to - gap];
        }
        keys[to] = key;
    }
    return moves;
}

/* Sorts the keys, and returns how often one was moved past another. Ciura's sequence of gaps ends
 * with 701. Greater gaps, for longer lists, grow by a factor of 9/4, which is about that of his
 * sequence. */
static int64_t sort(td_sweep_key *keys, int count) {
    static const int CIURA_GAPS[] = {701, 301, 132, 57, 23, 10, 4};
    int64_t moves = 0;
    if (is_disordered(keys, count)) {
        int gap = CIURA_GAPS[0];
        while (gap < count / 2) {
            gap = gap * 9 / 4;
        }
        for (; gap > CIURA_GAPS[0]; gap = gap * 4 / 9) {
            moves += insertion_sort(keys, count, gap);
        }
        for (size_t i = 0; i < sizeof CIURA_GAPS / sizeof *CIURA_GAPS; i++) {
            moves += insertion_sort(keys, count, CIURA_GAPS[i]);
        }
    }
    return moves + insertion_sort(keys, count, 1);
}

void td_sweep_sort(thud_world *w, td_proxy_set *set, td_sweep_key *keys, td_axis axis) {
    update_key_values(w, set, keys, set->list.count, axis);
    set->sort_moves += sort(keys, set->list.count);
}

void td_sweep_fill(thud_world *w, td_proxy_set *set, td_axis axis) {
    td_sweep_key *keys = set->keys.data;
    int32_t *ids = set->ids.data;
    set->axis = axis;
    td_sweep_sort(w, set, keys, axis);
    for (int i = 0; i < set->ids.count; i++) {
        ids[i] = keys[i].shape;
        keys[i].at = i;
    }
    td_sorted_axis_fill(w, set);
}

bool td_sweep_build(thud_world *w, td_proxy_set *set, td_axis axis) {
    if (!td_sweep_list(w, set, 1)) {
        return false;
    }
    td_sweep_fill(w, set, axis);
    return true;
}
