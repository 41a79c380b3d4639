/* box_faces.c: see box_faces.h. The face of the chosen axis clips the opposite face of the other
 * box. */
#include "contact/box_faces.h"

/* Open axes may be so much deeper than hidden ones, and the margin. Of 10^5 heaps in
 * test_internal_edges_random, 1.25 is wrong about none; 2 flings two bodies away, and 0, the margin
 * alone, lets one through the ground. */
#define DEEPER 1.25

/* Points where the edge of `other` that looks most against the outward normal (nx, ny) of `face`'s
 * box lies over that face. */
static int clip(const thud_shape_instance *face, const thud_shape_instance *other, double nx,
                double ny, double margin, double *x, double *y, double *separation) {
    double u, v, tx = -ny, ty = nx;
    /* The other box's edge: centre, direction and half length. */
    td_to_frame(other, -nx, -ny, &u, &v);
    bool by_u = td_abs(u) >= td_abs(v);
    double eu = by_u ? (u < 0.0 ? -other->hx : other->hx) : 0.0;
    double ev = by_u ? 0.0 : (v < 0.0 ? -other->hy : other->hy);
    double cx, cy, dx, dy, half = by_u ? other->hy : other->hx;
    td_from_frame(other, eu, ev, &cx, &cy);
    td_from_frame(other, by_u ? 0.0 : 1.0, by_u ? 1.0 : 0.0, &dx, &dy);
    cx += other->x - face->x;
    cy += other->y - face->y;
    /* Cut to where it is over the face. */
    double slope = dx * tx + dy * ty, middle = cx * tx + cy * ty;
    double reach = td_projected_extent(face, tx, ty), from = -half, to = half;
    double first = (-reach - middle) / slope, last = (reach - middle) / slope;
    if (first > last) {
        double t = first;
        first = last;
        last = t;
    }
    from = first > from ? first : from;
    to = last < to ? last : to;
    int count = 0;
    for (int k = 0; k < 2 && from <= to; k++) {
        double along = k ? to : from, px = cx + along * dx, py = cy + along * dy;
        double above = px * nx + py * ny - td_projected_extent(face, nx, ny);
        if (above <= margin) {
            x[count] = face->x + px - 0.5 * above * nx;
            y[count] = face->y + py - 0.5 * above * ny;
            separation[count++] = above;
        }
    }
    return count;
}

/* One of the axes of the two boxes, turned to look from a to b, and how far apart they are along
 * it. */
static double axis_of(const thud_shape_instance *a, const thud_shape_instance *b, int i, double *nx,
                      double *ny) {
    const thud_shape_instance *box = i < 2 ? a : b;
    double x = i % 2 ? -box->s : box->c, y = i % 2 ? box->c : box->s;
    double along = (b->x - a->x) * x + (b->y - a->y) * y;
    *nx = along < 0.0 ? -x : x;
    *ny = along < 0.0 ? -y : y;
    return td_abs(along) - td_projected_extent(a, x, y) - td_projected_extent(b, x, y);
}

/* How many directions have to be looked along: those of both boxes, which upright ones share. */
static int axes_of(const thud_shape_instance *a, const thud_shape_instance *b) {
    return td_kind_turns(a->kind) || td_kind_turns(b->kind) ? 4 : 2;
}

bool td_internal_edge_boxes_meet(const thud_shape_instance *a, const thud_shape_instance *b) {
    double nx, ny;
    if (axes_of(a, b) == 2) { /* what axis_of gives where c = 1 and s = 0 */
        return td_abs(b->x - a->x) - a->hx - b->hx <= 0.0 &&
               td_abs(b->y - a->y) - a->hy - b->hy <= 0.0;
    }
    for (int i = 0; i < 4; i++) {
        if (axis_of(a, b, i, &nx, &ny) > 0.0) {
            return false;
        }
    }
    return true;
}

bool td_internal_edge_boxes(const thud_shape_instance *a, const thud_shape_instance *b,
                            double margin, td_axis_hidden_fn *hidden, void *context,
                            td_internal_edge_contact *out) {
    double best = -1e300, plain = -1e300;
    const thud_shape_instance *face = NULL;
    for (int i = 0; i < axes_of(a, b); i++) {
        double nx, ny, separation = axis_of(a, b, i, &nx, &ny);
        plain = separation > plain ? separation : plain;
        if (separation > best && !hidden(nx, ny, context)) {
            best = separation;
            face = i < 2 ? a : b;
            out->nx = nx;
            out->ny = ny;
        }
    }
    /* What lies much deeper along an open axis than along a hidden one overlaps what hides that,
     * and is pushed out by it; pushed along the open axis it would be flung away. */
    if (!face || best > margin || best < DEEPER * plain - margin) {
        return false;
    }
    double sign = face == a ? 1.0 : -1.0;
    out->count = clip(face, face == a ? b : a, sign * out->nx, sign * out->ny, margin, out->x,
                      out->y, out->separation);
    return out->count > 0;
}
