/* awake.c: gives awake slots to bodies and takes them back; see awake.h. Slots stay dense: when a
 * body leaves its slot, the body of the last slot moves there, which renumbers the sides of its
 * lanes. */
#include "state/awake.h"

#include "constraint/lanes.h"
#include "state/sleep_hooks.h"

#include <string.h>

int td_awake_capacity(int bodies) {
    return 1 + bodies + TD_LANES;
}

bool td_awake_reserve(thud_world *w, int more) {
    int capacity = td_awake_capacity(w->bodies.live + more);
    for (int i = 0; i < TD_AWAKE_ARRAY_COUNT; i++) {
        if (!td_array_reserve(&w->memory, &w->awake[i], capacity)) {
            return false;
        }
    }
    if (w->body_of.count == 0) {
        td_push_body(&w->body_of, (td_body_index){TD_NONE});
    }
    return true;
}

/* Copies what follows from the body's record to its slot, and keeps the count of damped bodies. */
void td_awake_refresh(thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    if (body->awake.at < 0) {
        return;
    }
    float *reach = td_row(&w->reach, body->awake);
    float *damping = td_row(&w->damping, body->awake);
    w->damped -= damping[0] > 0.0f || damping[1] > 0.0f;
    td_row(&w->velocity, body->awake)[3] = body->inv_mass;
    *td_row(&w->mass, body->awake) = body->mass;
    *td_row(&w->inertia, body->awake) = body->inertia;
    *td_row(&w->gravity_mass, body->awake) = body->mass * body->gravity_scale;
    reach[0] = body->min_extent;
    reach[1] = body->max_extent;
    int lone = body->shape_count == 1 ? body->first_shape : TD_NONE;
    if (lone != TD_NONE && !td_shape_at(w, lone)->centred) {
        lone = TD_NONE;
    }
    td_int_set(&w->lone, body->awake.at, lone);
    damping[0] = body->linear_damping;
    damping[1] = body->angular_damping;
    w->damped += damping[0] > 0.0f || damping[1] > 0.0f;
    w->substep_gain_stale = w->kinetic_stale = true;
}

void td_awake_add(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    td_awake_slot slot = {w->body_of.count};
    td_push_body(&w->body_of, index);
    body->awake = slot;
    float *velocity = td_row(&w->velocity, slot);
    memcpy(velocity, body->velocity, sizeof body->velocity);
    memset(td_row(&w->delta, slot), 0, sizeof(float[4]));
    memset(td_row(&w->damping, slot), 0, sizeof(float[2]));
    *td_row(&w->idle, slot) = 0.0f;
    *td_direct_steps_at(w, slot) = body->direct_steps;
    *td_slow_steps_at(w, slot) = 0;
    *td_colours_at(w, slot) = (td_colours){0, 0};
    td_awake_refresh(w, index);
}

/* Moves a body to another slot: its element of every array, its record, and the lanes of its acting
 * constraints, which hold slots. */
static void move_slot(thud_world *w, td_awake_slot from, td_awake_slot to) {
    for (int i = 0; i < TD_AWAKE_ARRAY_COUNT; i++) {
        const td_array *array = &w->awake[i];
        memcpy(td_at(array, to.at), td_at(array, from.at), (size_t)array->stride);
    }
    td_body *body = td_body_at(w, td_body_of(w, to));
    body->awake = to;
    for (int edge = body->first_constraint; edge != TD_NONE;) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(edge));
        if (constraint->state == TD_TOUCHING) {
            td_lane_refresh(w, td_edge_constraint(edge));
        }
        edge = constraint->next[td_edge_side(edge)];
    }
}

void td_awake_remove(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    td_awake_slot slot = body->awake, last = {w->body_of.count - 1};
    const float *damping = td_row(&w->damping, slot);
    w->damped -= damping[0] > 0.0f || damping[1] > 0.0f;
    memcpy(body->velocity, td_row(&w->velocity, slot), sizeof body->velocity);
    body->direct_steps = *td_direct_steps_at(w, slot);
    body->awake.at = TD_NONE;
    if (slot.at != last.at) {
        move_slot(w, last, slot);
    }
    memset(td_row(&w->velocity, last), 0, sizeof(float[4]));
    w->body_of.count = last.at;
    w->kinetic_stale = true;
}

/* A world without sleep_hooks has no sleeping bodies. The pointer is checked all the same: a forged
 * snapshot may contain some. */
bool td_wake(thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    if (td_may_wake(body) && w->sleep_hooks) {
        return w->sleep_hooks->wake(w, index);
    }
    if (body->awake.at > 0) {
        *td_row(&w->idle, body->awake) = 0.0f;
    }
    return true;
}
