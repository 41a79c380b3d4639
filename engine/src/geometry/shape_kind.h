/* shape_kind.h: the properties of each kind of shape. Each function is a switch over all kinds
 * without a default, so that the compiler reports every switch that lacks a new kind
 * (-Wswitch-enum).
 *
 * A kind has two half extents, hx and hy. For a circle, hx is the radius and hy is 0, in the public
 * API, in thud_geometry and in td_shape. td_kind_half_y returns the half extent across hx, which
 * for a circle is its radius; td_shape_proxy stores this one. */
#ifndef TD_SHAPE_KIND_H
#define TD_SHAPE_KIND_H

#include "base/base.h"
#include "thud/thud_geometry.h"

/* Whether the kind is a line of ground (a terrain), which has segments, and neither a centre nor
 * half extents. All other kinds can be a thud_geometry. */
TD_INLINE_SMALL bool td_kind_is_line(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        return false;
    case THUD_SHAPE_TERRAIN:
        return true;
    }
    return false;
}

/* Whether a thud_geometry may have this kind; also false for invalid values. */
TD_INLINE_SMALL bool td_kind_has_instances(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        return true;
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* Whether a thud_volume may have this kind; also false for invalid values. */
TD_INLINE_SMALL bool td_kind_is_volume(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        return true;
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* Whether all points of the outline are equally far from the centre, so that rotation changes
 * nothing. */
TD_INLINE_SMALL bool td_kind_is_round(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
        return true;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* Whether the kind is a box: four faces and four corners, with half extents hx and hy. */
TD_INLINE_SMALL bool td_kind_is_box(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        return true;
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* Whether the shape rotates with its body, so that its extent depends on the angle. */
TD_INLINE_SMALL bool td_kind_turns(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_OBB:
        return true;
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* Whether a body with such a shape never rotates, whatever acts on it. */
TD_INLINE_SMALL bool td_kind_fixes_rotation(thud_shape_kind kind) {
    switch (kind) {
    case THUD_SHAPE_AABB:
        return true;
    case THUD_SHAPE_CIRCLE:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        return false;
    }
    return false;
}

/* The half extent across hx; for a circle its radius. */
TD_INLINE_SMALL double td_kind_half_y(thud_shape_kind kind, double hx, double hy) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
        return hx;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        return hy;
    }
    return hy;
}

/* Half of the shape's smallest width. A point that is less deep than this inside the shape has not
 * passed through its middle. */
TD_INLINE_SMALL double td_kind_half_thickness(thud_shape_kind kind, double hx, double hy) {
    double half_y = td_kind_half_y(kind, hx, hy);
    return hx < half_y ? hx : half_y;
}

/* hy of a shape that is grown by `by` on all sides; 0 for a circle. */
TD_INLINE_SMALL double td_kind_grown_hy(thud_shape_kind kind, double hy, double by) {
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
        return 0.0;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN:
        return hy + by;
    }
    return hy;
}

/* Area, and second moment of area about the shape's own centre. A terrain has neither: 0. */
static inline void td_kind_area(thud_shape_kind kind, double hx, double hy, double *area,
                                double *moment) {
    *area = *moment = 0.0;
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
        *area = TD_PI * hx * hx;
        *moment = *area * hx * hx / 2.0;
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        *area = 4.0 * hx * hy;
        *moment = *area * (hx * hx + hy * hy) / 3.0;
        break;
    case THUD_SHAPE_TERRAIN:
        break;
    }
}

#endif
