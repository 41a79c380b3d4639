/* grid.c: builds the hierarchical grid of grid.h by a counting sort, and updates it in place while
 * few shapes move. Within a cell shapes keep the order of the list, and columns and rows count from
 * the least centre of the proxy set, so that a translated world is sorted in the same order.
 * wide_grid.c and wide_grid_sweep.c have the loops that take eight shapes at a time. */
#include "broadphase/proxy_set.h"

#include "state/kinds.h"
#include "state/world.h"

#include <string.h>

/* The larger of width and height, bounds quanta. */
static int32_t extent_of(const td_bounds *b) {
    return td_max_int(td_wrap_sub(b->max_x, b->min_x), td_wrap_sub(b->max_y, b->min_y));
}

/* The size class of an extent: see TD_SIZE_SHIFT. */
static int size_class_of(int32_t extent) {
    float f = (float)td_max_int(extent, 1);
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return (int)(bits >> TD_SIZE_SHIFT) - TD_SIZE_OF_ONE;
}

/* Assigns size classes to levels, from the last level down: each takes the largest class that is
 * left and the eleven below it, which is an eightfold range, so that like sizes share a level.
 * Returns the lowest level in use. */
static int choose_levels(const int *has_size, uint8_t *level_of_size) {
    int level = TD_LEVELS, min_size = TD_SIZE_CLASSES;
    for (int size = TD_SIZE_CLASSES - 1; size >= 0; size--) {
        if (has_size[size] && size < min_size && level > 0) {
            level--;
            min_size = size - 11;
        }
        level_of_size[size] = (uint8_t)level;
    }
    return level;
}

/* The width of cells that the world sets, bounds quanta; 0 for none. */
static int32_t own_cell(const thud_world *w) {
    return (int32_t)((double)w->def.cell_size * w->to_coarse);
}

/* Sets has_size anew for the shapes whose extent is above `own`, the cell width that the world
 * sets. All smaller shapes share one level, whose cells have that width. */
static void drop_small(td_grid_measures *m, int32_t own) {
    memset(m->has_size, 0, sizeof m->has_size);
    for (int i = 0; i < m->count; i++) {
        if (m->extent[i] > own) {
            m->has_size[size_class_of(m->extent[i])] = 1;
        }
    }
}

/* Does what td_grid_measure does, but with 64-bit differences and one shape at a time, so that the
 * centres may be any distance apart. */
static void measure_one_by_one(const thud_world *w, td_grid_measures *m) {
    int64_t ref_x = td_shape_proxy_at(w, m->list[0])->center.x >> TD_COARSE_SHIFT;
    int64_t ref_y = td_shape_proxy_at(w, m->list[0])->center.y >> TD_COARSE_SHIFT;
    m->min_x = m->min_y = 0x1p62;
    m->max_x = m->max_y = -0x1p62;
    memset(m->has_size, 0, sizeof m->has_size);
    for (int i = 0; i < m->count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, m->list[i]);
        const td_bounds *b = &proxy->fat;
        double x = (double)(td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x) - ref_x);
        double y = (double)(td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y) - ref_y);
        m->x[i] = x;
        m->y[i] = y;
        m->extent[i] = extent_of(b);
        m->min_x = x < m->min_x ? x : m->min_x;
        m->min_y = y < m->min_y ? y : m->min_y;
        m->max_x = x > m->max_x ? x : m->max_x;
        m->max_y = y > m->max_y ? y : m->max_y;
        m->has_size[size_class_of(m->extent[i])] = 1;
    }
}

/* Measures all shapes, sets the range of the whole set, and assigns each shape to a level, whose
 * count and greatest extent (in `cell`) are updated. */
static void measure(const thud_world *w, td_proxy_set *grid, td_grid_measures *m) {
    uint8_t level_of_size[TD_SIZE_CLASSES];
    if (!TD_PICK_WIDE(w, td_grid_measure)(w->proxy.data, m)) {
        measure_one_by_one(w, m);
    }
    const td_position *first = &td_shape_proxy_at(w, m->list[0])->center;
    int64_t ref_x = first->x >> TD_COARSE_SHIFT, ref_y = first->y >> TD_COARSE_SHIFT;
    grid->origin_x = ref_x + (int64_t)m->min_x;
    grid->origin_y = ref_y + (int64_t)m->min_y;
    grid->end_x = ref_x + (int64_t)m->max_x;
    grid->end_y = ref_y + (int64_t)m->max_y;
    int32_t own = own_cell(w);
    if (own > 0) {
        drop_small(m, own);
    }
    int lowest = choose_levels(m->has_size, level_of_size), own_level = lowest - 1;
    if (lowest == TD_LEVELS - 1 && own <= 0) {
        int32_t widest = 0;
        for (int i = 0; i < m->count; i++) {
            widest = td_max_int(widest, m->extent[i]);
        }
        memset(m->level, lowest, (size_t)m->count);
        grid->levels[lowest].count = m->count;
        grid->levels[lowest].cell = widest;
        return;
    }
    for (int i = 0; i < m->count; i++) {
        bool small = m->extent[i] <= own;
        m->level[i] = small ? (uint8_t)own_level : level_of_size[size_class_of(m->extent[i])];
        td_level *level = &grid->levels[m->level[i]];
        int32_t width = small ? own : m->extent[i];
        level->cell = width > level->cell ? width : level->cell;
        level->count++;
    }
}

/* The least power of two that is not below n, and not below 64. */
static uint32_t table_size_for(int64_t n) {
    uint32_t p = 64;
    while (p < n) {
        p *= 2;
    }
    return p;
}

/* Sets each level's cell width and table; returns the length of `starts`. A level is hashed, with
 * at least two cells a shape, where its rectangle has more than twice as many cells as that table;
 * else its table holds the whole rectangle. Where few shapes moved, cells get a slack, by which
 * centres may move without leaving their cell (grid.h): half of the width that the cell has without
 * it. With more slack, cells hold more shapes, all of which are tested; with less, shapes leave
 * their cells sooner, and the grid has to be built again. This half and the factors of two are
 * chosen; not tuned. */
static int choose_tables(td_proxy_set *grid, bool few_moved) {
    int first = 0, starts = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        td_level *level = &grid->levels[l];
        level->first = first;
        level->starts = starts;
        if (!level->count) {
            continue;
        }
        level->slack = few_moved ? (int32_t)(level->cell / 2) : 0;
        level->cell += 2 + 2 * (int64_t)level->slack;
        /* Smaller than 1 / cell by 2^-16 of it, since rounding must never put shapes that overlap
         * two cells apart. 2 quanta of the width are for the rounding of the centres. */
        level->inv_cell = (1.0 - 1.0 / 65536.0) / (double)level->cell;
        /* One column more than the last index, and an empty one on each side (grid.h). */
        int64_t columns = td_grid_index(grid->end_x - grid->origin_x, level->inv_cell) + 3;
        int64_t rows = td_grid_index(grid->end_y - grid->origin_y, level->inv_cell) + 3;
        uint32_t table = table_size_for(2 * (int64_t)level->count);
        int64_t max = 2 * (int64_t)table;
        level->hashed = columns > max || rows > max || columns * rows > max;
        if (level->hashed) {
            /* The table's length over the golden ratio, made odd (Fibonacci hashing, grid.h). */
            level->row = (uint32_t)((double)table * 0.6180339887498949) | 1;
        } else {
            table = table_size_for(columns * rows);
            level->row = (uint32_t)columns;
        }
        level->mask = table - 1;
        first += level->count;
        starts += (int)table + 1;
    }
    return starts;
}

/* Bytes of scratch.order for a shape: x and y, extent and cell, and the
 * level's byte rounded up to 8. */
enum { MEASURES_BYTES = 2 * (int)sizeof(double) + 2 * (int)sizeof(int32_t) + 8 };

/* Memory for the shapes in grid->list, and for updates in place where few moved. */
static bool reserve(thud_world *w, td_proxy_set *grid, bool few_moved) {
    int count = grid->list.count;
    w->scratch.order.stride = MEASURES_BYTES;
    return td_proxy_set_reserve(w, grid, count) &&
           td_array_reserve(&w->memory, &w->scratch.order, count + TD_LANES) &&
           (!few_moved || (td_array_reserve(&w->memory, &grid->index_of, w->shapes.count) &&
                           td_array_reserve(&w->memory, &grid->anchor_x, count) &&
                           td_array_reserve(&w->memory, &grid->anchor_y, count)));
}

/* Counting sort of `ids` and `cells` by level and cell. Stable. */
static void sort(td_proxy_set *grid, const td_grid_measures *m, int starts_count) {
    int *starts = grid->starts.data, *ids = grid->ids.data, *cells = grid->cells.data;
    int *level_starts[TD_LEVELS];
    for (int l = 0; l < TD_LEVELS; l++) {
        level_starts[l] = starts + grid->levels[l].starts;
    }
    memset(starts, 0, (size_t)starts_count * sizeof(int));
    for (int i = 0; i < m->count; i++) {
        level_starts[m->level[i]][m->cell[i]]++;
    }
    /* Prefix sums give the end of each cell. Then the cells are filled from the last shape down,
     * which lowers each of these numbers to the start of its cell. */
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        int sum = level->first, ends = level->count ? (int)level->mask + 2 : 0;
        for (int c = 0; c < ends; c++) {
            sum += level_starts[l][c];
            level_starts[l][c] = sum;
        }
    }
    for (int i = m->count - 1; i >= 0; i--) {
        int at = --level_starts[m->level[i]][m->cell[i]];
        ids[at] = m->list[i];
        cells[at] = m->cell[i];
    }
}

/* Stores each shape's index in `ids` and its centre, from which `follow` measures its motion. */
static void store_anchors(td_proxy_set *grid) {
    int32_t *index_of = grid->index_of.data, *anchor_x = grid->anchor_x.data;
    int32_t *anchor_y = grid->anchor_y.data;
    const int32_t *ids = grid->ids.data, *min_x = grid->min_x.data, *min_y = grid->min_y.data;
    const int32_t *max_x = grid->max_x.data, *max_y = grid->max_y.data;
    for (int i = 0; i < grid->ids.count; i++) {
        index_of[ids[i]] = i;
        anchor_x[i] = td_middle(min_x[i], max_x[i]);
        anchor_y[i] = td_middle(min_y[i], max_y[i]);
    }
}

/* The arrays of td_grid_measures within the scratch memory. */
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

/* thud_broadphase.build: measures, chooses levels and tables, sorts. */
static bool build(thud_world *w, td_proxy_set *grid, bool few_moved) {
    grid->valid = grid->loose = grid->woken = false;
    grid->moved_count = 0;
    memset(grid->levels, 0, sizeof grid->levels);
    if (!reserve(w, grid, few_moved)) {
        return false;
    }
    grid->ids.count = grid->list.count;
    if (grid->list.count == 0) {
        grid->valid = true;
        return true;
    }
    td_grid_measures m = measures_in(&w->scratch.order, &grid->list);
    measure(w, grid, &m);
    int starts_count = choose_tables(grid, few_moved);
    if (!td_array_reserve(&w->memory, &grid->starts, starts_count)) {
        memset(grid->levels, 0, sizeof grid->levels);
        return false;
    }
    TD_PICK_WIDE(w, td_grid_cells)(grid->levels, &m);
    sort(grid, &m, starts_count);
    grid->moved_count = TD_PICK_WIDE(w, td_proxy_set_fill)(grid, w->proxy.data, w->marks.data);
    if (few_moved) {
        store_anchors(grid);
    }
    grid->loose = few_moved;
    grid->valid = true;
    return true;
}

/* Whether the middle of a moved shape's bounds, along one axis, is within the slack of its anchor:
 * -slack <= drift <= slack, as one comparison of unsigned numbers. */
static bool is_near_anchor(int32_t anchor, int32_t low, int32_t high, int32_t slack) {
    uint32_t drift = (uint32_t)td_wrap_sub(td_middle(low, high), anchor);
    return drift + (uint32_t)slack <= 2u * (uint32_t)slack;
}

/* The level of the shape at an index of `ids`. */
static const td_level *level_at(const td_proxy_set *grid, int at) {
    const td_level *level = grid->levels;
    while (at >= level->first + level->count) {
        level++;
    }
    return level;
}

/* thud_broadphase.follow: writes the bounds of moved shapes in place, and flags them as moved.
 * False where the grid was not built for it, or a shape no longer fits its cell. */
static bool follow(thud_world *w, td_proxy_set *grid, const int *moved, int count) {
    if (!grid->loose) {
        return false;
    }
    const int32_t *index_of = grid->index_of.data, *anchor_x = grid->anchor_x.data;
    const int32_t *anchor_y = grid->anchor_y.data;
    grid->moved_count = 0;
    for (int i = 0; i < count; i++) {
        if (td_body_at(w, td_shape_at(w, moved[i])->body)->awake.at <= 0) {
            continue;
        }
        const td_bounds *b = td_fat_at(w, moved[i]);
        int at = index_of[moved[i]];
        const td_level *level = level_at(grid, at);
        if (extent_of(b) + 2 + 2 * (int64_t)level->slack > level->cell ||
            !is_near_anchor(anchor_x[at], b->min_x, b->max_x, level->slack) ||
            !is_near_anchor(anchor_y[at], b->min_y, b->max_y, level->slack)) {
            return false;
        }
        td_proxy_set_put(grid, at, b);
        ((int32_t *)grid->moved.data)[at] = -1;
        grid->moved_count++;
    }
    grid->valid = true;
    return true;
}

/* ---- shapes that come to rest ---- */

/* The level of the strays, the resting shapes that are in no cell (TD_STRAYS_MAX, grid.h). It is
 * the level below those with cells; its td_level.cell is 0, by which it is recognised. Null in an
 * empty grid. */
static td_level *level_of_strays(td_proxy_set *grid) {
    td_level *level = &grid->levels[TD_LEVELS - 1];
    while (level[-1].count > 0) {
        level--;
    }
    return level->count == 0 ? NULL : level->cell == 0 ? level : level - 1;
}

/* thud_broadphase.enter: adds the shape to the strays. False where there are too many of them, or
 * the shape is left of the first column or below the first row. */
static bool enter(thud_world *w, td_proxy_set *grid, int shape) {
    const td_shape_proxy *proxy = td_shape_proxy_at(w, shape);
    const td_bounds *b = &proxy->fat;
    td_level *strays = level_of_strays(grid);
    int64_t x = td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x);
    int64_t y = td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y);
    if (!strays || strays->count == TD_STRAYS_MAX || x < grid->origin_x || y < grid->origin_y) {
        return false;
    }
    grid->end_x = x > grid->end_x ? x : grid->end_x;
    grid->end_y = y > grid->end_y ? y : grid->end_y;
    int at = grid->ids.count++;
    strays->first = at - strays->count++;
    ((int32_t *)grid->ids.data)[at] = shape;
    ((int32_t *)grid->cells.data)[at] = ((int32_t *)grid->moved.data)[at] = 0;
    td_proxy_set_put(grid, at, b);
    return true;
}

const thud_broadphase thud_broadphase_grid = {
    .name = "grid",
    .build = build,
    .follow = follow,
    .enter = enter,
    .sweep = TD_BOTH_WIDE(td_grid_sweep),
    .find = TD_BOTH_WIDE(td_grid_find),
};
