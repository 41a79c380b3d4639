/* wide_sweep.c: filling a grid, and finding its overlapping bounds, eight at a time.
 *
 * Bounds overlap where none of four differences is negative, so one sign bit a lane decides. Hits
 * come in the order of the grid, which is the order of places, not of addresses. */
#include "grid.h"

#include <stddef.h>

/* ---- filling ---- */

/* Four ints of each of eight records, turned into four vectors. */
TD_INLINE void load_bounds(const td_stance *stance, const int32_t *ids, i8 out[4])
{
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)(const void *)&stance[ids[i]].fat;
    }
    td_rows rows =
        td_turn(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]), f8_two(r[3], r[7]));
    out[0] = (i8)rows.x;
    out[1] = (i8)rows.y;
    out[2] = (i8)rows.z;
    out[3] = (i8)rows.w;
}

td_grid_fill_fn TD_WIDE(td_grid_fill);
int TD_WIDE(td_grid_fill)(td_grid *grid, const td_stance *stance, const uint8_t *marks)
{
    int32_t *ids = grid->ids.data, *moved = grid->moved.data;
    int32_t *rows[4] = {grid->min_x.data, grid->min_y.data, grid->max_x.data, grid->max_y.data};
    int count = grid->ids.count, moved_count = 0;
    /* The last eight may reach beyond the end, where any shape will do. */
    for (int i = count; i < count + TD_LANES; i++) {
        ids[i] = ids[count - 1];
    }
    for (int i = 0; i < count; i += TD_LANES) {
        i8 bounds[4];
        load_bounds(stance, ids + i, bounds);
        for (int k = 0; k < 4; k++) {
            __builtin_memcpy(rows[k] + i, &bounds[k], sizeof bounds[k]);
        }
    }
    for (int i = 0; i < count; i++) {
        int32_t flag = -(int32_t)(marks[ids[i]] & 1);
        moved[i] = flag;
        moved_count -= flag;
    }
    return moved_count;
}

/* ---- finding ---- */

typedef struct scan {
    const td_grid *grid;
    const int32_t *ids, *min_x, *min_y, *max_x, *max_y, *moved, *starts;
    td_memory *memory;
    td_array *hits;
    i8 box_min_x, box_min_y, box_max_x, box_max_y;
} scan;

/* Which of the overlapping shapes count. */
typedef enum heed { HEED_ALL, HEED_MOVED, HEED_UNMOVED } heed;

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

TD_INLINE void set_box(scan *s, const td_bounds *b)
{
    s->box_min_x = i8_all(b->min_x);
    s->box_min_y = i8_all(b->min_y);
    s->box_max_x = i8_all(b->max_x);
    s->box_max_y = i8_all(b->max_y);
}

TD_INLINE td_bounds bounds_at(const scan *s, int i)
{
    return (td_bounds){s->min_x[i], s->min_y[i], s->max_x[i], s->max_y[i]};
}

/* Overlapping lanes among the eight from `at` on. */
TD_INLINE unsigned test(const scan *s, int at, heed which)
{
    i8 apart = i8_wrap_sub(s->box_max_x, i8_load(s->min_x + at)) |
               i8_wrap_sub(i8_load(s->max_x + at), s->box_min_x) |
               i8_wrap_sub(s->box_max_y, i8_load(s->min_y + at)) |
               i8_wrap_sub(i8_load(s->max_y + at), s->box_min_y);
    i8 found = ~apart;
    if (which != HEED_ALL) {
        i8 moved = i8_load(s->moved + at);
        found &= which == HEED_MOVED ? moved : ~moved;
    }
    return i8_bits(found);
}

TD_INLINE bool scan_range(scan *s, int from, int to, heed which)
{
    int needed = s->hits->count + (to - from) + TD_LANES;
    if (needed > s->hits->capacity && !td_array_reserve(s->memory, s->hits, needed)) {
        return false;
    }
    int32_t *out = (int32_t *)s->hits->data + s->hits->count;
    for (int at = from; at < to; at += TD_LANES) {
        unsigned bits = test(s, at, which);
        int left = to - at;
        bits &= left < TD_LANES ? (1u << left) - 1u : 0xffu;
        out += i8_pack(out, s->ids + at, bits);
    }
    s->hits->count = (int)(out - (int32_t *)s->hits->data);
    return true;
}

/* Cells cell .. cell + n - 1 of a level, around the end of its table. */
TD_INLINE bool scan_cells(scan *s, const td_level *level, uint32_t cell, uint32_t n, heed which)
{
    const int32_t *starts = s->starts + level->starts;
    uint32_t table = level->mask + 1;
    cell &= level->mask;
    if (cell + n <= table) {
        return scan_range(s, starts[cell], starts[cell + n], which);
    }
    return scan_range(s, starts[cell], starts[table], which) &&
           scan_range(s, starts[0], starts[cell + n - table], which);
}

/* A shape's own level: the rest of its cell and the next one, and the row above; so that each pair
 * comes once. */
TD_INLINE bool scan_forward(scan *s, const td_level *level, int i, uint32_t cell, heed which)
{
    const int32_t *starts = s->starts + level->starts;
    bool wraps = cell == level->mask;
    return scan_range(s, i + 1, starts[cell + (wraps ? 1 : 2)], which) &&
           (!wraps || scan_range(s, starts[0], starts[1], which)) &&
           scan_cells(s, level, cell + level->row - 1, 3, which);
}

/* The other half of the neighbourhood. */
TD_INLINE bool scan_backward(scan *s, const td_level *level, int i, uint32_t cell, heed which)
{
    const int32_t *starts = s->starts + level->starts;
    bool wraps = cell == 0;
    return scan_range(s, starts[wraps ? cell : cell - 1], i, which) &&
           (!wraps || scan_range(s, starts[level->mask], starts[level->mask + 1], which)) &&
           scan_cells(s, level, cell - level->row - 1, 3, which);
}

/* A level of larger shapes: three rows of three cells each, about a centre. */
TD_INLINE bool scan_coarser(scan *s, const td_level *level, int64_t x, int64_t y, heed which)
{
    const td_grid *grid = s->grid;
    int64_t column = td_grid_index(x, grid->origin_x, level->inv_cell);
    int64_t row = td_grid_index(y, grid->origin_y, level->inv_cell);
    for (int64_t r = row - 1; r <= row + 1; r++) {
        if (!scan_cells(s, level, td_grid_cell(level, column - 1, r), 3, which)) {
            return false;
        }
    }
    return true;
}

/* Any level, by the cells that the bounds reach. */
TD_INLINE bool scan_window(scan *s, const td_level *level, const td_bounds *b, td_place near_position,
                           heed which)
{
    const td_grid *grid = s->grid;
    if (level->count <= TD_LANES) { /* one test is cheaper than finding the cells */
        return scan_range(s, level->first, level->first + level->count, which);
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
        return scan_range(s, level->first, level->first + level->count, which);
    }
    for (int64_t r = r0; r <= r1; r++) {
        if (!scan_cells(s, level, td_grid_cell(level, c0, r), (uint32_t)(c1 - c0 + 1), which)) {
            return false;
        }
    }
    return true;
}

TD_INLINE bool sweep_levels(scan *s, int own, int i, const td_stance *stance, bool every)
{
    const td_grid *grid = s->grid;
    td_bounds b = bounds_at(s, i);
    const td_place *at = &stance[s->ids[i]].center;
    int64_t x = td_unwrap(td_middle(b.min_x, b.max_x), at->x);
    int64_t y = td_unwrap(td_middle(b.min_y, b.max_y), at->y);
    heed which = s->moved[i] ? HEED_ALL : HEED_MOVED;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        bool done = l == own || !level->count ||
                    (l > own ? scan_coarser(s, level, x, y, which)
                             : every || scan_window(s, level, &b, *at, HEED_UNMOVED));
        if (!done) {
            return false;
        }
    }
    return true;
}

static int levels_in_use(const td_grid *grid)
{
    int used = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        used += grid->levels[l].count > 0;
    }
    return used;
}

td_grid_sweep_fn TD_WIDE(td_grid_sweep);
bool TD_WIDE(td_grid_sweep)(const td_grid *grid, td_memory *memory, const td_stance *stance,
                            bool every, td_array *runs, td_array *hits)
{
    scan s = begin(grid, memory, hits);
    const int32_t *cells = grid->cells.data;
    bool one_level = levels_in_use(grid) == 1;
    if (!td_array_reserve(memory, runs, grid->ids.count)) {
        return false;
    }
    td_hit_run *run = runs->data;
    int before = hits->count;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        for (int i = level->first; i < level->first + level->count; i++) {
            if (!every && !s.moved[i]) {
                continue;
            }
            td_bounds b = bounds_at(&s, i);
            set_box(&s, &b);
            uint32_t cell = (uint32_t)cells[i];
            if (!(s.moved[i] ? scan_forward(&s, level, i, cell, HEED_ALL)
                             : scan_forward(&s, level, i, cell, HEED_MOVED)) ||
                !(every || scan_backward(&s, level, i, cell, HEED_UNMOVED)) ||
                !(one_level || sweep_levels(&s, l, i, stance, every))) {
                return false;
            }
            *run = (td_hit_run){s.ids[i], hits->count};
            run += hits->count != before;
            before = hits->count;
        }
    }
    runs->count = (int)(run - (td_hit_run *)runs->data);
    return true;
}

td_grid_query_fn TD_WIDE(td_grid_query);
bool TD_WIDE(td_grid_query)(const td_grid *grid, td_memory *memory, const td_bounds *bounds,
                            td_place near_position, td_array *hits)
{
    scan s = begin(grid, memory, hits);
    set_box(&s, bounds);
    for (int l = 0; l < TD_LEVELS; l++) {
        if (grid->levels[l].count &&
            !scan_window(&s, &grid->levels[l], bounds, near_position, HEED_ALL)) {
            return false;
        }
    }
    return true;
}
