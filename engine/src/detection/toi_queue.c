/* toi_queue.c: see toi_queue.h. Times are shares, in [0, 1], of the step. */
#include "detection/toi_queue.h"

#include "constraint/constraint.h"
#include "constraint/tied_bodies.h"
#include "detection/collide.h"
#include "detection/gaps.h"
#include "detection/ghosts.h"
#include "state/body.h"

/* In multiples of TD_IMPACT_DISTANCE. Shapes nearer than TOUCHING_DISTANCE touch: they meet when
 * they close further, not at a distance. Motion that closes by less than CLOSING_MIN in the step
 * does not count. Both chosen, far above the rounding of places (2^-32 length scales; this is 1e-5)
 * and far below what is seen. At half and twice of both the times of impact in the scene smash
 * change by less than 5 %. */
#define TOUCHING_DISTANCE 0.01
#define CLOSING_MIN 0.01

/* Maximum number of ghosts (ghosts.h) that are skipped in one test of a pair; a pair that meets
 * more is not queued. Chosen: two boxes have 8 faces, each of which can give one ghost; rotating
 * boxes may give more, since the time at which they pass a face is only bounded from below. With 4
 * the scene platformer runs the same. */
enum { GHOSTS_MAX = 16 };

/* The later of two times. */
static double max_time(double a, double b) {
    return a > b ? a : b;
}

/* Whether joints tie one of the bodies to others. The pair is then left to the solver once it
 * touches, as in td_gap_is_left_to_solver: if such a body were held at its contact, all bodies that
 * are tied to it would be held, and a vehicle would stop whenever a wheel touches the ground. */
static bool is_tied(const thud_world *w, const td_toi_candidate *e) {
    return td_is_tied(w, td_body_at(w, e->body[0])->awake) ||
           td_is_tied(w, td_body_at(w, e->body[1])->awake);
}

/* Whether touching shapes close further from `now` on, so that they meet at once. */
static bool closes(thud_world *w, const td_toi_candidate *e, double now) {
    td_impact_point at;
    return td_impact_point_of(w, e, now, &at) &&
           at.closing_distance > CLOSING_MIN * (double)(TD_IMPACT_DISTANCE * w->length_scale);
}

/* Whether an impact can stop the body: it is dynamic, awake and not held. */
static bool can_stop(const thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    return b->kind == THUD_BODY_DYNAMIC && b->awake.at > 0 && !td_trajectory_at(w, b->awake)->held;
}

/* Whether the body had an impact in this step. */
static bool had_impact(const thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    return b->awake.at > 0 && td_trajectory_at(w, b->awake)->impacts > 0;
}

/* Finds when a pair meets after `now` in this step (*hit is true), or when it is to be tested
 * again since only a part of its path was tested (*hit is false); false if neither. *time is in
 * [0, 1] of the step. */
static bool next_check(thud_world *w, const td_toi_candidate *e, const thud_detection *detection,
                       double now, bool *hit, double *time) {
    td_approach approach;
    double unit = (double)(TD_IMPACT_DISTANCE * w->length_scale);
    *hit = false;
    if (now >= 1.0 || !td_toi_candidate_approach(w, e, now, 1.0, &approach)) {
        return false;
    }
    /* If the error of the straight path may exceed half the present distance, only a first part of
     * the path is tested, in which it does not; the error grows with the square of the time. */
    double until = 1.0, apart = max_time(approach.distance, TOUCHING_DISTANCE * unit);
    if (approach.path_error > 0.5 * apart) {
        until = now + (1.0 - now) * __builtin_sqrt(0.5 * apart / approach.path_error);
        if (!td_toi_candidate_approach(w, e, now, until, &approach)) {
            *time = until;
            return true;
        }
    }
    /* A tenth of the target. Chosen: with this tolerance, conservative advancement of rotating
     * shapes ends after fewer iterations. */
    approach.tolerance = 0.1 * approach.target;
    if (approach.target <= TOUCHING_DISTANCE * unit) {
        /* The shapes touch. A shape on a terrain meets it now if the two close. Two other shapes
         * meet when they are nearer than now by a margin: TD_LOAD_CLOSING_MAX if they overlap and
         * had no impact in this step, since a load may press them together that far; else
         * CLOSING_MIN. */
        if (approach.on_ground) {
            *hit = !is_tied(w, e) && closes(w, e, now);
            *time = *hit ? now : until;
            return *hit || until < 1.0;
        }
        bool pressed =
            approach.distance <= 0.0 && !had_impact(w, e->body[0]) && !had_impact(w, e->body[1]);
        approach.target = approach.distance - (pressed ? TD_LOAD_CLOSING_MAX : CLOSING_MIN) * unit;
        approach.tolerance = 0.1 * CLOSING_MIN * unit;
    }
    double part;
    w->stats.motion_exact++;
    *hit = detection->time_of_impact(&approach, &part);
    *time = *hit ? now + (until - now) * part : until;
    return *hit || until < 1.0;
}

/* For a candidate with a terrain: whether its body touches something, and none of its points moves
 * further in the rest of the step than a load may press it (TD_LOAD_CLOSING_MAX). Its contacts are
 * then left to the solver, as in td_gap_is_left_to_solver. */
static bool stays_on_ground(const thud_world *w, const td_toi_candidate *e) {
    const td_body *body = td_body_at(w, e->body[1]);
    if (td_shape_at(w, e->shape[0])->kind != THUD_SHAPE_TERRAIN || body->awake.at <= 0) {
        return false;
    }
    const td_trajectory *f = td_trajectory_at(w, body->awake);
    double left = 1.0 - f->since;
    double x = td_abs(f->motion[0]) + td_abs(f->acceleration[0]) * left;
    double y = td_abs(f->motion[1]) + td_abs(f->acceleration[1]) * left;
    double way = x + y + td_abs(f->motion[2]) * (double)body->max_extent;
    return f->contact_count > 0 && f->impacts == 0 &&
           way * left < TD_LOAD_CLOSING_MAX * (double)(TD_IMPACT_DISTANCE * w->length_scale);
}

bool td_toi_queue_meeting_time(thud_world *w, const td_toi_candidate *e, double *time) {
    const thud_detection *detection = td_detection_of(w, e->body[0], e->body[1]);
    double now =
        max_time(td_trajectory_of(w, e->body[0]).since, td_trajectory_of(w, e->body[1]).since);
    bool neither_stops = !can_stop(w, e->body[0]) && !can_stop(w, e->body[1]), hit = true;
    if (e->vetoed || !detection->time_of_impact || neither_stops || stays_on_ground(w, e)) {
        return false;
    }
    for (int i = 0; i < GHOSTS_MAX && next_check(w, e, detection, now, &hit, time); i++) {
        if (!hit || !td_is_ghost(w, e, *time, &now)) {
            return true;
        }
    }
    return false;
}

/* Whether the candidate is a touching contact that needs no time of impact: its gap provably stays
 * open, or it is left to the solver. */
static bool contact_stays_open(const thud_world *w, int number) {
    if (number >= w->constraints.count || td_contact_at(w, number)->state != TD_TOUCHING) {
        return false;
    }
    const td_contact *contact = td_contact_at(w, number);
    if (td_gap_is_left_to_solver(w, contact)) {
        return true;
    }
    double now = max_time(td_trajectory_of(w, contact->body[0]).since,
                          td_trajectory_of(w, contact->body[1]).since);
    return td_gap_stays_open(w, contact, now);
}

void td_toi_queue_set(thud_world *w, int number) {
    td_toi_candidate e = td_toi_candidate_at(w, number);
    double time;
    if (!contact_stays_open(w, number) && td_toi_queue_meeting_time(w, &e, &time)) {
        td_event_queue_set(&w->scratch.queue, number, time);
    } else {
        td_event_queue_strike(&w->scratch.queue, number);
    }
}

void td_toi_queue_set_first(thud_world *w, int number) {
    td_toi_candidate e = td_toi_candidate_at(w, number);
    double time;
    if (!td_toi_candidate_is_far(w, &e) && td_toi_queue_meeting_time(w, &e, &time)) {
        td_event_queue_set(&w->scratch.queue, number, time);
    }
}

bool td_toi_queue_accepts(const thud_world *w, int contact) {
    const td_constraint *c = td_constraint_at(w, contact);
    return c->kind < TD_PAIR_SENSOR && !td_pair_is_on_line((td_pair_kind)c->kind);
}

void td_toi_queue_update_body(thud_world *w, const td_trajectory *f) {
    for (int e = td_body_at(w, f->body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        if (td_toi_queue_accepts(w, td_edge_constraint(e))) {
            td_toi_queue_set(w, td_edge_constraint(e));
        }
    }
    for (int e = f->extras; e != TD_NONE;) {
        const td_toi_candidate *extra =
            TD_AT(td_toi_candidate, &w->scratch.extra_candidates, td_edge_candidate(e));
        int next = extra->next[td_edge_side(e)];
        td_toi_queue_set(w, w->constraints.count + td_edge_candidate(e));
        e = next;
    }
}
