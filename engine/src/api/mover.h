/* mover.h: the state and the parts of one call of thud_mover_move.
 *
 * A mover is a kinematic character controller that is no body of the world. It moves by collide and
 * slide (K. Fauerby, Improved Collision Detection and Response, 2003; the same scheme as
 * PM_SlideMove of Quake III): cast the shape along the rest of its path, move it to just before the
 * first hit, remove from the rest of the path the part into the hit's plane, repeat. The mover
 * keeps a skin (a gap of thud_mover.skin) before every surface, so that casts begin free of
 * overlap.
 *
 *     mover.c       the call: checks, riding on the ground, pushing bodies, the mover's body
 *     mover_meet.c  casts and the filter of hits; overlap; which ground can be stood on
 *     mover_walk.c  walking, steps and snapping to the ground; sliding in the air */
#ifndef TD_MOVER_H
#define TD_MOVER_H

#include "thud/thud.h"
#include "thud/thud_mover.h"

/* The mover can stand on a corner only if the component along `up` of the hit's unit normal is at
 * least this; otherwise the corner is a wall, which climb() may take as a step. Chosen: the normal
 * is 84 degrees off `up`. It also bounds skin / rise in td_mover_settle to ten skins. */
#define TD_MIN_RISE 0.1

/* A direction, a displacement (length) or a velocity (length/s). */
typedef struct td_way {
    double x, y;
} td_way;

typedef struct td_move {
    thud_world *world;
    thud_mover mover; /* a copy; the caller's mover is written only when the whole call succeeds */
    thud_mover_report report;
    thud_vec2 velocity;      /* the caller's, length/s */
    td_way left;             /* the part of it that hits in the air have left, length/s */
    bool stopped;            /* a wall stopped the mover on the ground */
    thud_query_filter solid; /* the mover's filter without sensors */
    double dt;               /* s */
    double walkable;    /* cos(max_slope): ground whose normal has at least this along `up` can be
                           stood on */
    thud_result result; /* the first error of a query; from then on nothing moves any more */
} td_move;

static inline double td_dot(td_way a, td_way b) {
    return a.x * b.x + a.y * b.y;
}

static inline td_way td_scaled(td_way a, double by) {
    return (td_way){a.x * by, a.y * by};
}

/* a + b * by */
static inline td_way td_plus(td_way a, td_way b, double by) {
    return (td_way){a.x + b.x * by, a.y + b.y * by};
}

/* The length of a. */
static inline double td_size(td_way a) {
    return __builtin_sqrt(a.x * a.x + a.y * a.y);
}

static inline td_way td_up(const td_move *m) {
    return (td_way){(double)m->mover.up.x, (double)m->mover.up.y};
}

/* The hit's normal, which is in single precision, scaled to length 1 in double precision. */
td_way td_mover_normal(const thud_mover_hit *hit);

/* The first hit on the displacement `way` that stops the mover: one that it moves into and that
 * neither its own body nor the callback `pass` lets through. *fraction: the part of the way before
 * the hit. False without one. */
bool td_mover_meets(td_move *m, td_way way, thud_mover_hit *hit, double *fraction);

/* Moves the mover by the displacement `way`, or until it is a skin away from the plane of the first
 * hit. True if a hit stopped it. *left: the rest of the way; not written where the way is zero. */
bool td_mover_go(td_move *m, td_way way, thud_mover_hit *hit, td_way *left);

/* Adds the sensors on a displacement from the mover's place to the report, if its filter has
 * `sensors`. */
void td_mover_sense(td_move *m, td_way way);

/* Moves the mover out of static and kinematic shapes that overlap it. */
void td_mover_separate(td_move *m);

/* Adds a hit to the report, while there is room. */
void td_mover_note(td_move *m, const thud_mover_hit *hit);

/* Whether the mover can stand on a hit: its normal is no steeper than max_slope, or the hit is a
 * corner of a surface that is not, at most step_height above `bottom` (a coordinate along `up`,
 * length). */
bool td_mover_stands_on(td_move *m, const thud_mover_hit *hit, double bottom);

/* The coordinate along `up` of the mover's lowest point, length. */
double td_mover_bottom(const td_move *m);

/* Moves the mover along the ground that it stands on, up slopes and steps, until a wall stops it.
 * `way`: a displacement at a right angle to `up`; its length is kept along slopes. */
void td_mover_walk(td_move *m, td_way way);

/* Moves the mover down to a skin above the ground. False if there is no ground to stand on within
 * snap_distance. */
bool td_mover_settle(td_move *m);

/* Moves the mover through the air and along the surfaces that it hits. Once it comes down on ground
 * it walks the rest of the way. */
void td_mover_fly(td_move *m, td_way way);

#endif
