/* bounds_grid.c: see bounds_grid.h. Bounds wrap around at 2^32 quanta, which is a multiple of the
 * width of a cell, so that cells do, too. */
#include "base/bounds_grid.h"

#include <string.h>

/* The widest cells are 2^30 quanta wide. A search begins one cell before its bounds, which are
 * narrower than 2^31 quanta, so that it never wraps around to its first cell. */
enum { SHIFT_MAX = 30 };
/* Up to this many boxes are tested one by one. A search by cells would look into at least four
 * cells, since it begins one cell before its bounds in both directions. */
enum { FEW_BOXES = 4 };

/* The cell of a corner. */
typedef struct grid_cell {
    uint32_t x, y;
} grid_cell;

static td_boxed *box_at(const td_bounds_grid *grid, int index) {
    return TD_AT(td_boxed, &grid->boxes, index);
}

/* The greater one of both sides of a box, in bounds quanta. */
static uint32_t width_of(const td_bounds *b) {
    uint32_t x = (uint32_t)b->max_x - (uint32_t)b->min_x;
    uint32_t y = (uint32_t)b->max_y - (uint32_t)b->min_y;
    return x > y ? x : y;
}

static grid_cell cell_of(const td_bounds_grid *grid, const td_bounds *b) {
    return (grid_cell){(uint32_t)b->min_x >> grid->shift, (uint32_t)b->min_y >> grid->shift};
}

/* The number of lists in the hash table: a power of two, at least the number of boxes. */
static int list_count(int boxes) {
    int count = 1;
    while (count < boxes) {
        count *= 2;
    }
    return count;
}

/* The list of a cell. Factors chosen: large odd numbers. The middle bits of the mixed sum depend
 * on all bits of both numbers. */
static int list_of(const td_bounds_grid *grid, grid_cell cell) {
    uint32_t mixed = (cell.x * 0x9E3779B1u ^ cell.y) * 0x85EBCA6Bu;
    return (int)((mixed >> 15 ^ mixed) & (uint32_t)(grid->ends.count - 2));
}

bool td_bounds_grid_reserve(td_memory *memory, td_bounds_grid *grid, int count) {
    grid->boxes.count = 0;
    return td_array_reserve(memory, &grid->boxes, 2 * count) &&
           td_array_reserve(memory, &grid->ends, list_count(count) + 1);
}

void td_bounds_grid_add(td_bounds_grid *grid, const td_bounds *bounds, int id) {
    TD_PUSH(td_boxed, &grid->boxes) =
        (td_boxed){.bounds = bounds ? *bounds : (td_bounds){0}, .id = id, .everywhere = !bounds};
}

/* Chooses the size of cells by the mean size of the boxes. */
static void choose_cells(td_bounds_grid *grid) {
    uint64_t count = (uint64_t)grid->boxes.count, sum = 0;
    for (int i = 0; i < grid->boxes.count; i++) {
        sum += width_of(&box_at(grid, i)->bounds);
    }
    grid->shift = 0;
    while (grid->shift < SHIFT_MAX && count << grid->shift < 2 * sum) {
        grid->shift++;
    }
}

/* The list that a box belongs to: that of its cell, or the one of the wide boxes. */
static int list_of_box(const td_bounds_grid *grid, const td_boxed *box) {
    bool fits = !box->everywhere && width_of(&box->bounds) <= UINT32_C(1) << grid->shift;
    return fits ? list_of(grid, cell_of(grid, &box->bounds)) : grid->ends.count - 1;
}

/* Sorts the boxes by their lists, by counting. */
void td_bounds_grid_build(td_bounds_grid *grid) {
    int count = grid->boxes.count, begin = 0;
    choose_cells(grid);
    grid->ends.count = list_count(count) + 1;
    int *ends = grid->ends.data;
    memset(ends, 0, (size_t)grid->ends.count * sizeof *ends);
    for (int i = 0; i < count; i++) {
        ends[list_of_box(grid, box_at(grid, i))]++;
    }
    for (int i = 0; i < grid->ends.count; i++) {
        int here = ends[i];
        ends[i] = begin;
        begin += here;
    }
    for (int i = 0; i < count; i++) {
        const td_boxed *box = box_at(grid, i);
        *box_at(grid, count + ends[list_of_box(grid, box)]++) = *box;
    }
}

/* Appends the box if it overlaps the bounds. */
static void test_box(const td_boxed *box, const td_bounds *b, td_array *ids) {
    if (!b || box->everywhere || td_bounds_overlap(&box->bounds, b)) {
        td_push_int(ids, box->id);
    }
}

/* Tests the boxes of one list. Several cells may share a list, so that only its boxes that are in
 * `cell` are tested; all of them if `cell` is null. */
static void test_list(const td_bounds_grid *grid, int list, const grid_cell *cell,
                      const td_bounds *b, td_array *ids) {
    int end = td_int_at(&grid->ends, list);
    for (int i = list > 0 ? td_int_at(&grid->ends, list - 1) : 0; i < end; i++) {
        const td_boxed *box = box_at(grid, grid->boxes.count + i);
        grid_cell its = cell_of(grid, &box->bounds);
        if (!cell || (its.x == cell->x && its.y == cell->y)) {
            test_box(box, b, ids);
        }
    }
}

void td_bounds_grid_find(const td_bounds_grid *grid, const td_bounds *b, td_array *ids) {
    uint32_t mask = UINT32_MAX >> grid->shift, columns = 0, rows = 0;
    grid_cell first = {0};
    bool all = !b || grid->boxes.count <= FEW_BOXES;
    if (!all) {
        /* A box that fits a cell begins at most one width of a cell before the bounds. */
        int32_t width = (int32_t)(UINT32_C(1) << grid->shift);
        td_bounds wider = {.min_x = td_wrap_sub(b->min_x, width),
                           .min_y = td_wrap_sub(b->min_y, width)};
        first = cell_of(grid, &wider);
        columns = ((((uint32_t)b->max_x >> grid->shift) - first.x) & mask) + 1;
        rows = ((((uint32_t)b->max_y >> grid->shift) - first.y) & mask) + 1;
    }
    if (all || (uint64_t)columns * rows >= (uint64_t)grid->boxes.count) {
        for (int i = 0; i < grid->boxes.count; i++) {
            test_box(box_at(grid, i), b, ids);
        }
        return;
    }
    for (uint32_t y = 0; y < rows; y++) {
        for (uint32_t x = 0; x < columns; x++) {
            grid_cell cell = {(first.x + x) & mask, (first.y + y) & mask};
            test_list(grid, list_of(grid, cell), &cell, b, ids);
        }
    }
    test_list(grid, grid->ends.count - 1, NULL, b, ids);
}
