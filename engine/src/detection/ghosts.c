/* ghosts.c: see ghosts.h. A ghost lasts until one shape has come past a face of the other that was
 * hidden from it: from there on another normal is theirs. What happens before is the neighbours'.
 */
#include "detection/ghosts.h"

#include "contact/internal_edges.h"
#include "terrain/terrain.h"

/* No ghost goes sooner than after this part of the rest of a step. */
#define SHORTEST 0x1p-20

/* What has to go past a face to be behind it: a circle's centre, or the whole shape. */
static thud_shape_instance heart_of(const thud_shape_instance *shape) {
    thud_shape_instance heart = *shape;
    if (td_kind_is_round(shape->kind)) {
        heart.hx = heart.hy = 0.0;
    }
    return heart;
}

/* When the first of those faces that are between the two is passed, in [0, 1] of the approach. */
static double time_past_face(const td_approach *p) {
    thud_shape_instance a = heart_of(&p->a), b = heart_of(&p->b);
    double first = 2.0;
    for (int i = 0; i < 4; i++) {
        const thud_shape_instance *box = i < 2 ? &a : &b;
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

/* What is met at the sealed end of a line is a ghost until the shape comes over the line. */
static bool met_at_end(const thud_world *w, const td_toi_candidate *e, const td_approach *p,
                       double *part) {
    thud_closest c;
    double x, out;
    thud_terrain_closest(&p->ground, &p->a, &c);
    if (!td_at_sealed_end(w, e->shape[0], &p->ground, &p->a, &c, &x, &out)) {
        return false;
    }
    thud_shape_instance end = {.kind = THUD_CIRCLE, .x = x, .y = p->a.y, .c = 1.0};
    thud_shape_instance heart = heart_of(&p->a);
    double beyond = (heart.x - x) * out - td_projected_extent(&heart, 1.0, 0.0);
    *part = beyond > 0.0
                ? td_time_across(&end, &(thud_motion){0}, &heart, &p->motion_a, out, 0.0, 0.0)
                : 2.0;
    return true;
}

static bool met(thud_world *w, const td_toi_candidate *e, const td_approach *p, double *part) {
    td_internal_edge_pair pair = {w, {e->shape[0], e->shape[1]}, {p->a, p->b}};
    td_internal_edge_contact contact;
    thud_closest c;
    td_closest(&p->a, &p->b, &c);
    if (!w->internal_edges->is_ghost(&pair, c.nx, c.ny)) {
        return false;
    }
    *part = time_past_face(p);
    /* Boxes that are past all faces touch along a normal that can be met, or not at all. */
    return *part < 2.0 || !w->internal_edges->contact(&pair, &contact);
}

bool td_ghost_met(thud_world *w, const td_toi_candidate *e, double time, double *again) {
    if (!td_toi_candidate_has_seams(w, e)) {
        return false;
    }
    td_approach p;
    double part;
    td_toi_candidate_ways(w, e, time, 1.0, &p);
    if (!(p.on_ground ? met_at_end(w, e, &p, &part) : met(w, e, &p, &part))) {
        return false;
    }
    *again = time + (1.0 - time) * td_max_double(part, SHORTEST);
    return true;
}
