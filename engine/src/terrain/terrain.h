/* terrain.h: the segments of a ground line, for the files that work on them. */
#ifndef TD_TERRAIN_H
#define TD_TERRAIN_H

#include "geometry/shape_instance.h"

/* A segment with its unit tangent; its normal, out of the ground, is (-ty, tx). */
typedef struct td_segment {
    thud_pos p, q;
    double tx, ty;
    double length;
} td_segment;

static inline double td_along(double tx, double ty, thud_pos from, double x, double y) {
    return tx * (x - from.x) + ty * (y - from.y);
}

/* Signed distance of a point above the segment's line. */
static inline double td_above(const td_segment *s, double x, double y) {
    return s->tx * (y - s->p.y) - s->ty * (x - s->p.x);
}

/* Everything but the points' values; enough to read the line without going astray. */
thud_result td_terrain_readable(const thud_terrain *terrain);

/* Whether a vertex may stand there, to the right of the one before (null: it is the first). */
bool td_terrain_vertex_valid(thud_terrain_kind kind, const thud_pos *before,
                             const thud_pos *vertex);

/* Where a vertex of a line that is not flat stands. */
double td_terrain_x(const thud_terrain *terrain, int vertex);

/* The segment whose half-open column holds x, the first or last one for an x beyond the ends. */
int td_terrain_segment_at(const thud_terrain *terrain, double x);

/* How many vertices stand strictly to the left of x. */
int td_terrain_vertices_left_of(const thud_terrain *terrain, double x);

/* A flat line gives the piece between x_min and x_max. */
td_segment td_terrain_segment(const thud_terrain *terrain, int segment, double x_min, double x_max);

/* terrain_closest.c: as thud_terrain_closest, for the shape moved by `offset` and known to be
 * valid, or a circle of radius 0; points are relative to the moved centre. */
void td_terrain_closest(const thud_terrain *terrain, const thud_shape_instance *shape,
                        thud_pos offset, thud_closest *out);

#endif
