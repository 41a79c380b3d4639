/* plane_sweep.c: sort and sweep (sweep and prune) along x: shapes are kept sorted by the min_x of
 * their fat bounds, so that a shape can only overlap those that begin before it ends.
 *
 * Motion is coherent: the order hardly changes from step to step, and insertion sort, which moves
 * each key past those that it has overtaken, takes little more than one comparison a shape
 * (D. Baraff, "Dynamic Simulation of Non-penetrating Rigid Bodies", 1992). Where the keys are far
 * from sorted, at the start or after great changes, passes of insertion sort over every 701st,
 * 301st ... key come first: Shell's sort with the gaps of M. Ciura ("Best Increments for the
 * Average Case of Shellsort", 2001), which bounds the work. */
#include "state/kinds.h"
#include "broadphase/sorted_axis.h"

#include <string.h>

/* Memory for the shapes in set->list. False when memory is short. */
static bool reserve(thud_world *w, td_proxy_set *set) {
    w->scratch.order.stride = (int)sizeof(uint8_t);
    return td_proxy_set_reserve(w, set) &&
           td_array_reserve(&w->memory, &set->keys, td_max_int(set->list.count, 1)) &&
           td_array_reserve(&w->memory, &w->scratch.order, td_max_int(w->shapes.count, 1));
}

/* Makes the keys those of the shapes in set->list: shapes that had a key keep their order, and new
 * ones are appended. */
static void update_keys(thud_world *w, td_proxy_set *set) {
    uint8_t *present = w->scratch.order.data;
    const int32_t *list = set->list.data;
    td_sweep_key *keys = set->keys.data;
    int kept_count = 0;
    memset(present, 0, (size_t)w->shapes.count);
    for (int i = 0; i < set->list.count; i++) {
        present[list[i]] = 1;
    }
    for (int i = 0; i < set->keys.count; i++) {
        if (keys[i].shape < w->shapes.count && present[keys[i].shape]) {
            present[keys[i].shape] = 0;
            keys[kept_count++] = keys[i];
        }
    }
    for (int i = 0; i < set->list.count; i++) {
        if (present[list[i]]) {
            keys[kept_count++].shape = list[i];
        }
    }
    set->keys.count = kept_count;
}

/* Sets each key to the shape's min_x relative to that of the first key's place, and set->widest to
 * the greatest width; both in bounds quanta. */
static void update_key_values(const thud_world *w, td_proxy_set *set) {
    td_sweep_key *keys = set->keys.data;
    set->widest = 0.0;
    set->reference =
        set->keys.count ? td_shape_proxy_at(w, keys[0].shape)->center.x >> TD_COARSE_SHIFT : 0;
    for (int i = 0; i < set->keys.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, keys[i].shape);
        double width = (double)td_wrap_sub(proxy->fat.max_x, proxy->fat.min_x);
        keys[i].min_x = (double)(td_unwrap(proxy->fat.min_x, proxy->center.x) - set->reference);
        set->widest = td_max_double(set->widest, width);
    }
}

/* Whether more than an eighth of the neighbouring keys (and 8 more) are in the wrong order, so that
 * insertion sort alone may take time of count^2. Chosen; not tuned. */
static bool is_disordered(const td_sweep_key *keys, int count) {
    int descents = 0;
    for (int i = 1; i < count; i++) {
        descents += keys[i].min_x < keys[i - 1].min_x;
    }
    return descents > count / 8 + 8;
}

/* Insertion sort within each sequence of keys that are `gap` apart. */
static void insertion_sort(td_sweep_key *keys, int count, int gap) {
    for (int i = gap; i < count; i++) {
        td_sweep_key key = keys[i];
        int to = i;
        for (; to >= gap && keys[to - gap].min_x > key.min_x; to -= gap) {
            keys[to] = keys[to - gap];
        }
        keys[to] = key;
    }
}

/* Sorts the keys. Gaps beyond Ciura's 701 grow by 9/4, as his sequence does on the whole. */
static void sort(td_sweep_key *keys, int count) {
    static const int CIURA_GAPS[] = {701, 301, 132, 57, 23, 10, 4};
    if (is_disordered(keys, count)) {
        int gap = CIURA_GAPS[0];
        while (gap < count / 2) {
            gap = gap * 9 / 4;
        }
        for (; gap > CIURA_GAPS[0]; gap = gap * 4 / 9) {
            insertion_sort(keys, count, gap);
        }
        for (size_t i = 0; i < sizeof CIURA_GAPS / sizeof *CIURA_GAPS; i++) {
            insertion_sort(keys, count, CIURA_GAPS[i]);
        }
    }
    insertion_sort(keys, count, 1);
}

/* thud_broadphase.build: sorts the keys and makes `ids` their order. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    set->valid = false;
    if (!reserve(w, set)) {
        return false;
    }
    update_keys(w, set);
    update_key_values(w, set);
    td_sweep_key *keys = set->keys.data;
    int32_t *ids = set->ids.data;
    sort(keys, set->keys.count);
    for (int i = 0; i < set->keys.count; i++) {
        ids[i] = keys[i].shape;
    }
    td_sorted_axis_fill(w, set);
    return true;
}

const thud_broadphase thud_broadphase_sweep = {
    .name = "plane sweep",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
