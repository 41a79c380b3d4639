/* shape_contacts.c: contact points of two shapes: their closest features and, where a face of a box
 * looks along the normal, the far end of what it shares with the other box. */
#include "geometry/shape_instance.h"

/* A face within this angle of the normal, in radians, counts as looking along it: between the links
 * of two corners of a face to another box, rounding decides as long as they differ by less. */
#define ALIGNED 1e-7
/* Points closer than this share of the smaller box's reach are one. */
#define SAME 1e-9

/* The outward normal of the box's face that looks most along a direction, and by how much that
 * fails to be the direction, as a tangent. */
static double face_along(const thud_shape_instance *box, double x, double y, double *nx,
                         double *ny) {
    double u, v;
    td_to_frame(box, x, y, &u, &v);
    bool by_u = td_abs(u) > td_abs(v);
    double fu = !by_u ? 0.0 : u < 0.0 ? -1.0 : 1.0, fv = by_u ? 0.0 : v < 0.0 ? -1.0 : 1.0;
    td_from_frame(box, fu, fv, nx, ny);
    return by_u ? td_abs(v / u) : td_abs(u / v);
}

/* A place in the frame of the normal: along the face, and above it. */
typedef struct spot {
    double along, above;
} spot;

static spot spot_of(const thud_closest *c, double x, double y) {
    return (spot){x * -c->ny + y * c->nx, x * c->nx + y * c->ny};
}

/* The ends of the box's face that looks most against the normal, relative to its centre. */
static void face_against(const thud_shape_instance *box, const thud_closest *c, spot end[2]) {
    double u, v, x, y;
    td_to_frame(box, -c->nx, -c->ny, &u, &v);
    bool by_u = td_abs(u) > td_abs(v);
    for (int i = 0; i < 2; i++) {
        double side = i ? 1.0 : -1.0;
        double eu = by_u ? (u < 0.0 ? -box->hx : box->hx) : side * box->hx;
        double ev = by_u ? side * box->hy : (v < 0.0 ? -box->hy : box->hy);
        td_from_frame(box, eu, ev, &x, &y);
        end[i] = spot_of(c, x, y);
    }
}

static spot part_way(spot p, spot q, double along) {
    double part = q.along != p.along ? (along - p.along) / (q.along - p.along) : 0.0;
    return (spot){along, p.above + td_clamp(part, 0.0, 1.0) * (q.above - p.above)};
}

/* The piece of the other box's opposite face that is over the face of `box` in the normal; then the
 * end of it that is further from the closest features. Both boxes and `c` are relative to where c
 * is on the surface of `box`, from which the normal points. */
static spot far_end(const thud_shape_instance *box, const thud_shape_instance *other,
                    const thud_closest *c) {
    spot end[2], center = spot_of(c, other->x, other->y), self = spot_of(c, box->x, box->y);
    double half = td_projected_extent(box, -c->ny, c->nx);
    double low = self.along - half, high = self.along + half;
    face_against(other, c, end);
    for (int i = 0; i < 2; i++) {
        end[i].along += center.along;
        end[i].above += center.above;
    }
    spot clipped[2];
    for (int i = 0; i < 2; i++) {
        clipped[i] = part_way(end[0], end[1], td_clamp(end[i].along, low, high));
    }
    return clipped[td_abs(clipped[1].along) > td_abs(clipped[0].along)];
}

static void reverse(thud_closest *c) {
    *c = (thud_closest){c->distance, -c->nx, -c->ny, c->bx, c->by, c->ax, c->ay};
}

/* Adds the second point of two boxes to the first, if there is one. */
static void add_far_end(const thud_shape_instance *a, const thud_shape_instance *b, double margin,
                        thud_contacts *out) {
    thud_closest c = out->point[0];
    double ax, ay, bx, by;
    double off_a = face_along(a, c.nx, c.ny, &ax, &ay);
    double off_b = face_along(b, -c.nx, -c.ny, &bx, &by);
    bool flipped = off_b < off_a;
    if ((flipped ? off_b : off_a) > ALIGNED) {
        return; /* corner to corner */
    }
    if (flipped) {
        reverse(&c);
    }
    c.nx = flipped ? bx : ax;
    c.ny = flipped ? by : ay;
    thud_shape_instance box = flipped ? *b : *a, other = flipped ? *a : *b;
    box.x -= c.ax;
    box.y -= c.ay;
    other.x -= c.ax;
    other.y -= c.ay;
    spot far = far_end(&box, &other, &c);
    double least = td_reach(a) < td_reach(b) ? td_reach(a) : td_reach(b);
    if (far.above > margin || td_abs(far.along) <= SAME * least) {
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

thud_result thud_shapes_contacts(const thud_shape_instance *a, const thud_shape_instance *b,
                                 double margin, thud_contacts *out) {
    if (!a || !b || !out) {
        return THUD_ERROR_NULL;
    }
    if (thud_placed_check(a) != THUD_OK || thud_placed_check(b) != THUD_OK ||
        !(margin >= 0.0 && margin <= THUD_COORDINATE_MAX)) {
        return THUD_ERROR_INVALID;
    }
    /* Relative to a: far from the origin, places are too coarse to work with. */
    thud_shape_instance here = *a, there = *b;
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
