/* wide_grid_sweep.c: finds the overlapping bounds of a grid (grid.h).
 *
 * In its own level, a shape searches the forward half of the 3 x 3 cells around its cell: the rest
 * of its own cell, the next cell, and three cells of the row above. So each pair is found once.
 * Where only moved shapes search, a moved shape also searches the other half, but only for shapes
 * that have not moved, since these do not search themselves.
 *
 * In a coarser level, it searches the cells within reach of its centre. In a finer level, it
 * searches all cells that its bounds overlap, after growing them by half a cell. */
#include "broadphase/wide_scan.h"

/* A level with this many shapes or fewer is tested whole. That takes two tests of eight, fewer than
 * a search by cells. The level of the strays (grid.h: shapes that came to rest while the grid stays
 * sorted) has no cells and must always be tested whole. */
enum { SCAN_WHOLE_MAX = 2 * TD_LANES };
static_assert((int)TD_STRAYS_MAX <= (int)SCAN_WHOLE_MAX, "strays are tested whole");

/* Rows of a hashed level up to which a window is searched by cells, and above which the whole level
 * is tested. Chosen; not tuned. */
enum { HASHED_ROWS_MAX = 64 };

/* Tests the shapes in the cells cell .. cell + n - 1 of a level, modulo its table. False
 * when memory is short, as all functions here that are named scan. */
TD_INLINE bool scan_cells(scan *s, const td_level *level, uint32_t cell, uint32_t n,
                          scan_filter which) {
    const int32_t *starts = s->starts + level->starts;
    uint32_t table = level->mask + 1;
    cell &= level->mask;
    bool around = cell + n > table;
    if (!reserve_hits(s, around ? level->count : starts[cell + n] - starts[cell])) {
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

/* Tests the shapes in `rows` rows of n cells, the first from (column, row) on. */
TD_INLINE bool scan_rows(scan *s, const td_level *level, int64_t column, int64_t row, uint32_t n,
                         int64_t rows, scan_filter which) {
    uint32_t cell = td_grid_cell(level, column, row);
    for (; rows > 0; rows--, cell += level->row) {
        if (!scan_cells(s, level, cell, n, which)) {
            return false;
        }
    }
    return true;
}

/* Tests all shapes of a level. */
TD_INLINE bool scan_level(scan *s, const td_level *level, scan_filter which) {
    if (!reserve_hits(s, level->count)) {
        return false;
    }
    scan_span(s, level->first, level->first + level->count, which);
    return true;
}

/* Tests the forward half of the neighbourhood of the i-th shape: what follows it in its cell, the
 * next cell, and the three cells from `above` on. The caller makes sure that none of these cells
 * wraps around the table's end. */
TD_INLINE bool scan_forward(scan *s, const int32_t *starts, int i, uint32_t cell, uint32_t above,
                            scan_filter which) {
    int end = starts[cell + 2], first = starts[above], last = starts[above + 3];
    if (!reserve_hits(s, end - i + last - first)) {
        return false;
    }
    scan_span(s, i + 1, end, which);
    scan_span(s, first, last, which);
    return true;
}

/* scan_forward where cells may wrap around the table's end; or, with `forward` false, the other
 * half of the neighbourhood: what precedes the shape in its cell, the cell before, and three cells
 * of the row below. */
TD_INLINE bool scan_half(scan *s, const td_level *level, int i, uint32_t cell, bool forward,
                         scan_filter which) {
    const int32_t *starts = s->starts + level->starts + cell;
    int from = forward ? i + 1 : starts[0], to = forward ? starts[1] : i;
    if (!reserve_hits(s, to - from)) {
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

/* Tests the shapes of a coarser level that can overlap a shape of the level `own`. (x, y) is the
 * centre of that shape, in bounds quanta from the grid's origin. Along each axis, the centres of
 * two such shapes are at most half a cell of the one level plus half a cell of the other apart.
 * These are mostly 2 x 2 cells, and never more than 3 x 3. In a hashed table, the rows share no
 * cell: of three consecutive rows, any two begin at least 0.23 of the table apart (0.382 and 0.236
 * are the distances of one and two times the golden ratio from whole numbers), and a table has 64
 * cells or more. */
TD_INLINE bool scan_coarser(scan *s, const td_level *level, const td_level *own, double x, double y,
                            scan_filter which) {
    if (level->count <= SCAN_WHOLE_MAX) {
        return scan_level(s, level, which);
    }
    /* Half the width of a cell covers half the greatest extent, the slack, and a quantum for
     * rounding. A column or row between -1 and 0 is truncated to 0, where the first cells are. */
    double reach = 0.5 * (double)(level->cell + own->cell), inv_cell = level->inv_cell;
    int64_t column = (int64_t)((x - reach) * inv_cell), row = (int64_t)((y - reach) * inv_cell);
    int64_t columns = (int64_t)((x + reach) * inv_cell) - column + 1;
    int64_t rows = (int64_t)((y + reach) * inv_cell) - row + 1;
    return scan_rows(s, level, column, row, (uint32_t)columns, rows, which);
}

/* Whether two of `rows` successive rows of n cells may share cells of a hashed table, so that a
 * shape could be found twice. Also true where there are too many rows to check, or a row covers
 * more than half of the table. Each row begins level->row cells after the one before, modulo the
 * table's length. */
TD_INLINE bool rows_may_overlap(const td_level *level, uint32_t n, int64_t rows) {
    if (rows > HASHED_ROWS_MAX || n > (level->mask + 1) / 2) {
        return true;
    }
    uint32_t apart = 0;
    for (int64_t i = 1; i < rows; i++) {
        apart = (apart + level->row) & level->mask;
        if (apart < n || level->mask + 1 - apart < n) {
            return true;
        }
    }
    return false;
}

/* Tests the shapes of one level of the grid whose centres lie within half a cell of the bounds `b`.
 * The cells of a level are wide enough (grid.h) that no other shape of it can overlap these bounds.
 * `near_position` is a position near the bounds, by which their coordinates, which wrap around, are
 * unwrapped. Tests the whole level where that is cheaper, or where cells would be visited twice. */
TD_INLINE bool scan_window(scan *s, const td_level *level, const td_bounds *b,
                           td_position near_position, scan_filter which) {
    const td_proxy_set *grid = s->set;
    if (level->count <= SCAN_WHOLE_MAX) {
        return scan_level(s, level, which);
    }
    int64_t half = level->cell / 2 + 1;
    int64_t x0 = td_unwrap(b->min_x, near_position.x) - half;
    int64_t y0 = td_unwrap(b->min_y, near_position.y) - half;
    int64_t x1 = td_unwrap(b->max_x, near_position.x) + half;
    int64_t y1 = td_unwrap(b->max_y, near_position.y) + half;
    if (x0 > grid->end_x || x1 < grid->origin_x || y0 > grid->end_y || y1 < grid->origin_y) {
        return true;
    }
    /* No centre was below the origin when the grid was sorted, and a shape that has moved there
     * since keeps its cell: so the window may be cut off at 0. */
    int64_t c0 = td_grid_index(x0 < grid->origin_x ? 0 : x0 - grid->origin_x, level->inv_cell);
    int64_t r0 = td_grid_index(y0 < grid->origin_y ? 0 : y0 - grid->origin_y, level->inv_cell);
    int64_t c1 = td_grid_index(x1 - grid->origin_x, level->inv_cell);
    int64_t r1 = td_grid_index(y1 - grid->origin_y, level->inv_cell);
    /* level->row counts the empty columns on both sides, so that columns - 2 is the empty column
     * after the last one. Row r ends at cell (r + 2) * columns - 1, which must be in the table. */
    if (!level->hashed) {
        int64_t columns = level->row, cells = (int64_t)level->mask + 1;
        c1 = c1 > columns - 2 ? columns - 2 : c1;
        if ((r1 + 2) * columns > cells) { /* rare; without this test every search would divide */
            r1 = cells / columns - 2;
        }
    }
    if (c1 < c0) {
        return true;
    }
    if (c1 - c0 + 1 > level->count || r1 - r0 + 1 > level->count ||
        (level->hashed && rows_may_overlap(level, (uint32_t)(c1 - c0 + 1), r1 - r0 + 1))) {
        return scan_level(s, level, which);
    }
    return scan_rows(s, level, c0, r0, (uint32_t)(c1 - c0 + 1), r1 - r0 + 1, which);
}

/* Sets, for each level, a bit for each other level that its shapes search. Where only moved shapes
 * search, each searches all levels. Where every shape searches, each pair of levels is searched
 * from one side only: the side that tests fewer rows of cells in total. A shape of the finer level
 * tests about two rows of the coarser one; a shape of the coarser level tests as many rows of the
 * finer one as its window covers, where its extent is taken as a third of the level's greatest.
 * Chosen, for worlds in which small shapes are more frequent. */
TD_INLINE void choose_searches(const td_level *levels, bool every, uint32_t *searches) {
    __builtin_memset(searches, 0, TD_LEVELS * sizeof *searches);
    for (int fine = 0; fine < TD_LEVELS; fine++) {
        for (int coarse = fine + 1; coarse < TD_LEVELS && levels[fine].count; coarse++) {
            const td_level *f = &levels[fine], *c = &levels[coarse];
            int64_t rows = c->count * (c->cell / (3 * f->cell) + 2);
            bool from_coarse = 2 * (int64_t)f->count > rows;
            searches[fine] |= c->count && !(every && from_coarse) ? 1u << coarse : 0;
            searches[coarse] |= c->count && !(every && !from_coarse) ? 1u << fine : 0;
        }
    }
}

/* Tests the i-th shape, of the level `own`, against the other levels whose bits are in `searches`.
 * `every`: every shape of the set searches, and each pair of levels is searched from one side only,
 * so that any pair is found once. Otherwise only moved shapes search, in all levels: in finer
 * levels they are tested against shapes that have not moved only, since a moved shape of a finer
 * level finds the pair itself. A pair of which no shape has moved is never reported. */
TD_INLINE bool scan_other_levels(scan *s, int own, int i, td_position near_position, bool every,
                                 uint32_t searches) {
    const td_proxy_set *grid = s->set;
    td_bounds b = bounds_at(s, i);
    double x = (double)(td_unwrap(td_middle(b.min_x, b.max_x), near_position.x) - grid->origin_x);
    double y = (double)(td_unwrap(td_middle(b.min_y, b.max_y), near_position.y) - grid->origin_y);
    scan_filter which = s->moved[i] ? SCAN_ALL : SCAN_MOVED;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (!(searches >> l & 1)) {
            continue;
        }
        bool done = l < own ? scan_window(s, level, &b, near_position, every ? which : SCAN_UNMOVED)
                            : scan_coarser(s, level, &grid->levels[own], x, y, which);
        if (!done) {
            return false;
        }
    }
    return true;
}

td_sweep_fn TD_WIDE(td_grid_sweep);
bool TD_WIDE(td_grid_sweep)(const td_proxy_set *grid, td_memory *memory,
                            const td_shape_proxy *proxy, td_array *hits, td_hits_fn *report,
                            void *context, int64_t *tested) {
    scan s = begin_scan(grid, memory, hits);
    const int32_t *cells = grid->cells.data;
    bool every = td_sweeps_every(grid);
    uint32_t searches[TD_LEVELS];
    choose_searches(grid->levels, every, searches);
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (level->count == 0) {
            continue;
        }
        const int32_t *starts = s.starts + level->starts;
        int stop = td_min_int(grid->ids.count - grid->tail, level->first + level->count);
        for (int i = td_max_int(grid->head, level->first); i < stop; i++) {
            if (!every && !s.moved[i]) {
                continue;
            }
            td_bounds b = bounds_at(&s, i);
            set_query(&s, &b);
            uint32_t cell = (uint32_t)cells[i], above = (cell + level->row - 1) & level->mask;
            bool whole = cell < level->mask && above + 3 <= level->mask + 1, done = true;
            if (whole) {
                done = s.moved[i] ? scan_forward(&s, starts, i, cell, above, SCAN_ALL)
                                  : scan_forward(&s, starts, i, cell, above, SCAN_MOVED);
            }
            for (int back = whole; back <= !every && done; back++) {
                scan_filter which = back ? SCAN_UNMOVED : s.moved[i] ? SCAN_ALL : SCAN_MOVED;
                done = scan_half(&s, level, i, cell, !back, which);
            }
            if (!done ||
                (searches[l] &&
                 !scan_other_levels(&s, l, i, proxy[s.ids[i]].center, every, searches[l])) ||
                !report_hits(&s, i, report, context)) {
                *tested += s.tested;
                return false;
            }
        }
    }
    *tested += s.tested;
    return true;
}

/* Removes, from index `first` on, the hits that are shapes which have left the set (TD_NONE). Their
 * bounds are inverted (td_proxy_set_drop_woken), so that they overlap only bounds that reach a
 * quarter of the range of bounds. Only the set of resting shapes has such entries, and that set is
 * searched by td_grid_find alone, never swept. */
static void drop_left(td_array *hits, int first) {
    int *data = hits->data, count = first;
    for (int i = first; i < hits->count; i++) {
        data[count] = data[i];
        count += data[i] != TD_NONE;
    }
    hits->count = count;
}

td_find_fn TD_WIDE(td_grid_find);
bool TD_WIDE(td_grid_find)(const td_proxy_set *grid, td_memory *memory, const td_bounds *bounds,
                           td_position near_position, td_array *hits, int64_t *tested) {
    scan s = begin_scan(grid, memory, hits);
    int first = hits->count;
    set_query(&s, bounds);
    /* The levels in use stand at the end of the array without gaps, so that the search ends at the
     * first empty one. */
    for (int l = TD_LEVELS - 1; l >= 0 && grid->levels[l].count; l--) {
        if (!scan_window(&s, &grid->levels[l], bounds, near_position, SCAN_ALL)) {
            return false;
        }
    }
    count_hits(&s);
    drop_left(hits, first);
    if (tested) {
        *tested += s.tested;
    }
    return true;
}
