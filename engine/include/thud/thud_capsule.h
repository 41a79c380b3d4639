/* thud_capsule.h: capsules without a world: distance from circles, boxes, terrain and each other,
 * and times of impact. A capsule is the set of all points within a radius of a segment: the area
 * that a circle sweeps along a straight path. Pure functions: no state, no allocation.
 *
 * A capsule is the Minkowski sum of its segment and a circle. Its signed distance from a convex
 * shape is the distance of the segment minus the radius, and it meets a shape when the segment
 * comes within the radius of the shape (C. Ericson, Real-Time Collision Detection, 2004, 4.4.2).
 * Shapes of worlds are never capsules. Lengths are in any unit, relative to any origin near the
 * shapes.
 *
 * Every function returns THUD_ERROR_NULL for a null pointer and THUD_ERROR_INVALID for an invalid
 * capsule, shape or line, or a value out of range; outputs are then not written. */
#ifndef THUD_CAPSULE_H
#define THUD_CAPSULE_H

#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A capsule: all points within a distance of a segment. */
typedef struct thud_capsule {
    double x1, y1, x2, y2; /* the ends of the segment, which may coincide; |x|, |y| <=
                              THUD_COORDINATE_MAX */
    double radius;         /* (0, THUD_COORDINATE_MAX] */
} thud_capsule;

/* THUD_OK if all fields are finite and in their ranges. */
THUD_API thud_result thud_capsule_check(const thud_capsule *capsule);

/* The area that a moving circle sweeps: a shape at rest overlaps this capsule exactly if the circle
 * hits it. THUD_ERROR_INVALID if the shape is no circle, or if its path ends out of range. */
THUD_API thud_result thud_capsule_of_motion(const thud_geometry *circle, thud_motion motion,
                                            thud_capsule *out);

/* ---- distance ---- */

/* Both calls: signed distance, normal and closest points, as thud_geometry_closest, with the
 * capsule as a. They overlap if the distance is <= 0; the normal is then the axis of least
 * penetration. */
THUD_API thud_result thud_capsule_closest(const thud_capsule *a, const thud_geometry *b,
                                          thud_closest *out);
THUD_API thud_result thud_capsules_closest(const thud_capsule *a, const thud_capsule *b,
                                           thud_closest *out);

/* The same with the terrain as a and the capsule as b. If they overlap, the distance is that of the
 * capsule's segment from the ground (thud_terrain_closest) minus the radius: the length of the way
 * along the normal out of the nearest part of the ground. In a valley the capsule may still touch
 * another part after that. */
THUD_API thud_result thud_terrain_capsule_closest(const thud_terrain *terrain,
                                                  const thud_capsule *capsule, thud_closest *out);

/* ---- times of impact ---- */

/* The first time in [0, 1] at which the moving shapes come within the distance `target` ([0,
 * THUD_COORDINATE_MAX]) of each other, in closed form: as thud_geometry_time_of_impact, but for
 * motions without rotation only. All calls with a time of impact take the same arguments. */
THUD_API thud_result thud_capsule_time_of_impact(const thud_capsule *a, thud_motion motion_a,
                                                 const thud_geometry *b, thud_motion motion_b,
                                                 double target, bool *out_hit, double *out_time);
THUD_API thud_result thud_capsules_time_of_impact(const thud_capsule *a, thud_motion motion_a,
                                                  const thud_capsule *b, thud_motion motion_b,
                                                  double target, bool *out_hit, double *out_time);
/* The capsule moves against terrain at rest. */
THUD_API thud_result thud_terrain_capsule_time_of_impact(const thud_terrain *terrain,
                                                         const thud_capsule *capsule,
                                                         thud_motion motion, double target,
                                                         bool *out_hit, double *out_time);

#ifdef __cplusplus
}
#endif

#endif
