/* walk.h: iterates over the hits of a path in order, so that a cast can end after any of them.
 *
 * A walk only reads the world, and lists candidates in an array that its caller provides. So
 * several walks may run at the same time, on several threads or one inside another. */
#ifndef TD_WALK_H
#define TD_WALK_H

#include "casts/path.h"

typedef struct td_walk {
    const thud_world *world;
    const td_path *way;
    td_array found;  /* int: slots of the candidates of the present piece */
    bool every;      /* all shapes are candidates: the array was too small, or the piece too wide */
    bool under_way;  /* there is a present piece */
    double to, next; /* its end, and the length of the next piece, fractions of the path */
    thud_ray_hit last; /* hits up to this one, in the order of td_hit_before, have been returned */
    thud_ray_hit ground; /* the first hit on a terrain after it; fraction 2 without one */
} td_walk;

/* The ints that a walk's array needs. A piece with more than 16384 candidates tests all shapes
 * instead, which costs little more there. Chosen: 64 kB a worker. */
static inline int td_walk_room(const thud_world *w) {
    return td_min_int(w->shapes.count, 16384) + TD_LANES;
}

/* Begins a walk (the search for the hits of a cast along a path, in the order of their distance)
 * along `way`, which the caller keeps until the walk ends; `room`: an array of `size` =
 * td_walk_room ints. To be called after td_query_prepare. */
td_walk td_walk_begin(const thud_world *w, const td_path *way, int *room, int size);

/* Finds the next hits below the fraction `limit`, at most k->capacity; k->count is 0 where there
 * are none left. */
void td_walk_next(td_walk *walk, double limit, td_nearest *k);

#endif
