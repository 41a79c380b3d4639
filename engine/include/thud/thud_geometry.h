/* thud_geometry.h: geometry of shapes without a world: overlap, distance, contact points, rays,
 * times of impact, and terrain. Every function is pure: it has no state and allocates nothing.
 * Coordinates are in any unit, relative to any origin near the shapes; y is up, angles are in
 * radians counter-clockwise.
 *
 * Functions that return a thud_result return THUD_ERROR_NULL for a null pointer and
 * THUD_ERROR_INVALID for an invalid shape or a value out of range; outputs are then not written.
 * Included by thud.h. */
#ifndef THUD_GEOMETRY_H
#define THUD_GEOMETRY_H

#include "thud_limits.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The kinds of shapes. */
typedef enum thud_shape_kind {
    THUD_SHAPE_CIRCLE = 0,
    THUD_SHAPE_AABB,   /* axis-aligned box; never rotates */
    THUD_SHAPE_OBB,    /* oriented box */
    THUD_SHAPE_TERRAIN /* a ground line, solid below; see below */
} thud_shape_kind;

/* The number of kinds; no enumerator of thud_shape_kind, so that a switch over the kinds need not
 * name it. */
enum { THUD_SHAPE_KIND_COUNT = THUD_SHAPE_TERRAIN + 1 };

/* A circle, AABB or OBB at a pose. */
typedef struct thud_geometry {
    thud_shape_kind kind; /* not THUD_SHAPE_TERRAIN */
    double x, y;          /* centre; |x|, |y| <= THUD_COORDINATE_MAX */
    double c, s;          /* cosine and sine of the angle; for an OBB c * c + s * s is 1 within
                             THUD_UNIT_ERROR, for an AABB they are 1, 0; not read for a circle */
    double hx, hy; /* half extents, (0, THUD_COORDINATE_MAX]; a circle has its radius in hx, and
                      hy 0 */
} thud_geometry;

/* A circle with its centre at (x, y). It and the two constructors below are for the functions of
 * this header, for queries and movers, and for bodies that are made with their shapes
 * (thud_edits.h). They check nothing. */
static inline thud_geometry thud_circle_at(double x, double y, double radius) {
    thud_geometry circle = {THUD_SHAPE_CIRCLE, x, y, 1.0, 0.0, radius, 0.0};
    return circle;
}

/* A box parallel to the axes, with its centre at (x, y) and these half extents. */
static inline thud_geometry thud_aabb_at(double x, double y, double half_x, double half_y) {
    thud_geometry box = {THUD_SHAPE_AABB, x, y, 1.0, 0.0, half_x, half_y};
    return box;
}

/* The same box turned by `angle`, rad, counter-clockwise. An angle beyond THUD_ANGLE_MAX gives
 * (c, s) = (0, 0), which thud_geometry_check refuses. */
static inline thud_geometry thud_obb_at(double x, double y, double half_x, double half_y,
                                        double angle) {
    thud_geometry box = {THUD_SHAPE_OBB, x, y, 0.0, 0.0, half_x, half_y};
    thud_sincos(angle, &box.s, &box.c);
    return box;
}

/* The straight path of a ray or a point, from (x, y) to (x + dx, y + dy). */
typedef struct thud_segment {
    double x, y, dx, dy;
} thud_segment;

/* A motion over one unit of time: a translation at constant velocity and a rotation about the
 * centre at constant angular velocity. */
typedef struct thud_motion {
    double dx, dy; /* length */
    double turn;   /* rad, |turn| <= THUD_ANGLE_MAX; only an OBB turns */
} thud_motion;

/* The closest points of two shapes, or the deepest points where they overlap; point b - point a =
 * distance * normal. */
typedef struct thud_closest {
    double distance; /* signed; negative: penetration depth along the normal */
    double nx, ny;   /* unit normal from a to b */
    double ax, ay;   /* point on a's surface */
    double bx, by;   /* point on b's surface */
} thud_closest;

/* The contact points of two shapes that touch or nearly touch: first the closest points; if two
 * faces lie along each other, second the far end of the part where they face each other. */
typedef struct thud_contacts {
    int count;             /* 0..2 */
    thud_closest point[2]; /* the distance of each is its separation */
} thud_contacts;

/* How two moving circles pass each other. */
typedef struct thud_approach {
    bool hit;                 /* the circles touch during the motion */
    double time;              /* of the impact, in [0, 1]; 1 without one */
    double min_distance;      /* between the centres during the motion */
    double min_distance_time; /* time of that distance, in [0, 1]; the first such time */
} thud_approach;

/* THUD_OK if all fields are finite and in their ranges; the kind must not be THUD_SHAPE_TERRAIN. */
THUD_API thud_result thud_geometry_check(const thud_geometry *shape);

/* Whether the shapes share a point. Touching counts. False for invalid shapes. */
THUD_API bool thud_geometry_overlap(const thud_geometry *a, const thud_geometry *b);

/* Signed distance, normal and closest points. Where the shapes overlap, the normal is the axis of
 * least penetration. */
THUD_API thud_result thud_geometry_closest(const thud_geometry *a, const thud_geometry *b,
                                           thud_closest *out);

/* The contact points at which the shapes are within `margin` ([0, THUD_COORDINATE_MAX]) of each
 * other. The first is that of thud_geometry_closest. There may be a second if a face of one of two
 * boxes is at a right angle to the normal: the point furthest from the first along this face at
 * which the opposite face of the other box lies over it. */
THUD_API thud_result thud_geometry_contacts(const thud_geometry *a, const thud_geometry *b,
                                            double margin, thud_contacts *out);

/* Whether the ray hits the shape; *out_fraction, in [0, 1], is the fraction of the ray before the
 * hit, (*out_nx, *out_ny) the unit outward normal there. A ray that starts inside hits nothing.
 * False, too, for a shape or ray that is not valid. Outputs are written only for a hit, and may be
 * null. */
THUD_API bool thud_geometry_cast_ray(const thud_geometry *shape, thud_segment ray,
                                     double *out_fraction, double *out_nx, double *out_ny);

/* The first time in [0, 1] at which the moving shapes come within the distance `target` ([0,
 * THUD_COORDINATE_MAX]) of each other; *out_hit = false and *out_time = 1 if they never do. Shapes
 * that start within the target hit at 0. Without rotation the time is in closed form, exact up to
 * rounding. With rotation it is found by conservative advancement (B. Mirtich, Impulse-based
 * dynamic simulation, 1996), which ends when the distance is within 1e-10 of the shapes' size of
 * the target. The time is never late; it is early only if the shapes rotate close to each other for
 * so long that the limit of iterations is reached. */
THUD_API thud_result thud_geometry_time_of_impact(const thud_geometry *a, thud_motion motion_a,
                                                  const thud_geometry *b, thud_motion motion_b,
                                                  double target, bool *out_hit, double *out_time);

/* Impact and closest approach of two moving circles, in closed form; rotation has no effect. The
 * closest approach is that of the whole motion, as if the circles passed through each other.
 * THUD_ERROR_INVALID unless both are circles. */
THUD_API thud_result thud_geometry_approach(const thud_geometry *a, thud_motion motion_a,
                                            const thud_geometry *b, thud_motion motion_b,
                                            thud_approach *out);

/* The time at which moving shapes that are apart at time 0 and overlap at time 1 began to overlap,
 * by bisection over the motion. At *out_time, in [0, 1), they are still apart; at some time within
 * `tolerance` after it they overlap. tolerance, in [THUD_TOLERANCE_MIN, 1], is a fraction of the
 * motion; each halving of it costs one overlap test. *out_collided = false and *out_time = 1 if the
 * shapes are apart at the end, even if they passed through each other (see
 * thud_geometry_is_bisectable), or overlap at the start. */
THUD_API thud_result thud_geometry_time_of_collision(const thud_geometry *a, thud_motion motion_a,
                                                     const thud_geometry *b, thud_motion motion_b,
                                                     double tolerance, bool *out_collided,
                                                     double *out_time);

/* Whether an overlap test at the end of the motions cannot miss that one shape passed through the
 * middle of the other: the relative motion, with the rotation at the corners, is less than the
 * thickness of the thinner shape. Collisions in which corners only graze each other can still be
 * missed. False for invalid shapes. */
THUD_API bool thud_geometry_is_bisectable(const thud_geometry *a, thud_motion motion_a,
                                          const thud_geometry *b, thud_motion motion_b);

/* ---- terrain ---- */

/* How the line of a terrain is given. */
typedef enum thud_terrain_kind {
    THUD_TERRAIN_FLAT = 0, /* a straight line without ends: height = slope * x */
    THUD_TERRAIN_UNIFORM,  /* heights at x0, x0 + spacing, x0 + 2 * spacing and so on */
    THUD_TERRAIN_IRREGULAR /* points with strictly increasing x */
} thud_terrain_kind;

/* A ground line, solid below, with vertical sides below its two ends. The caller owns `points`, and
 * must keep them as long as the struct is used; a world copies them. Only thud_terrain_check checks
 * all vertices; the other functions only check the fields of the struct, and give a meaningless
 * result for invalid vertices. */
typedef struct thud_terrain {
    thud_terrain_kind kind;
    double slope;           /* flat only: rise over run, |slope| <= THUD_TERRAIN_SLOPE_MAX */
    double x0, spacing;     /* uniform only: |x0| <= THUD_TERRAIN_PLACE_MAX, spacing in (0,
                               THUD_TERRAIN_PLACE_MAX] and at least 1e-12 of the largest |x| */
    const thud_pos *points; /* uniform (only y is read) and irregular: |x|, |y| <=
                               THUD_TERRAIN_PLACE_MAX */
    int count;              /* of points, [2, THUD_TERRAIN_COUNT_MAX] */
} thud_terrain;

/* Height, normal and interpolation weights at one x. */
typedef struct thud_terrain_sample {
    double height;
    double nx, ny;    /* unit normal, ny > 0 */
    int segment;      /* the one between vertices segment and segment + 1; 0 for flat */
    double weight[2]; /* interpolation weights of these two vertices, of sum 1. A flat line has
                         vertices at x = 0 and x = 1, and the weights 1 - x and x at any x */
} thud_terrain_sample;

/* THUD_OK if all fields and all vertices are valid. Takes a pass over the vertices. */
THUD_API thud_result thud_terrain_check(const thud_terrain *terrain);

/* The line at x. Takes constant time for flat and uniform lines, logarithmic for irregular ones.
 * THUD_ERROR_INVALID beyond the ends. */
THUD_API thud_result thud_terrain_sample_at(const thud_terrain *terrain, double x,
                                            thud_terrain_sample *out);

/* The first and last segment that the interval [x_min, x_max] touches; *out_first > *out_last if
 * there are none. */
THUD_API void thud_terrain_segments(const thud_terrain *terrain, double x_min, double x_max,
                                    int *out_first, int *out_last);

/* As thud_geometry_cast_ray, against the line from above. A ray that starts below the line hits
 * nothing. */
THUD_API bool thud_terrain_cast_ray(const thud_terrain *terrain, thud_segment ray,
                                    double *out_fraction, double *out_nx, double *out_ny);

/* Whether the shape touches the line or the solid ground below it. */
THUD_API bool thud_terrain_overlap(const thud_terrain *terrain, const thud_geometry *shape);

/* As thud_geometry_closest with the terrain as a. If they overlap, distance and normal are those of
 * the shortest translation that moves the shape out of the ground, and the points belong to one of
 * the spots that touch after it. The time is proportional to the number of segments within the
 * resulting distance, and with overlap to that number times the number of segments under the
 * shape. */
THUD_API thud_result thud_terrain_closest(const thud_terrain *terrain, const thud_geometry *shape,
                                          thud_closest *out);

/* As thud_geometry_contacts with the terrain as a. Candidates for the second point are: each corner
 * of a box with the closest point of the ground; each convex vertex of the ground with the closest
 * point of the shape; and each segment that a circle touches. The second point is the candidate
 * within the margin that is furthest from the point of thud_terrain_closest. The first is the point
 * of thud_terrain_closest or, if several candidates are equally deep (to 1e-9 of the shape's size),
 * the one of them that is furthest from the second. Each point has its own normal: a circle in a
 * valley touches both slopes. */
THUD_API thud_result thud_terrain_contacts(const thud_terrain *terrain, const thud_geometry *shape,
                                           double margin, thud_contacts *out);

/* As thud_geometry_time_of_impact, for a shape that moves against terrain at rest. */
THUD_API thud_result thud_terrain_time_of_impact(const thud_terrain *terrain,
                                                 const thud_geometry *shape, thud_motion motion,
                                                 double target, bool *out_hit, double *out_time);

/* As thud_geometry_time_of_collision, for a shape that moves against terrain at rest. */
THUD_API thud_result thud_terrain_time_of_collision(const thud_terrain *terrain,
                                                    const thud_geometry *shape, thud_motion motion,
                                                    double tolerance, bool *out_collided,
                                                    double *out_time);

#ifdef __cplusplus
}
#endif

#endif
