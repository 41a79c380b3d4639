/* shape_instance.h: small helpers on placed shapes, shared by the geometry files. */
#ifndef TD_SHAPE_INSTANCE_H
#define TD_SHAPE_INSTANCE_H

#include "base/base.h"
#include "geometry/shape_kind.h"

static inline double td_clamp(double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
}

/* A world vector in the shape's frame, and back. */
static inline void td_to_frame(const thud_shape_instance *f, double x, double y, double *u,
                               double *v) {
    *u = f->c * x + f->s * y;
    *v = f->c * y - f->s * x;
}

static inline void td_from_frame(const thud_shape_instance *f, double u, double v, double *x,
                                 double *y) {
    *x = f->c * u - f->s * v;
    *y = f->s * u + f->c * v;
}

/* Corner 0..3 counter-clockwise from the lower left, in the world. */
static inline void td_corner(const thud_shape_instance *box, int i, double *x, double *y) {
    double u = i == 1 || i == 2 ? box->hx : -box->hx, v = i >= 2 ? box->hy : -box->hy;
    td_from_frame(box, u, v, x, y);
    *x += box->x;
    *y += box->y;
}

/* Half extent of a box's shadow on the direction (x, y), which has length 1. */
static inline double td_projected_extent(const thud_shape_instance *box, double x, double y) {
    double u, v;
    td_to_frame(box, x, y, &u, &v);
    return td_abs(u) * box->hx + td_abs(v) * box->hy;
}

/* No point of the shape is further than this from its centre. A circle's hy is not read. */
TD_INLINE_SMALL double td_reach(const thud_shape_instance *shape) {
    switch (shape->kind) {
    case THUD_CIRCLE:
        return shape->hx;
    case THUD_AABB:
    case THUD_OBB:
    case THUD_TERRAIN:
        break;
    }
    return shape->hx + shape->hy;
}

/* Half of what the shape takes up along (x, y), which has length 1. A circle's angle is not read.
 */
static inline double td_half_along(const thud_shape_instance *shape, double x, double y) {
    switch (shape->kind) {
    case THUD_CIRCLE:
        return shape->hx;
    case THUD_AABB:
    case THUD_OBB:
    case THUD_TERRAIN:
        break;
    }
    return td_projected_extent(shape, x, y);
}

/* Half the width of the shape's bounding box. */
static inline double td_half_width(const thud_shape_instance *shape) {
    return td_half_along(shape, 1.0, 0.0);
}

static inline bool td_motion_valid(thud_motion m) {
    return td_finite(m.dx + m.dy + m.turn) && td_abs(m.turn) <= THUD_ANGLE_MAX;
}

/* Distances at which shapes count as met: squares of the largest are far from overflow. */
static inline bool td_target_valid(double target) {
    return target >= 0.0 && target <= THUD_COORDINATE_MAX;
}

/* The shape at a time of its motion. */
thud_shape_instance td_placed_at(const thud_shape_instance *shape, const thud_motion *motion,
                                 double time);

/* closest.c: as thud_shapes_closest, for shapes known to be valid; boxes may be flat (hy = 0). */
void td_closest(const thud_shape_instance *a, const thud_shape_instance *b, thud_closest *out);

/* toi.c: as thud_shapes_time_of_impact, for shapes and motions known to be valid. */
void td_time_of_impact(const thud_shape_instance *a, thud_motion motion_a,
                       const thud_shape_instance *b, thud_motion motion_b, double target, bool *hit,
                       double *time);
/* For how long nothing can come across a direction, in which the two are apart by more than the
 * target; more than 1 where that is longer than the motions. */
typedef double td_jump_fn(const thud_shape_instance *a, const thud_motion *motion_a,
                          const thud_shape_instance *b, const thud_motion *motion_b, double nx,
                          double ny, double target);
td_jump_fn td_time_across;
/* Finds a longer time than td_time_across where the face of a turning box goes on keeping the two
 * apart. It takes longer itself, which pays for shapes that slide on others. */
td_jump_fn td_time_across_faces;

/* Does what td_time_of_impact does, but the target may be negative, where the shapes overlap, and
 * turning shapes may stop `tolerance` short of it, which saves jumps. */
void td_time_of_near_impact(const thud_shape_instance *a, thud_motion motion_a,
                            const thud_shape_instance *b, thud_motion motion_b, double target,
                            double tolerance, td_jump_fn *jump, bool *hit, double *time);

#endif
