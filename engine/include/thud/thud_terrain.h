/* thud_terrain.h: terrain in games: texture coordinates, placing feet, and edits of the line. The
 * line itself, its height at x and the tests against shapes are in thud_geometry.h. thud.h includes
 * this header. */
#ifndef THUD_TERRAIN_H
#define THUD_TERRAIN_H

#include "thud_ids.h"
#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- without a world ---- */

/* Texture coordinates, in any scale. */
typedef struct thud_uv {
    double u, v;
} thud_uv;

/* Interpolates texture coordinates at a sample, between `vertices[segment]` and `vertices[segment +
 * 1]`, by the sample's weights. The caller has one thud_uv for each of `count` vertices; a flat
 * line has two, at x = 0 and x = 1, and is extrapolated beyond them. THUD_ERROR_NULL;
 * THUD_ERROR_INVALID if the vertices do not contain the segment, or the result is not finite; *out
 * is then not written. */
THUD_API thud_result thud_terrain_texture_at(const thud_terrain_sample *sample,
                                             const thud_uv *vertices, int count, thud_uv *out);

/* The position of a foot on the ground. */
typedef struct thud_foot {
    double height; /* of the highest ground under the sole, so that no part of the sole is below
                      ground */
    double x;      /* x of that ground; of several equally high points the nearest to the middle of
                      the sole */
    double nx, ny; /* unit normal, ny > 0, of the straight line between the ground under the two
                      ends of the sole, by which to tilt the character */
} thud_foot;

/* Places a horizontal sole of this width (>= 0, finite) on the ground, with its middle at x. Parts
 * beyond an end of the line are ignored. The cost is three look-ups and a pass over the vertices
 * under the sole. THUD_ERROR_NULL; THUD_ERROR_INVALID if no part of the sole is over the line; *out
 * is then not written. */
THUD_API thud_result thud_terrain_place_foot(const thud_terrain *terrain, double x, double width,
                                             thud_foot *out);

/* ---- editing the line of a terrain shape while the world runs ----
 *
 * The line changes at once. The next step wakes every body that touches a changed part, before or
 * after the change, and the bodies stacked on it; other bodies stay asleep, and keep their
 * contacts. A body that ends inside raised ground is moved out through the nearest surface, at no
 * more than the world's push_speed. A contact with a segment that no longer exists ends, and begins
 * again with another segment.
 *
 * All return THUD_ERROR_NULL for a null world, THUD_ERROR_STALE for a handle that names nothing,
 * THUD_ERROR_LOCKED inside a callback, THUD_ERROR_INVALID for a shape that is no terrain, a value
 * that is not finite or out of range, and a resulting line that thud_terrain_check would refuse,
 * and THUD_ERROR_MEMORY. The line is then unchanged. Vertices that do not change wake no bodies. An
 * edit costs a pass over the world's shapes and the terrain's contacts, and, if vertices are added
 * or removed, a move of all vertices to the right of them. */

/* Replaces the heights of `count` vertices from number `first` on, relative to the body's origin.
 * Not for flat terrain. */
THUD_API thud_result thud_shape_set_heights(thud_world *world, thud_shape_id shape, int first,
                                            const double *heights, int count);

/* Removes the ground inside a circle, and the ground above it, since a line cannot have caves:
 * ground above the circle's lower half is lowered to it. The centre is in world coordinates; the
 * radius is in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales. A uniform line keeps the x of its
 * vertices, so that a circle between two of them has no effect. An irregular line gets up to 19 new
 * vertices, and follows the circle within 1 % of the radius, except for the walls at its sides,
 * which lean in by 2 %. Not for flat terrain. */
THUD_API thud_result thud_shape_dig(thud_world *world, thud_shape_id shape, thud_pos center,
                                    double radius);

/* Adds a smooth hill around x, a world coordinate, that extends by `radius` (range as above) to
 * both sides: at the distance u * radius from x the ground rises by height * (1 - u^2)^2, whose
 * slope is 0 at the foot and the top. A negative height makes a hollow; |height| <= THUD_PLACE_MAX
 * length scales. A uniform line keeps the x of its vertices, an irregular one gets new vertices as
 * above. Not for flat terrain. */
THUD_API thud_result thud_shape_raise(thud_world *world, thud_shape_id shape, double x,
                                      double radius, double height);

/* Replaces the vertices of an irregular line from x0 to x1, both included, by `count` (>= 0) points
 * with strictly increasing x in [x0, x1]; `points` may be null if count is 0. Coordinates are
 * relative to the body's origin, as in thud_shape_create_terrain. The range may extend beyond an
 * end of the line, which then grows; at least two vertices must remain. */
THUD_API thud_result thud_shape_replace_range(thud_world *world, thud_shape_id shape, double x0,
                                              double x1, const thud_pos *points, int count);

#ifdef __cplusplus
}
#endif

#endif
