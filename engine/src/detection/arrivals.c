/* arrivals.c: see arrivals.h, and arrival_rows.h for what an arrival is. */
#include "detection/arrivals.h"

#include "constraint/tied_bodies.h"
#include "detection/toi_queue.h"
#include "state/body.h"
#include "state/surface.h"

/* Minimum of the touching contacts that the two bodies of an arrival have together. Chosen so that
 * a body that meets another one that stands alone on the ground still has its impact at the exact
 * time (impacts.c). */
enum { CONTACTS_MIN = 2 };
/* Maximum number of arrivals in a step: ARRIVALS_MAX, and one more for each BODIES_PER_ARRIVAL
 * awake bodies. Chosen: in the scene circle_pit (2,000) a step has at most 52. */
enum { ARRIVALS_MAX = 64, BODIES_PER_ARRIVAL = 4 };

/* The gap at which the rows of arrivals aim, in multiples of TD_IMPACT_DISTANCE. impacts.c counts
 * shapes that are nearer than 1 as meeting; the rows may miss their target by up to
 * TD_LOAD_CLOSING_MAX, and must stay above that. */
#define ARRIVAL_DISTANCE 1.2f

int td_arrivals_max(const thud_world *w) {
    return ARRIVALS_MAX + w->body_of.count / BODIES_PER_ARRIVAL;
}

/* Whether the motion of a body in the step is finite and within the bounds of motions
 * (td_motion_held); if not, td_finalize may quarantine the body. True for slot 0, which does not
 * move. */
static bool has_path(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot);
    bool bounded = true;
    for (int k = 0; k < 3; k++) {
        bounded &= td_motion_held(w, k, (double)delta[k]) == (double)delta[k];
    }
    return bounded;
}

/* Whether a contact may be an arrival, before the time at which its shapes meet is known. */
static bool may_arrive(const thud_world *w, int contact) {
    const td_constraint *c = td_constraint_at(w, contact);
    if (!c->live || c->state == TD_TOUCHING || !td_toi_queue_accepts(w, contact)) {
        return false;
    }
    td_awake_slot a = td_moving_slot(w, c->body[0]), b = td_moving_slot(w, c->body[1]);
    int contacts = (a.at ? td_trajectory_at(w, a)->contact_count : 0) +
                   (b.at ? td_trajectory_at(w, b)->contact_count : 0);
    return contacts >= CONTACTS_MIN && !td_body_sleeps(w, c->body[0]) &&
           !td_body_sleeps(w, c->body[1]) && !td_is_tied(w, a) && !td_is_tied(w, b) &&
           has_path(w, a) && has_path(w, b) &&
           td_detection_of(w, c->body[0], c->body[1])->rank == TD_RANK_SWEPT;
}

/* Whether the pair closes and does not bounce, by the rule that bounce_speed of collide.c has for
 * pairs that are not in free flight. */
static bool stops(const thud_world *w, const td_arrival *r) {
    float threshold = w->def.restitution_threshold * w->length_scale;
    float restitution = r->settings.restitution, speed = r->impact.closing_speed;
    return speed > 0.0f && (restitution == 0.0f || (restitution < 1.0f && speed <= threshold));
}

/* Asks the collision rules (rules/) and the prologue, the caller's callback before a contact is
 * solved, about the pair, and keeps the answer in the arrival. False if they refuse the pair: its
 * contact is then vetoed, and the two shapes pass through each other in this step. */
static bool is_accepted(thud_world *w, td_arrival *r) {
    if (w->decisions) {
        w->decisions->has_impact = false; /* forgets the decision about an earlier impact */
    }
    bool meets = td_surface_meet(w, &r->impact.seen, &r->settings);
    if (w->decisions && w->decisions->has_impact) {
        r->decided = true;
        r->decision = w->decisions->impact;
    } else if (!meets) {
        td_contact_at(w, r->contact)->vetoed = TD_VETOED;
        return false;
    }
    return true;
}

/* The arm of the impact point: the vector from a body's centre of mass, where it is at `time`, to
 * that point. */
static void arm_of(const thud_world *w, td_body_index body, const td_impact_point *at, double time,
                   float *x, float *y) {
    td_trajectory f = td_trajectory_of(w, body);
    *x = (float)(at->x - (double)(f.place.x - at->origin.x) / w->to_fixed - f.motion[0] * time);
    *y = (float)(at->y - (double)(f.place.y - at->origin.y) / w->to_fixed - f.motion[1] * time);
}

/* The inverse moment of inertia of a body; 0 for one that impulses do not change. */
static float inverse_inertia_of(const thud_world *w, td_body_index body) {
    const td_body *b = td_body_at(w, body);
    return b->kind == THUD_BODY_DYNAMIC && b->awake.at > 0 ? b->inv_inertia : 0.0f;
}

/* Adds the arrival of a contact whose shapes meet at `time`, unless it bounces or is refused. */
static void add_arrival(thud_world *w, int contact, const td_toi_candidate *e, double time) {
    td_impact_point at;
    if (!td_impact_point_of(w, e, time, &at)) {
        return;
    }
    td_arrival r = {.a = td_moving_slot(w, e->body[0]),
                    .b = td_moving_slot(w, e->body[1]),
                    .nx = (float)at.nx,
                    .ny = (float)at.ny,
                    .start = (float)(at.distance + at.speed * time),
                    .gap_min = ARRIVAL_DISTANCE * TD_IMPACT_DISTANCE * w->length_scale,
                    .inv_inertia = {inverse_inertia_of(w, e->body[0]),
                                    inverse_inertia_of(w, e->body[1])},
                    .impact = {.seen = td_impact_view(w, e, &at),
                               .closing_speed = (float)(at.speed / w->def.time_step)},
                    .contact = contact};
    r.settings = td_surface_of_impact(w, &r.impact.seen);
    if (!stops(w, &r) || !is_accepted(w, &r)) {
        return;
    }
    arm_of(w, e->body[0], &at, time, &r.ax, &r.ay);
    arm_of(w, e->body[1], &at, time, &r.bx, &r.by);
    float turn_a = r.ax * r.ny - r.ay * r.nx, turn_b = r.bx * r.ny - r.by * r.nx;
    r.mass = 1.0f / (td_row(&w->velocity, r.a)[3] + td_row(&w->velocity, r.b)[3] +
                     r.inv_inertia[0] * turn_a * turn_a + r.inv_inertia[1] * turn_b * turn_b);
    TD_PUSH(td_arrival, &w->scratch.arrivals) = r;
}

/* Trajectories are begun at the first contact that may be an arrival, so that a step without one
 * needs no pass over all bodies. */
void td_arrivals_find(thud_world *w) {
    bool began = false;
    double time;
    for (int i = 0; i < w->constraints.count; i++) {
        if (!may_arrive(w, i) || w->scratch.arrivals.count == td_arrivals_max(w)) {
            continue;
        }
        for (td_awake_slot slot = {1}; slot.at < w->body_of.count && !began; slot.at++) {
            td_trajectory_begin(w, slot, false);
        }
        began = true;
        td_toi_candidate e = td_toi_candidate_at(w, i);
        if (!td_toi_candidate_has_internal_edges(w, &e) && !td_toi_candidate_is_far(w, &e) &&
            td_toi_queue_meeting_time(w, &e, &time)) {
            add_arrival(w, i, &e, time);
        }
    }
}

/* Finds the arrival by binary search: td_arrivals_find lists arrivals by rising numbers of their
 * contacts. */
const td_arrival *td_arrival_of(const thud_world *w, int contact) {
    int low = 0, end = w->scratch.arrivals.count;
    while (low < end) {
        int middle = (low + end) / 2;
        const td_arrival *r = TD_AT(td_arrival, &w->scratch.arrivals, middle);
        if (r->contact == contact) {
            return r;
        }
        low = r->contact < contact ? middle + 1 : low;
        end = r->contact < contact ? end : middle;
    }
    return NULL;
}

void td_arrivals_end(thud_world *w) {
    td_arrival_rows_rub(w);
    for (int i = 0; i < w->scratch.arrivals.count; i++) {
        td_arrival *r = TD_AT(td_arrival, &w->scratch.arrivals, i);
        if (r->velocity > 0.0f) {
            r->impact.seen.normal_impulse = r->velocity;
            r->impact.seen.tangent_impulse = r->rubbed;
            TD_PUSH(td_impact, &w->scratch.impacts) = r->impact;
            w->stats.impacts++;
        }
    }
}
