/* edge_neighbours.h: a shape among its neighbours: of a static one, the other static shapes; of one
 * that moves, those of its own body. */
#ifndef TD_EDGE_NEIGHBOURS_H
#define TD_EDGE_NEIGHBOURS_H

#include "geometry/shape_instance.h"
#include "state/shape.h"

/* In length scales: neighbours may be so far apart or overlap so much. What lies twice as far
 * outside a face is looked at to see whether it is covered: a neighbour's face in line with it does
 * not reach there. */
#define TD_FLUSH 1e-3

/* A shape and another that it meets, or TD_NONE, relative to the centre of the first; along the
 * axes of the world where the first is static, else along those of its body. */
typedef struct td_internal_edge {
    thud_world *w;
    int shape, other;
    td_position origin; /* the centre, of a static shape */
    bool moves;
    double c, s; /* of the axes in the world */
    thud_shape_instance a, b;
    double unit;
} td_internal_edge;

td_internal_edge td_internal_edge_of(thud_world *w, int shape, int other);
/* Where the two are placed as told, relative to anything. */
td_internal_edge td_internal_edge_between(thud_world *w, int shape, int other,
                                          const thud_shape_instance *a,
                                          const thud_shape_instance *b);

/* A static shape that others meet. */
bool td_is_ground(const thud_world *w, int shape);

/* Where a neighbour stands, relative to the first shape and along the same axes. */
thud_shape_instance td_internal_edge_place(const td_internal_edge *s, int neighbour);

/* Three questions about a neighbour that stands where td_internal_edge_place says, which is asked
 * once for all of them. */

/* Whether the ground of a neighbour, `slack` thicker, holds a point. */
bool td_internal_edge_holds(const td_internal_edge *s, int neighbour,
                            const thud_shape_instance *placed, double x, double y, double slack);
/* Whether a neighbour shares a point with a box. */
bool td_internal_edge_meets(const td_internal_edge *s, int neighbour,
                            const thud_shape_instance *placed, const thud_shape_instance *box);
/* Whether a neighbour goes further than `level` past a point that it holds, along (nx, ny). */
bool td_internal_edge_rises(const td_internal_edge *s, int neighbour,
                            const thud_shape_instance *placed, double x, double y, double nx,
                            double ny, double level);

typedef bool td_neighbour_fn(const td_internal_edge *s, int neighbour, void *context);

/* Asks of each neighbour near a place that the other shape meets too, until one answers true. */
bool td_internal_edge_any(const td_internal_edge *s, const thud_shape_instance *where,
                          td_neighbour_fn *fn, void *context);

#endif
