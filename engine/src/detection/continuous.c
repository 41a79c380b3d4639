/* continuous.c: fast bodies do not pass through static shapes.
 *
 * A body that moved further than half its smallest half extent in the step is swept from where it
 * was; at its first time of impact with a static shape it stops for the rest of the step, and the
 * contact solver takes over in the next. The swept shapes are a little smaller, so that sliding
 * along a floor is no impact. Where even the smaller shape overlaps at the start, the middle of the
 * body is swept alone: it may rub along, but never change sides. */
#include "constraint/joint_hooks.h"
#include "state/body.h"
#include "contact/contact.h"
#include "solver/error.h"
#include "detection/detection.h"
#include "detection/sensing.h"
#include "detection/trajectory.h"
#include "state/kinds.h"
#include "geometry/shape_instance.h"
#include "base/rotation.h"
#include "state/shape.h"
#include "state/surface.h"

/* One of the body's shapes meets a static one. */
typedef struct meeting {
    double time;
    int64_t pair; /* both shapes, which decide where times agree */
} meeting;

typedef struct sweep {
    thud_world *w;
    td_awake_slot slot;
    td_body_index body;
    int shape;
    /* From where the body's centre was: `placed` is smaller than the shape, and `core` a small
     * circle in its middle. */
    td_swept way;
    double shrink;
    meeting last, next;     /* the one let through last, and the first after it so far */
    const td_array *shapes; /* int: all static ones near it, and others */
} sweep;

/* The pair as the prologue sees it: the shape at `time`, in its full size. */
static thud_contact view(const sweep *s, int other, double time) {
    const thud_world *w = s->w;
    bool ground = td_kind_is_line(td_shape_at(w, other)->kind);
    td_position origin = ground ? td_shape_proxy_at(w, other)->center : s->way.start;
    thud_shape_instance shape = td_placed_at(&s->way.placed, &s->way.motion, time);
    shape.x += (double)(s->way.start.x - origin.x) / w->to_fixed;
    shape.y += (double)(s->way.start.y - origin.y) / w->to_fixed;
    shape.hx += s->shrink;
    shape.hy = td_kind_grown_hy(shape.kind, shape.hy, s->shrink);
    thud_closest c;
    if (ground) {
        c = w->ground->below(w, other, &shape);
    } else {
        thud_shape_instance b = td_shape_instance(w, other, origin);
        td_closest(&b, &shape, &c);
    }
    td_position at = {origin.x + td_round64(0.5 * (c.ax + c.bx) * w->to_fixed),
                      origin.y + td_round64(0.5 * (c.ay + c.by) * w->to_fixed)};
    return td_contact_between(w, other, s->shape, at, (thud_vec2){(float)c.nx, (float)c.ny},
                              c.distance);
}

/* Whether the prologue lets the body through the static shape. It has been asked already about what
 * touched at the start. A callback may make bodies and queries: arrays of them may have moved. */
static bool passes(const sweep *s, int other, double time) {
    thud_world *w = s->w;
    bool asked = false, vetoed = true;
    int e = td_surface_asks(w) ? td_body_at(w, s->body)->first_constraint : TD_NONE;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, e / 2);
        if (contact->state == TD_TOUCHING && contact->shape_a == other &&
            contact->shape_b == s->shape) {
            asked = true;
            vetoed &= contact->vetoed;
        }
    }
    if (asked || !td_surface_asks(w)) {
        return asked && vetoed;
    }
    thud_contact seen = view(s, other, time);
    thud_contact_settings settings = td_surface_of_pair(w, other, s->shape);
    return !td_surface_meet(w, &seen, &settings);
}

static bool is_sooner(const meeting *a, const meeting *b) {
    return a->time < b->time || (a->time == b->time && a->pair < b->pair);
}

/* `inside`: the core met it. The smaller shape meets a little later than the real one does. */
static void meet(sweep *s, int other, const td_swept_hit *hit) {
    const thud_motion *m = &s->way.motion;
    double time = hit->time;
    if (!hit->inside) {
        time -= s->shrink / __builtin_sqrt(m->dx * m->dx + m->dy * m->dy);
        time = time > 0.0 ? time : 0.0;
    }
    meeting met = {time, (int64_t)s->shape << 32 | other};
    if (hit->hit && !(hit->inside && time <= 0.0) && is_sooner(&met, &s->next) &&
        is_sooner(&s->last, &met)) {
        s->next = met;
    }
}

/* Whether the shape of the sweep stops at another one. */
static bool stops_at(const sweep *s, int other) {
    const td_shape *shape = td_shape_at(s->w, other);
    return td_body_at(s->w, shape->body)->kind == THUD_STATIC &&
           !(shape->flags & TD_SHAPE_HOLLOW) && td_pair_allowed(s->w, s->shape, other);
}

static void against_shape(sweep *s, int other) {
    if (!stops_at(s, other)) {
        return;
    }
    const td_swept *way = &s->way;
    thud_motion motion = way->motion, still = {0.0, 0.0, 0.0};
    thud_shape_instance b = td_shape_instance(s->w, other, way->start);
    td_swept_hit hit = {thud_shapes_overlap(&way->placed, &b), false, 1.0};
    motion.turn = hit.inside ? 0.0 : motion.turn;
    thud_shapes_time_of_impact(hit.inside ? &way->core : &way->placed, motion, &b, still, 0.0,
                               &hit.hit, &hit.time);
    meet(s, other, &hit);
}

static void against_terrain(sweep *s, int line) {
    if (stops_at(s, line)) {
        td_swept_hit hit = {.time = 1.0};
        s->w->ground->sweep(s->w, line, &s->way, &hit);
        meet(s, line, &hit);
    }
}

/* Bounds of the whole sweep, for the grid. */
static td_bounds swept_bounds(const sweep *s, td_position end) {
    const thud_world *w = s->w;
    double reach = (double)td_row(&w->reach, s->slot)[1] + (double)w->unit * (double)TD_SPECULATIVE;
    int32_t half = (int32_t)(reach * w->to_coarse) + 1;
    td_bounds a = td_bounds_about(s->way.start, half, half), b = td_bounds_about(end, half, half);
    return td_bounds_around(&a, &b);
}

static void set_shape(sweep *s, int index, const float *delta, float c, float sine) {
    const thud_world *w = s->w;
    const td_shape *shape = td_shape_at(w, index);
    float arm_x = shape->arm_x, arm_y = shape->arm_y, hx = shape->half_x, hy = shape->half_y;
    float least = td_half_thickness(shape);
    float shrink = td_min_float(2.0f * TD_SLOP * w->unit, 0.25f * least);
    bool turns = td_kind_turns(shape->kind);
    s->shape = index;
    s->shrink = (double)shrink;
    s->way.placed =
        (thud_shape_instance){.kind = (thud_shape_kind)shape->kind,
                              .x = (double)(c * arm_x - sine * arm_y),
                              .y = (double)(sine * arm_x + c * arm_y),
                              .c = turns ? (double)(c * shape->angle_c - sine * shape->angle_s)
                                         : 1.0,
                              .s = turns ? (double)(sine * shape->angle_c + c * shape->angle_s)
                                         : 0.0,
                              .hx = (double)(hx - shrink),
                              .hy = td_kind_is_round(shape->kind) ? 0.0 : (double)(hy - shrink)};
    s->way.core = (thud_shape_instance){.kind = THUD_CIRCLE,
                                        .x = s->way.placed.x,
                                        .y = s->way.placed.y,
                                        .c = 1.0,
                                        .hx = (double)(0.25f * least)};
    /* The centre of an offset shape also moves as the body turns. */
    float end_c, end_s;
    td_angle_turn(td_pose_at(w, s->body)->angle, &end_c, &end_s);
    s->way.motion =
        (thud_motion){(double)delta[0] + (double)(end_c * arm_x - end_s * arm_y) - s->way.placed.x,
                      (double)delta[1] + (double)(end_s * arm_x + end_c * arm_y) - s->way.placed.y,
                      turns ? (double)delta[2] : 0.0};
}

/* Whether the sweep comes near anything that it might hit. */
static bool looks_around(sweep *s) {
    thud_world *w = s->w;
    td_array *hits = &w->scratch.ahead;
    const float *delta = td_row(&w->delta, s->slot);
    float most = 0x1p15f * w->unit;
    if (delta[0] * delta[0] + delta[1] * delta[1] > most * most) {
        s->shapes = &w->rest_shapes.ids;
        s->way.far = true;
        return true;
    }
    s->shapes = hits;
    hits->count = 0;
    td_find_fn *find = w->def.broadphase->find[w->wide];
    bool near_any =
        find(&w->rest_shapes, &w->memory, &s->way.bounds, s->way.start, hits) && hits->count > 0;
    for (int t = 0; t < w->terrains.count && !near_any; t++) {
        const td_terrain_record *record = td_terrain_record_at(w, t);
        if (record->shape != TD_NONE) {
            near_any = w->ground->near_sweep(w, record->shape, &s->way);
        }
    }
    return near_any;
}

/* The first meeting after the last one, of all shapes of the body; and puts that shape in place. */
static void find_next(sweep *s, int first, float c, float sine) {
    const thud_world *w = s->w;
    s->next = (meeting){.time = 1.0};
    for (int i = first; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (td_shape_at(w, i)->flags & TD_SHAPE_HOLLOW) {
            continue;
        }
        set_shape(s, i, td_row(&w->delta, s->slot), c, sine);
        for (int k = 0; k < s->shapes->count; k++) {
            against_shape(s, td_int_at(s->shapes, k));
        }
        for (int t = 0; t < w->terrains.count; t++) {
            const td_terrain_record *record = td_terrain_record_at(w, t);
            if (record->shape != TD_NONE) {
                against_terrain(s, record->shape);
            }
        }
    }
    if (s->next.time < 1.0) {
        set_shape(s, (int)(s->next.pair >> 32), td_row(&w->delta, s->slot), c, sine);
    }
}

/* Where the body's motion began. */
static td_pose start_of(const thud_world *w, td_awake_slot slot) {
    td_pose pose = *td_pose_at(w, td_body_of(w, slot));
    const float *delta = td_row(&w->delta, slot);
    pose.center.x -= td_length_from(w, delta[0]);
    pose.center.y -= td_length_from(w, delta[1]);
    pose.angle -= td_angle_between(delta[2]);
    return pose;
}

void td_hold_at(thud_world *w, td_awake_slot slot, double time) {
    double rest = 1.0 - time;
    td_body_index body = td_body_of(w, slot);
    td_pose pose = start_of(w, slot);
    float *delta = td_row(&w->delta, slot), *velocity = td_row(&w->velocity, slot);
    const float *push = td_row(&w->push, slot);
    float x = (float)rest * delta[0], y = (float)rest * delta[1];
    td_error_fall_short(w, x, y);
    td_error_follow(w, slot, x, y);
    for (int k = 0; k < 3; k++) {
        delta[k] = (float)((double)delta[k] * time);
        velocity[k] -= (float)td_gain_held(w, k, (double)((float)(w->substeps * rest) * push[k]));
    }
    pose.center.x += td_length_from(w, delta[0]);
    pose.center.y += td_length_from(w, delta[1]);
    pose.angle += td_angle_between(delta[2]);
    td_angle_turn(pose.angle, &pose.c, &pose.s);
    *td_pose_at(w, body) = pose;
    td_held_count(w, slot, time);
    td_body_place_shapes(w, body);
}

/* The prologue is asked in the order of time, whichever order the broadphase has, up to the first
 * that stops the body. */
static void sweep_body(thud_world *w, td_awake_slot slot) {
    td_body_index index = td_body_of(w, slot);
    td_pose start = start_of(w, slot);
    sweep swept = {.w = w,
                   .slot = slot,
                   .body = index,
                   .way = {.start = start.center},
                   .next = {.time = -1.0}};
    swept.way.bounds = swept_bounds(&swept, td_pose_at(w, index)->center);
    if (!looks_around(&swept)) {
        return;
    }
    float c, s;
    td_angle_turn(start.angle, &c, &s);
    int first = td_body_at(w, index)->first_shape;
    do {
        swept.last = swept.next;
        find_next(&swept, first, c, s);
    } while (swept.next.time < 1.0 && passes(&swept, (int)swept.next.pair, swept.next.time));
    if (swept.next.time < 1.0) {
        td_hold_at(w, slot, swept.next.time);
        if (w->joint_hooks) {
            w->joint_hooks->hold_back(w, slot, swept.next.time);
        }
    }
}

/* Notes for sensors how far each body that was held went: at the speed that it had, up to the part
 * of the step that all holds together have left. */
static void note_legs(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->scratch.held_at.count; slot.at++) {
        double end = *TD_AT(double, &w->scratch.held_at, slot.at);
        if (end < 1.0 && end > 0.0) {
            td_pose start = start_of(w, slot);
            const float *delta = td_row(&w->delta, slot);
            td_trajectory way = {.place = start.center,
                                 .angle = start.angle,
                                 .body = td_body_of(w, slot)};
            for (int k = 0; k < 3; k++) {
                way.motion[k] = (double)delta[k] / end;
            }
            td_leg_note(w, &way, end);
        }
    }
}

/* A query asks for room as if every shape of the ranges that it scans were a hit. */
static bool reserve(thud_world *w) {
    return td_held_reserve(w) && td_array_reserve(&w->memory, &w->scratch.ahead,
                                                  3 * w->rest_shapes.ids.count + 4 * TD_LANES);
}

static void run(thud_world *w) {
    bool anything = w->rest_shapes.ids.count > 0 || w->terrains.live > 0;
    for (int i = 0; i < w->scratch.fast.count && anything; i++) {
        td_awake_slot slot = td_slot_in(&w->scratch.fast, i);
        const td_body *body = td_body_at(w, td_body_of(w, slot));
        if (body->detection->rank == TD_RANK_CONTINUOUS) {
            sweep_body(w, slot);
        }
    }
    if (w->stats.held_bodies) {
        td_error_settle(w);
        if (w->scratch.sensed_room > 0) {
            note_legs(w);
        }
    }
}

const td_detection_stage td_stage_continuous = {.reserve = reserve,
                                                .run = {[TD_AFTER_MOVING] = run}};

const thud_detection thud_detection_continuous = {.name = "continuous",
                                                  .rank = TD_RANK_CONTINUOUS,
                                                  .stage = &td_stage_continuous,
                                                  .sensing = &td_sensing_at_rest};
