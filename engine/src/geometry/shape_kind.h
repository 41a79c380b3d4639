/* shape_kind.h: what is asked of a shape's kind. Every question is a switch over all kinds without
 * a default, so that the compiler names each one that a new kind has to answer (-Wswitch-enum).
 *
 * A kind has two half extents, hx and hy. A circle has one radius, which is hx, and its hy is 0:
 * so callers give it, and so thud_shape_instance and td_shape keep it. td_kind_half_y turns that
 * into the half extent that the circle really has; td_shape_proxy alone keeps the answer. */
#ifndef TD_SHAPE_KIND_H
#define TD_SHAPE_KIND_H

#include "base/base.h"
#include "thud/thud_shapes.h"

/* A ground line: it has segments, and neither centre nor half extents. What is no line has a place
 * as a thud_shape_instance. */
TD_INLINE_SMALL bool td_kind_is_line(thud_shape_kind kind) {
    switch (kind) {
    case THUD_CIRCLE:
    case THUD_AABB:
    case THUD_OBB:
        return false;
    case THUD_TERRAIN:
        return true;
    }
    return false;
}

/* Whether there is a thud_shape_instance of that kind; false also for what is no kind at all. */
TD_INLINE_SMALL bool td_kind_has_instances(thud_shape_kind kind) {
    switch (kind) {
    case THUD_CIRCLE:
    case THUD_AABB:
    case THUD_OBB:
        return true;
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* Whether there is a thud_volume of that kind; false also for what is no kind at all. */
TD_INLINE_SMALL bool td_kind_is_volume(thud_shape_kind kind) {
    switch (kind) {
    case THUD_CIRCLE:
    case THUD_AABB:
    case THUD_OBB:
        return true;
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* The whole outline has one distance from the centre, so that no angle is to be seen. */
TD_INLINE_SMALL bool td_kind_is_round(thud_shape_kind kind) {
    switch (kind) {
    case THUD_CIRCLE:
        return true;
    case THUD_AABB:
    case THUD_OBB:
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* A box: four straight faces and four corners, hx and hy from the centre. */
TD_INLINE_SMALL bool td_kind_is_box(thud_shape_kind kind) {
    switch (kind) {
    case THUD_AABB:
    case THUD_OBB:
        return true;
    case THUD_CIRCLE:
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* Its angle is to be seen and follows its body's: what the shape takes up depends on it. */
TD_INLINE_SMALL bool td_kind_turns(thud_shape_kind kind) {
    switch (kind) {
    case THUD_OBB:
        return true;
    case THUD_CIRCLE:
    case THUD_AABB:
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* A body that has one never turns, whatever pushes it. */
TD_INLINE_SMALL bool td_kind_fixes_rotation(thud_shape_kind kind) {
    switch (kind) {
    case THUD_AABB:
        return true;
    case THUD_CIRCLE:
    case THUD_OBB:
    case THUD_TERRAIN:
        return false;
    }
    return false;
}

/* The half extent across hx, also of a circle. */
TD_INLINE_SMALL double td_kind_half_y(thud_shape_kind kind, double hx, double hy) {
    switch (kind) {
    case THUD_CIRCLE:
        return hx;
    case THUD_AABB:
    case THUD_OBB:
    case THUD_TERRAIN:
        return hy;
    }
    return hy;
}

/* How deep the shape's middle lies: nothing that goes less deep is through it. */
TD_INLINE_SMALL double td_kind_half_thickness(thud_shape_kind kind, double hx, double hy) {
    double half_y = td_kind_half_y(kind, hx, hy);
    return hx < half_y ? hx : half_y;
}

/* The half extent hy that is kept of a shape grown by `by` on all sides, as a circle's 0 is. */
TD_INLINE_SMALL double td_kind_grown_hy(thud_shape_kind kind, double hy, double by) {
    switch (kind) {
    case THUD_CIRCLE:
        return 0.0;
    case THUD_AABB:
    case THUD_OBB:
    case THUD_TERRAIN:
        return hy + by;
    }
    return hy;
}

/* Area, and second moment of area about the shape's own centre; a line has none. */
static inline void td_kind_area(thud_shape_kind kind, double hx, double hy, double *area,
                                double *moment) {
    *area = *moment = 0.0;
    switch (kind) {
    case THUD_CIRCLE:
        *area = TD_PI * hx * hx;
        *moment = *area * hx * hx / 2.0;
        break;
    case THUD_AABB:
    case THUD_OBB:
        *area = 4.0 * hx * hy;
        *moment = *area * (hx * hx + hy * hy) / 3.0;
        break;
    case THUD_TERRAIN:
        break;
    }
}

#endif
