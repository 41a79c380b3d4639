/* toi_candidates.c: see toi_candidates.h. A pair whose fat bounds overlapped at the start of the
 * step has a contact, and is a candidate already. An extra candidate is added if these bounds did
 * not overlap, but the bounds of the escaped shape's path overlap those of the other shape. */
#include "detection/toi_candidates.h"

#include "contact/contact.h"
#include "geometry/shape_instance.h"
#include "state/body.h"
#include "state/shape.h"

/* Whether the pair is an extra candidate already: two escaped shapes may find each other. */
static bool is_listed(const thud_world *w, int shape_a, int shape_b) {
    td_awake_slot slot = td_body_at(w, td_shape_at(w, shape_b)->body)->awake;
    int e = slot.at > 0 ? td_trajectory_at(w, slot)->extras : TD_NONE;
    while (e != TD_NONE) {
        const td_toi_candidate *extra =
            TD_AT(td_toi_candidate, &w->scratch.extra_candidates, td_edge_candidate(e));
        if ((extra->shape[0] == shape_a && extra->shape[1] == shape_b) ||
            (extra->shape[0] == shape_b && extra->shape[1] == shape_a)) {
            break;
        }
        e = extra->next[td_edge_side(e)];
    }
    return e != TD_NONE;
}

/* Adds an extra candidate, if it is not there yet, to the lists of both bodies. It is not queued.
 * False when memory is short. */
static bool add_extra(thud_world *w, int shape_a, int shape_b) {
    td_array *extras = &w->scratch.extra_candidates;
    int number = w->constraints.count + extras->count, index = extras->count;
    if (is_listed(w, shape_a, shape_b)) {
        return true;
    }
    if (!td_array_reserve(&w->memory, extras, index + 1) ||
        !td_event_queue_reserve(&w->memory, &w->scratch.queue, number + 1)) {
        return false;
    }
    td_toi_candidate *e = &TD_PUSH(td_toi_candidate, extras);
    *e = (td_toi_candidate){.shape = {shape_a, shape_b},
                            .body = {td_shape_at(w, shape_a)->body, td_shape_at(w, shape_b)->body}};
    td_int_set(&w->scratch.queue.spot, number, TD_NONE);
    for (int side = 0; side < 2; side++) {
        td_awake_slot slot = td_body_at(w, e->body[side])->awake;
        if (slot.at > 0) {
            td_trajectory *f = td_trajectory_at(w, slot);
            e->next[side] = f->extras;
            f->extras = td_edge_of(index, side);
        }
    }
    return true;
}

/* ---- bounds ---- */

/* A shape's fat bounds at the start of the step, unwrapped about the place of its body there. */
static td_far_bounds bounds_at_start(const thud_world *w, int shape) {
    const td_bounds *b =
        *td_marks_at(w, shape) & TD_MARK_MOVED ? td_previous_fat_at(w, shape) : td_fat_at(w, shape);
    td_body_index body = td_shape_at(w, shape)->body;
    td_awake_slot slot = td_body_at(w, body)->awake;
    td_position p = td_pose_at(w, body)->center;
    if (slot.at > 0) {
        const float *delta = td_row(&w->delta, slot);
        p.x = td_wrap_sub64(p.x, td_length_from(w, delta[0]));
        p.y = td_wrap_sub64(p.y, td_length_from(w, delta[1]));
    }
    return (td_far_bounds){(double)td_unwrap(b->min_x, p.x), (double)td_unwrap(b->min_y, p.y),
                           (double)td_unwrap(b->max_x, p.x), (double)td_unwrap(b->max_y, p.y)};
}

/* Whether two bounds share a point. */
static bool overlap(const td_far_bounds *a, const td_far_bounds *b) {
    return a->min_x <= b->max_x && b->min_x <= a->max_x && a->min_y <= b->max_y &&
           b->min_y <= a->max_y;
}

/* Whether the outer bounds contain the inner ones. */
static bool contains(const td_far_bounds *outer, const td_far_bounds *inner) {
    return outer->min_x <= inner->min_x && inner->max_x <= outer->max_x &&
           outer->min_y <= inner->min_y && inner->max_y <= outer->max_y;
}

/* Whether the bounds are small enough for a query of the broadphase: 2^30 quanta plus the bounds of
 * any shape are less than half of 2^32, after which bounds wrap around. */
static bool fits(const td_far_bounds *b) {
    return td_max_double(b->max_x - b->min_x, b->max_y - b->min_y) < 0x1p30;
}

/* The low 32 bits of a whole number, as td_bounds has them. */
static int32_t wrapped(double x) {
    return (int32_t)(uint32_t)(uint64_t)(int64_t)x;
}

/* Bounds as the broadphase has them, wrapped around. */
static td_bounds wrap(const td_far_bounds *b) {
    return (td_bounds){wrapped(b->min_x), wrapped(b->min_y), wrapped(b->max_x), wrapped(b->max_y)};
}

/* A half extent in bounds quanta, never less than the true one: 2 quanta are added for the rounding
 * of the length and of the position. At most 2^60, which int64_t holds. */
static double half_extent_quanta(const thud_world *w, double length) {
    return (double)(int64_t)td_min_double(length * w->to_coarse, 0x1p60) + 2.0;
}

/* Extends bounds to contain a placed shape with `slack` (a length) on each side, like
 * td_placed_bounds. */
static void widen(const thud_world *w, const thud_geometry *p, td_position origin, double slack,
                  td_far_bounds *b) {
    double x = (double)(td_wrap_add64(origin.x, td_round64(p->x * w->to_fixed)) >> TD_COARSE_SHIFT);
    double y = (double)(td_wrap_add64(origin.y, td_round64(p->y * w->to_fixed)) >> TD_COARSE_SHIFT);
    double half_x = half_extent_quanta(w, td_half_along(p, 1.0, 0.0) + slack);
    double half_y = half_extent_quanta(w, td_half_along(p, 0.0, 1.0) + slack);
    b->min_x = td_min_double(b->min_x, x - half_x);
    b->min_y = td_min_double(b->min_y, y - half_y);
    b->max_x = td_max_double(b->max_x, x + half_x + 1.0);
    b->max_y = td_max_double(b->max_y, y + half_y + 1.0);
}

/* Bounds of a shape on the rest of its path. A turn by phi takes no point out of the bounds of
 * both ends by more than r |phi| / 2, where r bounds its distance from the body's centre; a
 * parabola leaves them by its sagitta at most. */
static td_far_bounds bounds_ahead(const thud_world *w, const td_trajectory *f, int index) {
    thud_geometry now = td_trajectory_shape(w, f, index, f->since, f->place);
    thud_geometry end = td_trajectory_shape(w, f, index, 1.0, f->place);
    double turn = 0.5 * td_abs(f->motion[2]) * (1.0 - f->since);
    double slack =
        (td_reach(&now) + td_abs(now.x) + td_abs(now.y)) * turn +
        (double)(TD_IMPACT_DISTANCE * w->length_scale) +
        td_trajectories_chord_error(&(td_trajectory){.body = {TD_NONE}}, f, 1.0 - f->since);
    double huge = (double)__builtin_inf();
    td_far_bounds b = {huge, huge, -huge, -huge};
    widen(w, &now, f->place, slack, &b);
    widen(w, &end, f->place, slack, &b);
    return b;
}

/* Appends to scratch.found_shapes the shapes of a proxy set whose fat bounds overlap those of the
 * path; all of the set where the path is too long for a query. False when memory is short. */
static bool append_overlapping(thud_world *w, const td_proxy_set *set, const td_far_bounds *ahead,
                               td_position near_place) {
    td_array *found = &w->scratch.found_shapes;
    if (fits(ahead)) {
        td_bounds bounds = wrap(ahead);
        return w->def.broadphase->find[w->wide](set, &w->memory, &bounds, near_place, found, NULL);
    }
    for (int i = 0; i < set->ids.count; i++) {
        int shape = td_int_at(&set->ids, i);
        if (shape != TD_NONE) { /* a body that was woken leaves holes */
            td_push_int(found, shape);
        }
    }
    return true;
}

/* ---- candidates ---- */

/* Whether the pair is one for times of impact: neither shape is a sensor or new, they may collide,
 * and the detection of the pair finds them. */
static bool is_detected(const thud_world *w, int shape, int other) {
    const td_shape *a = td_shape_at(w, shape), *b = td_shape_at(w, other);
    return !((a->flags | b->flags) & TD_SHAPE_HOLLOW) && td_pair_allowed(w, shape, other) &&
           td_detection_of(w, a->body, b->body)->time_of_impact;
}

/* Adds candidates for the shapes that a query found, in the order of their numbers, which does not
 * depend on the broadphase. The exact bounds are compared again, since those of the broadphase
 * wrap around. */
static bool add_found(thud_world *w, const td_escaped_shape *s) {
    const td_array *found = &w->scratch.found_shapes;
    td_sort_ints(&w->scratch.found_shapes);
    for (int i = 0; i < found->count; i++) {
        int other = td_int_at(found, i);
        td_far_bounds there = bounds_at_start(w, other);
        if (!overlap(&s->start, &there) && overlap(&s->ahead, &there) &&
            is_detected(w, s->shape, other) && !add_extra(w, s->shape, other)) {
            return false;
        }
    }
    return true;
}

/* Adds candidates with the escaped shapes of other bodies, which the broadphase only knows at their
 * old places. At least one body of the pair must have a detection that finds times of impact. */
static bool add_escaped_pairs(thud_world *w, const td_escaped_shape *s) {
    const td_array *escaped = &w->scratch.escaped;
    for (int i = 0; i < escaped->count; i++) {
        const td_escaped_shape *other = TD_AT(td_escaped_shape, escaped, i);
        if ((s->detects || other->detects) && overlap(&s->ahead, &other->ahead) &&
            !overlap(&s->start, &other->start) && is_detected(w, s->shape, other->shape) &&
            !add_extra(w, s->shape, other->shape)) {
            return false;
        }
    }
    return true;
}

/* Adds an escaped shape to scratch.escaped and to its body, or updates the path of one that is
 * there. False when memory is short. */
static bool record_escaped_shape(thud_world *w, td_trajectory *f, const td_escaped_shape *s) {
    td_array *escaped = &w->scratch.escaped;
    int i = f->escaped;
    while (i != TD_NONE && TD_AT(td_escaped_shape, escaped, i)->shape != s->shape) {
        i = TD_AT(td_escaped_shape, escaped, i)->next;
    }
    if (i != TD_NONE) {
        TD_AT(td_escaped_shape, escaped, i)->ahead = s->ahead;
        return true;
    }
    if (!td_array_reserve(&w->memory, escaped, escaped->count + 1)) {
        return false;
    }
    f->escaped = escaped->count;
    TD_PUSH(td_escaped_shape, escaped) = *s;
    return true;
}

bool td_toi_candidates_find(thud_world *w, td_trajectory *f) {
    const td_body *body = td_body_at(w, f->body);
    bool detects = body->kind == THUD_BODY_DYNAMIC && body->detection->time_of_impact;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_escaped_shape s = {bounds_at_start(w, i), bounds_ahead(w, f, i), i, f->escaped, detects};
        if (contains(&s.start, &s.ahead) || (td_shape_at(w, i)->flags & TD_SHAPE_HOLLOW)) {
            continue;
        }
        w->scratch.found_shapes.count = 0;
        if (!append_overlapping(w, &w->awake_shapes, &s.ahead, f->place) ||
            !append_overlapping(w, &w->rest_shapes, &s.ahead, f->place) || !add_found(w, &s) ||
            !add_escaped_pairs(w, &s) || !record_escaped_shape(w, f, &s)) {
            return false;
        }
    }
    return true;
}

bool td_toi_candidates_find_terrain(thud_world *w, const td_trajectory *f) {
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_terrain_record_at(w, t);
        int i = record->shape == TD_NONE ? TD_NONE : td_body_at(w, f->body)->first_shape;
        for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
            td_far_bounds far = bounds_ahead(w, f, i);
            td_bounds ahead = wrap(&far);
            if (!((td_shape_at(w, record->shape)->flags | td_shape_at(w, i)->flags) &
                  TD_SHAPE_HOLLOW) &&
                td_pair_allowed(w, record->shape, i) &&
                !(fits(&far) && td_terrain_below(w, record->shape, f->place, &ahead)) &&
                !add_extra(w, record->shape, i)) {
                return false;
            }
        }
    }
    return true;
}

/* A turn by phi takes corners at distance r up to r phi^2 / 8 out of the bounds of both ends; with
 * more than TD_MARGIN of that the fat bounds may not contain the path. Otherwise a shape has left
 * its fat bounds if td_finalize has marked it as moved. */
bool td_trajectory_leaves_bounds(const thud_world *w, const td_trajectory *f) {
    const td_body *body = td_body_at(w, f->body);
    double out = 0.125 * (double)body->max_extent * f->motion[2] * f->motion[2];
    int i = body->first_shape;
    bool turns = !body->aabbs && out > (double)(TD_MARGIN * w->length_scale);
    while (i != TD_NONE && !turns && !(*td_marks_at(w, i) & TD_MARK_MOVED)) {
        i = td_shape_at(w, i)->next;
    }
    return i != TD_NONE;
}
