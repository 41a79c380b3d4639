/* continuous.c: the detection `continuous`, which stops fast bodies at static shapes (as continuous
 * collision of non-bullet bodies in Box2D, solver.c: b2SolveContinuous).
 *
 * A body that moved in the step by more than half its smallest half extent is swept from its pose
 * at the start to that at the end, by the time of impact of each of its shapes with static shapes
 * (geometry/toi.c: conservative advancement). It is put back to the first time of impact, and stays
 * there for the rest of the step; the next step finds a contact. The swept shapes are smaller than
 * the real ones by `shrink`, so that a body that slides along a floor does not hit it. If even the
 * smaller shape overlaps a static shape at the start, only its core, a circle in its middle, is
 * swept, without rotation: the body may slide on while it overlaps, but its middle does not pass to
 * the other side.
 *
 * It runs after td_finalize, once a step. Times are numbers in [0, 1]: shares of the motion of the
 * step. */
#include "constraint/joint_hooks.h"
#include "state/body.h"
#include "contact/contact.h"
#include "contact/sensors.h"
#include "solver/error.h"
#include "detection/detection.h"
#include "detection/trajectory.h"
#include "state/kinds.h"
#include "geometry/shape_instance.h"
#include "base/rotation.h"
#include "state/shape.h"
#include "state/shared_stages.h"
#include "state/surface.h"

/* A time of impact of one of the body's shapes with a static shape. */
typedef struct sweep_hit {
    double time;
    int64_t pair; /* shape << 32 | static shape; orders hits at equal times */
} sweep_hit;

/* The sweep of one body. */
typedef struct sweep {
    thud_world *w;
    td_awake_slot slot;
    td_body_index body;
    int shape;              /* the shape of the body that `swept` describes */
    td_swept swept;         /* `placed`: the shape, made smaller by td_swept.shrink; `core`: a
                               circle in its middle */
    sweep_hit last;         /* the latest hit that the prologue refused; time -1: none */
    sweep_hit next;         /* the first hit after `last` found so far; time 1: none */
    const td_array *shapes; /* int: shapes near the path; static shapes are among them */
    td_array *hits;         /* int: shapes that a query finds; `memory` is used if there are more
                               than it has room for */
    td_memory *memory;
} sweep;

/* Whether hit a comes before hit b: by time, then by shapes. */
static bool is_sooner(const sweep_hit *a, const sweep_hit *b) {
    return a->time < b->time || (a->time == b->time && a->pair < b->pair);
}

/* Keeps a hit as `next` if it is after `last` and before `next`. The swept shape, which is smaller
 * by `shrink`, hits later than the real one. The time of the hit is therefore reduced by
 * shrink / |motion|: a head-on hit then leaves no overlap, an oblique one up to `shrink`. A core
 * (hit->inside) that overlaps already at the start is no hit, so that the body can move out. */
static void record_hit(sweep *s, int other, const td_swept_hit *hit) {
    const thud_motion *m = &s->swept.motion;
    double time = hit->time;
    if (!hit->inside) {
        time -= s->swept.shrink / __builtin_sqrt(m->dx * m->dx + m->dy * m->dy);
        time = time > 0.0 ? time : 0.0;
    }
    sweep_hit met = {time, (int64_t)s->shape << 32 | other};
    if (hit->hit && !(hit->inside && time <= 0.0) && is_sooner(&met, &s->next) &&
        is_sooner(&s->last, &met)) {
        s->next = met;
    }
}

/* Whether the swept shape stops at another one: a solid shape of a static body that it may collide
 * with. */
static bool stops_at(const sweep *s, int other) {
    if (other == TD_NONE) { /* a shape that has left the set since it was built */
        return false;
    }
    const td_shape *shape = td_shape_at(s->w, other);
    return td_body_at(s->w, shape->body)->kind == THUD_BODY_STATIC &&
           !(shape->flags & TD_SHAPE_HOLLOW) && td_pair_allowed(s->w, s->shape, other);
}

/* Sweeps the shape, or its core where it overlaps at the start, against a static shape. */
static void sweep_against_shape(sweep *s, int other) {
    if (!stops_at(s, other)) {
        return;
    }
    const td_swept *swept = &s->swept;
    const td_instance_ops *instances = s->w->instances;
    thud_motion motion = swept->motion, still = {0.0, 0.0, 0.0};
    thud_geometry b = td_shape_instance(s->w, other, swept->start);
    td_swept_hit hit = {instances->overlap(&swept->placed, &b), false, 1.0};
    motion.turn = hit.inside ? 0.0 : motion.turn;
    instances->time_of_impact(hit.inside ? &swept->core : &swept->placed, motion, &b, still, 0.0,
                              &hit.hit, &hit.time);
    record_hit(s, other, &hit);
}

/* Sweeps the shape against a terrain, as sweep_against_shape does against a static shape. */
static void sweep_against_terrain(sweep *s, int line) {
    if (stops_at(s, line)) {
        td_swept_hit hit = {.time = 1.0};
        s->w->ground->sweep(s->w, line, &s->swept, &hit);
        record_hit(s, line, &hit);
    }
}

/* Bounds of the body on its whole path, for the broadphase. Wider by TD_SPECULATIVE, which is more
 * than rounding needs. */
static td_bounds swept_bounds(const sweep *s, td_position end) {
    const thud_world *w = s->w;
    double reach =
        (double)td_row(&w->reach, s->slot)[1] + (double)w->length_scale * (double)TD_SPECULATIVE;
    int32_t half = (int32_t)(reach * w->to_coarse) + 1;
    td_bounds a = td_bounds_about(s->swept.start, half, half), b = td_bounds_about(end, half, half);
    return td_bounds_around(&a, &b);
}

/* Sets the sweep to one of the body's shapes, placed relative to swept.start, the body's centre at
 * the start. (c, sine) is the body's rotation there, `delta` its motion in the step. `shrink` is
 * twice TD_SLOP, at most a quarter of the half thickness, which is also the radius of the core.
 * Both chosen: with less shrink bodies that slide with some overlap stop; with more a stopped
 * body is left in deeper overlap. */
static void set_shape(sweep *s, int index, const float *delta, float c, float sine) {
    const thud_world *w = s->w;
    const td_shape *shape = td_shape_at(w, index);
    float arm_x = shape->arm_x, arm_y = shape->arm_y, hx = shape->half_x, hy = shape->half_y;
    float half_thickness = td_half_thickness(shape);
    float shrink = td_min_float(2.0f * TD_SLOP * w->length_scale, 0.25f * half_thickness);
    bool turns = td_kind_turns(shape->kind);
    s->shape = index;
    s->swept.shrink = (double)shrink;
    s->swept.placed =
        (thud_geometry){.kind = (thud_shape_kind)shape->kind,
                        .x = (double)(c * arm_x - sine * arm_y),
                        .y = (double)(sine * arm_x + c * arm_y),
                        .c = turns ? (double)(c * shape->angle_c - sine * shape->angle_s) : 1.0,
                        .s = turns ? (double)(sine * shape->angle_c + c * shape->angle_s) : 0.0,
                        .hx = (double)(hx - shrink),
                        .hy = td_kind_is_round(shape->kind) ? 0.0 : (double)(hy - shrink)};
    s->swept.core = (thud_geometry){.kind = THUD_SHAPE_CIRCLE,
                                    .x = s->swept.placed.x,
                                    .y = s->swept.placed.y,
                                    .c = 1.0,
                                    .hx = (double)(0.25f * half_thickness)};
    /* The centre of a shape off the centre of mass also moves as the body turns. */
    float end_c, end_s;
    td_angle_turn(td_pose_at(w, s->body)->angle, &end_c, &end_s);
    s->swept.motion = (thud_motion){(double)delta[0] + (double)(end_c * arm_x - end_s * arm_y) -
                                        s->swept.placed.x,
                                    (double)delta[1] + (double)(end_s * arm_x + end_c * arm_y) -
                                        s->swept.placed.y,
                                    turns ? (double)delta[2] : 0.0};
}

/* Sets `shapes` to the shapes at rest that the bounds of the path overlap. False where neither
 * such a shape nor a terrain is near. True also where memory is short, which happens only to a
 * worker (td_fast_meets): the calling thread, for which `reserve` has made room, then sweeps the
 * body. A path longer than 2^15 length scales, an eighth of the period at which bounds wrap around,
 * is tested against all shapes at rest. */
static bool find_obstacles(sweep *s) {
    const thud_world *w = s->w;
    td_array *hits = s->hits;
    const float *delta = td_row(&w->delta, s->slot);
    float distance_max = 0x1p15f * w->length_scale;
    if (delta[0] * delta[0] + delta[1] * delta[1] > distance_max * distance_max) {
        s->shapes = &w->rest_shapes.ids;
        s->swept.far = true;
        return true;
    }
    s->shapes = hits;
    hits->count = 0;
    td_find_fn *find = w->def.broadphase->find[w->wide];
    bool near_any =
        !find(&w->rest_shapes, s->memory, &s->swept.bounds, s->swept.start, hits, NULL) ||
        hits->count > 0;
    for (int t = 0; t < w->terrains.count && !near_any; t++) {
        const td_terrain_record *record = td_terrain_record_at(w, t);
        if (record->shape != TD_NONE) {
            near_any = w->ground->near_sweep(w, record->shape, &s->swept);
        }
    }
    return near_any;
}

/* Sets `next` to the first hit after `last` of all shapes of the body (`first` and those linked to
 * it), and sets the sweep to the shape that has it. */
static void find_next_hit(sweep *s, int first, float c, float sine) {
    const thud_world *w = s->w;
    s->next = (sweep_hit){.time = 1.0};
    for (int i = first; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (td_shape_at(w, i)->flags & TD_SHAPE_HOLLOW) {
            continue;
        }
        set_shape(s, i, td_row(&w->delta, s->slot), c, sine);
        for (int k = 0; k < s->shapes->count; k++) {
            sweep_against_shape(s, td_int_at(s->shapes, k));
        }
        for (int t = 0; t < w->terrains.count; t++) {
            const td_terrain_record *record = td_terrain_record_at(w, t);
            if (record->shape != TD_NONE) {
                sweep_against_terrain(s, record->shape);
            }
        }
    }
    if (s->next.time < 1.0) {
        set_shape(s, (int)(s->next.pair >> 32), td_row(&w->delta, s->slot), c, sine);
    }
}

void td_hold_at(thud_world *w, td_awake_slot slot, double time) {
    double remaining = 1.0 - time;
    td_body_index body = td_body_of(w, slot);
    td_pose pose = td_start_pose(w, slot);
    float *delta = td_row(&w->delta, slot), *velocity = td_row(&w->velocity, slot);
    const float *substep_gain = td_row(&w->substep_gain, slot);
    float x = (float)remaining * delta[0], y = (float)remaining * delta[1];
    td_errors_note_shortfall(w, x, y);
    td_errors_undo_gravity_work(w, slot, x, y);
    for (int k = 0; k < 3; k++) {
        delta[k] = (float)((double)delta[k] * time);
        double gain = (double)((float)(w->substeps * remaining) * substep_gain[k]);
        velocity[k] = td_velocity_without_gain(w, k, velocity[k], gain);
    }
    pose.center.x = td_wrap_add64(pose.center.x, td_length_from(w, delta[0]));
    pose.center.y = td_wrap_add64(pose.center.y, td_length_from(w, delta[1]));
    pose.angle += td_angle_between((double)delta[2]);
    td_angle_turn(pose.angle, &pose.c, &pose.s);
    *td_pose_at(w, body) = pose;
    td_held_count(w, slot, time);
    td_body_place_shapes(w, body);
}

/* Begins the sweep of a body. Returns whether a shape is near its path. Most bodies have none, so
 * that only the fields that find_obstacles needs are set. */
static bool begin_sweep(sweep *s, thud_world *w, td_awake_slot slot, td_array *hits,
                        td_memory *memory) {
    const float *delta = td_row(&w->delta, slot);
    s->w = w;
    s->slot = slot;
    s->body = td_body_of(w, slot);
    s->hits = hits;
    s->memory = memory;
    td_position end = td_pose_at(w, s->body)->center;
    s->swept.start = (td_position){td_wrap_sub64(end.x, td_length_from(w, delta[0])),
                                   td_wrap_sub64(end.y, td_length_from(w, delta[1]))};
    s->swept.bounds = swept_bounds(s, end);
    s->swept.far = false;
    return find_obstacles(s);
}

bool td_fast_meets(thud_world *w, td_awake_slot slot, td_array *hits, td_memory *memory) {
    sweep s;
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    return body->detection->rank == TD_RANK_CONTINUOUS && begin_sweep(&s, w, slot, hits, memory);
}

void td_fast_fetch(const thud_world *w, int i) {
    if (td_fetches(w) && i + 8 < w->scratch.fast.count) { /* chosen */
        td_body_index ahead = td_body_of(w, td_slot_in(&w->scratch.fast, i + 8));
        __builtin_prefetch(td_body_at(w, ahead));
        __builtin_prefetch(&td_body_at(w, ahead)->detection);
        __builtin_prefetch(td_pose_at(w, ahead));
    }
}

/* Stops a body at its first hit that the prologue does not refuse. The prologue is called in the
 * order of time, whatever the order of the broadphase, and not for hits after the one that stops
 * the body. Bodies that joints tie to it go back to the same time. */
static void stop_at_first_hit(thud_world *w, td_awake_slot slot) {
    sweep s;
    if (!begin_sweep(&s, w, slot, &w->scratch.ahead, &w->memory)) {
        return;
    }
    float c, sine;
    td_angle_turn(td_start_pose(w, slot).angle, &c, &sine);
    s.next = (sweep_hit){.time = -1.0};
    int first = td_body_at(w, s.body)->first_shape;
    do {
        s.last = s.next;
        find_next_hit(&s, first, c, sine);
    } while (s.next.time < 1.0 && w->sweep_is_vetoed &&
             w->sweep_is_vetoed(w, &s.swept, s.shape, (int)s.next.pair, s.next.time));
    if (s.next.time < 1.0) {
        td_hold_at(w, slot, s.next.time);
        if (w->joint_hooks) {
            w->joint_hooks->hold_back(w, slot, s.next.time);
        }
    }
}

/* Reserves memory for the hits of a query among the resting shapes. */
static bool reserve(thud_world *w) {
    return td_held_reserve(w) &&
           td_array_reserve(&w->memory, &w->scratch.ahead, td_query_room(w->rest_shapes.ids.count));
}

/* Stops the fast bodies of this detection; see td_detection_stage. */
static void run(thud_world *w) {
    bool anything = w->rest_shapes.ids.count > 0 || w->terrains.live > 0;
    const thud_shared_stages *shared = TD_HAS_THREADS ? w->def.job_system.stages : NULL;
    if (shared && anything) {
        shared->sift_fast(w);
    }
    for (int i = 0; i < w->scratch.fast.count && anything; i++) {
        td_fast_fetch(w, i);
        td_awake_slot slot = td_slot_in(&w->scratch.fast, i);
        const td_body *body = td_body_at(w, td_body_of(w, slot));
        if (body->detection->rank == TD_RANK_CONTINUOUS) {
            stop_at_first_hit(w, slot);
        }
    }
    if (w->stats.held_bodies) {
        td_errors_resum_kinetic(w);
        if (w->scratch.sensed_room > 0) {
            w->sensor_hooks->note_held(w);
        }
    }
}

const td_detection_stage td_stage_continuous = {.reserve = reserve,
                                                .run = {[TD_AFTER_MOVING] = run}};

const thud_detection thud_detection_continuous = {.name = "continuous",
                                                  .rank = TD_RANK_CONTINUOUS,
                                                  .stage = &td_stage_continuous,
                                                  .senses = true};
