/* thud_terrain.h: what games do with ground: texture it, stand on it, dig it up. The line itself,
 * its height at x and the tests against shapes are in thud_shapes.h. */
#ifndef THUD_TERRAIN_H
#define THUD_TERRAIN_H

#include "thud_ids.h"
#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- without a world ---- */

/* Texture coordinates, in the caller's own scale. */
typedef struct thud_uv {
    double u, v;
} thud_uv;

/* Texture coordinates at a sample: those of the vertices on both sides of it, `vertices[segment]`
 * and `vertices[segment + 1]`, by the sample's weights. The caller keeps one thud_uv a vertex; a
 * flat line has two, at x = 0 and x = 1, and goes on beyond them. THUD_ERROR_INVALID when there are
 * no such vertices among the `count`, or the outcome is not finite; *out is then as it was. */
THUD_API thud_result thud_terrain_texture_at(const thud_terrain_sample *sample,
                                             const thud_uv *vertices, int count, thud_uv *out);

/* Where a foot comes to stand. */
typedef struct thud_foot {
    double height; /* of the highest ground under the sole, so that no part of it sinks in */
    double x;      /* where that is; of several places the one nearest to the sole's middle */
    double nx, ny; /* unit normal, ny > 0, of the straight line between the ground under the sole's
                      two ends: how the character leans */
} thud_foot;

/* Puts a level sole of the given width (>= 0, finite) onto the ground, with its middle at x. What
 * juts out beyond an end of the line does not count. Takes three look-ups and a pass over the
 * vertices under the sole. THUD_ERROR_INVALID when no part of the sole is over the line; *out is
 * then as it was. */
THUD_API thud_result thud_terrain_place_foot(const thud_terrain *terrain, double x, double width,
                                             thud_foot *out);

/* ---- editing the line of a terrain shape while the world runs ----
 *
 * The line changes at once. In the next step every body wakes that touches a changed part, or would
 * now, with what is stacked on it; bodies elsewhere sleep on, and their contacts stay as they are.
 * A body that is left inside raised ground is pushed out through the nearest surface, at most at
 * the world's push_speed. A contact whose segment is gone ends, and begins anew with another.
 *
 * Every function: THUD_ERROR_STALE for a handle that names nothing, THUD_ERROR_LOCKED inside a
 * callback, THUD_ERROR_INVALID for a shape that is no terrain, a value that is not finite or out of
 * its range, and a line that thud_terrain_check would refuse; THUD_ERROR_MEMORY. The line is then
 * as it was. Vertices that come out as they were disturb nobody. An edit costs a pass over the
 * world's shapes and the terrain's contacts; where vertices come or go, those to the right of them
 * move as well. */

/* Replaces the heights of `count` vertices from `first` on; not of flat ground. Heights are
 * relative to the body's origin. */
THUD_API thud_result thud_shape_set_heights(thud_world *world, thud_shape_id shape, int first,
                                            const double *heights, int count);

/* Takes away the ground inside a circle, and what stands above it, since a line has no caves: under
 * the circle the ground goes down to its lower half. The centre is a place in the world; the radius
 * lies in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales. Ground below the circle stays. A uniform
 * line keeps its grid, so that a circle between two of its vertices digs nothing; an irregular one
 * gets up to 19 vertices more, and follows the circle within 1 % of the radius, but for walls at
 * its sides, which lean in by 2 %. Not for flat ground. */
THUD_API thud_result thud_shape_dig(thud_world *world, thud_shape_id shape, thud_pos center,
                                    double radius);

/* Raises a mound about x, a place in the world, over `radius` (range as above) to either side:
 * heights grow by height * (1 - u^2)^2 at the fraction u of the radius, so that neither foot nor
 * top has an edge. A negative height makes a hollow; |height| <= THUD_PLACE_MAX length scales. A
 * uniform line keeps its grid, an irregular one gets vertices as above. Not for flat ground. */
THUD_API thud_result thud_shape_raise(thud_world *world, thud_shape_id shape, double x,
                                      double radius, double height);

/* Replaces the vertices of an irregular line at x0 to x1, both included, by `count` others (>= 0;
 * null if 0) with strictly increasing x from x0 to x1. Coordinates are relative to the body's
 * origin, as in thud_shape_create_terrain. The range may lie beyond an end, and the line grows; at
 * least two vertices must be left. */
THUD_API thud_result thud_shape_replace_range(thud_world *world, thud_shape_id shape, double x0,
                                              double x1, const thud_pos *points, int count);

#ifdef __cplusplus
}
#endif

#endif
