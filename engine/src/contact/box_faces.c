/* box_faces.c: see box_faces.h. The axis of the contact is, of the open ones (those that are not
 * hidden), the one with the largest separation. It is the normal of a face of one box, the
 * reference face; the edge of the other box that is most opposed to it, the incident edge, is
 * clipped to the width of the reference face, and its up to two ends are the contact points. */
#include "contact/box_faces.h"

/* The contact is dropped if the overlap along the best open axis is more than this many times the
 * smallest overlap along any axis, plus the speculative margin (the distance below which shapes
 * have a contact). Measured with 10^5 heaps of test_internal_edges_random: with 1.25 no body is
 * flung away or falls through the ground; with 2 two bodies are flung away along an axis along
 * which they overlap much deeper; with 0 (the margin alone) one body falls through the ground. The
 * same formula is used where the boxes are apart, by at most the margin. */
#define OPEN_DEPTH_RATIO_MAX 1.25

/* Clips the incident edge of the box `incident`, the edge that is most opposed to the outward
 * normal (nx, ny) of a face of the box `reference`, to the width of that face. Writes the ends that
 * are within `margin` above the face: places halfway between edge and face, and separations.
 * Returns their number, 0 to 2. */
static int clip_incident_edge(const thud_geometry *reference, const thud_geometry *incident,
                              double nx, double ny, double margin, double *x, double *y,
                              double *separation) {
    double u, v, tx = -ny, ty = nx;
    /* The incident edge: its centre (cx, cy), relative to the centre of `reference`, its direction
     * (dx, dy) and its half length. (u, v) is the opposite of the normal in the frame of
     * `incident`; the edge lies on the side of its larger component. */
    td_to_frame(incident, -nx, -ny, &u, &v);
    bool by_u = td_abs(u) >= td_abs(v);
    double eu = by_u ? (u < 0.0 ? -incident->hx : incident->hx) : 0.0;
    double ev = by_u ? 0.0 : (v < 0.0 ? -incident->hy : incident->hy);
    double cx, cy, dx, dy, half = by_u ? incident->hy : incident->hx;
    td_from_frame(incident, eu, ev, &cx, &cy);
    td_from_frame(incident, by_u ? 0.0 : 1.0, by_u ? 1.0 : 0.0, &dx, &dy);
    cx += incident->x - reference->x;
    cy += incident->y - reference->y;
    /* The interval of the edge's parameter that lies over the reference face. The cosine of the
     * angle between edge and face is max(|u|, |v|) or its opposite, and so never 0. */
    double cosine = dx * tx + dy * ty, middle = cx * tx + cy * ty;
    double reach = td_projected_extent(reference, tx, ty), from = -half, to = half;
    double first = (-reach - middle) / cosine, last = (reach - middle) / cosine;
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
        double above = px * nx + py * ny - td_projected_extent(reference, nx, ny);
        if (above <= margin) {
            x[count] = reference->x + px - 0.5 * above * nx;
            y[count] = reference->y + py - 0.5 * above * ny;
            separation[count++] = above;
        }
    }
    return count;
}

/* The separation along axis i: 0 and 1 are the axes of a, 2 and 3 those of b. (*nx, *ny) is the
 * axis as a unit normal from a to b. */
static double separation_on_axis(const thud_geometry *a, const thud_geometry *b, int i, double *nx,
                                 double *ny) {
    const thud_geometry *box = i < 2 ? a : b;
    double x = i % 2 ? -box->s : box->c, y = i % 2 ? box->c : box->s;
    double along = (b->x - a->x) * x + (b->y - a->y) * y;
    *nx = along < 0.0 ? -x : x;
    *ny = along < 0.0 ? -y : y;
    return td_abs(along) - td_projected_extent(a, x, y) - td_projected_extent(b, x, y);
}

/* The number of different axes: four, or two where both boxes are upright and share theirs. */
static int axis_count(const thud_geometry *a, const thud_geometry *b) {
    return td_kind_turns(a->kind) || td_kind_turns(b->kind) ? 4 : 2;
}

bool td_boxes_overlap(const thud_geometry *a, const thud_geometry *b) {
    double nx, ny;
    if (axis_count(a, b) == 2) { /* separation_on_axis for c = 1 and s = 0 */
        return td_abs(b->x - a->x) - a->hx - b->hx <= 0.0 &&
               td_abs(b->y - a->y) - a->hy - b->hy <= 0.0;
    }
    for (int i = 0; i < 4; i++) {
        if (separation_on_axis(a, b, i, &nx, &ny) > 0.0) {
            return false;
        }
    }
    return true;
}

bool td_box_contact_on_open_axis(const thud_geometry *a, const thud_geometry *b, double margin,
                                 td_axis_hidden_fn *hidden, void *context,
                                 td_internal_edge_contact *out) {
    double best_open = -1e300, best = -1e300; /* largest separation: open axes; all axes */
    const thud_geometry *reference = NULL;
    for (int i = 0; i < axis_count(a, b); i++) {
        double nx, ny, separation = separation_on_axis(a, b, i, &nx, &ny);
        best = separation > best ? separation : best;
        if (separation > best_open && !hidden(nx, ny, context)) {
            best_open = separation;
            reference = i < 2 ? a : b;
            out->nx = nx;
            out->ny = ny;
        }
    }
    /* A box that overlaps much deeper along the open axis than along a hidden one also overlaps the
     * neighbour that hides the latter, and the contact with the neighbour pushes it out; this
     * contact would fling it away along the open axis. */
    if (!reference || best_open > margin || best_open < OPEN_DEPTH_RATIO_MAX * best - margin) {
        return false;
    }
    double sign = reference == a ? 1.0 : -1.0;
    out->count = clip_incident_edge(reference, reference == a ? b : a, sign * out->nx,
                                    sign * out->ny, margin, out->x, out->y, out->separation);
    return out->count > 0;
}
