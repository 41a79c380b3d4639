/* grid.c: building a grid by counting sort, and following small changes. The order of the shapes
 * listed decides within a cell, and places count relative to the population's own least centre, so
 * that a shifted world is sorted the same. */
#include "grid.h"

#include "kinds.h"
#include "world.h"

#include <string.h>

typedef struct sorted_shape {
    int64_t x, y; /* centre of the fat bounds, bounds quanta */
    int32_t extent, level;
    int32_t cell;
} sorted_shape;

static int32_t extent_of(const td_bounds *b)
{
    return td_max_int(td_wrap_sub(b->max_x, b->min_x), td_wrap_sub(b->max_y, b->min_y));
}

/* Sizes are told apart to a quarter of an octave, by the leading bits of a float. */
enum { SIZES = 128 };

static int size_of(int32_t extent)
{
    float f = (float)td_max_int(extent, 1);
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return (int)(bits >> 21) - (127 << 2);
}

/* Levels from the last one down: each begins at the largest size that is left, and holds all down to
 * a quarter of it, so that sizes that differ little share a level. */
static void choose_levels(const int *population, uint8_t *level_of_size)
{
    int level = TD_LEVELS, least = SIZES;
    for (int size = SIZES - 1; size >= 0; size--) {
        if (population[size] && size < least && level > 0) {
            level--;
            least = size - 7;
        }
        level_of_size[size] = (uint8_t)level;
    }
}

/* Centres and the corners of the population, then levels, their counts and largest extents. */
static void measure(const thud_world *w, td_grid *grid, sorted_shape *sorted)
{
    const int *list = grid->list.data;
    const td_stance *stances = w->stance.data;
    int64_t least_x = INT64_MAX, least_y = INT64_MAX, most_x = INT64_MIN, most_y = INT64_MIN;
    int population[SIZES] = {0};
    for (int i = 0; i < grid->list.count; i++) {
        const td_stance *stance = &stances[list[i]];
        const td_bounds *b = &stance->fat;
        sorted_shape *s = &sorted[i];
        s->extent = extent_of(b);
        s->x = td_unwrap(td_middle(b->min_x, b->max_x), stance->center.x);
        s->y = td_unwrap(td_middle(b->min_y, b->max_y), stance->center.y);
        least_x = s->x < least_x ? s->x : least_x;
        least_y = s->y < least_y ? s->y : least_y;
        most_x = s->x > most_x ? s->x : most_x;
        most_y = s->y > most_y ? s->y : most_y;
        population[size_of(s->extent)]++;
    }
    uint8_t level_of_size[SIZES];
    choose_levels(population, level_of_size);
    for (int i = 0; i < grid->list.count; i++) {
        sorted_shape *s = &sorted[i];
        int32_t extent = s->extent;
        s->level = level_of_size[size_of(extent)];
        td_level *level = &grid->levels[s->level];
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

/* Chooses each level's table from its population; returns the length of `starts`. */
static int lay_out(td_grid *grid, bool quiet)
{
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

static bool reserve(thud_world *w, td_grid *grid, bool quiet)
{
    int count = grid->list.count;
    td_array *arrays[] = {&grid->ids,   &grid->min_x, &grid->min_y, &grid->max_x,
                          &grid->max_y, &grid->moved, &grid->cells};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        arrays[i]->stride = (int)sizeof(int32_t);
        if (!td_array_reserve(&w->memory, arrays[i], count + TD_LANES)) {
            return false;
        }
        arrays[i]->count = count;
    }
    grid->spot.stride = grid->anchor_x.stride = grid->anchor_y.stride = (int)sizeof(int32_t);
    w->scratch.grid.stride = (int)sizeof(sorted_shape);
    return td_array_reserve(&w->memory, &w->scratch.grid, count) &&
           (!quiet || (td_array_reserve(&w->memory, &grid->spot, w->shapes.items.count) &&
                       td_array_reserve(&w->memory, &grid->anchor_x, count) &&
                       td_array_reserve(&w->memory, &grid->anchor_y, count)));
}

/* Counting sort of ids and cells. */
static void sort(td_grid *grid, sorted_shape *sorted, int starts_count)
{
    int *starts = grid->starts.data, *ids = grid->ids.data, *cells = grid->cells.data;
    const int *list = grid->list.data;
    memset(starts, 0, (size_t)starts_count * sizeof(int));
    for (int i = 0; i < grid->list.count; i++) {
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
    for (int i = 0; i < grid->list.count; i++) {
        const sorted_shape *s = &sorted[i];
        int at = starts[grid->levels[s->level].starts + s->cell]++;
        ids[at] = list[i];
        cells[at] = s->cell;
    }
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        if (level->count) {
            memmove(&starts[level->starts + 1], &starts[level->starts],
                    (size_t)(level->mask + 1) * sizeof(int));
            starts[level->starts] = level->first;
        }
    }
}

/* Notes where each shape went, for td_grid_follow. */
static void note_spots(td_grid *grid)
{
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

bool td_grid_build(thud_world *w, td_grid *grid, bool quiet)
{
    grid->valid = grid->loose = false;
    grid->moved_count = 0;
    memset(grid->levels, 0, sizeof grid->levels);
    if (!reserve(w, grid, quiet)) {
        return false;
    }
    sorted_shape *sorted = w->scratch.grid.data;
    measure(w, grid, sorted);
    int starts_count = lay_out(grid, quiet);
    grid->starts.stride = (int)sizeof(int);
    if (!td_array_reserve(&w->memory, &grid->starts, starts_count)) {
        return false;
    }
    if (starts_count) {
        sort(grid, sorted, starts_count);
        grid->moved_count =
            TD_PICK_WIDE(w, td_grid_fill)(grid, w->stance.data, w->marks.data);
        if (quiet) {
            note_spots(grid);
        }
    }
    grid->loose = quiet;
    grid->valid = true;
    return true;
}

static bool near_anchor(int32_t anchor, int32_t low, int32_t high, int32_t slack)
{
    int32_t drift = td_wrap_sub(td_middle(low, high), anchor);
    return drift <= slack && drift >= -slack;
}

static const td_level *level_at(const td_grid *grid, int at)
{
    const td_level *level = grid->levels;
    while (at >= level->first + level->count) {
        level++;
    }
    return level;
}

bool td_grid_follow(thud_world *w, td_grid *grid, const int *moved, int count)
{
    if (!grid->loose) {
        return false;
    }
    const int32_t *spot = grid->spot.data, *anchor_x = grid->anchor_x.data;
    const int32_t *anchor_y = grid->anchor_y.data;
    grid->moved_count = 0;
    for (int i = 0; i < count; i++) {
        if (td_body_at(w, td_shape_at(w, moved[i])->body)->awake <= 0) {
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

void td_grid_free(td_memory *memory, td_grid *grid)
{
    td_array *arrays[] = {&grid->list,  &grid->ids,      &grid->min_x,   &grid->min_y,
                          &grid->max_x, &grid->max_y,    &grid->moved,   &grid->cells,
                          &grid->spot,  &grid->anchor_x, &grid->anchor_y, &grid->starts};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        td_array_free(memory, arrays[i]);
    }
}
