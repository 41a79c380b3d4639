/* thud_minkowski.h: Minkowski sums of circles, AABBs and OBBs. Pure: no state, no allocation.
 *
 * The sum of a and the reflected b holds every place of b's centre, seen from a's, at which the
 * shapes share a point. So two shapes become one shape and a point: they overlap when the point is
 * in the sum, their distance is the point's distance from it, and shapes that move without turning
 * meet when the point's path enters it (Lozano-Perez, Spatial planning: a configuration space
 * approach, 1983). With p for (b.x - a.x, b.y - a.y) and d for the motion of b less that of a:
 *
 *     thud_minkowski sum;
 *     thud_minkowski_sum(&a, &b, &sum);
 *     thud_minkowski_contains(&sum, p.x, p.y, &overlap);
 *     thud_minkowski_distance(&sum, p.x, p.y, &distance, &nx, &ny);
 *     thud_minkowski_cast(&sum, p.x, p.y, d.x, d.y, &hit, &fraction, &nx, &ny);
 *
 * The sum does not depend on where the shapes are: one sum serves all places of a pair, and loses
 * nothing far from the origin. Lengths are the caller's own, angles in radians.
 *
 * Every function returns THUD_ERROR_NULL for a null pointer and THUD_ERROR_INVALID for a value that
 * is not finite or out of range, and then leaves its outputs as they were. */
#ifndef THUD_MINKOWSKI_H
#define THUD_MINKOWSKI_H

#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define THUD_MINKOWSKI_MAX 8 /* vertices of a sum */

/* A convex polygon about the origin, rounded by a radius. Circles and boxes are their own mirror
 * images, and so is the sum: vertex i + count / 2 is vertex i negated, and so with the faces. */
typedef struct thud_minkowski {
    /* Vertices: 1 of two circles, 4, or 8 of two boxes that are not parallel. */
    int count;
    thud_pos vertices[THUD_MINKOWSKI_MAX]; /* counter-clockwise; two may coincide */
    /* Of the faces from vertex i to i + 1, i < count / 2 (none of two circles): outward, of length
     * 1, and the face's distance from the origin. */
    thud_pos normals[THUD_MINKOWSKI_MAX / 2];
    double offsets[THUD_MINKOWSKI_MAX / 2];
    double radius; /* of the rounding, [0, THUD_VOLUME_MAX]; a caller may grow it by a margin */
} thud_minkowski;

/* The sum of a and the reflected b. The centres are not read, but must be valid. Entries beyond
 * count are 0. */
THUD_API thud_result thud_minkowski_sum(const thud_shape_instance *a, const thud_shape_instance *b,
                                        thud_minkowski *sum);

/* Whether the point (x, y) is in the sum; its edge belongs to it. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_contains(const thud_minkowski *sum, double x, double y,
                                             bool *inside);

/* The point's signed distance from the edge of the sum, negative inside, and the unit normal along
 * which the point leaves the soonest: thud_shapes_closest's distance and normal, from a to b. Where
 * several faces are as near, it is one of theirs. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_distance(const thud_minkowski *sum, double x, double y,
                                             double *distance, double *nx, double *ny);

/* Where the point, moving by (dx, dy), first is in the sum: *fraction of the motion, in [0, 1], and
 * the outward unit normal there. A point that starts in the sum hits at 0, with the normal of
 * thud_minkowski_distance. Without a hit *fraction is 1 and the normal (0, 0).
 * |x|, |y|, |dx|, |dy| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_cast(const thud_minkowski *sum, double x, double y, double dx,
                                         double dy, bool *hit, double *fraction, double *nx,
                                         double *ny);

#ifdef __cplusplus
}
#endif

#endif
