/* shape_instance.h: helpers on thud_geometry, a circle or box at a pose, in double precision and
 * without a world; and the internal versions of the geometry functions, which do not check their
 * input. Lengths are the caller's unit, angles radians. */
#ifndef TD_SHAPE_INSTANCE_H
#define TD_SHAPE_INSTANCE_H

#include "base/base.h"
#include "geometry/shape_kind.h"

static inline double td_clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/* Rotates a world vector into the shape's frame, and back. */
static inline void td_to_frame(const thud_geometry *f, double x, double y, double *u, double *v) {
    *u = f->c * x + f->s * y;
    *v = f->c * y - f->s * x;
}

static inline void td_from_frame(const thud_geometry *f, double u, double v, double *x, double *y) {
    *x = f->c * u - f->s * v;
    *y = f->s * u + f->c * v;
}

/* A corner of a box in the world; 0 to 3 counter-clockwise from the lower left one in its frame. */
static inline void td_corner(const thud_geometry *box, int i, double *x, double *y) {
    double u = i == 1 || i == 2 ? box->hx : -box->hx, v = i >= 2 ? box->hy : -box->hy;
    td_from_frame(box, u, v, x, y);
    *x += box->x;
    *y += box->y;
}

/* Half the length of a box's projection onto the unit vector (x, y). */
static inline double td_projected_extent(const thud_geometry *box, double x, double y) {
    double u, v;
    td_to_frame(box, x, y, &u, &v);
    return td_abs(u) * box->hx + td_abs(v) * box->hy;
}

/* An upper bound of the distance of the shape's points from its centre: the radius, or hx + hy. */
TD_INLINE_SMALL double td_reach(const thud_geometry *shape) {
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        return shape->hx;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        break;
    }
    return shape->hx + shape->hy;
}

/* Half the length of a shape's projection onto the unit vector (x, y). */
static inline double td_half_along(const thud_geometry *shape, double x, double y) {
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        return shape->hx;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        break;
    }
    return td_projected_extent(shape, x, y);
}

/* Half the width of the shape's bounding box. */
static inline double td_half_width(const thud_geometry *shape) {
    return td_half_along(shape, 1.0, 0.0);
}

/* Whether a motion is finite and turns by no more than THUD_ANGLE_MAX. */
static inline bool td_motion_valid(thud_motion m) {
    return td_finite(m.dx + m.dy + m.turn) && td_abs(m.turn) <= THUD_ANGLE_MAX;
}

/* Whether a target distance of a time of impact is in range; squares of such numbers do not
 * overflow. */
static inline bool td_target_valid(double target) {
    return target >= 0.0 && target <= THUD_COORDINATE_MAX;
}

/* The instance at a time of its motion, 0 to 1. */
thud_geometry td_placed_at(const thud_geometry *shape, const thud_motion *motion, double time);

/* Whether a shape's place and first half extent are in range; all that thud_geometry_check tests of
 * a circle. */
static inline bool td_circle_valid(const thud_geometry *p) {
    return td_abs(p->x) <= THUD_COORDINATE_MAX && td_abs(p->y) <= THUD_COORDINATE_MAX &&
           p->hx > 0.0 && p->hx <= THUD_COORDINATE_MAX;
}

/* circles.c: the closest points of two circles. Where the centres coincide, the normal is (0, 1).
 */
void td_circles_closest(const thud_geometry *a, const thud_geometry *b, thud_closest *out);
/* circles.c: finds where a point that moves by (dx, dy) enters a circle, from outside: the fraction
 * of the motion, and the outward normal. False where it does not. */
bool td_circle_enter(thud_pos centre, double radius, double x, double y, double dx, double dy,
                     double *fraction, double *nx, double *ny);

/* Functions on two instances (shapes at a pose). A world uses td_circle_instances, and from its
 * first box on td_all_instances (state/kinds.h). For two valid circles both give the same bits. */
typedef struct td_instance_ops {
    /* As thud_geometry_overlap, thud_geometry_time_of_impact and td_closest. */
    bool (*overlap)(const thud_geometry *a, const thud_geometry *b);
    thud_result (*time_of_impact)(const thud_geometry *a, thud_motion motion_a,
                                  const thud_geometry *b, thud_motion motion_b, double target,
                                  bool *hit, double *time);
    void (*closest)(const thud_geometry *a, const thud_geometry *b, thud_closest *out);
} td_instance_ops;

extern const td_instance_ops td_circle_instances; /* circles.c */
extern const td_instance_ops td_all_instances;    /* toi.c */

/* closest.c: as thud_geometry_closest, for valid shapes (not checked again); boxes may have hy =
 * 0. */
void td_closest(const thud_geometry *a, const thud_geometry *b, thud_closest *out);

/* toi.c: as thud_geometry_time_of_impact, for valid shapes and motions (not checked again). */
void td_time_of_impact(const thud_geometry *a, thud_motion motion_a, const thud_geometry *b,
                       thud_motion motion_b, double target, bool *hit, double *time);
/* A lower bound of the time until the shapes can come within `target` of each other, for
 * conservative advancement: from the separation along the unit normal (nx, ny), from a to b, which
 * is greater than the target. Motions take one unit of time; a result above 1 means that they
 * cannot within the motions. */
typedef double td_jump_fn(const thud_geometry *a, const thud_motion *motion_a,
                          const thud_geometry *b, const thud_motion *motion_b, double nx, double ny,
                          double target);
td_jump_fn td_time_across;
/* A td_jump_fn that also uses the faces of turning boxes, and finds later times than td_time_across
 * if such a face separates the shapes. It is slower, which is worth it for shapes that slide on
 * others. */
td_jump_fn td_time_across_faces;

/* As td_time_of_impact, with `jump` as the bound of each advance. `target` may be negative, so that
 * shapes may overlap by that depth; the search, which is used for turning shapes and for every
 * negative target, may stop while the distance is still up to `tolerance` (length) above the
 * target, which saves advances. */
void td_time_of_near_impact(const thud_geometry *a, thud_motion motion_a, const thud_geometry *b,
                            thud_motion motion_b, double target, double tolerance, td_jump_fn *jump,
                            bool *hit, double *time);

#endif
