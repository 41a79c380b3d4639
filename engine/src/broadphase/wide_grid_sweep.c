/* wide_grid_sweep.c: finding the overlapping bounds of a grid. Hits come in the order of the grid,
 * which is the order of places, not of addresses. */
#include "broadphase/wide_scan.h"

/* A level of so few is searched whole, which costs less than finding the cells. */
enum { FEW = 2 * TD_LANES };

/* A hashed level is searched whole where more rows are asked for. */
enum { MOST_ROWS = 16 };

/* Cells cell .. cell + n - 1 of a level, around the end of its table. */
TD_INLINE bool scan_cells(scan *s, const td_level *level, uint32_t cell, uint32_t n, heed which) {
    const int32_t *starts = s->starts + level->starts;
    uint32_t table = level->mask + 1;
    cell &= level->mask;
    bool around = cell + n > table;
    if (!room(s, around ? level->count : starts[cell + n] - starts[cell])) {
        return false;
    }
    if (!around) {
        scan_span(s, starts[cell], starts[cell + n], which);
        return true;
    }
    scan_span(s, starts[cell], starts[table], which);
    scan_span(s, starts[0], starts[cell + n - table], which);
    return true;
}

TD_INLINE bool scan_level(scan *s, const td_level *level, heed which) {
    if (!room(s, level->count)) {
        return false;
    }
    scan_span(s, level->first, level->first + level->count, which);
    return true;
}

/* The rest of a shape's cell and the next one, and the row above; so that each pair comes once.
 * Where the table's end does not lie between them. */
TD_INLINE bool scan_forward(scan *s, const int32_t *starts, int i, uint32_t cell, uint32_t above,
                            heed which) {
    int end = starts[cell + 2], first = starts[above], last = starts[above + 3];
    if (!room(s, end - i + last - first)) {
        return false;
    }
    scan_span(s, i + 1, end, which);
    scan_span(s, first, last, which);
    return true;
}

/* The same anywhere, or the other half of the neighbourhood. */
TD_INLINE bool scan_half(scan *s, const td_level *level, int i, uint32_t cell, bool forward,
                         heed which) {
    const int32_t *starts = s->starts + level->starts + cell;
    int from = forward ? i + 1 : starts[0], to = forward ? starts[1] : i;
    if (!room(s, to - from)) {
        return false;
    }
    scan_span(s, from, to, which);
    uint32_t beside = forward ? cell + 1 : cell - 1, n = 1;
    for (int k = 0; k < 2; k++) {
        if (!scan_cells(s, level, beside, n, which)) {
            return false;
        }
        beside = (forward ? cell + level->row : cell - level->row) - 1;
        n = 3;
    }
    return true;
}

/* A level of larger shapes: three rows of three cells each, about a centre, which is given relative
 * to the origin, and not below it. */
TD_INLINE bool scan_coarser(scan *s, const td_level *level, double x, double y, heed which) {
    if (level->count <= FEW) {
        return scan_level(s, level, which);
    }
    int64_t column = (int64_t)(x * level->inv_cell), row = (int64_t)(y * level->inv_cell);
    for (int64_t r = row - 1; r <= row + 1; r++) {
        if (!scan_cells(s, level, td_grid_cell(level, column - 1, r), 3, which)) {
            return false;
        }
    }
    return true;
}

/* Whether rows of a hashed level fall onto each other, so that a shape could be found twice. Those
 * of a window of three by three never do. */
TD_INLINE bool rows_meet(const td_level *level, int64_t column, int64_t row, uint32_t n,
                         int64_t rows) {
    if (n <= 3 && rows <= 3) {
        return false;
    }
    if (rows > MOST_ROWS || n > (level->mask + 1) / 2) {
        return true;
    }
    uint32_t first[MOST_ROWS];
    for (int i = 0; i < rows; i++) {
        first[i] = td_grid_cell(level, column, row + i);
        for (int k = 0; k < i; k++) {
            uint32_t apart = (first[i] - first[k]) & level->mask;
            if (apart < n || level->mask + 1 - apart < n) {
                return true;
            }
        }
    }
    return false;
}

/* Any level, by the cells that the bounds reach. */
TD_INLINE bool scan_window(scan *s, const td_level *level, const td_bounds *b,
                           td_position near_position, heed which) {
    const td_proxy_set *grid = s->set;
    if (level->count <= FEW) {
        return scan_level(s, level, which);
    }
    int64_t half = level->cell / 2 + 1;
    int64_t x0 = td_unwrap(b->min_x, near_position.x) - half;
    int64_t y0 = td_unwrap(b->min_y, near_position.y) - half;
    int64_t x1 = td_unwrap(b->max_x, near_position.x) + half;
    int64_t y1 = td_unwrap(b->max_y, near_position.y) + half;
    if (x0 > level->most_x || x1 < level->least_x || y0 > level->most_y || y1 < level->least_y) {
        return true;
    }
    int64_t c0 = td_grid_index(x0, grid->origin_x, level->inv_cell);
    int64_t c1 = td_grid_index(x1, grid->origin_x, level->inv_cell);
    int64_t r0 = td_grid_index(y0, grid->origin_y, level->inv_cell);
    int64_t r1 = td_grid_index(y1, grid->origin_y, level->inv_cell);
    if (!level->hashed) {
        int64_t columns = level->row, rows = (int64_t)(level->mask + 1) / columns;
        c0 = c0 < 0 ? 0 : c0;
        r0 = r0 < 0 ? 0 : r0;
        c1 = c1 > columns - 2 ? columns - 2 : c1;
        r1 = r1 > rows - 2 ? rows - 2 : r1;
    }
    if (c1 < c0 || r1 < r0) {
        return true;
    }
    if (c1 - c0 + 1 > level->count || r1 - r0 + 1 > level->count ||
        (level->hashed && rows_meet(level, c0, r0, (uint32_t)(c1 - c0 + 1), r1 - r0 + 1))) {
        return scan_level(s, level, which);
    }
    for (int64_t r = r0; r <= r1; r++) {
        if (!scan_cells(s, level, td_grid_cell(level, c0, r), (uint32_t)(c1 - c0 + 1), which)) {
            return false;
        }
    }
    return true;
}

/* The levels that are not the shape's own. */
TD_INLINE bool scan_others(scan *s, int own, int i, td_position near_position, bool every) {
    const td_proxy_set *grid = s->set;
    td_bounds b = bounds_at(s, i);
    double x = (double)(td_unwrap(td_middle(b.min_x, b.max_x), near_position.x) - grid->origin_x);
    double y = (double)(td_unwrap(td_middle(b.min_y, b.max_y), near_position.y) - grid->origin_y);
    for (int l = every ? own + 1 : 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (l == own || !level->count) {
            continue;
        }
        heed which = s->moved[i] ? HEED_ALL : HEED_MOVED;
        bool done = l < own ? scan_window(s, level, &b, near_position, HEED_UNMOVED)
                            : scan_coarser(s, level, x, y, which);
        if (!done) {
            return false;
        }
    }
    return true;
}

static int levels_in_use(const td_proxy_set *grid) {
    int used = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        used += grid->levels[l].count > 0;
    }
    return used;
}

td_sweep_fn TD_WIDE(td_grid_sweep);
bool TD_WIDE(td_grid_sweep)(const td_proxy_set *grid, td_memory *memory,
                            const td_shape_proxy *proxy, bool every, td_array *hits,
                            td_hits_fn *tell, void *context) {
    scan s = begin_scan(grid, memory, hits);
    const int32_t *cells = grid->cells.data;
    bool one_level = levels_in_use(grid) == 1;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (level->count == 0) {
            continue;
        }
        const int32_t *starts = s.starts + level->starts;
        for (int i = level->first; i < level->first + level->count; i++) {
            if (!every && !s.moved[i]) {
                continue;
            }
            td_bounds b = bounds_at(&s, i);
            set_box(&s, &b);
            uint32_t cell = (uint32_t)cells[i], above = (cell + level->row - 1) & level->mask;
            bool whole = cell < level->mask && above + 3 <= level->mask + 1, done = true;
            if (whole) {
                done = s.moved[i] ? scan_forward(&s, starts, i, cell, above, HEED_ALL)
                                  : scan_forward(&s, starts, i, cell, above, HEED_MOVED);
            }
            for (int back = whole; back <= !every && done; back++) {
                heed which = back ? HEED_UNMOVED : s.moved[i] ? HEED_ALL : HEED_MOVED;
                done = scan_half(&s, level, i, cell, !back, which);
            }
            if (!done || (!one_level && !scan_others(&s, l, i, proxy[s.ids[i]].center, every)) ||
                !tell_hits(&s, i, tell, context)) {
                return false;
            }
        }
    }
    return true;
}

td_find_fn TD_WIDE(td_grid_find);
bool TD_WIDE(td_grid_find)(const td_proxy_set *grid, td_memory *memory, const td_bounds *bounds,
                           td_position near_position, td_array *hits) {
    scan s = begin_scan(grid, memory, hits);
    set_box(&s, bounds);
    /* Levels in use follow each other, the last one first. */
    for (int l = TD_LEVELS - 1; l >= 0 && grid->levels[l].count; l--) {
        if (!scan_window(&s, &grid->levels[l], bounds, near_position, HEED_ALL)) {
            return false;
        }
    }
    count_hits(&s);
    return true;
}
