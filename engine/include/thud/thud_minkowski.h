/* thud_minkowski.h: Minkowski sums of circles, AABBs and OBBs. Pure functions: no state, no
 * allocation.
 *
 * The sum of a and the reflected b is the set of all positions of b's centre, relative to a's
 * centre, at which the two shapes share a point. It reduces two shapes to one shape and a point:
 * they overlap if the point is in the sum, their distance is the distance of the point from it, and
 * shapes that move without rotation meet when the point's path enters it (Lozano-Perez, Spatial
 * planning: a configuration space approach, 1983). With p = (b.x - a.x, b.y - a.y), and d the
 * motion of b minus that of a:
 *
 *     thud_minkowski sum;
 *     thud_minkowski_sum(&a, &b, &sum);
 *     thud_minkowski_contains(&sum, p.x, p.y, &overlap);
 *     thud_minkowski_distance(&sum, p.x, p.y, &distance, &nx, &ny);
 *     thud_minkowski_cast(&sum, (thud_segment){p.x, p.y, d.x, d.y}, &hit, &fraction, &nx, &ny);
 *
 * The sum does not depend on the positions of the shapes: one sum serves all positions of a pair,
 * and is as precise far from the origin. Lengths are in any unit, angles in radians.
 *
 * Every function returns THUD_ERROR_NULL for a null pointer and THUD_ERROR_INVALID for a value that
 * is not finite or out of range, and then does not write its outputs. */
#ifndef THUD_MINKOWSKI_H
#define THUD_MINKOWSKI_H

#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

#define THUD_MINKOWSKI_VERTICES_MAX 8 /* vertices of a sum */

/* A convex polygon about the origin, rounded by a radius. Circles and boxes are symmetric about
 * their centre, and so is the sum: vertex i + count / 2 is the negated vertex i, and the same holds
 * for the faces. */
typedef struct thud_minkowski {
    /* The number of vertices: 1 for two circles, 8 for two boxes that are not parallel, else 4. */
    int count;
    thud_pos vertices[THUD_MINKOWSKI_VERTICES_MAX]; /* counter-clockwise; two may coincide */
    /* For the face from vertex i to i + 1, i < count / 2 (there is none for two circles): its unit
     * outward normal and its distance from the origin. */
    thud_pos normals[THUD_MINKOWSKI_VERTICES_MAX / 2];
    double offsets[THUD_MINKOWSKI_VERTICES_MAX / 2];
    double radius; /* of the rounding, [0, THUD_VOLUME_MAX]; the caller may add a margin to it */
} thud_minkowski;

/* The sum of a and the reflected b. The centres of the shapes have no effect, but must be valid.
 * Elements beyond count are 0. */
THUD_API thud_result thud_minkowski_sum(const thud_geometry *a, const thud_geometry *b,
                                        thud_minkowski *out);

/* Whether the point (x, y) is in the sum or on its edge. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_contains(const thud_minkowski *sum, double x, double y,
                                             bool *out_inside);

/* The point's signed distance from the edge of the sum, negative inside, and the unit normal along
 * which the point leaves the sum by the shortest way: the distance and normal of
 * thud_geometry_closest, from a to b. If several faces are equally near, the normal is that of one
 * of them. |x|, |y| <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_distance(const thud_minkowski *sum, double x, double y,
                                             double *out_distance, double *out_nx, double *out_ny);

/* Where the point that moves by (dx, dy) first enters the sum: *fraction of the motion, in [0, 1],
 * and the unit outward normal there. A point that starts inside hits at 0, with the normal of
 * thud_minkowski_distance. Without a hit *fraction is 1 and the normal (0, 0). |x|, |y|, |dx|, |dy|
 * <= THUD_VOLUME_MAX. */
THUD_API thud_result thud_minkowski_cast(const thud_minkowski *sum, thud_segment path,
                                         bool *out_hit, double *out_fraction, double *out_nx,
                                         double *out_ny);

#ifdef __cplusplus
}
#endif

#endif
