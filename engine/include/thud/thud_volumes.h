/* thud_volumes.h: bounding volumes. A circle, an AABB or an OBB around something stands for it in a
 * first, cheap test; only what passes needs an exact one. Pure: no state, no allocation.
 *
 * In the order of their price, both to fit and to test, and of how tightly they fit:
 *
 *     circle   loose and cheapest; does not change when the thing turns
 *     AABB     tighter, two intervals to compare; changes as the thing turns
 *     OBB      tightest, up to four directions to compare in; turns with the thing
 *
 * Volumes are grown by a few roundings (2e-15 of their place and size), so that no test misses what
 * is within for a rounding. A body's volume is that of its shapes, merged.
 *
 * Every function returns THUD_ERROR_NULL for a null pointer and THUD_ERROR_INVALID for a value that
 * is not finite or out of range, or when the outcome would exceed thud_volume_check's range, and
 * then leaves its outputs as they were. `out` may be an input. Lengths are the caller's own,
 * relative to any origin. */
#ifndef THUD_VOLUMES_H
#define THUD_VOLUMES_H

#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* As a placed shape, but that its extents (a circle's radius is hx) may be 0. `kind` says which
 * volume it is. */
typedef thud_shape_instance thud_volume;

/* THUD_OK if it is a circle, AABB or OBB, |x|, |y| <= THUD_VOLUME_MAX, extents in [0,
 * THUD_VOLUME_MAX], and (c, s) of length 1, its square within THUD_UNIT_ERROR, (1, 0) for an AABB.
 * Of a circle, c, s and hy are not read. */
THUD_API thud_result thud_volume_check(const thud_volume *volume);

/* ---- fit: the volume of the wanted kind around something ---- */

/* The smallest of its kind. */
THUD_API thud_result thud_volume_around_shape(thud_shape_kind kind,
                                              const thud_shape_instance *shape, thud_volume *out);

/* Around every place of the shape in its motion, turning included. A box counts as wide everywhere
 * as it ever is on its way, for a circle as the circle around it. An OBB lies in the direction of
 * the motion or in the shape's own direction halfway, whichever makes it smaller. */
THUD_API thud_result thud_volume_around_motion(thud_shape_kind kind,
                                               const thud_shape_instance *shape, thud_motion motion,
                                               thud_volume *out);

/* Around count >= 1 points, |x|, |y| <= THUD_COORDINATE_MAX; one point, or all on a line, will do.
 * The smallest circle, by exchanging the points that it rests on (Gaertner, Fast and robust
 * smallest enclosing balls, 1999), takes a few passes over the points. The OBB of least area has a
 * side along a side of the convex hull (Freeman and Shapira, Determining the minimum-area encasing
 * rectangle, 1975): two passes for each of the hull's sides, of which the first 512 are tried. */
THUD_API thud_result thud_volume_around_points(thud_shape_kind kind, const thud_pos *points,
                                               int count, thud_volume *out);

/* Around the ground line (not what is below it) from x_min to x_max, as around points; cut off at
 * the ends of the line, THUD_ERROR_INVALID when nothing of it is left. */
THUD_API thud_result thud_volume_around_terrain(thud_shape_kind kind, const thud_terrain *terrain,
                                                double x_min, double x_max, thud_volume *out);

/* Around both: the smallest AABB; the smallest circle around the circles of the two; an OBB
 * upright, in the direction of a, of b, or from centre to centre, whichever is the smallest. */
THUD_API thud_result thud_volume_merge(thud_shape_kind kind, const thud_volume *a,
                                       const thud_volume *b, thud_volume *out);

/* ---- test ---- */

/* Whether two volumes of any kinds share a point. Touching counts. From cheap to dear: two circles,
 * two AABBs, circle and AABB, circle and OBB, AABB or OBB and OBB. */
THUD_API thud_result thud_volumes_overlap(const thud_volume *a, const thud_volume *b,
                                          bool *overlap);

/* Whether the point is in the volume; its edge belongs to it. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_volume_contains_point(const thud_volume *volume, double x, double y,
                                                bool *inside);

/* Whether every point of the inner volume is in the outer one. */
THUD_API thud_result thud_volume_contains(const thud_volume *outer, const thud_volume *inner,
                                          bool *inside);

#ifdef __cplusplus
}
#endif

#endif
