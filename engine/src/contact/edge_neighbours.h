/* edge_neighbours.h: a shape and the shapes that stand next to it, for internal_edges.h: the
 * queries by which edge_finder.c and internal_edges.c find out which part of the shape a neighbour
 * hides.
 *
 * The neighbours of a shape of a static body are all shapes of static bodies; those of a shape of a
 * moving body are the other shapes of the same body. */
#ifndef TD_EDGE_NEIGHBOURS_H
#define TD_EDGE_NEIGHBOURS_H

#include "geometry/shape_instance.h"
#include "state/shape.h"

/* Greatest gap or overlap between two faces that still counts as none, length scales. Whether a
 * face is covered is tested at twice this distance outside of it, where a neighbour whose own face
 * is in line with it does not reach. Chosen; not tuned. */
#define TD_NEIGHBOUR_GAP 1e-3

/* A shape in the frame that its neighbours are described in: the origin is the shape's centre, and
 * the axes are those of the world for a static body, those of the body for a moving one. */
typedef struct td_neighbourhood {
    thud_world *w;
    int shape, other;   /* other: a shape in contact with it, or TD_NONE */
    td_position origin; /* centre of the shape in the world; only for a static body */
    bool moves;         /* the body is not static */
    double c, s;        /* cosine and sine of the frame's rotation in the world; not static only */
    thud_geometry a, b; /* `shape` and `other` in the frame */
    double length_scale;
} td_neighbourhood;

/* For the present poses. With `other` TD_NONE, the field b is a copy of a. */
td_neighbourhood td_neighbourhood_of(thud_world *w, int shape, int other);
/* td_neighbourhood_of for given poses of both shapes, such as those at a time within the step. Both
 * are relative to the same origin, which may be any. */
void td_neighbourhood_between(td_neighbourhood *s, thud_world *w, int shape, int other,
                              const thud_geometry *a, const thud_geometry *b);

/* Whether a shape is one that can hide edges of static shapes: live, not a sensor, and of a static
 * body that is enabled. */
bool td_is_ground(const thud_world *w, int shape);

/* The instance of a neighbour in the frame of `s`. */
thud_geometry td_neighbour_instance(const td_neighbourhood *s, int neighbour);

/* Three queries about a neighbour. `placed` is its td_neighbour_instance, which the caller computes
 * once for all of them. */

/* Whether the neighbour, grown by `slack` on all sides, contains the point. A terrain contains what
 * is below its line. */
bool td_neighbour_contains(const td_neighbourhood *s, int neighbour, const thud_geometry *placed,
                           double x, double y, double slack);
/* Whether the neighbour and another shape share a point. The other is a box where the neighbour is
 * one. */
bool td_neighbour_overlaps(const td_neighbourhood *s, int neighbour, const thud_geometry *placed,
                           const thud_geometry *other);
/* Whether the neighbour extends further than `level` (length) beyond the point (x, y), which it
 * contains, in the direction of the unit vector (nx, ny). Of a terrain only the part of the line
 * within 2 TD_NEIGHBOUR_GAP of x counts, without its ends. */
bool td_neighbour_extends(const td_neighbourhood *s, int neighbour, const thud_geometry *placed,
                          double x, double y, double nx, double ny, double level);

/* Called for a neighbour; true ends the enumeration. */
typedef bool td_neighbour_fn(const td_neighbourhood *s, int neighbour, void *context);

/* Calls `fn` for the neighbours whose bounds are within 2 TD_NEIGHBOUR_GAP of `where` (an instance
 * in the frame of `s`), as long as it returns false; whether a call returned true. Where `other` is
 * not TD_NONE, a neighbour counts only if it may collide with `other`, too, and no one-way rule
 * lets `other` pass through it. Terrains count wherever they are. Uses scratch.found_shapes, for
 * which td_internal_edges_see, _find and _lose reserve room; false also where the search runs out
 * of memory. */
bool td_neighbour_any(const td_neighbourhood *s, const thud_geometry *where, td_neighbour_fn *fn,
                      void *context);

#endif
