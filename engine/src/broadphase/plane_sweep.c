/* plane_sweep.c: the broadphase that keeps its shapes sorted by where they begin along x.
 *
 * While little moves the order hardly changes from step to step, and insertion sort, which moves
 * each shape past those that it overtook, costs little more than a look at each (D. Baraff,
 * "Dynamic Simulation of Non-penetrating Rigid Bodies", 1992). Where the order tells nothing, at
 * the start or after great changes, it is preceded by passes over every 701st, 301st ... shape,
 * which is Shell's sort with Ciura's gaps: the work stays bounded. */
#include "state/kinds.h"
#include "broadphase/sorted_axis.h"

#include <string.h>

static bool reserve(thud_world *w, td_proxy_set *row) {
    w->scratch.order.stride = (int)sizeof(uint8_t);
    return td_proxy_set_reserve(w, row) &&
           td_array_reserve(&w->memory, &row->keys, td_max_int(row->list.count, 1)) &&
           td_array_reserve(&w->memory, &w->scratch.order, td_max_int(w->shapes.count, 1));
}

/* Shapes that are still there keep their order, new ones come last. */
static void follow_list(thud_world *w, td_proxy_set *row) {
    uint8_t *present = w->scratch.order.data;
    const int32_t *list = row->list.data;
    td_sweep_key *keys = row->keys.data;
    int kept = 0;
    memset(present, 0, (size_t)w->shapes.count);
    for (int i = 0; i < row->list.count; i++) {
        present[list[i]] = 1;
    }
    for (int i = 0; i < row->keys.count; i++) {
        if (keys[i].shape < w->shapes.count && present[keys[i].shape]) {
            present[keys[i].shape] = 0;
            keys[kept++] = keys[i];
        }
    }
    for (int i = 0; i < row->list.count; i++) {
        if (present[list[i]]) {
            keys[kept++].shape = list[i];
        }
    }
    row->keys.count = kept;
}

static void measure(const thud_world *w, td_proxy_set *row) {
    td_sweep_key *keys = row->keys.data;
    row->widest = 0.0;
    row->reference =
        row->keys.count ? td_shape_proxy_at(w, keys[0].shape)->center.x >> TD_COARSE_SHIFT : 0;
    for (int i = 0; i < row->keys.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, keys[i].shape);
        double width = (double)td_wrap_sub(proxy->fat.max_x, proxy->fat.min_x);
        keys[i].least = (double)(td_unwrap(proxy->fat.min_x, proxy->center.x) - row->reference);
        row->widest = td_max_double(row->widest, width);
    }
}

static bool is_disordered(const td_sweep_key *keys, int count) {
    int descents = 0;
    for (int i = 1; i < count; i++) {
        descents += keys[i].least < keys[i - 1].least;
    }
    return descents > count / 8 + 8;
}

/* Insertion sort of every `gap`-th. */
static void insert(td_sweep_key *keys, int count, int gap) {
    for (int i = gap; i < count; i++) {
        td_sweep_key key = keys[i];
        int to = i;
        for (; to >= gap && keys[to - gap].least > key.least; to -= gap) {
            keys[to] = keys[to - gap];
        }
        keys[to] = key;
    }
}

static void sort(td_sweep_key *keys, int count) {
    static const int gaps[] = {701, 301, 132, 57, 23, 10, 4};
    if (is_disordered(keys, count)) {
        int gap = gaps[0];
        while (gap < count / 2) {
            gap = gap * 9 / 4;
        }
        for (; gap > gaps[0]; gap = gap * 4 / 9) {
            insert(keys, count, gap);
        }
        for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++) {
            insert(keys, count, gaps[i]);
        }
    }
    insert(keys, count, 1);
}

static bool build(thud_world *w, td_proxy_set *row, bool quiet) {
    (void)quiet;
    row->valid = false;
    if (!reserve(w, row)) {
        return false;
    }
    follow_list(w, row);
    measure(w, row);
    td_sweep_key *keys = row->keys.data;
    int32_t *ids = row->ids.data;
    sort(keys, row->keys.count);
    for (int i = 0; i < row->keys.count; i++) {
        ids[i] = keys[i].shape;
    }
    td_sorted_axis_fill(w, row);
    return true;
}

const thud_broadphase thud_broadphase_sweep = {
    .name = "plane sweep",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
