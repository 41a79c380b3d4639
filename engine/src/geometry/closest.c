/* closest.c: signed distance, normal and closest points of circles and boxes, in closed form, and
 * the overlap test.
 *
 * Two boxes: the separating axis test over the axes of both (Gottschalk, Lin and Manocha,
 * "OBBTree", 1996) gives the depth and the normal of an overlap. The closest points of two separate
 * boxes include a corner of one, so that all corners are tested against the other box. */
#include "geometry/shape_instance.h"

thud_result thud_geometry_check(const thud_geometry *p) {
    if (!p) {
        return THUD_ERROR_NULL;
    }
    bool circle = td_kind_is_round(p->kind), kind = td_kind_has_instances(p->kind);
    bool height = circle || (p->hy > 0.0 && p->hy <= THUD_COORDINATE_MAX);
    bool turned = td_abs(p->c * p->c + p->s * p->s - 1.0) < THUD_UNIT_ERROR;
    bool upright = td_kind_turns(p->kind) || (p->c == 1.0 && p->s == 0.0) || circle;
    return kind && td_circle_valid(p) && height && (circle || turned) && upright
               ? THUD_OK
               : THUD_ERROR_INVALID;
}

/* A box and a circle. If the centre is outside of the box, the closest point is its projection onto
 * the box; if it is inside, the normal is that of the nearest face. */
static void box_circle(const thud_geometry *box, const thud_geometry *circle, thud_closest *out) {
    double u, v, nu, nv, distance;
    td_to_frame(box, circle->x - box->x, circle->y - box->y, &u, &v);
    double cu = td_clamp(u, -box->hx, box->hx), cv = td_clamp(v, -box->hy, box->hy);
    if (cu != u || cv != v) {
        double du = u - cu, dv = v - cv;
        distance = __builtin_sqrt(du * du + dv * dv);
        nu = du / distance;
        nv = dv / distance;
    } else if (box->hx - td_abs(u) < box->hy - td_abs(v)) {
        distance = td_abs(u) - box->hx;
        nu = u < 0.0 ? -1.0 : 1.0;
        nv = 0.0;
        cu = nu * box->hx;
    } else {
        distance = td_abs(v) - box->hy;
        nu = 0.0;
        nv = v < 0.0 ? -1.0 : 1.0;
        cv = nv * box->hy;
    }
    td_from_frame(box, nu, nv, &out->nx, &out->ny);
    td_from_frame(box, cu, cv, &out->ax, &out->ay);
    out->ax += box->x;
    out->ay += box->y;
    out->distance = distance - circle->hx;
    out->bx = circle->x - out->nx * circle->hx;
    out->by = circle->y - out->ny * circle->hx;
}

/* Exchanges a and b in a result. */
static void flip(thud_closest *c) {
    double x = c->ax, y = c->ay;
    c->ax = c->bx;
    c->ay = c->by;
    c->bx = x;
    c->by = y;
    c->nx = -c->nx;
    c->ny = -c->ny;
}

/* Computes the separation of a and b along both axes of the box `reference`. *out keeps the
 * greatest separation so far, with its normal from a to b. Returns whether it is along one of these
 * two axes. */
static bool try_axes(const thud_geometry *reference, const thud_geometry *a, const thud_geometry *b,
                     thud_closest *out) {
    double dx = b->x - a->x, dy = b->y - a->y;
    bool better = false;
    for (int axis = 0; axis < 2; axis++) {
        double nx = axis ? -reference->s : reference->c, ny = axis ? reference->c : reference->s;
        double along = dx * nx + dy * ny;
        double separation =
            td_abs(along) - (td_projected_extent(a, nx, ny) + td_projected_extent(b, nx, ny));
        if (separation > out->distance) {
            out->distance = separation;
            out->nx = along < 0.0 ? -nx : nx;
            out->ny = along < 0.0 ? -ny : ny;
            better = true;
        }
    }
    return better;
}

/* Sets the points of two boxes that overlap, or whose corners nearly touch, if the normal in *out
 * is that of a face of a: the point on a is the projection of b's deepest corner onto that face,
 * clamped to the face's ends; the point on b is `distance` from there along the normal. */
static void deepest_points(const thud_geometry *a, const thud_geometry *b, thud_closest *out) {
    double u, v, x, y;
    td_to_frame(b, -out->nx, -out->ny, &u, &v);
    td_from_frame(b, u < 0.0 ? -b->hx : b->hx, v < 0.0 ? -b->hy : b->hy, &x, &y);
    x += b->x - a->x - out->nx * out->distance;
    y += b->y - a->y - out->ny * out->distance;
    td_to_frame(a, x, y, &u, &v);
    td_from_frame(a, td_clamp(u, -a->hx, a->hx), td_clamp(v, -a->hy, a->hy), &x, &y);
    out->ax = a->x + x;
    out->ay = a->y + y;
    out->bx = out->ax + out->nx * out->distance;
    out->by = out->ay + out->ny * out->distance;
}

/* Moves both points of a result. */
static void shift(thud_closest *c, double x, double y) {
    c->ax += x;
    c->ay += y;
    c->bx += x;
    c->by += y;
}

/* Tests each corner of b against the box a, and keeps the closest pair in *out. `flipped`: the
 * caller has exchanged a and b. Coordinates are relative to a's centre, since rounding far from the
 * origin would be too large for distances. */
static void try_corners(const thud_geometry *a, const thud_geometry *b, bool flipped,
                        thud_closest *out) {
    thud_geometry box = *a, other = *b;
    box.x = box.y = 0.0;
    other.x = b->x - a->x;
    other.y = b->y - a->y;
    for (int i = 0; i < 4; i++) {
        thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .c = 1.0};
        thud_closest found;
        td_corner(&other, i, &point.x, &point.y);
        box_circle(&box, &point, &found);
        if (found.distance < out->distance) {
            *out = found;
            shift(out, a->x, a->y);
            if (flipped) {
                flip(out);
            }
        }
    }
}

/* The separation of two boxes along the normal of *c. */
static double gap_along(const thud_geometry *a, const thud_geometry *b, const thud_closest *c) {
    return (b->x - a->x) * c->nx + (b->y - a->y) * c->ny - td_projected_extent(a, c->nx, c->ny) -
           td_projected_extent(b, c->nx, c->ny);
}

/* Sets distance and normal of *out by the axes of both boxes. Returns whether the axis is one of
 * b's. */
static bool try_all_axes(const thud_geometry *a, const thud_geometry *b, thud_closest *out) {
    out->distance = -1e300;
    try_axes(a, a, b, out);
    return try_axes(b, a, b, out);
}

/* Two boxes. */
static void box_box(const thud_geometry *a, const thud_geometry *b, thud_closest *out) {
    thud_closest corners = {.distance = 1e300};
    bool face_of_b = try_all_axes(a, b, out);
    if (out->distance > 0.0) {
        try_corners(a, b, false, &corners);
        try_corners(b, a, true, &corners);
    }
    /* If two corners nearly touch, the direction of the vector between them is only rounding error,
     * and may even point into a box. So the corners' normal is used only if it separates the boxes
     * as well as the best axis does. */
    double rounding = 1e-15 * (td_reach(a) + td_reach(b));
    if (out->distance > 0.0 && gap_along(a, b, &corners) >= out->distance - rounding) {
        *out = corners;
    } else if (face_of_b) {
        flip(out);
        deepest_points(b, a, out);
        flip(out);
    } else {
        deepest_points(a, b, out);
    }
}

void td_closest(const thud_geometry *a, const thud_geometry *b, thud_closest *out) {
    switch (a->kind) {
    case THUD_SHAPE_CIRCLE:
        if (td_kind_is_round(b->kind)) {
            td_circles_closest(a, b, out);
        } else {
            box_circle(b, a, out);
            flip(out);
        }
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
    case THUD_SHAPE_TERRAIN: /* never called for one */
        if (td_kind_is_round(b->kind)) {
            box_circle(a, b, out);
        } else {
            box_box(a, b, out);
        }
        break;
    }
}

thud_result thud_geometry_closest(const thud_geometry *a, const thud_geometry *b,
                                  thud_closest *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    td_closest(a, b, out);
    return THUD_OK;
}

bool thud_geometry_overlap(const thud_geometry *a, const thud_geometry *b) {
    thud_closest closest;
    if (a && b && td_kind_is_box(a->kind) && td_kind_is_box(b->kind)) {
        /* A positive separation along an axis shows that the boxes are apart, without a search for
         * the closest corners. If it may be a rounding error, td_closest decides, so that both
         * functions agree. */
        try_all_axes(a, b, &closest);
        if (closest.distance > 1e-12 * (td_reach(a) + td_reach(b))) {
            return false;
        }
    }
    return thud_geometry_closest(a, b, &closest) == THUD_OK && closest.distance <= 0.0;
}
