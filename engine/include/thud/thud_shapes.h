/* thud_shapes.h: geometry without a world. Every function is pure: no state, no allocation.
 * Coordinates are the caller's own, relative to any origin near the shapes, y up, angles in
 * radians counter-clockwise. */
#ifndef THUD_SHAPES_H
#define THUD_SHAPES_H

#include "thud_limits.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum thud_shape_kind {
    THUD_CIRCLE = 0,
    THUD_AABB,   /* axis-aligned box; never rotates */
    THUD_OBB,    /* oriented box */
    THUD_TERRAIN /* ground line, solid below */
} thud_shape_kind;

/* How many kinds there are; no enumerator of thud_shape_kind, so that a switch over the kinds need
 * not name it. */
enum { THUD_SHAPE_KIND_COUNT = THUD_TERRAIN + 1 };

/* A circle, AABB or OBB in its place. */
typedef struct thud_shape_instance {
    thud_shape_kind kind; /* not THUD_TERRAIN */
    double x, y;          /* centre; |x|, |y| <= THUD_COORDINATE_MAX */
    double c, s;          /* cosine and sine of the angle; 1, 0 unless OBB: then c * c + s * s is 1
                             within THUD_UNIT_ERROR; not read of a circle */
    double hx, hy;        /* half extents, (0, THUD_COORDINATE_MAX]; a circle's radius is hx, its hy
                             is 0 */
} thud_shape_instance;

/* Shapes in their places, each in one expression: for the functions here, for queries and movers,
 * and for bodies that are made with their shapes (thud_edits.h). Nothing is checked; an OBB whose
 * angle is beyond THUD_ANGLE_MAX has no direction, by which thud_placed_check refuses it. */
static inline thud_shape_instance thud_circle_at(double x, double y, double radius) {
    thud_shape_instance circle = {THUD_CIRCLE, x, y, 1.0, 0.0, radius, 0.0};
    return circle;
}

static inline thud_shape_instance thud_aabb_at(double x, double y, double half_x, double half_y) {
    thud_shape_instance box = {THUD_AABB, x, y, 1.0, 0.0, half_x, half_y};
    return box;
}

static inline thud_shape_instance thud_obb_at(double x, double y, double half_x, double half_y,
                                              double angle) {
    thud_shape_instance box = {THUD_OBB, x, y, 0.0, 0.0, half_x, half_y};
    thud_sincos(angle, &box.s, &box.c);
    return box;
}

/* Straight motion with turning about the centre, over one unit of time. */
typedef struct thud_motion {
    double dx, dy;
    double turn; /* radians, |turn| <= THUD_ANGLE_MAX; only an OBB heeds it */
} thud_motion;

/* The closest (or deepest) features of two shapes; (b - a) = distance * normal. */
typedef struct thud_closest {
    double distance; /* negative: penetration depth along the normal */
    double nx, ny;   /* unit normal from a to b */
    double ax, ay;   /* the feature's point on a's surface */
    double bx, by;   /* ... and on b's */
} thud_closest;

/* Where two shapes touch, or nearly: the closest features first, and where a face lies along
 * another the far end of what they share. */
typedef struct thud_contacts {
    int count;             /* 0..2 */
    thud_closest point[2]; /* a point's distance is its separation */
} thud_contacts;

/* How two moving circles pass each other. */
typedef struct thud_approach {
    bool hit;
    double time;       /* of the impact; 1 without one */
    double least;      /* the smallest distance that ever separates the centres */
    double least_time; /* when, in [0, 1]; the first time if the circles keep their distance */
} thud_approach;

/* THUD_OK if finite and in range. */
THUD_API thud_result thud_placed_check(const thud_shape_instance *shape);

/* True if the shapes share a point. Touching counts. False also for invalid shapes. */
THUD_API bool thud_shapes_overlap(const thud_shape_instance *a, const thud_shape_instance *b);

/* Signed distance, normal and closest points. Overlapping shapes give the axis of least
 * penetration. */
THUD_API thud_result thud_shapes_closest(const thud_shape_instance *a, const thud_shape_instance *b,
                                         thud_closest *out);

/* The points at which the shapes are within `margin` ([0, THUD_COORDINATE_MAX]) of each other. The
 * first is that of thud_shapes_closest. Boxes of which one has a face across the normal may have a
 * second: the place furthest from the first along that face where the other box's opposite face
 * lies over it. */
THUD_API thud_result thud_shapes_contacts(const thud_shape_instance *a,
                                          const thud_shape_instance *b, double margin,
                                          thud_contacts *out);

/* Where the ray from (ox, oy) along (dx, dy) first meets the shape. *fraction is in [0, 1] of the
 * translation, (*nx, *ny) the outward unit normal there. A ray that starts inside hits nothing. */
THUD_API bool thud_shape_cast_ray(const thud_shape_instance *shape, double ox, double oy, double dx,
                                  double dy, double *fraction, double *nx, double *ny);

/* First time in [0, 1] at which the moving shapes come within `target` ([0,
 * THUD_COORDINATE_MAX]) of each other; 1 and
 * *hit = false if they never do. Shapes that start within the target hit at 0. Without turning the
 * time is in closed form, exact but for rounding; with turning it is found by conservative
 * advancement, as soon as the shapes are within 1e-10 of their size of the target: never late, and
 * early where they turn so close by each other, for so long, that the work is cut off. */
THUD_API thud_result thud_shapes_time_of_impact(const thud_shape_instance *a, thud_motion motion_a,
                                                const thud_shape_instance *b, thud_motion motion_b,
                                                double target, bool *hit, double *time);

/* Impact and nearest approach of two circles in closed form; turning does not matter. The nearest
 * approach is of the whole motion, as if the circles went through each other. THUD_ERROR_INVALID
 * unless both are circles. */
THUD_API thud_result thud_circles_approach(const thud_shape_instance *a, thud_motion motion_a,
                                           const thud_shape_instance *b, thud_motion motion_b,
                                           thud_approach *out);

/* When the moving shapes began to overlap, by bisection over the motion, for shapes that are apart
 * at time 0 and overlap at time 1. At *time, in [0, 1), they are still apart, and within
 * `tolerance` of it they overlap; tolerance is in [THUD_TOLERANCE_MIN, 1], of the motion, and each
 * halving costs one overlap test. *collided = false and *time = 1 where they are apart at the end,
 * whatever happened in between (see thud_motion_is_bisectable), or overlap at the start. */
THUD_API thud_result thud_shapes_time_of_collision(const thud_shape_instance *a,
                                                   thud_motion motion_a,
                                                   const thud_shape_instance *b,
                                                   thud_motion motion_b, double tolerance,
                                                   bool *collided, double *time);

/* Whether a test at the end of the motions cannot miss that one shape went through the middle of
 * the other: they move by less, relative to each other and with what turning adds at their corners,
 * than the smaller of both is thick. Corners that only graze each other can be missed all the same.
 * False for invalid shapes. */
THUD_API bool thud_motion_is_bisectable(const thud_shape_instance *a, thud_motion motion_a,
                                        const thud_shape_instance *b, thud_motion motion_b);

/* ---- terrain ---- */

typedef enum thud_terrain_kind {
    THUD_TERRAIN_FLAT = 0, /* an endless straight line: height = slope * x */
    THUD_TERRAIN_UNIFORM,  /* heights at x0, x0 + spacing, ... */
    THUD_TERRAIN_IRREGULAR /* points with strictly increasing x */
} thud_terrain_kind;

/* A ground line, one-sided: solid below, with upright sides under its ends. The caller owns
 * `points` (uniform: only y is read) and must keep them while the view is used; a world copies
 * them. That every vertex is finite and further right than the one before is seen by
 * thud_terrain_check alone: the other functions refuse whatever is wrong at first sight, and give a
 * result without a meaning for a line that it would refuse. */
typedef struct thud_terrain {
    thud_terrain_kind kind;
    double slope;           /* flat only: rise over run, |slope| <= THUD_TERRAIN_SLOPE_MAX */
    double x0, spacing;     /* uniform only; |x0| <= THUD_TERRAIN_PLACE_MAX, spacing in (0,
                               THUD_TERRAIN_PLACE_MAX], and 1e-12 of the furthest x at least */
    const thud_pos *points; /* uniform and irregular; |x|, |y| <= THUD_TERRAIN_PLACE_MAX */
    int count;              /* [2, THUD_TERRAIN_COUNT_MAX] */
} thud_terrain;

/* Height, normal and interpolation weights at one x. */
typedef struct thud_terrain_sample {
    double height;
    double nx, ny;    /* unit normal, ny > 0 */
    int segment;      /* between vertices segment and segment + 1; 0 for flat */
    double weight[2]; /* of those two vertices; they sum to 1. A flat line counts as one with
                         vertices at x = 0 and x = 1, and goes on beyond them: 1 - x, x */
} thud_terrain_sample;

THUD_API thud_result thud_terrain_check(const thud_terrain *terrain);

/* Constant time for flat and uniform, logarithmic for irregular. THUD_ERROR_INVALID beyond the
 * ends. */
THUD_API thud_result thud_terrain_sample_at(const thud_terrain *terrain, double x,
                                            thud_terrain_sample *out);

/* First and last segment that the interval [x_min, x_max] touches; first > last when none. */
THUD_API void thud_terrain_segments(const thud_terrain *terrain, double x_min, double x_max,
                                    int *first, int *last);

/* As thud_shape_cast_ray, against the line from above; a ray that starts below hits nothing. */
THUD_API bool thud_terrain_cast_ray(const thud_terrain *terrain, double ox, double oy, double dx,
                                    double dy, double *fraction, double *nx, double *ny);

/* True if the shape reaches the line or the solid ground below it. */
THUD_API bool thud_terrain_overlap(const thud_terrain *terrain, const thud_shape_instance *shape);

/* As thud_shapes_closest with the terrain as a. Overlapping, the distance is that of the least
 * translation that takes the shape out of the ground, and the normal its direction; the points are
 * of one of the places that then touch. Time grows with the number of segments that are as near as
 * the result, and when overlapping with that number times those under the shape's width. */
THUD_API thud_result thud_terrain_closest(const thud_terrain *terrain,
                                          const thud_shape_instance *shape, thud_closest *out);

/* As thud_shapes_contacts with the terrain as a. Candidates for the second point are the corners of
 * a box, each with the nearest place of the ground; the ridges of the ground, each with the nearest
 * place of the shape; and the segments on which a circle stands. Of those within the margin, the
 * one furthest from thud_terrain_closest's is taken; the first point is thud_terrain_closest's, or
 * of candidates as deep (to 1e-9 of the shape's size) the one furthest from the second. Each point
 * has a normal of its own: a circle in a valley leans on both slopes. */
THUD_API thud_result thud_terrain_contacts(const thud_terrain *terrain,
                                           const thud_shape_instance *shape, double margin,
                                           thud_contacts *out);

/* As thud_shapes_time_of_impact with the terrain at rest. */
THUD_API thud_result thud_terrain_time_of_impact(const thud_terrain *terrain,
                                                 const thud_shape_instance *shape,
                                                 thud_motion motion, double target, bool *hit,
                                                 double *time);

/* As thud_shapes_time_of_collision with the terrain at rest. */
THUD_API thud_result thud_terrain_time_of_collision(const thud_terrain *terrain,
                                                    const thud_shape_instance *shape,
                                                    thud_motion motion, double tolerance,
                                                    bool *collided, double *time);

#ifdef __cplusplus
}
#endif

#endif
