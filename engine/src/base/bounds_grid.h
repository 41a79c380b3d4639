/* bounds_grid.h: a grid of boxes, filled anew for each use, to find those that overlap another box.
 * For stages that look for neighbours among things of which the broadphase has no valid bounds: the
 * paths of bodies, and shapes that have moved since it ran.
 *
 * Each box belongs to the cell of its lower left corner. Cells are squares, at least twice as wide
 * as the boxes are on average. Boxes that are wider than a cell are in a list of their own, which
 * each search reads. Cells are kept in a hash table (after Teschner et al., Optimized Spatial
 * Hashing for Collision Detection of Deformable Objects, 2003). */
#ifndef TD_BOUNDS_GRID_H
#define TD_BOUNDS_GRID_H

#include "base/fixed.h"
#include "base/memory.h"

/* A box in the grid. */
typedef struct td_boxed {
    td_bounds bounds;
    int32_t id;      /* the caller's */
    bool everywhere; /* `bounds` means nothing: each search finds the box */
} td_boxed;

/* `boxes` has the boxes twice: boxes.count of them in the order in which they were added, and after
 * these the same ones, list by list. The lists are those of the hash table, and the one of the wide
 * boxes last. */
typedef struct td_bounds_grid {
    td_array boxes; /* td_boxed */
    td_array ends;  /* int, by list: where it ends, counted from box number boxes.count on */
    int shift;      /* cells are 2^shift bounds quanta wide */
} td_bounds_grid;

/* Empties the grid, and reserves memory for so many boxes. False when memory is short. */
bool td_bounds_grid_reserve(td_memory *memory, td_bounds_grid *grid, int count);
/* Adds a box, for which there must be room; null: one that each search finds. */
void td_bounds_grid_add(td_bounds_grid *grid, const td_bounds *bounds, int id);
/* Sorts the boxes into lists. To be called when all have been added, before the first search. */
void td_bounds_grid_build(td_bounds_grid *grid);
/* Appends the ids of all boxes that overlap `bounds` to an array of ints that has room for all;
 * null: the ids of all boxes. Their order depends on the boxes, the order in which they
 * were added, and `bounds` alone. */
void td_bounds_grid_find(const td_bounds_grid *grid, const td_bounds *bounds, td_array *ids);

#endif
