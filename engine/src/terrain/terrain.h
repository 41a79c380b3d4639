/* terrain.h: the segments of a terrain, and the internal functions on terrains without a world.
 *
 * A terrain (thud_terrain of thud_geometry.h) is a line with one height for each x: an endless
 * straight line (THUD_TERRAIN_FLAT), vertices at equal distances (UNIFORM), or vertices at any
 * rising x (IRREGULAR). The ground is solid below the line, down to any depth, and ends in a
 * vertical side under each end vertex. Coordinates are relative to the terrain's origin, in the
 * caller's unit, in double precision. Segment i is between the vertices i and i + 1; a flat line
 * has the segment 0 alone. */
#ifndef TD_TERRAIN_H
#define TD_TERRAIN_H

#include "geometry/shape_instance.h"

/* A segment from its left end p to its right end q. Its unit normal, out of the ground, is (-ty,
 * tx). */
typedef struct td_segment {
    thud_pos p, q;
    double tx, ty; /* unit tangent, to the right */
    double length;
} td_segment;

/* The coordinate of (x, y) along the unit tangent (tx, ty), measured from the point `from`. */
static inline double td_along(double tx, double ty, thud_pos from, double x, double y) {
    return tx * (x - from.x) + ty * (y - from.y);
}

/* The signed distance of (x, y) from the infinite line through the segment, positive out of the
 * ground. */
static inline double td_above(const td_segment *s, double x, double y) {
    return s->tx * (y - s->p.y) - s->ty * (x - s->p.x);
}

/* Checks kind, count, and the ranges of slope, x0 and spacing of a terrain, but not the coordinates
 * of its vertices. It takes constant time; a terrain that passes can be read without an access out
 * of bounds. */
thud_result td_terrain_readable(const thud_terrain *terrain);

/* Whether a vertex is in range and to the right of the one before it; `before` is null for the
 * first vertex. */
bool td_terrain_vertex_valid(thud_terrain_kind kind, const thud_pos *before,
                             const thud_pos *vertex);

/* The x of a vertex; not of a flat line. */
double td_terrain_x(const thud_terrain *terrain, int vertex);

/* The segment i with x_i <= x < x_(i+1); the first or last one for an x beyond the ends. */
int td_terrain_segment_at(const thud_terrain *terrain, double x);

/* The number of vertices with a smaller x than `x`; not of a flat line. */
int td_terrain_vertices_left_of(const thud_terrain *terrain, double x);

/* The segment. For a flat line it is the piece between x_min and x_max; other kinds ignore these
 * arguments. */
td_segment td_terrain_segment(const thud_terrain *terrain, int segment, double x_min, double x_max);

/* terrain_closest.c: as thud_terrain_closest, for a valid shape (not checked again) that is moved
 * by `offset`; it may also be a circle of radius 0 or a box of thickness 0. The points of *out are
 * relative to the moved centre. */
void td_terrain_closest(const thud_terrain *terrain, const thud_geometry *shape, thud_pos offset,
                        thud_closest *out);

/* terrain_toi.c: as thud_terrain_time_of_impact, for valid input (not checked again); circles and
 * boxes may have size 0 as above. */
void td_terrain_time_of_impact(const thud_terrain *terrain, const thud_geometry *shape,
                               thud_motion motion, double target, bool *out_hit, double *out_time);

#endif
