/* volumes_overlap.c: overlap of two bounding volumes, and containment of points and volumes. Two
 * boxes are tested by the separating axis test over the axes of both (Gottschalk, Lin and Manocha,
 * "OBBTree", 1996). */
#include "geometry/shape_instance.h"
#include "thud/thud_volumes.h"

static bool circle_circle(const thud_volume *a, const thud_volume *b) {
    double x = b->x - a->x, y = b->y - a->y, r = a->hx + b->hx;
    return x * x + y * y <= r * r;
}

/* The circle's centre is (u, v) in the frame of the box. */
static bool circle_box(const thud_volume *circle, const thud_volume *box, double u, double v) {
    double out_u = td_abs(u) - box->hx, out_v = td_abs(v) - box->hy;
    out_u = out_u > 0.0 ? out_u : 0.0;
    out_v = out_v > 0.0 ? out_v : 0.0;
    return out_u * out_u + out_v * out_v <= circle->hx * circle->hx;
}

static bool aabb_aabb(const thud_volume *a, const thud_volume *b) {
    return td_abs(b->x - a->x) <= a->hx + b->hx && td_abs(b->y - a->y) <= a->hy + b->hy;
}

static bool box_box(const thud_volume *a, const thud_volume *b) {
    double x = b->x - a->x, y = b->y - a->y, u, v;
    double c = td_abs(a->c * b->c + a->s * b->s), s = td_abs(a->c * b->s - a->s * b->c);
    td_to_frame(a, x, y, &u, &v);
    if (td_abs(u) > a->hx + c * b->hx + s * b->hy || td_abs(v) > a->hy + s * b->hx + c * b->hy) {
        return false;
    }
    td_to_frame(b, x, y, &u, &v);
    return td_abs(u) <= b->hx + c * a->hx + s * a->hy && td_abs(v) <= b->hy + s * a->hx + c * a->hy;
}

/* The kinds of a and b are in ascending order, so that a is a circle if any is, and b an OBB if any
 * is. */
static bool overlap(const thud_volume *a, const thud_volume *b) {
    double x = a->x - b->x, y = a->y - b->y;
    if (td_kind_is_round(b->kind)) {
        return circle_circle(a, b);
    }
    if (td_kind_is_round(a->kind)) {
        double u = x, v = y;
        if (td_kind_turns(b->kind)) {
            td_to_frame(b, x, y, &u, &v);
        }
        return circle_box(a, b, u, v);
    }
    return td_kind_turns(b->kind) ? box_box(a, b) : aabb_aabb(a, b);
}

thud_result thud_volumes_overlap(const thud_volume *a, const thud_volume *b, bool *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_volume_check(a) != THUD_OK || thud_volume_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    *out = a->kind <= b->kind ? overlap(a, b) : overlap(b, a);
    return THUD_OK;
}

/* The furthest point of a box is a corner; the furthest point of a circle lies one radius beyond
 * its centre. */
static bool in_circle(const thud_volume *circle, const thud_volume *inner) {
    double x = inner->x - circle->x, y = inner->y - circle->y;
    double room = circle->hx;
    if (td_kind_is_round(inner->kind)) {
        room -= inner->hx;
        return room >= 0.0 && x * x + y * y <= room * room;
    }
    double u, v;
    td_to_frame(inner, x, y, &u, &v);
    u = td_abs(u) + inner->hx;
    v = td_abs(v) + inner->hy;
    return u * u + v * v <= room * room;
}

/* The extents of the inner volume about its centre, along the axes of the box, must lie within the
 * box. */
static bool in_box(const thud_volume *box, const thud_volume *inner) {
    double u, v, hu = inner->hx, hv = inner->hx;
    td_to_frame(box, inner->x - box->x, inner->y - box->y, &u, &v);
    if (td_kind_is_box(inner->kind)) {
        hu = td_projected_extent(inner, box->c, box->s);
        hv = td_projected_extent(inner, -box->s, box->c);
    }
    return td_abs(u) + hu <= box->hx && td_abs(v) + hv <= box->hy;
}

thud_result thud_volume_contains(const thud_volume *outer, const thud_volume *inner,
                                 bool *out_inside) {
    if (!outer || !inner || !out_inside) {
        return THUD_ERROR_NULL;
    }
    if (thud_volume_check(outer) != THUD_OK || thud_volume_check(inner) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    *out_inside = td_kind_is_round(outer->kind) ? in_circle(outer, inner) : in_box(outer, inner);
    return THUD_OK;
}

thud_result thud_volume_contains_point(const thud_volume *volume, double x, double y,
                                       bool *out_inside) {
    const thud_volume point = {.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y};
    return thud_volume_contains(volume, &point, out_inside);
}
