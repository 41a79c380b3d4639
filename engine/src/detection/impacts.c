/* impacts.c: moves the bodies that are bisected or swept forward to each of their collisions, in
 * the order of time, and resolves it there.
 *
 * Reads the motion that the solver gave to every awake body; writes poses, velocities and motions
 * of those that met something, events, and what callbacks are told. Candidates are the contacts,
 * whose bounds reach as far as the bodies were expected to move; who strays from that looks around
 * for himself. The work is bounded: a body that met others too often is held where it is for the
 * rest of the step, which the statistics tell. */
#include "constraint/joint_hooks.h"
#include "constraint/tied_bodies.h"
#include "detection/ballistics.h"
#include "state/body.h"
#include "solver/bounces.h"
#include "detection/collide.h"
#include "contact/contact.h"
#include "solver/error.h"
#include "detection/toi_candidates.h"
#include "detection/toi_queue.h"
#include "detection/gaps.h"
#include "constraint/lanes.h"
#include "base/rotation.h"
#include "state/shape.h"
#include "detection/detection.h"
#include "state/surface.h"
#include "detection/unbisectable.h"

enum {
    MOST_IMPACTS = 8,  /* of a body in a step, before it is held */
    MOST_BOUNCES = 16, /* of a body in a step, while those that it meets are elastic */
    SPARE = 256        /* room for so many candidates more than there are bodies */
};

/* Times of collision that a step works out before whatever meets something is held: so many, and so
 * many more for each awake body; one takes 1 to 3 microseconds. Where all bodies are as large as
 * the place that they are in, each impact has two of them look at all others: 100 boxes with sides
 * of 0.01 to 100 took 59,000. A packed drum at its fastest takes 40 a body (scene tumbler_half). */
enum { MOST_LOOKS = 8192, MOST_LOOKS_OF_A_BODY = 48 };

/* ---- collisions ---- */

static void hold(thud_world *w, td_trajectory *f) {
    if (!f->held) {
        double rest = 1.0 - f->since, fall = 0.5 * rest;
        f->held = true;
        td_error_fall_short(w, (float)((f->motion[0] + fall * f->fall[0]) * rest),
                            (float)((f->motion[1] + fall * f->fall[1]) * rest));
        td_held_count(w, td_body_at(w, f->body)->awake, f->since);
    }
    td_trajectory_bear(w, f, f->fall[0], f->fall[1]);
    f->motion[0] = f->motion[1] = f->motion[2] = 0.0;
    f->free = false;
    f->changed = true;
}

/* What stops with others that joints tie to it does not fall on in the rest of the step: gravity
 * and forces give it no speed there, as continuous.c has it. Those that fly freely bear their fall.
 */
static void give_back(thud_world *w, td_awake_slot slot, const td_trajectory *f) {
    float *velocity = td_row(&w->velocity, slot);
    const float *push = td_row(&w->push, slot);
    for (int k = 0; k < 3 && !f->free; k++) {
        double given = w->substeps * (1.0 - f->since) * (double)push[k];
        velocity[k] -= (float)td_gain_held(w, k, given);
    }
}

/* Where joints tie it to others, all of them stop: one that went on alone would open them. */
static void hold_tied(thud_world *w, td_trajectory *f) {
    td_awake_slot slot = td_body_at(w, f->body)->awake;
    if (td_is_tied(w, slot) && !f->held) {
        give_back(w, slot, f);
    }
    hold(w, f);
    if (f->all_held) {
        return;
    }
    f->all_held = true;
    for (td_awake_slot i = slot; td_is_tied(w, i) && td_next_tied(w, i).at != slot.at;) {
        i = td_next_tied(w, i);
        td_trajectory *other = td_trajectory_at(w, i);
        other->all_held = true;
        if (!other->held) {
            td_trajectory_advance(w, other, f->since);
            give_back(w, i, other);
            hold(w, other);
            td_toi_queue_renew(w, other);
        }
    }
}

static bool ties_any(const thud_world *w, const td_toi_candidate *e) {
    return td_is_tied(w, td_body_at(w, e->body[0])->awake) ||
           td_is_tied(w, td_body_at(w, e->body[1])->awake);
}

/* The prologue has been asked about what touched at the start of the step. */
static bool vetoes(thud_world *w, int number, const td_toi_candidate *e, const thud_contact *seen,
                   thud_contact_settings *settings) {
    if (number < w->constraints.count && td_contact_at(w, number)->state == TD_TOUCHING) {
        const td_contact *contact = td_contact_at(w, number);
        td_lane at = td_lane_of(w, contact);
        *settings =
            td_surface_get(at.block, td_form_points(w->kinds[contact->kind]->form), at.lane);
        return false;
    }
    *settings = td_surface_of_pair(w, e->shape[0], e->shape[1]);
    bool veto = !td_surface_meet(w, seen, settings);
    if (veto && number < w->constraints.count) {
        td_contact_at(w, number)->vetoed = TD_VETOED;
    } else if (veto) {
        td_extra_at(w, number)->vetoed = true;
    }
    return veto;
}

static bool is_spent(const thud_world *w) {
    return w->stats.motion_exact / MOST_LOOKS_OF_A_BODY >
           MOST_LOOKS / MOST_LOOKS_OF_A_BODY + w->body_of.count;
}

/* Shapes that swing about their bodies' centres are stopped early, where their arcs may be near:
 * from there on less of the arc is left. This counts as having met, or they would never arrive. */
static void look_again(thud_world *w, int number, td_trajectory *const trajectories[2]) {
    for (int side = 0; side < 2; side++) {
        td_trajectory *f = trajectories[side];
        if (f && td_body_at(w, f->body)->kind == THUD_DYNAMIC &&
            (++f->impacts > MOST_IMPACTS || is_spent(w))) {
            hold_tied(w, f);
            td_toi_queue_renew(w, f);
        }
    }
    td_toi_queue_set(w, number);
}

/* The two are at the place of their collision now. Whoever is asleep wakes in the next step, and is
 * met then. */
static void collide(thud_world *w, int number, double time) {
    td_toi_candidate e = td_toi_candidate_at(w, number);
    td_trajectory *trajectories[2] = {NULL, NULL};
    for (int side = 0; side < 2; side++) {
        td_awake_slot slot = td_body_at(w, e.body[side])->awake;
        if (slot.at > 0) {
            trajectories[side] = td_trajectory_at(w, slot);
            td_trajectory_advance(w, trajectories[side], time);
        }
    }
    td_impact_point at;
    if (!td_impact_point_of(w, &e, time, &at) || at.speed <= 0.0) {
        look_again(w, number, trajectories);
        return;
    }
    td_impact impact = {.seen = td_impact_view(w, &e, &at)};
    thud_contact_settings settings;
    if (vetoes(w, number, &e, &impact.seen, &settings)) {
        return;
    }
    /* What is tied to others meets in the next step, as sleepers do. */
    bool later = td_body_sleeps(w, e.body[0]) || td_body_sleeps(w, e.body[1]) || ties_any(w, &e);
    if (!later) {
        impact.touching =
            number < w->constraints.count && td_contact_at(w, number)->state == TD_TOUCHING;
        td_impact_resolve(w, &e, &at, time, &settings, &impact);
        TD_PUSH(td_impact, &w->scratch.impacts) = impact;
    }
    int most = settings.restitution < 1.0f ? MOST_IMPACTS : MOST_BOUNCES;
    for (int side = 0; side < 2; side++) {
        td_trajectory *f = trajectories[side];
        if (f && td_body_at(w, f->body)->kind == THUD_DYNAMIC && !impact.stayed[side] &&
            (later || f->impacts > most || is_spent(w) || !td_toi_candidates_around(w, f))) {
            hold_tied(w, f);
        }
    }
    w->stats.impacts++;
    for (int side = 0; side < 2; side++) {
        if (trajectories[side] && (!impact.stayed[side] || impact.bent[side])) {
            td_toi_queue_renew(w, trajectories[side]);
        }
    }
}

/* ---- the stage ---- */

static bool takes_part(const thud_world *w, td_awake_slot slot) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    return body->kind == THUD_DYNAMIC && body->detection->meet;
}

/* From where the solver's motion began. */
static void take_off(thud_world *w, td_awake_slot slot) {
    td_body_index index = td_body_of(w, slot);
    const td_pose *pose = td_pose_at(w, index);
    const float *delta = td_row(&w->delta, slot);
    td_trajectory f = *td_trajectory_at(w, slot);
    if (!td_same_body(f.body, index)) { /* somebody was quarantined, and it stands in his slot */
        f = (td_trajectory){.body = index};
    }
    *td_trajectory_at(w, slot) =
        (td_trajectory){.place = {pose->center.x - td_length_from(w, delta[0]),
                                  pose->center.y - td_length_from(w, delta[1])},
                        .angle = pose->angle - td_angle_between(delta[2]),
                        .body = index,
                        .extras = TD_NONE,
                        .strays = TD_NONE,
                        .motion = {(double)delta[0] - 0.5 * f.fall[0],
                                   (double)delta[1] - 0.5 * f.fall[1], (double)delta[2]},
                        .fall = {f.fall[0], f.fall[1]},
                        .free = f.free};
}

/* Whether its way was no more the solver's. */
static bool land(thud_world *w, td_awake_slot slot) {
    td_trajectory *f = td_trajectory_at(w, slot);
    if (!f->changed) {
        return false;
    }
    td_pose *pose = td_pose_at(w, f->body);
    float *delta = td_row(&w->delta, slot);
    td_position start = {pose->center.x - td_length_from(w, delta[0]),
                         pose->center.y - td_length_from(w, delta[1])};
    uint32_t angle = pose->angle - td_angle_between(delta[2]);
    td_trajectory_advance(w, f, 1.0);
    pose->center = f->place;
    pose->angle = f->angle;
    td_angle_turn(pose->angle, &pose->c, &pose->s);
    float x = delta[0], y = delta[1];
    delta[0] = (float)((double)(f->place.x - start.x) / w->to_fixed);
    delta[1] = (float)((double)(f->place.y - start.y) / w->to_fixed);
    delta[2] = (float)(int32_t)(f->angle - angle) * (float)TD_RADIANS_A_QUANTUM;
    td_error_follow(w, slot, x - delta[0], y - delta[1]);
    td_body_place_shapes(w, f->body);
    return true;
}

/* Bounds for the next step reach as far as the body is going to move. */
static void expect(thud_world *w, td_awake_slot slot) {
    const float *v = td_row(&w->velocity, slot);
    float h = (float)w->def.time_step;
    int i = td_body_at(w, td_body_of(w, slot))->first_shape;
    for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_expect(w, i, v[0] * h, v[1] * h);
    }
}

static void note_touch(thud_world *w, const td_constraint *contact) {
    for (int side = 0; side < 2 && contact->state == TD_TOUCHING; side++) {
        td_awake_slot slot = td_body_at(w, contact->body[side])->awake;
        if (slot.at > 0) {
            td_trajectory_at(w, slot)->touching++;
        }
    }
}

/* Everything that may meet, from the start of the step. */
static void schedule_everything(thud_world *w) {
    w->scratch.candidates.count = w->scratch.strays.count = w->scratch.impacts.count = 0;
    td_event_queue_clear(&w->scratch.queue, w->constraints.count);
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        take_off(w, slot);
    }
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        bool own = takes_part(w, slot), strays = td_trajectory_is_unexpected(w, f);
        if ((own && !td_toi_candidates_on_ground(w, f)) ||
            (strays && !td_toi_candidates_around(w, f))) {
            hold(w, f);
        }
        w->stats.unbisectable += td_is_unbisectable(w, slot);
    }
    for (int i = 0; i < w->constraints.count; i++) {
        td_constraint *contact = td_constraint_at(w, i);
        if (contact->live) {
            contact->vetoed = contact->state == TD_TOUCHING ? contact->vetoed : 0;
            note_touch(w, contact);
        }
    }
    td_gaps_judge(w);
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *c = td_constraint_at(w, i);
        if (c->live && td_toi_queue_has(w, i) &&
            !(c->state == TD_TOUCHING && td_gap_is_judged(w, c))) {
            td_toi_queue_begin(w, i);
        }
    }
    for (int i = 0; i < w->scratch.candidates.count; i++) {
        td_toi_queue_set(w, w->constraints.count + i);
    }
}

static void hit_events(thud_world *w) {
    for (int i = 0; i < w->scratch.impacts.count && w->def.contact_events; i++) {
        const td_impact *impact = TD_AT(td_impact, &w->scratch.impacts, i);
        const thud_contact *seen = &impact->seen;
        int a = (int)seen->shape_a.index1 - 1, b = (int)seen->shape_b.index1 - 1;
        if (impact->approach > w->def.hit_speed * w->unit && !td_pair_is_silent(w, a, b)) {
            TD_PUSH(thud_hit_event, &w->events.hit) =
                (thud_hit_event){seen->shape_a, seen->shape_b, seen->point, seen->normal,
                                 td_hit_speed(impact->approach)};
        }
    }
}

static bool reserve(thud_world *w) {
    /* Every impact has a body that was not held before it. */
    int awake = w->body_of.count, most = (MOST_BOUNCES + 1) * awake;
    int extras = awake * (w->terrains.live + 1) + SPARE;
    int hits = w->scratch.begins.count; /* of contacts */
    int shapes =
        w->awake_shapes.ids.count + w->rest_shapes.ids.count; /* each may be found, and asked for */
    /* Two an impact, and all to the end; before, those that continuous.c holds. */
    int legs = w->sensors > 0 ? 2 * most + 2 * awake : 0;
    return td_held_reserve(w) && td_array_reserve(&w->memory, &w->scratch.legs, legs) &&
           td_array_reserve(&w->memory, &w->scratch.hits, 2 * shapes + 4 * TD_LANES) &&
           td_array_reserve(&w->memory, &w->scratch.trajectories, awake) &&
           td_array_reserve(&w->memory, &w->scratch.strays, awake) &&
           td_array_reserve(&w->memory, &w->scratch.impacts, td_max_int(most, td_gaps_room(w))) &&
           td_array_reserve(&w->memory, &w->scratch.candidates, extras) &&
           td_array_reserve(&w->memory, &w->events.hit, w->events.hit.count + hits + most) &&
           td_event_queue_reserve(&w->memory, &w->scratch.queue, w->constraints.count + extras);
}

/* Before the solver: what it is to leave alone. */
static void prepare(thud_world *w) {
    if (w->joint_hooks) {
        w->joint_hooks->tie(w);
    }
    td_ballistics_note(w);
    td_bounces_take(w);
}

/* After the solver: what it left of motion into each other, and who flies freely. */
static void launch(thud_world *w) {
    if (w->skin > 0.0f) {
        td_gaps_project(w);
    }
    td_ballistics_fly(w);
}

static void run(thud_world *w) {
    double time;
    schedule_everything(w);
    for (int n; (n = td_event_queue_next(&w->scratch.queue, &time)) != TD_NONE;) {
        collide(w, n, time);
    }
    bool changed = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        changed |= land(w, slot);
        if (takes_part(w, slot)) {
            expect(w, slot);
        }
    }
    if (changed) {
        td_error_settle(w);
    }
    hit_events(w);
}

const td_detection_stage td_stage_impacts = {.reserve = reserve, .run = {prepare, launch, run}};
