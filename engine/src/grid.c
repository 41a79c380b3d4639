/* grid.c: building a grid by counting sort. The order of the shapes listed decides within a cell,
 * and places count relative to the population's own least centre, so that a shifted world is sorted
 * the same. */
#include "grid.h"

#include "world.h"

#include <string.h>

typedef struct sorted_shape {
    int64_t x, y; /* centre of the fat bounds, bounds quanta */
    int32_t level, cell;
} sorted_shape;

static int level_of(const td_bounds *b)
{
    uint32_t extent = (uint32_t)td_max_int(td_wrap_sub(b->max_x, b->min_x),
                                           td_wrap_sub(b->max_y, b->min_y));
    return (31 - __builtin_clz(extent | 1)) / 2;
}

static int32_t middle(int32_t low, int32_t high)
{
    return td_wrap_add(low, (int32_t)((uint32_t)td_wrap_sub(high, low) / 2));
}

/* Centres and levels, the origin, and each level's count and cell size. */
static void measure(const thud_world *w, td_grid *grid, const int *shapes, int count,
                    sorted_shape *sorted)
{
    int64_t least_x = INT64_MAX, least_y = INT64_MAX, most_x = INT64_MIN, most_y = INT64_MIN;
    for (int i = 0; i < count; i++) {
        const td_bounds *b = td_fat_at(w, shapes[i]);
        const td_place *center = &td_stance_at(w, shapes[i])->center;
        sorted_shape *s = &sorted[i];
        s->x = td_unwrap(middle(b->min_x, b->max_x), center->x);
        s->y = td_unwrap(middle(b->min_y, b->max_y), center->y);
        s->level = level_of(b);
        least_x = s->x < least_x ? s->x : least_x;
        least_y = s->y < least_y ? s->y : least_y;
        most_x = s->x > most_x ? s->x : most_x;
        most_y = s->y > most_y ? s->y : most_y;
        td_level *level = &grid->levels[s->level];
        int64_t extent = td_max_int(td_wrap_sub(b->max_x, b->min_x),
                                    td_wrap_sub(b->max_y, b->min_y)) + 2;
        level->cell = extent > level->cell ? extent : level->cell;
        level->count++;
    }
    grid->origin_x = least_x;
    grid->origin_y = least_y;
    grid->end_x = most_x;
    grid->end_y = most_y;
}

static uint32_t power_above(int64_t n)
{
    uint32_t p = 64;
    while (p < n) {
        p *= 2;
    }
    return p;
}

/* Chooses each level's table from its population. */
static int lay_out(td_grid *grid, int count, const sorted_shape *sorted)
{
    int64_t most_x[TD_LEVELS] = {0}, most_y[TD_LEVELS] = {0};
    for (int i = 0; i < count; i++) {
        const sorted_shape *s = &sorted[i];
        most_x[s->level] = s->x > most_x[s->level] || !most_x[s->level] ? s->x : most_x[s->level];
        most_y[s->level] = s->y > most_y[s->level] || !most_y[s->level] ? s->y : most_y[s->level];
    }
    int first = 0, starts = 0;
    for (int l = 0; l < TD_LEVELS; l++) {
        td_level *level = &grid->levels[l];
        level->first = first;
        level->starts = starts;
        if (!level->count) {
            continue;
        }
        /* A little less than 1 / cell: rounding must never put neighbours two cells apart. */
        level->inv_cell = (1.0 - 1.0 / 65536.0) / (double)level->cell;
        int64_t columns = td_grid_index(most_x[l], grid->origin_x, level->inv_cell) + 3;
        int64_t rows = td_grid_index(most_y[l], grid->origin_y, level->inv_cell) + 3;
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

static bool reserve(thud_world *w, td_grid *grid, int count)
{
    td_array *arrays[] = {&grid->ids,   &grid->min_x, &grid->min_y, &grid->max_x,
                          &grid->max_y, &grid->moved, &grid->cells};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        arrays[i]->stride = (int)sizeof(int32_t);
        if (!td_array_reserve(&w->memory, arrays[i], count + TD_LANES)) {
            return false;
        }
        arrays[i]->count = count;
    }
    w->scratch.grid.stride = (int)sizeof(sorted_shape);
    return td_array_reserve(&w->memory, &w->scratch.grid, count);
}

static void put(const thud_world *w, td_grid *grid, int at, int shape, int cell)
{
    const td_bounds *b = td_fat_at(w, shape);
    ((int32_t *)grid->ids.data)[at] = shape;
    ((int32_t *)grid->min_x.data)[at] = b->min_x;
    ((int32_t *)grid->min_y.data)[at] = b->min_y;
    ((int32_t *)grid->max_x.data)[at] = b->max_x;
    ((int32_t *)grid->max_y.data)[at] = b->max_y;
    ((int32_t *)grid->moved.data)[at] = *td_marks_at(w, shape) & TD_MARK_MOVED ? -1 : 0;
    ((int32_t *)grid->cells.data)[at] = cell;
}

bool td_grid_build(thud_world *w, td_grid *grid, const int *shapes, int count)
{
    grid->valid = false;
    memset(grid->levels, 0, sizeof grid->levels);
    if (!reserve(w, grid, count)) {
        return false;
    }
    sorted_shape *sorted = w->scratch.grid.data;
    measure(w, grid, shapes, count, sorted);
    int starts_count = lay_out(grid, count, sorted);
    grid->starts.stride = (int)sizeof(int);
    if (!td_array_reserve(&w->memory, &grid->starts, starts_count)) {
        return false;
    }
    int *starts = grid->starts.data;
    if (starts_count == 0) {
        grid->valid = true;
        return true;
    }
    memset(starts, 0, (size_t)starts_count * sizeof(int));
    for (int i = 0; i < count; i++) {
        sorted_shape *s = &sorted[i];
        const td_level *level = &grid->levels[s->level];
        s->cell = (int32_t)td_grid_cell(level,
                                        td_grid_index(s->x, grid->origin_x, level->inv_cell),
                                        td_grid_index(s->y, grid->origin_y, level->inv_cell));
        starts[level->starts + s->cell + 1]++;
    }
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        int sum = level->first;
        for (uint32_t c = 0; level->count && c <= level->mask + 1; c++) {
            sum += starts[(uint32_t)level->starts + c];
            starts[(uint32_t)level->starts + c] = sum;
        }
    }
    /* starts[c] is where cell c begins; while filling it runs up to where the next one does, and is
     * set back by one cell afterwards. */
    for (int i = 0; i < count; i++) {
        const sorted_shape *s = &sorted[i];
        put(w, grid, starts[grid->levels[s->level].starts + s->cell]++, shapes[i], s->cell);
    }
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (level->count) {
            memmove(&starts[level->starts + 1], &starts[level->starts],
                    (size_t)(level->mask + 1) * sizeof(int));
            starts[level->starts] = level->first;
        }
    }
    grid->valid = true;
    return true;
}

void td_grid_free(td_memory *memory, td_grid *grid)
{
    td_array *arrays[] = {&grid->ids,   &grid->min_x, &grid->min_y, &grid->max_x,
                          &grid->max_y, &grid->moved, &grid->cells, &grid->starts};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        td_array_free(memory, arrays[i]);
    }
}
