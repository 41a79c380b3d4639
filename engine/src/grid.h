/* grid.h: bounds sorted into the cells of a grid, one level for about every eightfold of size.
 *
 * A level's cell is as large as its largest shape, so that two shapes of a level that overlap lie in
 * the same or in neighbouring cells, by their centres. Where the population's rectangle is dense,
 * the cells are laid out row by row; where it is sparse, rows start at hashed places of a table of
 * about twice the population, so that memory and time depend on the number of shapes alone, never
 * on the size of the world.
 *
 * While little moves, cells are made a little larger than that, and a shape keeps its cell until it
 * has used the difference up: a few changed bounds are then written where they stand, and nothing
 * is sorted. */
#ifndef TD_GRID_H
#define TD_GRID_H

#include "block.h"
#include "memory.h"

enum { TD_LEVELS = 16 };

typedef struct td_level {
    int32_t first, count;  /* in the sorted arrays */
    int32_t starts;        /* where its cells begin in td_grid.starts; one more than cells */
    uint32_t mask;         /* cells - 1 */
    uint32_t row;          /* cells from one row to the next, modulo the table */
    bool hashed;
    int32_t slack;         /* a centre may be so far from where it was when its cell was chosen */
    int64_t cell;          /* bounds quanta */
    double inv_cell;
    int64_t least_x, least_y, most_x, most_y; /* of its shapes' centres when they were sorted */
} td_level;

typedef struct td_grid {
    td_array list;                       /* int: the population, in the order that callers give */
    td_array ids;                        /* int: shapes, by level, then cell */
    td_array min_x, min_y, max_x, max_y; /* int32, in the order of ids, eight more at the end */
    td_array moved;                      /* int32: -1 where the shape is on the moved list */
    td_array cells;                      /* int: cell of each, within its level */
    td_array starts;                     /* int */
    td_array spot;                       /* int, by shape: its index in ids; only while `loose` */
    td_array anchor_x, anchor_y;         /* int32: centres when cells were chosen; likewise */
    td_level levels[TD_LEVELS];
    int64_t origin_x, origin_y;          /* bounds quanta: the least centre of the population */
    int64_t end_x, end_y;                /* ... and the greatest */
    int moved_count;                     /* of its shapes, when last brought up to date */
    bool listed;                         /* `list` is the present population */
    bool loose;                          /* has slack */
    bool valid;                          /* holds the present bounds */
} td_grid;

/* What a sweep found: the hits from the end of the run before to `end` overlap `shape`. */
typedef struct td_hit_run {
    int32_t shape, end;
} td_hit_run;

/* Of its own level, no more neighbours of a shape are found at once on either side of it. Shapes side
 * by side have far fewer; where everything is inside everything, the nearest in the order of the grid
 * push each other apart first, and no step takes longer than a crowd is worth. */
enum { TD_CROWD = 32 };

struct thud_world;

/* Sorts the shapes in `list`. `quiet`: little moves, so that it pays to be able to follow. False
 * when memory is short; the grid is then not valid. */
bool td_grid_build(struct thud_world *w, td_grid *grid, bool quiet);
/* Writes the bounds of moved shapes in place. False where that is not possible. */
bool td_grid_follow(struct thud_world *w, td_grid *grid, const int *moved, int count);
/* The population has changed. */
static inline void td_grid_forget(td_grid *grid)
{
    grid->listed = grid->valid = grid->loose = false;
}
void td_grid_free(td_memory *memory, td_grid *grid);

/* Sizes are told apart to a quarter of an octave, by the leading bits of a float. */
enum { TD_SIZES = 128, TD_SIZE_SHIFT = 21, TD_SIZE_ZERO = 127 << 2 };

/* A population that reaches no further than this from its first shape, in length scales, is measured
 * with 32 bits. */
enum { TD_NEAR = 1 << 15 };

/* What sorting needs to know of the shapes listed. Room for a multiple of eight. */
typedef struct td_grid_measures {
    const int32_t *list;
    int count;
    double *x, *y;                           /* centres of the fat bounds, bounds quanta from the
                                                first shape's place */
    int32_t *extent;                         /* the larger of width and height */
    int32_t *cell;                           /* within its level */
    uint8_t *level;
    int population[TD_SIZES];                /* which sizes there are; cleared before */
    double least_x, least_y, most_x, most_y; /* of the centres */
} td_grid_measures;

/* False where the population reaches too far; what it wrote is then void. */
typedef bool td_grid_measure_fn(const td_stance *stance, td_grid_measures *measures);
/* The cells of the shapes in their levels. */
typedef void td_grid_cells_fn(const td_level *levels, td_grid_measures *measures);

/* Fills bounds and moved flags of the sorted shapes from the stances and marks of all. */
typedef int td_grid_fill_fn(td_grid *grid, const td_stance *stance, const uint8_t *marks);

/* Finds each pair of shapes whose bounds overlap and of which one moved, once. `runs` gets
 * td_hit_run, `hits`, empty before, the ids; `crowded`, with room for all, the shapes that may have
 * more. `every`: look at every shape rather than at those that moved, which pays when most did. */
typedef bool td_grid_sweep_fn(const td_grid *grid, td_memory *memory, const td_stance *stance,
                              bool every, td_array *runs, td_array *hits, td_array *crowded);
/* Appends every shape whose bounds overlap `bounds`, which lie near the position. */
typedef bool td_grid_query_fn(const td_grid *grid, td_memory *memory, const td_bounds *bounds,
                              td_place near_position, td_array *hits);

static inline int64_t td_grid_index(int64_t coarse, int64_t origin, double inv_cell)
{
    double x = (double)(coarse - origin) * inv_cell;
    int64_t i = (int64_t)x;
    return (double)i > x ? i - 1 : i;
}

static inline uint32_t td_grid_cell(const td_level *level, int64_t column, int64_t row)
{
    return ((uint32_t)(uint64_t)(column + 1) + (uint32_t)(uint64_t)(row + 1) * level->row) &
           level->mask;
}

static inline int32_t td_middle(int32_t low, int32_t high)
{
    return td_wrap_add(low, (int32_t)((uint32_t)td_wrap_sub(high, low) / 2));
}

#endif
