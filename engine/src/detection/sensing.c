/* sensing.c: see sensing.h.
 *
 * A way is a chain of legs, each straight or a parabola: impacts.c and continuous.c note a leg of
 * each body whose way they change, where there are sensors. A body without legs went straight. Two
 * shapes are looked at from turn to turn of either of them: forward in time for when they first
 * meet, and backward for when they part. */
#include "detection/sensing.h"

#include "base/rotation.h"
#include "contact/sensors.h"
#include "detection/trajectory.h"
#include "state/body.h"
#include "state/kinds.h"
#include "state/shape.h"

/* ---- ways ---- */

static int first_leg(const thud_world *w, td_awake_slot slot) {
    const td_array *first = &w->scratch.first_legs;
    return slot.at > 0 && slot.at < first->count ? td_int_at(first, slot.at) : TD_NONE;
}

/* The leg on which the body is at that time and from then on; null where its way has none, or it
 * stays where the last one ended. */
static const td_leg *leg_at(const thud_world *w, td_awake_slot slot, double time) {
    int i = first_leg(w, slot);
    while (i != TD_NONE && TD_AT(td_leg, &w->scratch.legs, i)->end <= time) {
        i = TD_AT(td_leg, &w->scratch.legs, i)->next;
    }
    return i == TD_NONE ? NULL : TD_AT(td_leg, &w->scratch.legs, i);
}

static td_trajectory way_at(const thud_world *w, td_body_index body, double time) {
    td_awake_slot slot = td_body_at(w, body)->awake;
    const td_leg *leg = leg_at(w, slot, time);
    const td_pose *pose = td_pose_at(w, body);
    td_trajectory way = {.place = pose->center, .angle = pose->angle, .body = body};
    if (leg) {
        way = leg->way;
    } else if (slot.at > 0 && first_leg(w, slot) == TD_NONE) {
        const float *delta = td_row(&w->delta, slot);
        way.place.x -= td_length_from(w, delta[0]);
        way.place.y -= td_length_from(w, delta[1]);
        way.angle -= td_angle_between(delta[2]);
        for (int k = 0; k < 3; k++) {
            way.motion[k] = (double)delta[k];
        }
    }
    return way;
}

/* Until when a body that is there at `time` keeps its leg. */
static double leg_end(const thud_world *w, td_body_index body, double time) {
    const td_leg *leg = leg_at(w, td_body_at(w, body)->awake, time);
    return leg ? leg->end : 1.0;
}

/* A shape on a piece of its way that has no turn. */
typedef struct piece {
    thud_shape_instance begin, end;
    thud_motion motion;
} piece;

static piece piece_of(const thud_world *w, int shape, double from, double until,
                      td_position origin) {
    td_trajectory way = way_at(w, td_shape_at(w, shape)->body, from);
    piece p = {.begin = td_trajectory_shape(w, &way, shape, from, origin),
               .end = td_trajectory_shape(w, &way, shape, until, origin)};
    bool turns = td_kind_turns(p.begin.kind);
    p.motion = (thud_motion){p.end.x - p.begin.x, p.end.y - p.begin.y,
                             turns ? way.motion[2] * (until - from) : 0.0};
    return p;
}

/* Two shapes, the first of which may be a line, and then nothing moves it. */
typedef struct couple {
    int a, b;
    bool line;
    thud_terrain terrain;
    td_position origin;
} couple;

static couple couple_of(const thud_world *w, int a, int b) {
    bool second = td_kind_is_line(td_shape_at(w, b)->kind);
    couple c = {.a = second ? b : a, .b = second ? a : b};
    c.line = td_kind_is_line(td_shape_at(w, c.a)->kind);
    c.origin = td_shape_proxy_at(w, c.a)->center;
    if (c.line) {
        c.terrain = td_terrain_view(w, c.a);
    }
    return c;
}

static thud_motion reversed(thud_motion m) {
    return (thud_motion){-m.dx, -m.dy, -m.turn};
}

/* When the two meet on those pieces, in [0, 1]; `back`: backward in time, from their ends. */
static bool meet(const thud_world *w, const couple *c, const piece *a, const piece *b, bool back,
                 double *time) {
    bool hit = false;
    const thud_shape_instance *at_b = back ? &b->end : &b->begin;
    thud_motion motion_b = back ? reversed(b->motion) : b->motion;
    if (c->line) {
        w->ground->time_of_impact(&c->terrain, at_b, motion_b, 0.0, &hit, time);
    } else {
        thud_shapes_time_of_impact(back ? &a->end : &a->begin,
                                   back ? reversed(a->motion) : a->motion, at_b, motion_b, 0.0,
                                   &hit, time);
    }
    return hit;
}

/* Whether the two overlap within the step: from when on, and when they last do. */
static bool overlap_on_way(const thud_world *w, int shape_a, int shape_b, double *from,
                           double *until) {
    couple c = couple_of(w, shape_a, shape_b);
    td_body_index body_a = td_shape_at(w, c.a)->body, body_b = td_shape_at(w, c.b)->body;
    bool met = false;
    for (double now = 0.0, next; now < 1.0; now = next) {
        next = td_min_double(leg_end(w, body_a, now), leg_end(w, body_b, now));
        piece a = {0}, b = piece_of(w, c.b, now, next, c.origin);
        if (!c.line) {
            a = piece_of(w, c.a, now, next, c.origin);
        }
        double part = 0.0, rest = 1.0;
        if (meet(w, &c, &a, &b, false, &part)) {
            bool parts = meet(w, &c, &a, &b, true, &rest);
            *from = met ? *from : now + part * (next - now);
            *until = parts ? next - rest * (next - now) : now + part * (next - now);
            met = true;
        }
    }
    return met;
}

/* Continuous detection looks at static sensors alone. */
static bool is_looked_at(const thud_world *w, int a, int b) {
    const td_shape *shapes[2] = {td_shape_at(w, a), td_shape_at(w, b)};
    const thud_detection *detection = td_detection_of(w, shapes[0]->body, shapes[1]->body);
    bool fixed = false;
    for (int i = 0; i < 2; i++) {
        fixed |= (shapes[i]->flags & TD_SHAPE_SENSOR) &&
                 td_body_at(w, shapes[i]->body)->kind == THUD_STATIC;
    }
    return detection->meet || (detection->rank == TD_RANK_CONTINUOUS && fixed);
}

static float when(const thud_world *w, int a, int b, bool begins) {
    double from = 1.0, until = 1.0;
    if (is_looked_at(w, a, b)) {
        overlap_on_way(w, a, b, &from, &until);
    }
    return (float)(begins ? from : until);
}

/* ---- what was passed ---- */

/* Those that were open as the step began end by themselves. */
static bool is_open(const thud_world *w, int a, int b) {
    int e = td_body_at(w, td_shape_at(w, b)->body)->first_constraint;
    bool open = false;
    for (; e != TD_NONE && !open; e = td_next_edge(w, e)) {
        const td_constraint *c = td_constraint_at(w, e / 2);
        open = c->kind == TD_PAIR_SENSOR && c->open &&
               ((c->shape_a == a && c->shape_b == b) || (c->shape_a == b && c->shape_b == a));
    }
    return open;
}

static void look_at(thud_world *w, int a, int b) {
    double from, until;
    if (td_pair_allowed(w, a, b) && !td_pair_is_silent(w, a, b) && is_looked_at(w, a, b) &&
        overlap_on_way(w, a, b, &from, &until) && !td_sensor_overlaps(w, a, b) &&
        !is_open(w, a, b)) {
        bool second = !(td_shape_at(w, a)->flags & TD_SHAPE_SENSOR);
        td_sensor_passed(w, second ? b : a, second ? a : b, (float)from, (float)until);
    }
}

static bool senses(const thud_world *w, int a, int b) {
    return (td_shape_at(w, a)->flags | td_shape_at(w, b)->flags) & TD_SHAPE_SENSOR;
}

/* A body that moved further than half its smallest half extent, or met something on its way. */
static bool is_quick(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot), *reach = td_row(&w->reach, slot);
    return first_leg(w, slot) != TD_NONE ||
           delta[0] * delta[0] + delta[1] * delta[1] > 0.25f * reach[0] * reach[0];
}

/* Whether two bodies that went straight are too far apart to have met. */
static bool are_apart(const thud_world *w, td_awake_slot a, td_awake_slot b) {
    if (first_leg(w, a) != TD_NONE || first_leg(w, b) != TD_NONE) {
        return false;
    }
    const td_position *p = &td_pose_at(w, td_body_of(w, a))->center;
    const td_position *q = &td_pose_at(w, td_body_of(w, b))->center;
    double x = (double)(q->x - p->x) / w->to_fixed, y = (double)(q->y - p->y) / w->to_fixed;
    double reach = (double)(td_row(&w->reach, a)[1] + td_row(&w->reach, b)[1]);
    for (int i = 0; i < 2; i++) {
        const float *delta = td_row(&w->delta, i ? b : a);
        reach += td_abs((double)delta[0]) + td_abs((double)delta[1]);
    }
    return x * x + y * y > reach * reach;
}

static void between(thud_world *w, td_awake_slot slot, td_awake_slot other) {
    if (other.at == slot.at || (other.at < slot.at && is_quick(w, other)) ||
        are_apart(w, slot, other)) {
        return;
    }
    int a = td_body_at(w, td_body_of(w, slot))->first_shape;
    for (; a != TD_NONE; a = td_shape_at(w, a)->next) {
        int b = td_body_at(w, td_body_of(w, other))->first_shape;
        for (; b != TD_NONE; b = td_shape_at(w, b)->next) {
            if (senses(w, a, b)) {
                look_at(w, a, b);
            }
        }
    }
}

static bool has_sensor(const thud_world *w, td_awake_slot slot) {
    int i = td_body_at(w, td_body_of(w, slot))->first_shape;
    while (i != TD_NONE && !(td_shape_at(w, i)->flags & TD_SHAPE_SENSOR)) {
        i = td_shape_at(w, i)->next;
    }
    return i != TD_NONE;
}

/* Against what moves as well. Of two quick bodies the one in the lower slot finds the other. */
static void among_awake(thud_world *w, td_awake_slot slot) {
    const td_array *sensing = &w->scratch.sensing;
    if (sensing->count > 0 && has_sensor(w, slot)) {
        for (td_awake_slot other = {1}; other.at < w->body_of.count; other.at++) {
            between(w, slot, other);
        }
        return;
    }
    for (int i = 0; i < sensing->count; i++) {
        between(w, slot, td_slot_in(sensing, i));
    }
}

/* Bounds of all of the way, wherever on the body a shape is; false where bounds cannot tell, as
 * they wrap around. */
static bool bounds_of_way(const thud_world *w, td_awake_slot slot, td_bounds *bounds) {
    td_body_index body = td_body_of(w, slot);
    const td_position end = td_pose_at(w, body)->center;
    double most = 0x1p15 * (double)w->unit;
    int32_t half = (int32_t)((double)td_row(&w->reach, slot)[1] * w->to_coarse) + 2;
    *bounds = td_bounds_about(end, half, half);
    for (double now = 0.0; now < 1.0; now = leg_end(w, body, now)) {
        td_position place = way_at(w, body, now).place;
        double x = (double)(place.x - end.x) / w->to_fixed;
        double y = (double)(place.y - end.y) / w->to_fixed;
        if (!(x * x + y * y < most * most)) {
            return false;
        }
        td_bounds there = td_bounds_about(place, half, half);
        *bounds = td_bounds_around(bounds, &there);
    }
    return true;
}

/* The set of what rests is of the broadphase: the narrowphase may have woken some since then, and
 * among_awake() looks at those. */
static void look_at_resting(thud_world *w, int shape, int other) {
    if (td_body_at(w, td_shape_at(w, other)->body)->awake.at <= 0 && senses(w, shape, other)) {
        look_at(w, shape, other);
    }
}

/* Against what rests, in the order of shapes, so that it is the same with each broadphase. */
static void among_resting(thud_world *w, td_awake_slot slot) {
    td_body_index index = td_body_of(w, slot);
    const td_array *found = &w->rest_shapes.ids;
    td_bounds bounds;
    if (bounds_of_way(w, slot, &bounds)) {
        td_array *hits = &w->scratch.ahead;
        hits->count = 0;
        if (!w->def.broadphase->find[w->wide](&w->rest_shapes, &w->memory, &bounds,
                                              td_pose_at(w, index)->center, hits)) {
            return;
        }
        td_sort_ints(hits);
        found = hits;
    }
    for (int a = td_body_at(w, index)->first_shape; a != TD_NONE; a = td_shape_at(w, a)->next) {
        for (int i = 0; i < found->count; i++) {
            look_at_resting(w, a, td_int_at(found, i));
        }
        for (int t = 0; t < w->terrains.count; t++) {
            int line = td_terrain_record_at(w, t)->shape;
            if (line != TD_NONE && senses(w, a, line)) {
                look_at(w, a, line);
            }
        }
    }
}

/* Links the legs of each body, which were noted in the order of time. */
static void link_legs(thud_world *w) {
    td_array *first = &w->scratch.first_legs;
    first->count = w->body_of.count;
    for (int slot = 0; slot < first->count; slot++) {
        td_int_set(first, slot, TD_NONE);
    }
    for (int i = w->scratch.legs.count - 1; i >= 0; i--) {
        td_leg *leg = TD_AT(td_leg, &w->scratch.legs, i);
        int slot = td_body_at(w, leg->way.body)->awake.at;
        leg->next = td_int_at(first, slot);
        td_int_set(first, slot, i);
    }
}

/* A query asks for room as if every shape of the ranges that it scans were a hit. */
static bool reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.first_legs, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.legs, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.ahead,
                            3 * w->rest_shapes.ids.count + 4 * TD_LANES);
}

static void pass(thud_world *w) {
    if (!reserve(w)) { /* the prologue made the first sensor */
        return;
    }
    link_legs(w);
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (is_quick(w, slot)) {
            among_resting(w, slot);
            among_awake(w, slot);
        }
    }
}

const td_sensing td_sensing_on_ways = {reserve, pass, when};
