/* decide.c: a prologue that decides the velocities after a collision by itself
 * (thud_contact_decide). listeners.c takes the decided pair out of the step, like a vetoed one;
 * here the velocities are kept until all prologues have been called, so that each of them sees
 * bodies as they were, and are then given to the bodies. */
#include "constraint/lanes.h"
#include "contact/contact.h"
#include "detection/collide.h"
#include "listeners/listeners.h"
#include "solver/error.h"
#include "state/handles.h"

/* The body of a side of a contact. */
static td_body_index body_of_side(const thud_world *w, const thud_contact *seen, int side) {
    return td_shape_at(w, (int)(side ? seen->shape_b : seen->shape_a).index1 - 1)->body;
}

/* ---- what a decision does ---- */

/* Twice the kinetic energy of a body at a velocity. */
static double twice_energy(const td_body *body, const double v[3]) {
    return (double)body->mass * (v[0] * v[0] + v[1] * v[1]) + (double)body->inertia * v[2] * v[2];
}

/* Adds the change of a body's velocity from `before` to the decided one to the step's energy
 * change. For body b it also becomes the impulse that the epilogue gets. */
static void count_change(thud_world *w, td_decision *d, thud_contact *seen, int side,
                         const double before[3]) {
    const td_body *body = td_body_at(w, body_of_side(w, &d->seen, side));
    double after[3];
    for (int k = 0; k < 3; k++) {
        after[k] = (double)d->velocity[side][k];
    }
    w->errors.energy_decided += 0.5 * (twice_energy(body, after) - twice_energy(body, before));
    double sign = side ? (double)body->mass : -(double)body->mass;
    double x = sign * (after[0] - before[0]), y = sign * (after[1] - before[1]);
    double nx = (double)seen->normal.x, ny = (double)seen->normal.y;
    seen->normal_impulse = (float)(x * nx + y * ny);
    seen->tangent_impulse = (float)(x * ny - y * nx);
}

/* Recomputes the closing speeds of the points of a body's contacts from the decided velocity:
 * restitution bounces by these speeds. */
static void renew_closing_speeds(thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *c = td_constraint_at(w, td_edge_constraint(e));
        if (td_is_contact(c) && c->state == TD_TOUCHING) {
            td_lane at = td_lane_of(w, c);
            int points = td_form_points(w->kinds[c->kind]->form);
            for (int k = 0; k < points; k++) {
                td_history_of(at.block, points)[k].normal_velocity[at.lane] =
                    -td_contact_closing_speed(w, at.block, &at.block->point[k], at.lane);
            }
        }
    }
}

/* td_decisions.apply. If the kinetic energy is stale, it is summed up first, so that the energy
 * change of the step includes the decisions. */
static void apply(thud_world *w) {
    td_decisions *all = w->decisions;
    if (all->list.count > 0 && w->kinetic_stale) {
        td_errors_resum_kinetic(w);
        w->kinetic_stale = false;
    }
    for (int i = 0; i < all->list.count; i++) {
        td_decision *d = TD_AT(td_decision, &all->list, i);
        for (int side = 0; side < 2; side++) {
            td_body_index body = body_of_side(w, &d->seen, side);
            td_awake_slot slot = td_body_at(w, body)->awake;
            if (!d->given[side] || slot.at <= 0) {
                continue;
            }
            float *velocity = td_row(&w->velocity, slot);
            double before[3];
            for (int k = 0; k < 3; k++) {
                before[k] = (double)velocity[k];
                velocity[k] = d->velocity[side][k];
            }
            count_change(w, d, &d->seen, side, before);
            *td_row(&w->idle, slot) = 0.0f;
        }
    }
    for (int i = 0; i < all->list.count; i++) {
        const td_decision *d = TD_AT(td_decision, &all->list, i);
        for (int side = 0; side < 2; side++) {
            if (d->given[side]) {
                renew_closing_speeds(w, body_of_side(w, &d->seen, side));
            }
        }
    }
}

/* td_decisions.resolve. The velocity of an awake body is that of the end of the step, so that it
 * differs from that at the impact by what `acceleration` adds until then. A body that is held keeps
 * its place. */
static void resolve(thud_world *w, td_impact *resolved) {
    td_decision *d = &w->decisions->impact;
    double before[2][3] = {{0.0}};
    for (int side = 0; side < 2; side++) {
        td_awake_slot slot = td_body_at(w, body_of_side(w, &d->seen, side))->awake;
        if (slot.at <= 0) {
            continue;
        }
        td_trajectory *f = td_trajectory_at(w, slot);
        float *velocity = td_row(&w->velocity, slot);
        for (int k = 0; k < 3; k++) {
            double gained = k < 2 ? f->acceleration[k] * (1.0 - f->since) / w->def.time_step : 0.0;
            before[side][k] = (double)velocity[k] - gained;
            if (d->given[side]) {
                double now = (double)d->velocity[side][k];
                double max = td_speed_max(w, k);
                velocity[k] = (float)td_clamp(now + gained, -max, max);
                f->motion[k] = f->held ? 0.0 : td_motion_held(w, k, now * w->def.time_step);
            }
        }
        if (d->given[side]) {
            f->changed = true;
            f->impacts++;
            *td_row(&w->idle, slot) = 0.0f;
        }
    }
    for (int side = 0; side < 2; side++) {
        if (d->given[side]) {
            count_change(w, d, &resolved->seen, side, before[side]);
        }
    }
}

/* ---- deciding ---- */

/* The number of a contact among those that a prologue is being asked about, or -1. */
static int number_of(const thud_world *w, const thud_contact *contact) {
    const td_question *q = w->listeners ? &w->listeners->asked : NULL;
    uintptr_t bytes = q ? (uintptr_t)contact - (uintptr_t)q->contacts : 0;
    uintptr_t place = bytes / sizeof *contact;
    bool one_of_them = q && bytes % sizeof *contact == 0 && place < (uintptr_t)q->count;
    return one_of_them ? q->number + (int)place : -1;
}

/* Checks the velocities that are given for a side, and sets them in the decision. */
static thud_result set_side(const thud_world *w, td_decision *d, int side,
                            const thud_velocities *v) {
    const td_body *body = td_body_at(w, body_of_side(w, &d->seen, side));
    if (!v) {
        return THUD_OK;
    }
    if (body->kind != THUD_BODY_DYNAMIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "decide: the body is not dynamic");
    }
    float turn = body->inv_inertia == 0.0f ? 0.0f : v->angular_velocity;
    const float given[3] = {v->velocity.x, v->velocity.y, turn};
    d->given[side] = true;
    for (int k = 0; k < 3; k++) {
        double max = td_speed_max(w, k);
        d->velocity[side][k] = (float)td_clamp((double)given[k], -max, max);
    }
    return td_check_finite(w, "decide: velocity or angular_velocity", v->velocity.x, v->velocity.y,
                           v->angular_velocity);
}

/* The place in the list of the decision for a contact: that of an earlier one for the same contact,
 * else the end. Prologues mostly decide in the order of numbers, and then nothing is searched. */
static int place_in_list(const td_decisions *all, int number) {
    int i = all->list.count;
    if (i == 0 || TD_AT(td_decision, &all->list, i - 1)->number < number) {
        return i;
    }
    while (i > 0 && TD_AT(td_decision, &all->list, i - 1)->number != number) {
        i--;
    }
    return i > 0 ? i - 1 : all->list.count;
}

/* The decisions of the world, made at the first one; null when memory is short. */
static td_decisions *decisions_of(thud_world *w) {
    if (!w->decisions) {
        w->decisions = td_memory_get(&w->memory, sizeof *w->decisions);
        if (w->decisions) {
            w->decisions->list.stride = (int)sizeof(td_decision);
            w->decisions->apply = apply;
            w->decisions->resolve = resolve;
        }
    }
    return w->decisions;
}

thud_result thud_contact_decide(thud_world *w, const thud_contact *contact,
                                const thud_velocities *a, const thud_velocities *b) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !contact || (!a && !b)) {
        return td_refuse(w, THUD_ERROR_NULL, "decide: world, contact or both velocities are null");
    }
    int number = number_of(w, contact);
    if (number < 0) {
        return td_refuse(w, THUD_ERROR_INVALID, "decide: no prologue is asked about this contact");
    }
    td_decision d = {.seen = *contact, .number = number};
    thud_result result = set_side(w, &d, 0, a);
    result = result == THUD_OK ? set_side(w, &d, 1, b) : result;
    if (result != THUD_OK) {
        return result;
    }
    td_decisions *all = decisions_of(w);
    if (!all || !td_array_reserve(&w->memory, &all->list, all->list.count + 1)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "decide: out of memory");
    }
    if (w->listeners->asked.impact) {
        all->impact = d;
        all->has_impact = true;
        return THUD_OK;
    }
    int place = place_in_list(all, number);
    all->list.count += place == all->list.count;
    *TD_AT(td_decision, &all->list, place) = d;
    return THUD_OK;
}
