/* contact.c: see contact.h. Which pairs of shapes become contacts, and how contacts begin, end and
 * are destroyed, with their events. */
#include "contact/contact.h"

#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "rules/rule_hooks.h"

static td_body *body_of_shape(const thud_world *w, int shape) {
    return td_body_at(w, td_shape_at(w, shape)->body);
}

static void swap(int *a, int *b) {
    int t = *a;
    *a = *b;
    *b = t;
}

td_pair_kind td_pair_of(const thud_world *w, int *shape_a, int *shape_b) {
    const td_shape *a = td_shape_at(w, *shape_a), *b = td_shape_at(w, *shape_b);
    if ((a->flags | b->flags) & TD_SHAPE_SENSOR) {
        if (!(a->flags & TD_SHAPE_SENSOR)) {
            swap(shape_a, shape_b);
        }
        return TD_PAIR_SENSOR;
    }
    bool a_static = body_of_shape(w, *shape_a)->kind == THUD_BODY_STATIC;
    bool b_static = body_of_shape(w, *shape_b)->kind == THUD_BODY_STATIC;
    unsigned pairing = td_pairing_of(a->kind, b->kind);
    bool swaps = a->kind == b->kind ? *shape_a > *shape_b : pairing & TD_PAIR_SWAPS;
    if (b_static || (!a_static && swaps)) {
        swap(shape_a, shape_b);
        pairing = td_pairing_of(b->kind, a->kind);
    }
    return pairing & ~(unsigned)TD_PAIR_SWAPS;
}

bool td_pair_allowed(const thud_world *w, int shape_a, int shape_b) {
    const td_shape *a = td_shape_at(w, shape_a), *b = td_shape_at(w, shape_b);
    const td_body *body_a = td_body_at(w, a->body), *body_b = td_body_at(w, b->body);
    /* A contact of two solid shapes needs a dynamic body; a contact of a sensor needs a dynamic or
     * kinematic one. */
    int kind_min =
        (a->flags | b->flags) & TD_SHAPE_SENSOR ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
    if (td_same_body(a->body, b->body) || (body_a->kind < kind_min && body_b->kind < kind_min) ||
        ((body_a->flags | body_b->flags) & TD_BODY_DISABLED)) {
        return false;
    }
    if (w->joint_hooks && kind_min == THUD_BODY_DYNAMIC &&
        w->joint_hooks->exclude_contact(w, a->body, b->body)) {
        return false;
    }
    bool collides = (a->filter.mask & b->filter.category) && (b->filter.mask & a->filter.category);
    if (a->filter.group == b->filter.group && a->filter.group != 0) {
        collides = a->filter.group > 0;
    }
    return collides && (!w->rule_hooks || w->rule_hooks->allows(w, shape_a, shape_b));
}

bool td_pair_meets(const thud_world *w, int a, int b) {
    if (!td_bounds_overlap(td_fat_at(w, a), td_fat_at(w, b))) {
        return false;
    }
    const td_position *p = &td_shape_proxy_at(w, a)->center, *q = &td_shape_proxy_at(w, b)->center;
    /* A quarter of the range of the 32-bit coarse coordinates. */
    int64_t limit = (int64_t)1 << (30 + TD_COARSE_SHIFT), x = td_wrap_sub64(p->x, q->x),
            y = td_wrap_sub64(p->y, q->y);
    return !w->vast || (x < limit && x > -limit && y < limit && y > -limit);
}

bool td_contact_bounds_meet(const thud_world *w, const td_contact *contact) {
    int a = contact->shape_a, b = contact->shape_b, kind = contact->kind;
    bool sensor = kind == TD_PAIR_SENSOR;
    if (td_pair_is_on_line(kind) || (sensor && td_kind_is_line(td_shape_at(w, a)->kind))) {
        return w->ground->reaches(w, a, b, contact->child);
    }
    if (sensor && td_kind_is_line(td_shape_at(w, b)->kind)) {
        return w->ground->reaches(w, b, a, contact->child);
    }
    return td_pair_meets(w, a, b);
}

void td_contact_create(thud_world *w, td_pair_kind kind, int shape_a, int shape_b, int child) {
    int index =
        td_constraint_create(w, kind, td_shape_at(w, shape_a)->body, td_shape_at(w, shape_b)->body);
    td_contact *contact = td_contact_at(w, index);
    contact->shape_a = shape_a;
    contact->shape_b = shape_b;
    contact->child = child;
}

bool td_contact_end_reserve(thud_world *w, int more) {
    td_event_lists *e = &w->events;
    int sensed = e->sensor_end.count + 2 * td_min_int(more, w->constraint_count[TD_PAIR_SENSOR]);
    /* Makes room for at least 32 events, so that few steps have to allocate memory. Chosen. */
    int ends = e->end.count + td_max_int(more, 32);
    return more == 0 || ((!w->def.contact_events || td_array_reserve(&w->memory, &e->end, ends)) &&
                         td_array_reserve(&w->memory, &e->sensor_end, sensed) &&
                         td_array_reserve(&w->memory, &e->sensor_end_time, sensed));
}

/* A shape has one contact for each segment of a terrain that it touches, but events treat the
 * terrain as one shape: the pair begins with its first segment and ends with its last. Returns
 * td_constraint.open of another contact of the pair that is open, or 0. */
static int open_elsewhere(const thud_world *w, int contact_index) {
    const td_contact *contact = td_contact_at(w, contact_index);
    bool ground_first = td_kind_is_line(td_shape_at(w, contact->shape_a)->kind);
    if (!ground_first && !td_kind_is_line(td_shape_at(w, contact->shape_b)->kind)) {
        return 0;
    }
    int e = td_body_at(w, contact->body[ground_first])->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *other = td_constraint_at(w, td_edge_constraint(e));
        if (other != contact && other->open && other->shape_a == contact->shape_a &&
            other->shape_b == contact->shape_b) {
            return other->open;
        }
    }
    return 0;
}

/* Appends an event to a list that has room. */
static void push_event(thud_world *w, td_array *list, int shape_a, int shape_b) {
    TD_PUSH(thud_contact_event, list) =
        (thud_contact_event){td_shape_handle(w, shape_a), td_shape_handle(w, shape_b)};
}

void td_sensor_tell(thud_world *w, td_array *list, td_array *times, int a, int b, float time) {
    push_event(w, list, a, b);
    TD_PUSH(float, times) = time;
    if (td_shape_at(w, b)->flags & TD_SHAPE_SENSOR) {
        push_event(w, list, b, a);
        TD_PUSH(float, times) = time;
    }
}

/* Adds the begin or end event of a contact. Events of sensors are added even where
 * thud_world_def.contact_events is false. */
static void add_event(thud_world *w, const td_contact *contact, bool begins) {
    td_event_lists *e = &w->events;
    int a = contact->shape_a, b = contact->shape_b;
    if (contact->kind == TD_PAIR_SENSOR) {
        td_sensor_tell(w, begins ? &e->sensor_begin : &e->sensor_end,
                       begins ? &e->sensor_begin_time : &e->sensor_end_time, a, b, 0.0f);
    } else if (w->def.contact_events) {
        push_event(w, begins ? &e->begin : &e->end, a, b);
    }
}

bool td_pair_is_silent(const thud_world *w, int shape_a, int shape_b) {
    return (td_shape_at(w, shape_a)->flags | td_shape_at(w, shape_b)->flags) & TD_SHAPE_SILENT;
}

void td_contact_begin(thud_world *w, int contact_index) {
    td_contact *contact = td_contact_at(w, contact_index);
    int open = open_elsewhere(w, contact_index);
    bool silent = td_pair_is_silent(w, contact->shape_a, contact->shape_b);
    contact->open = (uint8_t)(open ? open : silent ? TD_OPEN : TD_OPEN | TD_TOLD);
    contact->vetoed = 0; /* a rule or prologue has not yet decided about this touch */
    if (!open && contact->open & TD_TOLD) {
        add_event(w, contact, true);
    }
}

void td_contact_end(thud_world *w, int contact_index) {
    td_contact *contact = td_contact_at(w, contact_index);
    int open = contact->open;
    contact->open = 0;
    if (open & TD_TOLD && !open_elsewhere(w, contact_index)) {
        add_event(w, contact, false);
    }
}

/* Whether an edit that waits for the next step will end a constraint on this side: it removes,
 * disables or enables the body, removes the shape, or moves it if it is a terrain. `shape`: TD_NONE
 * for a joint. */
static bool is_ending_side(const thud_world *w, td_body_index body, int shape) {
    const td_body *b = td_body_at(w, body);
    bool gone = !(b->flags & TD_BODY_LIVE) || b->changes & TD_CHANGE_ENABLE;
    if (gone || shape == TD_NONE) {
        return gone;
    }
    bool moved_line = td_kind_is_line(td_shape_at(w, shape)->kind) && b->changes & TD_CHANGE_PLACE;
    return moved_line || !(td_shape_at(w, shape)->flags & TD_SHAPE_LIVE);
}

/* The function has to agree with state/changes.c, which applies the waiting edits in the next step.
 */
bool td_contact_is_ending(const thud_world *w, const td_constraint *constraint) {
    return (td_is_contact(constraint) && constraint->child == TD_NONE) ||
           is_ending_side(w, constraint->body[0], constraint->shape_a) ||
           is_ending_side(w, constraint->body[1], constraint->shape_b);
}

void td_contact_part(thud_world *w, int contact_index) {
    td_lane_remove(w, contact_index);
    td_constraint_wait(w, contact_index);
    td_contact_end(w, contact_index);
}

void td_contact_destroy(thud_world *w, int index) {
    if (td_constraint_at(w, index)->open) {
        td_contact_end(w, index);
    }
    td_constraint_destroy(w, index);
}

thud_contact td_contact_between(const thud_world *w, int shape_a, int shape_b, td_position at,
                                thud_vec2 normal, double distance) {
    return (thud_contact){.shape_a = td_shape_handle(w, shape_a),
                          .shape_b = td_shape_handle(w, shape_b),
                          .body_a = td_body_handle(w, td_shape_at(w, shape_a)->body),
                          .body_b = td_body_handle(w, td_shape_at(w, shape_b)->body),
                          .normal = normal,
                          .point = td_place_to(w, at),
                          .separation = (float)distance,
                          .point_count = 1};
}

void td_contacts_destroy(thud_world *w, td_body_index body, int shape, bool joints) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE;) {
        int next = td_next_edge(w, e);
        const td_constraint *c = td_constraint_at(w, td_edge_constraint(e));
        if (td_is_contact(c) ? shape == TD_NONE || c->shape_a == shape || c->shape_b == shape
                             : joints) {
            td_contact_destroy(w, td_edge_constraint(e));
        }
        e = next;
    }
}
