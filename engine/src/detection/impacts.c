/* impacts.c: event-driven continuous collision detection: moves the bodies whose detection is
 * `bisect` or `swept` from impact to impact, in the order of time, and resolves each impact there
 * (Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996).
 *
 * Before the motions that the solver found become poses, gaps.c corrects them so that touching
 * shapes do not move into each other; it solves these contacts together with the arrivals
 * (arrivals.c). The rest of this file runs after that. Each awake body has a trajectory, at first
 * the motion that the solver gave it. Pairs that may meet are candidates: contacts, whose fat
 * bounds reach as far as the bodies were expected to move; each body and the ground; and pairs with
 * escaped shapes, which move out of their fat bounds within the step. A queue has the time of
 * impact of each candidate. The earliest is taken out, both bodies are moved to that time, they get
 * new velocities and trajectories (collide.c), and the times of all their candidates are computed
 * anew. At the end poses, motions and bounds of changed bodies follow, and hit events are made.
 *
 * The work of a step is bounded: a body is held at its place for the rest of the step after
 * IMPACTS_MAX impacts, and at its next impact once TOI_BUDGET is spent (thud_stats.held_bodies).
 * Bodies that joints tie together are held together.
 *
 * Times are shares, in [0, 1], of the step. */
#include "constraint/joint_hooks.h"
#include "constraint/tied_bodies.h"
#include "detection/arrivals.h"
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
#include "listeners/decisions.h"
#include "state/surface.h"
#include "detection/unbisectable.h"

/* Impacts of a body in a step before it is held, and the same where the pair is elastic
 * (restitution 1), since a held body loses energy. Measured in the scene smash (size 300, 120
 * steps, swept): bodies are held for 2.7 s in all. With half of both numbers it is 4.8 s, with 21 %
 * fewer computed times of impact; with twice both numbers 1.7 s, with 30 % more. */
enum { IMPACTS_MAX = 8, ELASTIC_IMPACTS_MAX = 16 };

/* Extra candidates for which memory is reserved, in addition to one for each body and one for each
 * body and terrain. Chosen. Memory for more is allocated within the step; if that fails, their
 * bodies are held. */
enum { SPARE_CANDIDATES = 256 };

/* Times of impact (thud_stats.motion_exact) that a step computes before a body is held at its next
 * impact: TOI_BUDGET, and TOI_BUDGET_PER_BODY for each awake body. One takes 1 to 3 us. Chosen. It
 * bounds worlds whose bodies are as large as the place that they are in, where each impact updates
 * all pairs of two bodies: 100 boxes with sides of 0.01 to 100 took 59,000 in a step (260 ms), and
 * with this bound 15,400 (76 ms). The scene tumbler_half, a drum full of bodies at its highest
 * speed, needs 40 a body, so that half of it would hold bodies there. */
enum { TOI_BUDGET = 8192, TOI_BUDGET_PER_BODY = 48 };

/* ---- collisions ---- */

/* Holds a body at its present place (at trajectory.since) for the rest of the step. Cancels its
 * `acceleration`, and the velocity that this would add. */
static void hold_body(thud_world *w, td_trajectory *f) {
    if (!f->held) {
        double remaining = 1.0 - f->since, half = 0.5 * remaining;
        f->held = true;
        td_errors_note_shortfall(w, (float)((f->motion[0] + half * f->acceleration[0]) * remaining),
                                 (float)((f->motion[1] + half * f->acceleration[1]) * remaining));
        td_held_count(w, td_body_at(w, f->body)->awake, f->since);
    }
    td_trajectory_reduce_acceleration(w, f, f->acceleration[0], f->acceleration[1]);
    f->motion[0] = f->motion[1] = f->motion[2] = 0.0;
    f->free = false;
    f->changed = true;
}

/* Removes from the velocity of a tied body (constraint/tied_bodies.h) the part that gravity and
 * forces give in the rest of the step, since the body does not move in it; td_hold_at does the
 * same. For a body in free flight that part is in its `acceleration`, which hold_body cancels. */
static void remove_remaining_gain(thud_world *w, td_awake_slot slot, const td_trajectory *f) {
    float *velocity = td_row(&w->velocity, slot);
    const float *substep_gain = td_row(&w->substep_gain, slot);
    for (int k = 0; k < 3 && !f->free; k++) {
        double gain = w->substeps * (1.0 - f->since) * (double)substep_gain[k];
        velocity[k] = td_velocity_without_gain(w, k, velocity[k], gain);
    }
}

/* Holds a body, and all bodies that joints tie to it at the same time: if they moved on, the
 * joints would open. */
static void hold_tied_group(thud_world *w, td_trajectory *f) {
    td_awake_slot slot = td_body_at(w, f->body)->awake;
    if (td_is_tied(w, slot) && !f->held) {
        remove_remaining_gain(w, slot, f);
    }
    hold_body(w, f);
    if (f->ring_held) {
        return;
    }
    f->ring_held = true;
    for (td_awake_slot i = slot; td_is_tied(w, i) && td_next_tied(w, i).at != slot.at;) {
        i = td_next_tied(w, i);
        td_trajectory *other = td_trajectory_at(w, i);
        other->ring_held = true;
        if (!other->held) {
            td_trajectory_advance(w, other, f->since);
            remove_remaining_gain(w, i, other);
            hold_body(w, other);
            td_toi_queue_update_body(w, other);
        }
    }
}

/* Whether joints tie one of the candidate's bodies to others. */
static bool is_tied(const thud_world *w, const td_toi_candidate *e) {
    return td_is_tied(w, td_body_at(w, e->body[0])->awake) ||
           td_is_tied(w, td_body_at(w, e->body[1])->awake);
}

/* Whether the prologue refuses the pair or has decided its velocities (*decided); the candidate is
 * then marked, and its time is not computed again in this step. Sets *settings to the surface of
 * the pair at the point of impact. The prologue has been called already for pairs that touched at
 * the start of the step, whose settings are in their lane, and for arrivals. */
static bool is_vetoed(thud_world *w, int number, const thud_contact *seen,
                      thud_contact_settings *settings, bool *decided) {
    *decided = false;
    if (number < w->constraints.count && td_contact_at(w, number)->state == TD_TOUCHING) {
        const td_contact *contact = td_contact_at(w, number);
        td_lane at = td_lane_of(w, contact);
        *settings =
            td_surface_get(at.block, td_form_points(w->kinds[contact->kind]->form), at.lane);
        return false;
    }
    const td_arrival *arrival = td_arrival_of(w, number);
    if (arrival) {
        *settings = arrival->settings;
        *decided = arrival->decided;
        if (arrival->decided) {
            w->decisions->impact = arrival->decision;
            td_contact_at(w, number)->vetoed = TD_VETOED;
        }
        return arrival->decided;
    }
    *settings = td_surface_of_impact(w, seen);
    if (w->decisions) {
        w->decisions->has_impact = false; /* forgets the decision about an earlier impact */
    }
    bool meets = td_surface_meet(w, seen, settings);
    *decided = w->decisions && w->decisions->has_impact;
    bool veto = !meets || *decided;
    if (veto && number < w->constraints.count) {
        td_contact_at(w, number)->vetoed = TD_VETOED;
    } else if (veto) {
        td_extra_candidate_at(w, number)->vetoed = true;
    }
    return veto;
}

/* Whether the step has used up its budget of times of impact: TOI_BUDGET + TOI_BUDGET_PER_BODY
 * times the awake bodies. Both sides are divided by the latter factor, so that nothing overflows.
 */
static bool is_over_budget(const thud_world *w) {
    return w->stats.motion_exact / TOI_BUDGET_PER_BODY >
           TOI_BUDGET / TOI_BUDGET_PER_BODY + w->body_of.count;
}

/* For a candidate whose shapes, at its time, do not meet yet or do not close: computes its time
 * anew. The test follows the chord of a path, and stops early where the arc may be nearer than the
 * chord. The rest of the arc deviates less from its own chord, so that the next test comes closer.
 * The stop counts as an impact of both bodies, which bounds the number of such tests. */
static void requeue_early_stop(thud_world *w, int number, td_trajectory *const trajectories[2]) {
    for (int side = 0; side < 2; side++) {
        td_trajectory *f = trajectories[side];
        if (f && td_body_at(w, f->body)->kind == THUD_BODY_DYNAMIC &&
            (++f->impacts > IMPACTS_MAX || is_over_budget(w))) {
            hold_tied_group(w, f);
            td_toi_queue_update_body(w, f);
        }
    }
    td_toi_queue_set(w, number);
}

/* Moves both bodies of a candidate to `time` and resolves the impact. A pair with a sleeping body,
 * or with one that joints tie to others, gets no impulse here: its dynamic bodies are held, and the
 * narrowphase of the next step makes a contact between them, which wakes the sleeping body. */
static void resolve_candidate(thud_world *w, int number, double time) {
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
        requeue_early_stop(w, number, trajectories);
        return;
    }
    td_impact impact = {.seen = td_impact_view(w, &e, &at)};
    thud_contact_settings settings;
    bool decided;
    if (is_vetoed(w, number, &impact.seen, &settings, &decided) && !decided) {
        return;
    }
    /* Sleeping and tied bodies are left to the contacts of the next step. */
    bool next_step = td_body_sleeps(w, e.body[0]) || td_body_sleeps(w, e.body[1]) || is_tied(w, &e);
    if (!next_step) {
        impact.touching =
            number < w->constraints.count && td_contact_at(w, number)->state == TD_TOUCHING;
        if (decided) {
            impact.closing_speed = (float)(at.speed / w->def.time_step);
            w->decisions->resolve(w, &impact);
        } else {
            td_impact_resolve(w, &e, &at, time, &settings, &impact);
        }
        TD_PUSH(td_impact, &w->scratch.impacts) = impact;
    }
    int impacts_max = settings.restitution < 1.0f ? IMPACTS_MAX : ELASTIC_IMPACTS_MAX;
    for (int side = 0; side < 2; side++) {
        td_trajectory *f = trajectories[side];
        if (f && td_body_at(w, f->body)->kind == THUD_BODY_DYNAMIC && !impact.kept_motion[side] &&
            (next_step || f->impacts > impacts_max || is_over_budget(w) ||
             !td_toi_candidates_find(w, f))) {
            hold_tied_group(w, f);
        }
    }
    w->stats.impacts++;
    for (int side = 0; side < 2; side++) {
        if (trajectories[side] &&
            (!impact.kept_motion[side] || impact.acceleration_reduced[side])) {
            td_toi_queue_update_body(w, trajectories[side]);
        }
    }
}

/* ---- the stage ---- */

/* Whether the body is dynamic and its detection finds times of impact. */
static bool is_bisected_or_swept(const thud_world *w, td_awake_slot slot) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    return body->kind == THUD_BODY_DYNAMIC && body->detection->time_of_impact;
}

/* Writes the end of a changed trajectory to pose, motion and shapes of the body. False: it was not
 * changed. */
static bool end_trajectory(thud_world *w, td_awake_slot slot) {
    td_trajectory *f = td_trajectory_at(w, slot);
    if (!f->changed) {
        return false;
    }
    td_pose *pose = td_pose_at(w, f->body);
    float *delta = td_row(&w->delta, slot);
    td_position start = {pose->center.x - td_length_from(w, delta[0]),
                         pose->center.y - td_length_from(w, delta[1])};
    uint32_t angle = pose->angle - td_angle_between((double)delta[2]);
    td_trajectory_advance(w, f, 1.0);
    pose->center = f->place;
    pose->angle = f->angle;
    td_angle_turn(pose->angle, &pose->c, &pose->s);
    float x = delta[0], y = delta[1];
    delta[0] = (float)((double)(f->place.x - start.x) / w->to_fixed);
    delta[1] = (float)((double)(f->place.y - start.y) / w->to_fixed);
    delta[2] = (float)(int32_t)(f->angle - angle) * (float)TD_RADIANS_A_QUANTUM;
    td_errors_undo_gravity_work(w, slot, x - delta[0], y - delta[1]);
    td_body_place_shapes(w, f->body);
    return true;
}

/* Extends the fat bounds of the body's shapes by the motion that its velocity gives in the next
 * step. */
static void extend_fat_bounds(thud_world *w, td_awake_slot slot) {
    const float *v = td_row(&w->velocity, slot);
    float h = (float)w->def.time_step;
    int i = td_body_at(w, td_body_of(w, slot))->first_shape;
    for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_expect(w, i, v[0] * h, v[1] * h);
    }
}

/* Sets all trajectories to the start of the step, and queues all candidates by their times of
 * impact. */
static void schedule_candidates(thud_world *w) {
    w->scratch.extra_candidates.count = w->scratch.escaped.count = 0;
    td_event_queue_clear(&w->scratch.queue, w->constraints.count);
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory_begin(w, slot, true);
    }
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        td_trajectory *f = td_trajectory_at(w, slot);
        bool detects = is_bisected_or_swept(w, slot), leaves = td_trajectory_leaves_bounds(w, f);
        if ((detects && !td_toi_candidates_find_terrain(w, f)) ||
            (leaves && !td_toi_candidates_find(w, f))) {
            hold_body(w, f);
        }
        w->stats.unbisectable += td_is_unbisectable(w, slot);
    }
    td_gaps_find_open(w);
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *c = td_constraint_at(w, i);
        if (c->live && td_toi_queue_accepts(w, i) &&
            !(c->state == TD_TOUCHING && td_gap_was_found_open(w, c))) {
            td_toi_queue_set_first(w, i);
        }
    }
    for (int i = 0; i < w->scratch.extra_candidates.count; i++) {
        td_toi_queue_set(w, w->constraints.count + i);
    }
}

/* A hit event for each impact that is faster than the hit speed. */
static void hit_events(thud_world *w) {
    for (int i = 0; i < w->scratch.impacts.count && w->def.contact_events; i++) {
        const td_impact *impact = TD_AT(td_impact, &w->scratch.impacts, i);
        const thud_contact *seen = &impact->seen;
        int a = (int)seen->shape_a.index1 - 1, b = (int)seen->shape_b.index1 - 1;
        if (impact->closing_speed > w->def.hit_speed * w->length_scale &&
            !td_pair_is_silent(w, a, b)) {
            TD_PUSH(thud_hit_event, &w->events.hit) =
                (thud_hit_event){seen->shape_a, seen->shape_b, seen->point, seen->normal,
                                 td_hit_speed(impact->closing_speed)};
        }
    }
}

/* Reserves all memory that the stage uses; see td_detection_stage. */
static bool reserve(thud_world *w) {
    /* Upper bound of the number of impacts: each is counted for at least one body that is not held,
     * and a body is held at its impact number ELASTIC_IMPACTS_MAX + 1 at the latest. */
    int awake = w->body_of.count;
    int impacts_max = (ELASTIC_IMPACTS_MAX + 1) * awake + td_arrivals_max(w);
    int extras = awake * (w->terrains.live + 1) + SPARE_CANDIDATES;
    /* Room for the hit events of contacts that begin in the step, beside those of impacts. */
    int hits = w->scratch.begins.count;
    int shapes = w->awake_shapes.ids.count + w->rest_shapes.ids.count;
    /* Each impact ends a leg of both bodies. Each body also has a last leg, and one more if
     * td_sensing_note_held finds it held. */
    int legs = w->sensors > 0 ? 2 * impacts_max + 2 * awake : 0;
    return td_held_reserve(w) && td_array_reserve(&w->memory, &w->scratch.legs, legs) &&
           td_array_reserve(&w->memory, &w->scratch.found_shapes, td_query_room(shapes)) &&
           td_array_reserve(&w->memory, &w->scratch.trajectories, awake) &&
           td_array_reserve(&w->memory, &w->scratch.arrivals, td_arrivals_max(w)) &&
           td_array_reserve(&w->memory, &w->scratch.escaped, awake) &&
           td_array_reserve(&w->memory, &w->scratch.impacts,
                            td_max_int(impacts_max, td_gaps_room(w))) &&
           td_array_reserve(&w->memory, &w->scratch.extra_candidates, extras) &&
           td_array_reserve(&w->memory, &w->events.hit, w->events.hit.count + hits + impacts_max) &&
           td_event_queue_reserve(&w->memory, &w->scratch.queue, w->constraints.count + extras);
}

/* Before the solver: finds the groups of tied bodies, saves velocities, and takes the contacts that
 * bounce within the step out of the soft solver (solver/bounces.h). */
static void run_before_solving(thud_world *w) {
    if (w->joint_hooks) {
        w->joint_hooks->tie(w);
    }
    td_ballistics_save_velocities(w);
    td_bounces_take(w);
}

/* Counts the touching contacts of each body, and clears the veto marks that pairs without a
 * touching contact got in the step before. */
static void visit_contacts(thud_world *w) {
    for (int i = 0; i < w->constraints.count; i++) {
        td_constraint *contact = td_constraint_at(w, i);
        if (contact->live && contact->state != TD_TOUCHING) {
            contact->vetoed = 0;
        }
        for (int side = 0; contact->live && contact->state == TD_TOUCHING && side < 2; side++) {
            td_awake_slot slot = td_body_at(w, contact->body[side])->awake;
            if (slot.at > 0) {
                td_trajectory_at(w, slot)->contact_count++;
            }
        }
    }
}

/* After the solver: corrects motions of touching shapes into each other, together with those of
 * arrivals (gaps.c, arrivals.c), and sets the paths of bodies in free flight. */
static void run_before_moving(thud_world *w) {
    w->scratch.arrivals.count = 0;
    visit_contacts(w);
    if (w->skin > 0.0f) {
        td_arrivals_find(w);
        td_gaps_project(w);
    }
    w->scratch.impacts.count = 0;
    td_arrivals_end(w);
    td_ballistics_set_parabolas(w);
}

/* After td_finalize: see the head of this file. */
static void run_after_moving(thud_world *w) {
    double time;
    schedule_candidates(w);
    for (int n; (n = td_event_queue_next(&w->scratch.queue, &time)) != TD_NONE;) {
        resolve_candidate(w, n, time);
    }
    bool changed = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        changed |= end_trajectory(w, slot);
        if (is_bisected_or_swept(w, slot)) {
            extend_fat_bounds(w, slot);
        }
    }
    if (changed) {
        td_errors_resum_kinetic(w);
    }
    hit_events(w);
}

const td_detection_stage td_stage_impacts = {.reserve = reserve,
                                             .run = {run_before_solving, run_before_moving,
                                                     run_after_moving}};
