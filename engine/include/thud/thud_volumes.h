/* thud_volumes.h: bounding volumes: a circle, AABB or OBB around an object, for a cheap test before
 * an exact one. Pure functions: no state, no allocation. Included by thud.h.
 *
 * The kinds, in ascending order of the cost to compute and test them, and of tightness:
 *
 *     circle   loosest; unchanged by rotation of the object
 *     AABB     tighter, a test compares two intervals; changes with rotation
 *     OBB      tightest, a test compares along up to four directions; rotates with the object
 *
 * Volumes are enlarged by 2e-15 of their position and size, so that no test misses a contained
 * object because of rounding. The volume of a body is the merged volume of its shapes.
 *
 * Every function returns THUD_ERROR_NULL for a null pointer and THUD_ERROR_INVALID for a value that
 * is not finite or out of range, or if the result would be out of the range of thud_volume_check;
 * outputs are then not written. `out` may be one of the inputs. Lengths are in any unit, relative
 * to any origin. */
#ifndef THUD_VOLUMES_H
#define THUD_VOLUMES_H

#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A shape at a pose, whose extents (for a circle hx, the radius) may also be 0. `kind` is the kind
 * of volume. */
typedef thud_geometry thud_volume;

/* THUD_OK if the volume is a circle, AABB or OBB, |x|, |y| <= THUD_VOLUME_MAX, extents are in [0,
 * THUD_VOLUME_MAX], and (c, s) is (1, 0) for an AABB and of squared length 1, within
 * THUD_UNIT_ERROR, for an OBB. For a circle c, s and hy are not read. */
THUD_API thud_result thud_volume_check(const thud_volume *volume);

/* ---- fitting: the volume of a given kind around an object ---- */

/* The smallest volume of this kind around a shape. */
THUD_API thud_result thud_volume_around_shape(thud_shape_kind kind, const thud_geometry *shape,
                                              thud_volume *out);

/* A volume that contains a shape at all times of its motion, with rotation. A box counts with its
 * maximum extent during the motion; for a bounding circle, it counts as the circle around it. An
 * OBB is aligned to the motion, or to the shape at half the motion, whichever makes it smaller. */
THUD_API thud_result thud_volume_around_motion(thud_shape_kind kind, const thud_geometry *shape,
                                               thud_motion motion, thud_volume *out);

/* The smallest volume around count >= 1 points, |x|, |y| <= THUD_COORDINATE_MAX, which may be on
 * one line or a single point. The smallest circle is found by exchanging the points that define it
 * (Elzinga and Hearn, Geometrical solutions for some minimax location problems, 1972), in a few
 * passes over the points. The OBB of least area has a side along a side of the convex hull (Freeman
 * and Shapira, Determining the minimum-area encasing rectangle, 1975): two passes over the points
 * for each side of the hull; at most 512 sides are tried. */
THUD_API thud_result thud_volume_around_points(thud_shape_kind kind, const thud_pos *points,
                                               int count, thud_volume *out);

/* The smallest volume around the ground line (without the ground below it) from x_min to x_max, as
 * around points. The interval is cut off at the ends of the line; THUD_ERROR_INVALID if nothing is
 * left of it. */
THUD_API thud_result thud_volume_around_terrain(thud_shape_kind kind, const thud_terrain *terrain,
                                                double x_min, double x_max, thud_volume *out);

/* A volume around two volumes: the smallest AABB; the smallest circle around their bounding
 * circles; or the smallest OBB of those with the direction of the axes, of a, of b, and from centre
 * to centre. */
THUD_API thud_result thud_volume_merge(thud_shape_kind kind, const thud_volume *a,
                                       const thud_volume *b, thud_volume *out);

/* ---- tests ---- */

/* Whether two volumes of any kinds share a point. Touching counts. In ascending order of cost: two
 * circles, two AABBs, circle and AABB, circle and OBB, AABB or OBB and OBB. */
THUD_API thud_result thud_volumes_overlap(const thud_volume *a, const thud_volume *b,
                                          bool *out_overlap);

/* Whether the point is in the volume or on its edge. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_volume_contains_point(const thud_volume *volume, double x, double y,
                                                bool *out_inside);

/* Whether every point of the inner volume is in the outer one. */
THUD_API thud_result thud_volume_contains(const thud_volume *outer, const thud_volume *inner,
                                          bool *out_inside);

#ifdef __cplusplus
}
#endif

#endif
