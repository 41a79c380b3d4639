/* grid.h: bounds sorted into the cells of a grid, one level for about every eightfold of size.
 *
 * A level's cell is as large as its largest shape, so that two shapes of a level that overlap lie
 * in the same or in neighbouring cells, by their centres. Where the proxy set's rectangle is dense,
 * the cells are laid out row by row; where it is sparse, rows start at hashed places of a table of
 * about twice the proxy set, so that memory and time depend on the number of shapes alone, never
 * on the size of the world.
 *
 * While little moves, cells are made a little larger than that, and a shape keeps its cell until it
 * has used the difference up: a few changed bounds are then written where they stand, and nothing
 * is sorted. */
#ifndef TD_GRID_H
#define TD_GRID_H

#include "constraint/block.h"

enum { TD_LEVELS = 16 };

typedef struct td_level {
    int32_t first, count; /* in the proxy set's order */
    int32_t starts;       /* where its cells begin in td_proxy_set.starts; one more than cells */
    uint32_t mask;        /* cells - 1 */
    uint32_t row;         /* cells from one row to the next, modulo the table */
    bool hashed;
    int32_t slack; /* a centre may be so far from where it was when its cell was chosen */
    int64_t cell;  /* bounds quanta */
    double inv_cell;
    int64_t least_x, least_y, most_x, most_y; /* of its shapes' centres when they were sorted */
} td_level;

/* Sizes are told apart to a quarter of an octave, by the leading bits of a float. */
enum { TD_SIZES = 128, TD_SIZE_SHIFT = 21, TD_SIZE_ZERO = 127 << 2 };

/* A proxy set that reaches no further than this from its first shape, in length scales, is measured
 * with 32 bits. */
enum { TD_NEAR = 1 << 15 };

/* What sorting needs to know of the shapes listed. All arrays have room for a multiple of eight. */
typedef struct td_grid_measures {
    const int32_t *list;
    int count;
    double *x, *y;   /* centres of the fat bounds, bounds quanta from the
                        first shape's place */
    int32_t *extent; /* the larger of width and height */
    int32_t *cell;   /* within its level */
    uint8_t *level;
    int set[TD_SIZES];                       /* which sizes there are; cleared before */
    double least_x, least_y, most_x, most_y; /* of the centres */
} td_grid_measures;

/* False where the proxy set reaches too far; what it wrote is then void. */
typedef bool td_grid_measure_fn(const td_shape_proxy *proxy, td_grid_measures *measures);
/* The cells of the shapes in their levels. */
typedef void td_grid_cells_fn(const td_level *levels, td_grid_measures *measures);

static inline int64_t td_grid_index(int64_t coarse, int64_t origin, double inv_cell) {
    double x = (double)(coarse - origin) * inv_cell;
    int64_t i = (int64_t)x;
    return (double)i > x ? i - 1 : i;
}

static inline uint32_t td_grid_cell(const td_level *level, int64_t column, int64_t row) {
    return ((uint32_t)(uint64_t)(column + 1) + (uint32_t)(uint64_t)(row + 1) * level->row) &
           level->mask;
}

static inline int32_t td_middle(int32_t low, int32_t high) {
    return td_wrap_add(low, (int32_t)((uint32_t)td_wrap_sub(high, low) / 2));
}

#endif
