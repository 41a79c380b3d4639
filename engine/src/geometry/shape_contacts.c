/* shape_contacts.c: the one or two contact points of two shapes, for queries. The first is the pair
 * of closest points. If a face of a box is perpendicular to the normal, the other box's opposite
 * face is clipped to it; the end that is further from the first point is the second point. The
 * solver's contacts come from contact/wide_box.c and its siblings. */
#include "geometry/shape_instance.h"

/* A face's normal and the contact normal count as equal if the tangent of the angle between them is
 * at most this. Larger than the rounding error of a normal that was computed from two corners;
 * chosen, not tuned. */
#define FACE_TANGENT_MAX 1e-7
/* Two points count as one if their distance is less than this share of the smaller box's extent.
 * Larger than rounding errors; chosen, not tuned. */
#define SAME_POINT 1e-9

/* Finds the outward normal of the box's face that is nearest to the direction (x, y). Returns the
 * tangent of the angle between the two. */
static double face_along(const thud_geometry *box, double x, double y, double *nx, double *ny) {
    double u, v;
    td_to_frame(box, x, y, &u, &v);
    bool by_u = td_abs(u) > td_abs(v);
    double fu = !by_u ? 0.0 : u < 0.0 ? -1.0 : 1.0, fv = by_u ? 0.0 : v < 0.0 ? -1.0 : 1.0;
    td_from_frame(box, fu, fv, nx, ny);
    return by_u ? td_abs(v / u) : td_abs(u / v);
}

/* A point by its coordinates along the reference face and above it. */
typedef struct face_point {
    double along, above;
} face_point;

/* The face_point of (x, y). */
static face_point face_point_of(const thud_closest *c, double x, double y) {
    return (face_point){x * -c->ny + y * c->nx, x * c->nx + y * c->ny};
}

/* The ends of the box's face that is most opposed to the normal, relative to its centre. */
static void face_against(const thud_geometry *box, const thud_closest *c, face_point end[2]) {
    double u, v, x, y;
    td_to_frame(box, -c->nx, -c->ny, &u, &v);
    bool by_u = td_abs(u) > td_abs(v);
    for (int i = 0; i < 2; i++) {
        double side = i ? 1.0 : -1.0;
        double eu = by_u ? (u < 0.0 ? -box->hx : box->hx) : side * box->hx;
        double ev = by_u ? side * box->hy : (v < 0.0 ? -box->hy : box->hy);
        td_from_frame(box, eu, ev, &x, &y);
        end[i] = face_point_of(c, x, y);
    }
}

/* The point of the line through p and q at the coordinate `along`, not beyond p and q in height. */
static face_point interpolate(face_point p, face_point q, double along) {
    double part = q.along != p.along ? (along - p.along) / (q.along - p.along) : 0.0;
    return (face_point){along, p.above + td_clamp(part, 0.0, 1.0) * (q.above - p.above)};
}

/* Clips the other box's opposite face to the face of `box` whose normal is c's, and returns the end
 * that is further from the closest points. The positions of both boxes are relative to c's point on
 * the surface of `box`; of `c` only the normal is read, which points out of `box`. */
static face_point far_end(const thud_geometry *box, const thud_geometry *other,
                          const thud_closest *c) {
    face_point end[2], offset = face_point_of(c, other->x, other->y),
                       own = face_point_of(c, box->x, box->y);
    double half = td_projected_extent(box, -c->ny, c->nx);
    double low = own.along - half, high = own.along + half;
    face_against(other, c, end);
    for (int i = 0; i < 2; i++) {
        end[i].along += offset.along;
        end[i].above += offset.above;
    }
    face_point clipped[2];
    for (int i = 0; i < 2; i++) {
        clipped[i] = interpolate(end[0], end[1], td_clamp(end[i].along, low, high));
    }
    return clipped[td_abs(clipped[1].along) > td_abs(clipped[0].along)];
}

/* Exchanges a and b. */
static void reverse(thud_closest *c) {
    *c = (thud_closest){c->distance, -c->nx, -c->ny, c->bx, c->by, c->ax, c->ay};
}

/* Adds the second point of two boxes, if there is one within the margin. */
static void add_far_end(const thud_geometry *a, const thud_geometry *b, double margin,
                        thud_contacts *out) {
    thud_closest c = out->point[0];
    double ax, ay, bx, by;
    double tangent_a = face_along(a, c.nx, c.ny, &ax, &ay);
    double tangent_b = face_along(b, -c.nx, -c.ny, &bx, &by);
    bool flipped = tangent_b < tangent_a;
    if ((flipped ? tangent_b : tangent_a) > FACE_TANGENT_MAX) {
        return; /* corner to corner */
    }
    if (flipped) {
        reverse(&c);
    }
    c.nx = flipped ? bx : ax;
    c.ny = flipped ? by : ay;
    thud_geometry box = flipped ? *b : *a, other = flipped ? *a : *b;
    box.x -= c.ax;
    box.y -= c.ay;
    other.x -= c.ax;
    other.y -= c.ay;
    face_point far = far_end(&box, &other, &c);
    double reach_min = td_reach(a) < td_reach(b) ? td_reach(a) : td_reach(b);
    if (far.above > margin || td_abs(far.along) <= SAME_POINT * reach_min) {
        return;
    }
    c.distance = far.above;
    c.ax -= far.along * c.ny;
    c.ay += far.along * c.nx;
    c.bx = c.ax + far.above * c.nx;
    c.by = c.ay + far.above * c.ny;
    if (flipped) {
        reverse(&c);
    }
    out->point[out->count++] = c;
}

thud_result thud_geometry_contacts(const thud_geometry *a, const thud_geometry *b, double margin,
                                   thud_contacts *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_geometry_check(a) != THUD_OK || thud_geometry_check(b) != THUD_OK ||
        !(margin >= 0.0 && margin <= THUD_COORDINATE_MAX)) {
        return THUD_ERROR_INVALID;
    }
    /* Both shapes are moved so that a's centre is the origin: far from the origin rounding errors
     * would be too large. */
    thud_geometry here = *a, there = *b;
    here.x = here.y = 0.0;
    there.x -= a->x;
    there.y -= a->y;
    *out = (thud_contacts){.count = 1};
    td_closest(&here, &there, &out->point[0]);
    if (out->point[0].distance > margin) {
        *out = (thud_contacts){0};
        return THUD_OK;
    }
    if (td_kind_is_box(a->kind) && td_kind_is_box(b->kind)) {
        add_far_end(&here, &there, margin, out);
    }
    for (int i = 0; i < out->count; i++) {
        out->point[i].ax += a->x;
        out->point[i].ay += a->y;
        out->point[i].bx += a->x;
        out->point[i].by += a->y;
    }
    return THUD_OK;
}
