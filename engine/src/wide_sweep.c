/* wide_sweep.c: finding the overlapping bounds of a grid, eight at a time.
 *
 * Bounds overlap where none of four differences is negative, so one sign bit a lane decides. Hits
 * come in the order of the grid, which is the order of places, not of addresses. */
#include "block.h"
#include "grid.h"

typedef struct scan {
    const td_grid *grid;
    const int32_t *ids, *min_x, *min_y, *max_x, *max_y, *moved, *starts;
    td_memory *memory;
    td_array *hits;
    i8 box_min_x, box_min_y, box_max_x, box_max_y;
    i8 heed; /* -1: report every overlap; 0: only with shapes that moved */
} scan;

TD_INLINE scan begin(const td_grid *grid, td_memory *memory, td_array *hits)
{
    return (scan){.grid = grid,
                  .ids = grid->ids.data,
                  .min_x = grid->min_x.data,
                  .min_y = grid->min_y.data,
                  .max_x = grid->max_x.data,
                  .max_y = grid->max_y.data,
                  .moved = grid->moved.data,
                  .starts = grid->starts.data,
                  .memory = memory,
                  .hits = hits};
}

TD_INLINE void set_box(scan *s, const td_bounds *b, int32_t heed)
{
    s->box_min_x = i8_all(b->min_x);
    s->box_min_y = i8_all(b->min_y);
    s->box_max_x = i8_all(b->max_x);
    s->box_max_y = i8_all(b->max_y);
    s->heed = i8_all(heed);
}

TD_INLINE td_bounds bounds_at(const scan *s, int i)
{
    return (td_bounds){s->min_x[i], s->min_y[i], s->max_x[i], s->max_y[i]};
}

/* Overlapping lanes among the eight from `at` on. */
TD_INLINE unsigned test(const scan *s, int at)
{
    i8 apart = i8_wrap_sub(s->box_max_x, i8_load(s->min_x + at)) |
               i8_wrap_sub(i8_load(s->max_x + at), s->box_min_x) |
               i8_wrap_sub(s->box_max_y, i8_load(s->min_y + at)) |
               i8_wrap_sub(i8_load(s->max_y + at), s->box_min_y);
    return i8_bits(~apart & (s->heed | i8_load(s->moved + at)));
}

/* Reports (`first`, hit) pairs when first is a shape, else hits alone. */
TD_INLINE bool scan_range(scan *s, int from, int to, int first)
{
    int needed = s->hits->count + 2 * (to - from) + 2 * TD_LANES;
    if (needed > s->hits->capacity && !td_array_reserve(s->memory, s->hits, needed)) {
        return false;
    }
    int32_t *out = (int32_t *)s->hits->data + s->hits->count;
    for (int at = from; at < to; at += TD_LANES) {
        unsigned bits = test(s, at);
        if (to - at < TD_LANES) {
            bits &= (1u << (to - at)) - 1u;
        }
        for (; bits; bits &= bits - 1) {
            if (first != TD_NONE) {
                *out++ = first;
            }
            *out++ = s->ids[at + __builtin_ctz(bits)];
        }
    }
    s->hits->count = (int)(out - (int32_t *)s->hits->data);
    return true;
}

/* Cells cell .. cell + n - 1 of a level, around the end of its table. */
TD_INLINE bool scan_cells(scan *s, const td_level *level, uint32_t cell, uint32_t n, int first)
{
    const int32_t *starts = s->starts + level->starts;
    uint32_t table = level->mask + 1;
    cell &= level->mask;
    if (cell + n <= table) {
        return scan_range(s, starts[cell], starts[cell + n], first);
    }
    return scan_range(s, starts[cell], starts[table], first) &&
           scan_range(s, starts[0], starts[cell + n - table], first);
}

/* Against the levels of larger shapes: three rows of three cells each. */
TD_INLINE bool scan_coarser(scan *s, int own_level, int64_t x, int64_t y, int first)
{
    const td_grid *grid = s->grid;
    for (int l = own_level + 1; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (!level->count) {
            continue;
        }
        int64_t column = td_grid_index(x, grid->origin_x, level->inv_cell);
        int64_t row = td_grid_index(y, grid->origin_y, level->inv_cell);
        for (int64_t r = row - 1; r <= row + 1; r++) {
            if (!scan_cells(s, level, td_grid_cell(level, column - 1, r), 3, first)) {
                return false;
            }
        }
    }
    return true;
}

static int coarsest_level(const td_grid *grid)
{
    int last = TD_LEVELS - 1;
    while (last > 0 && !grid->levels[last].count) {
        last--;
    }
    return last;
}

td_grid_sweep_fn TD_WIDE(td_grid_sweep);
bool TD_WIDE(td_grid_sweep)(const td_grid *grid, td_memory *memory, const td_stance *stance,
                            td_array *hits)
{
    scan s = begin(grid, memory, hits);
    const int32_t *cells = grid->cells.data;
    int coarsest = coarsest_level(grid);
    for (int l = 0; l <= coarsest; l++) {
        const td_level *level = &grid->levels[l];
        const int32_t *starts = s.starts + level->starts;
        for (int i = level->first; i < level->first + level->count; i++) {
            td_bounds b = bounds_at(&s, i);
            uint32_t cell = (uint32_t)cells[i];
            set_box(&s, &b, s.moved[i]);
            /* The rest of its own cell and the next one; then the row above. */
            bool wraps = cell == level->mask;
            if (!scan_range(&s, i + 1, starts[cell + (wraps ? 1 : 2)], s.ids[i]) ||
                (wraps && !scan_range(&s, starts[0], starts[1], s.ids[i])) ||
                !scan_cells(&s, level, cell + level->row - 1, 3, s.ids[i])) {
                return false;
            }
            if (l < coarsest) {
                const td_place *at = &stance[s.ids[i]].center;
                int64_t x = td_unwrap(b.min_x, at->x) + td_wrap_sub(b.max_x, b.min_x) / 2;
                int64_t y = td_unwrap(b.min_y, at->y) + td_wrap_sub(b.max_y, b.min_y) / 2;
                if (!scan_coarser(&s, l, x, y, s.ids[i])) {
                    return false;
                }
            }
        }
    }
    return true;
}

static bool query_level(scan *s, const td_level *level, const td_bounds *b, td_place near_position)
{
    const td_grid *grid = s->grid;
    if (level->count <= TD_LANES) { /* one test is cheaper than finding the cells */
        return scan_range(s, level->first, level->first + level->count, TD_NONE);
    }
    int64_t half = level->cell / 2 + 1;
    int64_t c0 = td_grid_index(td_unwrap(b->min_x, near_position.x) - half, grid->origin_x,
                               level->inv_cell);
    int64_t c1 = td_grid_index(td_unwrap(b->max_x, near_position.x) + half, grid->origin_x,
                               level->inv_cell);
    int64_t r0 = td_grid_index(td_unwrap(b->min_y, near_position.y) - half, grid->origin_y,
                               level->inv_cell);
    int64_t r1 = td_grid_index(td_unwrap(b->max_y, near_position.y) + half, grid->origin_y,
                               level->inv_cell);
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
    /* Hashed rows may fall onto each other, so a window of more than three is searched whole. */
    if (c1 - c0 + 1 > level->count || r1 - r0 + 1 > level->count ||
        (level->hashed && (r1 - r0 > 2 || c1 - c0 > 2))) {
        return scan_range(s, level->first, level->first + level->count, TD_NONE);
    }
    for (int64_t r = r0; r <= r1; r++) {
        if (!scan_cells(s, level, td_grid_cell(level, c0, r), (uint32_t)(c1 - c0 + 1), TD_NONE)) {
            return false;
        }
    }
    return true;
}

td_grid_query_fn TD_WIDE(td_grid_query);
bool TD_WIDE(td_grid_query)(const td_grid *grid, td_memory *memory, const td_bounds *bounds,
                            td_place near_position, td_array *hits)
{
    scan s = begin(grid, memory, hits);
    set_box(&s, bounds, -1);
    for (int l = 0; l < TD_LEVELS; l++) {
        if (grid->levels[l].count && !query_level(&s, &grid->levels[l], bounds, near_position)) {
            return false;
        }
    }
    return true;
}
