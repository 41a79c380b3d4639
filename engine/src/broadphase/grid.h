/* grid.h: a hierarchical grid (C. Ericson, "Real-Time Collision Detection", 2005, 7.1 and 7.2):
 * shapes sorted into square cells by the centres of their fat bounds, with a level of the grid for
 * each eightfold range of sizes that occurs.
 *
 * Main invariant: a level's cells are at least as wide as its largest shape, so that two shapes of
 * one level that overlap lie in the same or in neighbouring cells. The shapes of a cell stand side
 * by side in td_proxy_set.ids; td_proxy_set.starts says where each cell begins.
 *
 * The cell at (column, row), both counted from 0, has the index
 *     (column + 1 + (row + 1) * level.row) & level.mask
 * (td_grid_cell). Where the rectangle of all centres has few cells for the number of shapes,
 * level.row is the number of columns with one empty column on each side, and the index is unique.
 * Where it has many, the level is hashed: level.row is the table's length over the golden ratio, so
 * that rows begin far from each other (Fibonacci hashing; D. Knuth, "The Art of Computer
 * Programming", vol. 3, 6.4), and different cells may share an index. Either way, memory and time
 * depend on the number of shapes, never on the size of the world.
 *
 * A world may set the width of cells (thud_world_def.cell_size): all shapes whose bounds are no
 * wider than that share a level with such cells, below those of the larger shapes.
 *
 * While few shapes move, cells are made wider by 2 * slack, and a shape keeps its cell until its
 * centre has moved by more than slack: new bounds are then written in place, and nothing is sorted.
 */
#ifndef TD_GRID_H
#define TD_GRID_H

#include "constraint/block.h"

/* Levels of a grid. 11 would be enough: sizes range from 1 to 2^31 bounds quanta, and each level
 * holds an eightfold range (2^3). Snapshots and drawings hold an array of this length. */
enum { TD_LEVELS = 16 };

/* Maximum number of strays: resting shapes that a sorted grid takes in without a cell
 * (level_of_strays in grid.c). Derived: a level of so many shapes is always tested whole
 * (SCAN_WHOLE_MAX in wide_grid_sweep.c). */
enum { TD_STRAYS_MAX = 16 };

typedef struct td_level {
    int32_t first, count; /* its shapes, in the order of td_proxy_set.ids */
    int32_t starts; /* index of its part of td_proxy_set.starts, which has one element a cell and an
                       end */
    uint32_t mask;  /* number of cells - 1; that is a power of two */
    uint32_t row;   /* cells from one row to the next, modulo the number of cells */
    bool hashed;    /* several cells of the plane may share a cell of the table */
    int32_t slack;  /* how far a centre may move along an axis from where it was when its cell was
                       chosen (anchor_x, anchor_y), bounds quanta */
    int64_t cell;   /* width of a cell, bounds quanta */
    double inv_cell; /* a little less than 1 / cell: choose_tables in grid.c */
} td_level;

/* The size class 4 e + m, with m in 0..3, holds the extents from 2^e (4 + m) / 4 up to
 * 2^e (5 + m) / 4 bounds quanta. It is read from the extent as a float, whose bits above
 * TD_SIZE_SHIFT are the exponent and two bits of the mantissa; those of 1.0f are TD_SIZE_OF_ONE.
 * Extents are below 2^31, and classes below 4 * 31. */
enum { TD_SIZE_CLASSES = 128, TD_SIZE_SHIFT = 21, TD_SIZE_OF_ONE = 127 << 2 };

/* Greatest distance along an axis, in whole length scales, of the centres of a proxy set from that
 * of its first shape up to which the set is measured with 32-bit differences. It is an eighth of
 * the 2^18 length scales after which bounds wrap around. Chosen: 32 bits would reach to 2^17, less
 * the shapes' extents. */
enum { TD_GRID_NEAR = 1 << 15 };

/* What sorting needs to know of each listed shape. The arrays have room for a multiple of eight
 * elements, and lie in td_scratch.order. */
typedef struct td_grid_measures {
    const int32_t *list; /* indices of the shapes */
    int count;
    double *x, *y;   /* centres of the fat bounds, bounds quanta from the first shape's centre */
    int32_t *extent; /* the larger of width and height, bounds quanta */
    int32_t *cell;   /* index of the cell within its level */
    uint8_t *level;
    int has_size[TD_SIZE_CLASSES];     /* 1 for the size classes that occur; zeroed by the caller */
    double min_x, min_y, max_x, max_y; /* range of x and y */
} td_grid_measures;

/* Fills x, y, extent, has_size and the range. False where a centre is beyond
 * TD_GRID_NEAR; what it wrote is then void. */
typedef bool td_grid_measure_fn(const td_shape_proxy *proxy, td_grid_measures *measures);
/* Fills `cell` from x, y and level. */
typedef void td_grid_cells_fn(const td_level *levels, td_grid_measures *measures);

/* The column or row at a distance from the origin, bounds quanta. No centre was below the origin
 * when the grid was sorted, so that truncation rounds down. A shape that has moved below the origin
 * since then keeps its cell. */
static inline int64_t td_grid_index(int64_t distance, double inv_cell) {
    return (int64_t)((double)distance * inv_cell);
}

/* The index of a cell in its level's table: see above. */
static inline uint32_t td_grid_cell(const td_level *level, int64_t column, int64_t row) {
    return ((uint32_t)(uint64_t)(column + 1) + (uint32_t)(uint64_t)(row + 1) * level->row) &
           level->mask;
}

/* The middle of two bounds coordinates, which may wrap around; halves round down. */
static inline int32_t td_middle(int32_t low, int32_t high) {
    return td_wrap_add(low, (int32_t)((uint32_t)td_wrap_sub(high, low) / 2));
}

#endif
