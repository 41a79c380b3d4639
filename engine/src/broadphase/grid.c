/* grid.c: building a grid by counting sort, and following small changes. The order of the shapes
 * listed decides within a cell, and places count relative to the proxy set's own least centre, so
 * that a shifted world is sorted the same. */
#include "broadphase/proxy_set.h"

#include "state/kinds.h"
#include "state/world.h"

#include <string.h>

static int32_t extent_of(const td_bounds *b) {
    return td_max_int(td_wrap_sub(b->max_x, b->min_x), td_wrap_sub(b->max_y, b->min_y));
}

static int size_of(int32_t extent) {
    float f = (float)td_max_int(extent, 1);
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return (int)(bits >> TD_SIZE_SHIFT) - TD_SIZE_ZERO;
}

/* Levels from the last one down: each begins at the largest size that is left, and holds all down
 * to an eighth of it, so that sizes that differ little share a level. */
static void choose_levels(const int *set, uint8_t *level_of_size) {
    int level = TD_LEVELS, least = TD_SIZES;
    for (int size = TD_SIZES - 1; size >= 0; size--) {
        if (set[size] && size < least && level > 0) {
            level--;
            least = size - 11;
        }
        level_of_size[size] = (uint8_t)level;
    }
}

/* As the wide measure, however far the proxy set reaches. */
static void measure_far(const thud_world *w, td_grid_measures *m) {
    int64_t ref_x = td_shape_proxy_at(w, m->list[0])->center.x >> TD_COARSE_SHIFT;
    int64_t ref_y = td_shape_proxy_at(w, m->list[0])->center.y >> TD_COARSE_SHIFT;
    m->least_x = m->least_y = 0x1p62;
    m->most_x = m->most_y = -0x1p62;
    memset(m->set, 0, sizeof m->set);
    for (int i = 0; i < m->count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, m->list[i]);
        const td_bounds *b = &proxy->fat;
        double x = (double)(td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x) - ref_x);
        double y = (double)(td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y) - ref_y);
        m->x[i] = x;
        m->y[i] = y;
        m->extent[i] = extent_of(b);
        m->least_x = x < m->least_x ? x : m->least_x;
        m->least_y = y < m->least_y ? y : m->least_y;
        m->most_x = x > m->most_x ? x : m->most_x;
        m->most_y = y > m->most_y ? y : m->most_y;
        m->set[size_of(m->extent[i])] = 1;
    }
}

static void widen(td_level *level, int64_t x, int64_t y) {
    bool first = level->count == 0;
    level->least_x = first || x < level->least_x ? x : level->least_x;
    level->least_y = first || y < level->least_y ? y : level->least_y;
    level->most_x = first || x > level->most_x ? x : level->most_x;
    level->most_y = first || y > level->most_y ? y : level->most_y;
}

/* Measures the proxy set, counts the levels and finds the largest shape of each. */
static void measure(const thud_world *w, td_proxy_set *grid, td_grid_measures *m) {
    uint8_t level_of_size[TD_SIZES];
    if (!TD_PICK_WIDE(w, td_grid_measure)(w->proxy.data, m)) {
        measure_far(w, m);
    }
    const td_position *first = &td_shape_proxy_at(w, m->list[0])->center;
    int64_t ref_x = first->x >> TD_COARSE_SHIFT, ref_y = first->y >> TD_COARSE_SHIFT;
    grid->origin_x = ref_x + (int64_t)m->least_x;
    grid->origin_y = ref_y + (int64_t)m->least_y;
    grid->end_x = ref_x + (int64_t)m->most_x;
    grid->end_y = ref_y + (int64_t)m->most_y;
    choose_levels(m->set, level_of_size);
    for (int i = 0; i < m->count; i++) {
        m->level[i] = level_of_size[size_of(m->extent[i])];
        td_level *level = &grid->levels[m->level[i]];
        level->cell = m->extent[i] > level->cell ? m->extent[i] : level->cell;
        widen(level, ref_x + (int64_t)m->x[i], ref_y + (int64_t)m->y[i]);
        level->count++;
    }
}

static uint32_t power_above(int64_t n) {
    uint32_t p = 64;
    while (p < n) {
        p *= 2;
    }
    return p;
}

/* Chooses each level's table from its proxy set; returns the length of `starts`. */
static int lay_out(td_proxy_set *grid, bool quiet) {
    int first = 0, starts = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        td_level *level = &grid->levels[l];
        level->first = first;
        level->starts = starts;
        if (!level->count) {
            continue;
        }
        level->slack = quiet ? (int32_t)(level->cell / 16) : 0;
        level->cell += 2 + 2 * (int64_t)level->slack;
        /* A little less than 1 / cell: rounding must never put neighbours two cells apart. */
        level->inv_cell = (1.0 - 1.0 / 65536.0) / (double)level->cell;
        int64_t columns = td_grid_index(grid->end_x, grid->origin_x, level->inv_cell) + 3;
        int64_t rows = td_grid_index(grid->end_y, grid->origin_y, level->inv_cell) + 3;
        uint32_t table = power_above(2 * (int64_t)level->count);
        int64_t most = 2 * (int64_t)table;
        level->hashed = columns > most || rows > most || columns * rows > most;
        if (level->hashed) {
            /* By the golden ratio: rows fall far from each other, also every second one. */
            level->row = (uint32_t)((double)table * 0.6180339887498949) | 1;
        } else {
            table = power_above(columns * rows);
            level->row = (uint32_t)columns;
        }
        level->mask = table - 1;
        first += level->count;
        starts += (int)table + 1;
    }
    return starts;
}

/* What scratch.order takes for each shape. */
enum { MEASURES_BYTES = 2 * (int)sizeof(double) + 2 * (int)sizeof(int32_t) + 8 };

static bool reserve(thud_world *w, td_proxy_set *grid, bool quiet) {
    int count = grid->list.count;
    w->scratch.order.stride = MEASURES_BYTES;
    return td_proxy_set_reserve(w, grid) &&
           td_array_reserve(&w->memory, &grid->cells, count + TD_LANES) &&
           td_array_reserve(&w->memory, &w->scratch.order, count + TD_LANES) &&
           (!quiet || (td_array_reserve(&w->memory, &grid->spot, w->shapes.count) &&
                       td_array_reserve(&w->memory, &grid->anchor_x, count) &&
                       td_array_reserve(&w->memory, &grid->anchor_y, count)));
}

/* Counting sort of ids and cells. */
static void sort(td_proxy_set *grid, const td_grid_measures *m, int starts_count) {
    int *starts = grid->starts.data, *ids = grid->ids.data, *cells = grid->cells.data;
    memset(starts, 0, (size_t)starts_count * sizeof(int));
    for (int i = 0; i < m->count; i++) {
        starts[grid->levels[m->level[i]].starts + m->cell[i]]++;
    }
    /* Where each cell ends; what is then put in, from the last shape on, brings it to its start. */
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        int sum = level->first, *of_level = starts + level->starts;
        for (uint32_t c = 0; level->count && c <= level->mask + 1; c++) {
            sum += of_level[c];
            of_level[c] = sum;
        }
    }
    for (int i = m->count - 1; i >= 0; i--) {
        int at = --starts[grid->levels[m->level[i]].starts + m->cell[i]];
        ids[at] = m->list[i];
        cells[at] = m->cell[i];
    }
}

/* Notes where each shape went, for td_grid_follow. */
static void note_spots(td_proxy_set *grid) {
    int32_t *spot = grid->spot.data, *anchor_x = grid->anchor_x.data;
    int32_t *anchor_y = grid->anchor_y.data;
    const int32_t *ids = grid->ids.data, *min_x = grid->min_x.data, *min_y = grid->min_y.data;
    const int32_t *max_x = grid->max_x.data, *max_y = grid->max_y.data;
    for (int i = 0; i < grid->ids.count; i++) {
        spot[ids[i]] = i;
        anchor_x[i] = td_middle(min_x[i], max_x[i]);
        anchor_y[i] = td_middle(min_y[i], max_y[i]);
    }
}

static td_grid_measures measures_in(const td_array *scratch, const td_array *list) {
    size_t room = (size_t)scratch->capacity;
    double *x = scratch->data, *y = x + room;
    int32_t *extent = (int32_t *)(y + room), *cell = extent + room;
    return (td_grid_measures){.list = list->data,
                              .count = list->count,
                              .x = x,
                              .y = y,
                              .extent = extent,
                              .cell = cell,
                              .level = (uint8_t *)(cell + room)};
}

static bool build(thud_world *w, td_proxy_set *grid, bool quiet) {
    grid->valid = grid->loose = false;
    grid->moved_count = 0;
    memset(grid->levels, 0, sizeof grid->levels);
    if (!reserve(w, grid, quiet)) {
        return false;
    }
    if (grid->list.count == 0) {
        grid->valid = true;
        return true;
    }
    td_grid_measures m = measures_in(&w->scratch.order, &grid->list);
    measure(w, grid, &m);
    int starts_count = lay_out(grid, quiet);
    if (!td_array_reserve(&w->memory, &grid->starts, starts_count)) {
        return false;
    }
    TD_PICK_WIDE(w, td_grid_cells)(grid->levels, &m);
    sort(grid, &m, starts_count);
    grid->moved_count = TD_PICK_WIDE(w, td_proxy_set_fill)(grid, w->proxy.data, w->marks.data);
    if (quiet) {
        note_spots(grid);
    }
    grid->loose = quiet;
    grid->valid = true;
    return true;
}

static bool near_anchor(int32_t anchor, int32_t low, int32_t high, int32_t slack) {
    int32_t drift = td_wrap_sub(td_middle(low, high), anchor);
    return drift <= slack && drift >= -slack;
}

static const td_level *level_at(const td_proxy_set *grid, int at) {
    const td_level *level = grid->levels;
    while (at >= level->first + level->count) {
        level++;
    }
    return level;
}

static bool follow(thud_world *w, td_proxy_set *grid, const int *moved, int count) {
    if (!grid->loose) {
        return false;
    }
    const int32_t *spot = grid->spot.data, *anchor_x = grid->anchor_x.data;
    const int32_t *anchor_y = grid->anchor_y.data;
    grid->moved_count = 0;
    for (int i = 0; i < count; i++) {
        if (td_body_at(w, td_shape_at(w, moved[i])->body)->awake.at <= 0) {
            continue;
        }
        const td_bounds *b = td_fat_at(w, moved[i]);
        int at = spot[moved[i]];
        const td_level *level = level_at(grid, at);
        if (extent_of(b) + 2 + 2 * (int64_t)level->slack > level->cell ||
            !near_anchor(anchor_x[at], b->min_x, b->max_x, level->slack) ||
            !near_anchor(anchor_y[at], b->min_y, b->max_y, level->slack)) {
            return false;
        }
        ((int32_t *)grid->min_x.data)[at] = b->min_x;
        ((int32_t *)grid->min_y.data)[at] = b->min_y;
        ((int32_t *)grid->max_x.data)[at] = b->max_x;
        ((int32_t *)grid->max_y.data)[at] = b->max_y;
        ((int32_t *)grid->moved.data)[at] = -1;
        grid->moved_count++;
    }
    grid->valid = true;
    return true;
}

const thud_broadphase thud_broadphase_grid = {
    .name = "grid",
    .build = build,
    .follow = follow,
    .sweep = TD_BOTH_WIDE(td_grid_sweep),
    .find = TD_BOTH_WIDE(td_grid_find),
};
