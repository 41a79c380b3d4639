/* walk.h: going along a path from hit to hit, in order.
 *
 * A walk only reads the world and needs no memory but the room that it is given, so that several
 * may be under way at once. */
#ifndef TD_WALK_H
#define TD_WALK_H

#include "casts/path.h"

typedef struct td_walk {
    const thud_world *world;
    const td_path *way;
    td_array found;      /* int: candidates of the present piece, in the room that was given */
    bool every;          /* they are all shapes: the room was too small, or the piece too wide */
    bool under_way;      /* there is a present piece */
    double to, next;     /* where it ends, and how long the next one is */
    thud_ray_hit last;   /* what was told last, or a place behind all that was */
    thud_ray_hit ground; /* of all lines, the first hit after it; beyond 1 without one */
} td_walk;

/* How many ints make room for a walk. Where a piece has more candidates than the most, asking all
 * shapes costs little more. */
static inline int td_walk_room(const thud_world *w) {
    return td_min_int(w->shapes.count, 16384) + TD_LANES;
}

/* After td_query_prepare. */
td_walk td_walk_begin(const thud_world *w, const td_path *way, int *room, int size);

/* The next hits below the fraction `limit`, at most as many as k has room for; none: there are no
 * more. */
void td_walk_next(td_walk *walk, double limit, td_nearest *k);

#endif
