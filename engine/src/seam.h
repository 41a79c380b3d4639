/* seam.h: a static shape among its static neighbours. */
#ifndef TD_SEAM_H
#define TD_SEAM_H

#include "placed.h"
#include "world.h"

/* In length scales: neighbours may be so far apart or overlap so much. What lies twice as far outside
 * a face is looked at to see whether it is covered: a neighbour's face in line with it does not reach
 * there. */
#define TD_FLUSH 1e-3

/* A pair of which the first shape is static, relative to the centre of that; `other` may be TD_NONE. */
typedef struct td_seam {
    thud_world *w;
    int shape, other;
    td_place origin;
    thud_placed a, b;
    double unit;
} td_seam;

td_seam td_seam_of(thud_world *w, int shape, int other);

bool td_is_ground(const thud_world *w, int shape);

/* Whether the ground of a neighbour, `slack` thicker, holds a point. */
bool td_seam_holds(const td_seam *s, int neighbour, double x, double y, double slack);
/* Whether a neighbour goes further than `level` past a point that it holds, along (nx, ny). */
bool td_seam_rises(const td_seam *s, int neighbour, double x, double y, double nx, double ny,
                   double level);

typedef bool td_neighbour_fn(const td_seam *s, int neighbour, void *context);

/* Asks of each static shape near a place, relative to the origin, that the other shape meets too, until
 * one answers true. */
bool td_seam_any(const td_seam *s, const thud_placed *where, td_neighbour_fn *fn, void *context);

#endif
