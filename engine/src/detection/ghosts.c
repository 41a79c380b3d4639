/* ghosts.c: see ghosts.h. A contact stays a ghost until one shape crosses the plane of a face of
 * the other that separates the two at the time of the ghost: then the pair has another separating
 * axis, and so another normal. Until then the neighbours that hide the face meet the shape instead.
 */
#include "detection/ghosts.h"

#include "contact/internal_edges.h"
#include "terrain/terrain.h"

/* Minimum time for which a contact stays a ghost, as a share of the rest of the step, so that the
 * search makes progress. Chosen, equal to TIME_TOLERANCE of detect_bisect.c. */
#define GHOST_TIME_MIN 0x1p-20

/* The part of a shape that has to cross the plane of a face before the pair has another normal: the
 * centre of a circle, the whole of any other shape. */
static thud_geometry face_probe(const thud_geometry *shape) {
    thud_geometry probe = *shape;
    if (td_kind_is_round(shape->kind)) {
        probe.hx = probe.hy = 0.0;
    }
    return probe;
}

/* The earliest time, share of the approach, at which the pair may come past a face of a box that
 * now separates the two; 2 where no face does. */
static double time_past_face(const td_approach *p) {
    thud_geometry a = face_probe(&p->a), b = face_probe(&p->b);
    double first = 2.0;
    for (int i = 0; i < 4; i++) {
        const thud_geometry *box = i < 2 ? &a : &b;
        double x = i % 2 ? -box->s : box->c, y = i % 2 ? box->c : box->s;
        double along = (b.x - a.x) * x + (b.y - a.y) * y, sign = along < 0.0 ? -1.0 : 1.0;
        if (td_kind_is_box(box->kind) &&
            sign * along > td_projected_extent(&a, x, y) + td_projected_extent(&b, x, y)) {
            first = td_min_double(first, td_time_across(&a, &p->motion_a, &b, &p->motion_b,
                                                        sign * x, sign * y, 0.0));
        }
    }
    return first;
}

/* Whether a shape meets a terrain at a sealed end (td_is_at_sealed_end), which is a ghost. *part:
 * the share of the approach after which the shape may have crossed the vertical through that end
 * and come over the line, where its contacts are valid; 2 if a part of the shape is over the line
 * already, so that the contact stays a ghost for the whole step. */
static bool is_end_ghost(const thud_world *w, const td_toi_candidate *e, const td_approach *p,
                         double *part) {
    thud_closest c;
    double x, out;
    thud_terrain_closest(&p->ground, &p->a, &c);
    if (!td_is_at_sealed_end(w, e->shape[0], &p->ground, &p->a, &c, &x, &out)) {
        return false;
    }
    thud_geometry end = {.kind = THUD_SHAPE_CIRCLE, .x = x, .y = p->a.y, .c = 1.0};
    thud_geometry probe = face_probe(&p->a);
    /* The gap between the probe and the vertical through the end; < 0: the two overlap. */
    double beyond = (probe.x - x) * out - td_projected_extent(&probe, 1.0, 0.0);
    *part = beyond > 0.0
                ? td_time_across(&end, &(thud_motion){0}, &probe, &p->motion_a, out, 0.0, 0.0)
                : 2.0;
    return true;
}

/* Whether the contact of two shapes is a ghost. *part: the earliest time, as a share of the
 * approach, at which it may stop being one (time_past_face). */
static bool is_box_ghost(thud_world *w, const td_toi_candidate *e, const td_approach *p,
                         double *part) {
    td_internal_edge_pair pair = {w, {e->shape[0], e->shape[1]}, {p->a, p->b}};
    td_internal_edge_contact contact;
    thud_closest c;
    td_closest(&p->a, &p->b, &c);
    if (!w->internal_edges->is_ghost(&pair, c.nx, c.ny)) {
        return false;
    }
    *part = time_past_face(p);
    /* If no face separates the boxes, they touch along an allowed normal, which is no ghost, or
     * they do not touch. */
    return *part < 2.0 || !w->internal_edges->contact(&pair, &contact);
}

bool td_is_ghost(thud_world *w, const td_toi_candidate *e, double time, double *again) {
    if (!td_toi_candidate_has_internal_edges(w, e)) {
        return false;
    }
    td_approach p;
    double part;
    td_toi_candidate_motions(w, e, time, 1.0, &p);
    if (!(p.on_ground ? is_end_ghost(w, e, &p, &part) : is_box_ghost(w, e, &p, &part))) {
        return false;
    }
    *again = time + (1.0 - time) * td_max_double(part, GHOST_TIME_MIN);
    return true;
}
