/* mover.h: one call of thud_mover_move under way. */
#ifndef TD_MOVER_H
#define TD_MOVER_H

#include "thud/thud.h"
#include "thud/thud_mover.h"

/* Corners whose normal has less of `up` are climbed as steps, not rolled over. */
#define TD_LEAST_RISE 0.1

/* A direction or a way, in the caller's unit. */
typedef struct td_way {
    double x, y;
} td_way;

typedef struct td_move {
    thud_world *world;
    thud_mover mover; /* as it stands now; the caller's own is written last */
    thud_mover_report report;
    thud_vec2 velocity;      /* asked for */
    td_way left;             /* what is left of the velocity in the air */
    bool stopped;            /* by a wall, on the ground */
    thud_query_filter solid; /* the mover's filter without sensors, which stop nobody */
    double dt;
    double walkable;    /* least part of a ground's normal along `up` */
    thud_result result; /* the first that went wrong; then nothing moves any more */
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

static inline double td_size(td_way a) {
    return __builtin_sqrt(a.x * a.x + a.y * a.y);
}

static inline td_way td_up(const td_move *m) {
    return (td_way){(double)m->mover.up.x, (double)m->mover.up.y};
}

/* The hit's normal with length 1 in double precision. */
td_way td_mover_normal(const thud_mover_hit *hit);

/* The first thing in the way that stops the mover; *fraction of the way goes by before it
 * touches. */
bool td_mover_meets(td_move *m, td_way way, thud_mover_hit *hit, double *fraction);

/* Goes the way, up to a skin before whatever is met first; true if something was, and *left is then
 * what remains of the way. */
bool td_mover_go(td_move *m, td_way way, thud_mover_hit *hit, td_way *left);

/* Notes the sensors on a way from where it stands, where the mover's filter wants them. */
void td_mover_sense(td_move *m, td_way way);

/* Pushes the mover out of what has closed in on it. */
void td_mover_separate(td_move *m);

/* Notes a hit for the report. */
void td_mover_note(td_move *m, const thud_mover_hit *hit);

/* Whether the mover can stand on what it met: it is not too steep, or it is the corner of something
 * that is not, no further above `bottom` (along up) than a step. */
bool td_mover_stands_on(td_move *m, const thud_mover_hit *hit, double bottom);

/* How far the lowest point of the mover is along up. */
double td_mover_bottom(const td_move *m);

/* Along the ground that it stands on, up slopes and steps; a wall stops it. `way` is across up. */
void td_mover_walk(td_move *m, td_way way);

/* Down to the ground, a skin above it; false if there is none within the snap distance. */
bool td_mover_settle(td_move *m);

/* Along whatever it touches. Where it comes down on ground, it stands and walks what is left. */
void td_mover_fly(td_move *m, td_way way);

#endif
