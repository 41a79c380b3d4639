/* toi_candidates.c: see toi_candidates.h. */
#include "detection/toi_candidates.h"

#include "contact/contact.h"
#include "geometry/shape_instance.h"
#include "state/shape.h"

/* Whether the pair is a candidate already: where both stray, each may find the other. */
static bool is_listed(const thud_world *w, int shape_a, int shape_b) {
    td_awake_slot slot = td_body_at(w, td_shape_at(w, shape_b)->body)->awake;
    int e = slot.at > 0 ? td_trajectory_at(w, slot)->extras : TD_NONE;
    while (e != TD_NONE) {
        const td_toi_candidate *extra = TD_AT(td_toi_candidate, &w->scratch.candidates, e / 2);
        if ((extra->shape[0] == shape_a && extra->shape[1] == shape_b) ||
            (extra->shape[0] == shape_b && extra->shape[1] == shape_a)) {
            break;
        }
        e = extra->next[e & 1];
    }
    return e != TD_NONE;
}

/* False when memory is short; what strays is then held. */
static bool add_extra(thud_world *w, int shape_a, int shape_b) {
    td_array *extras = &w->scratch.candidates;
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
            f->extras = index * 2 + side;
        }
    }
    return true;
}

/* Bounds of one of the body's shapes on the rest of its way. While it turns, nothing of it is
 * further out than at one of both ends, but for what the turn moves its furthest corner. */
static td_bounds bounds_ahead(const thud_world *w, const td_trajectory *f, int index) {
    thud_shape_instance now = td_trajectory_shape(w, f, index, f->since, f->place);
    thud_shape_instance end = td_trajectory_shape(w, f, index, 1.0, f->place);
    double turn = 0.5 * td_abs(f->motion[2]) * (1.0 - f->since);
    double slack = (td_reach(&now) + td_abs(now.x) + td_abs(now.y)) * turn +
                   (double)(TD_MEET * w->unit) +
                   td_trajectories_bend(&(td_trajectory){.body = {TD_NONE}}, f, 1.0 - f->since);
    td_bounds a = td_placed_bounds(w, &now, f->place, slack);
    td_bounds b = td_placed_bounds(w, &end, f->place, slack);
    return td_bounds_around(&a, &b);
}

static const td_bounds *bounds_at_start(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED ? td_was_at(w, shape) : td_fat_at(w, shape);
}

/* Whether a detection sees to it that the two do not pass each other. */
static bool is_looked_at(const thud_world *w, int shape, int other) {
    const td_shape *a = td_shape_at(w, shape), *b = td_shape_at(w, other);
    return !((a->flags | b->flags) & TD_SHAPE_HOLLOW) && td_pair_allowed(w, shape, other) &&
           td_detection_of(w, a->body, b->body)->meet;
}

/* Adds what was found, in the order of shapes, so that it is the same whichever order a broadphase
 * finds it in. */
static bool add_found(thud_world *w, int shape, const td_bounds *ahead) {
    const td_array *hits = &w->scratch.hits;
    td_sort_ints(&w->scratch.hits);
    for (int i = 0; i < hits->count; i++) {
        int other = td_int_at(hits, i);
        if (!td_bounds_overlap(bounds_at_start(w, shape), bounds_at_start(w, other)) &&
            td_bounds_overlap(ahead, bounds_at_start(w, other)) && is_looked_at(w, shape, other) &&
            !add_extra(w, shape, other)) {
            return false;
        }
    }
    return true;
}

/* Looks among the shapes that strayed, since those are not where the broadphase has them. */
static bool add_strays(thud_world *w, int shape, const td_bounds *ahead, bool chose) {
    const td_array *strays = &w->scratch.strays;
    for (int i = 0; i < strays->count; i++) {
        const td_stray *s = TD_AT(td_stray, strays, i);
        if ((chose || s->chose) && td_bounds_overlap(ahead, &s->ahead) &&
            !td_bounds_overlap(bounds_at_start(w, shape), bounds_at_start(w, s->shape)) &&
            is_looked_at(w, shape, s->shape) && !add_extra(w, shape, s->shape)) {
            return false;
        }
    }
    return true;
}

static bool note_stray(thud_world *w, td_trajectory *f, int shape, const td_bounds *ahead,
                       bool chose) {
    td_array *strays = &w->scratch.strays;
    int i = f->strays;
    while (i != TD_NONE && TD_AT(td_stray, strays, i)->shape != shape) {
        i = TD_AT(td_stray, strays, i)->next;
    }
    if (i == TD_NONE) {
        if (!td_array_reserve(&w->memory, strays, strays->count + 1)) {
            return false;
        }
        i = strays->count++;
        *TD_AT(td_stray, strays, i) = (td_stray){.shape = shape, .next = f->strays, .chose = chose};
        f->strays = i;
    }
    TD_AT(td_stray, strays, i)->ahead = *ahead;
    return true;
}

bool td_toi_candidates_around(thud_world *w, td_trajectory *f) {
    td_find_fn *find = w->def.broadphase->find[w->wide];
    const td_body *body = td_body_at(w, f->body);
    bool chose = body->kind == THUD_DYNAMIC && body->detection->meet;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_bounds ahead = bounds_ahead(w, f, i);
        if (td_bounds_contain(bounds_at_start(w, i), &ahead) ||
            (td_shape_at(w, i)->flags & TD_SHAPE_HOLLOW)) {
            continue;
        }
        w->scratch.hits.count = 0;
        if (!find(&w->awake_shapes, &w->memory, &ahead, f->place, &w->scratch.hits) ||
            !find(&w->rest_shapes, &w->memory, &ahead, f->place, &w->scratch.hits) ||
            !add_found(w, i, &ahead) || !add_strays(w, i, &ahead, chose) ||
            !note_stray(w, f, i, &ahead, chose)) {
            return false;
        }
    }
    return true;
}

bool td_toi_candidates_on_ground(thud_world *w, const td_trajectory *f) {
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_terrain_record_at(w, t);
        int i = record->shape == TD_NONE ? TD_NONE : td_body_at(w, f->body)->first_shape;
        for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
            td_bounds ahead = bounds_ahead(w, f, i);
            if (!((td_shape_at(w, record->shape)->flags | td_shape_at(w, i)->flags) &
                  TD_SHAPE_HOLLOW) &&
                td_pair_allowed(w, record->shape, i) &&
                !td_terrain_below(w, record->shape, f->place, &ahead) &&
                !add_extra(w, record->shape, i)) {
                return false;
            }
        }
    }
    return true;
}

/* A turn may take corners out of the bounds of both ends. */
bool td_trajectory_is_unexpected(const thud_world *w, const td_trajectory *f) {
    const td_body *body = td_body_at(w, f->body);
    double out = 0.125 * (double)body->rim * f->motion[2] * f->motion[2];
    int i = body->first_shape;
    bool turns = !body->aabbs && out > (double)(TD_MARGIN * w->unit);
    while (i != TD_NONE && !turns && !(*td_marks_at(w, i) & TD_MARK_MOVED)) {
        i = td_shape_at(w, i)->next;
    }
    return i != TD_NONE;
}
