/* awake.c: see awake.h. The last body fills the hole that a leaving one makes. */
#include "state/awake.h"

#include "constraint/lanes.h"

#include <string.h>

/* The arrays that a body has a place in. */
#define BY_SLOT(w)                                                                                \
    &(w)->velocity, &(w)->delta, &(w)->start, &(w)->push, &(w)->damping, &(w)->idle, &(w)->reach, \
        &(w)->mass, &(w)->inertia, &(w)->weight, &(w)->body_of, &(w)->lone, &(w)->colours,        \
        &(w)->direct_steps, &(w)->slow_steps

bool td_awake_reserve(thud_world *w, int more) {
    /* The wide kernels work on whole eights, so a last partial one must exist in memory. */
    int capacity = w->bodies.live + more + 1 + TD_LANES;
    td_array *arrays[] = {BY_SLOT(w)};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        if (!td_array_reserve(&w->memory, arrays[i], capacity)) {
            return false;
        }
    }
    if (w->body_of.count == 0) {
        td_push_int(&w->body_of, TD_NONE);
    }
    return true;
}

void td_awake_refresh(thud_world *w, int index) {
    const td_body *body = td_body_at(w, index);
    if (body->awake < 0) {
        return;
    }
    float *reach = td_row(&w->reach, body->awake);
    float *damping = td_row(&w->damping, body->awake);
    w->damped -= damping[0] > 0.0f || damping[1] > 0.0f;
    td_row(&w->velocity, body->awake)[3] = body->inv_mass;
    *td_row(&w->mass, body->awake) = body->mass;
    *td_row(&w->inertia, body->awake) = body->inertia;
    *td_row(&w->weight, body->awake) = body->mass * body->gravity_scale;
    reach[0] = body->core;
    reach[1] = body->rim;
    int lone = body->shape_count == 1 ? body->first_shape : TD_NONE;
    if (lone != TD_NONE && !td_shape_at(w, lone)->plain) {
        lone = TD_NONE;
    }
    *(int *)td_at(&w->lone, body->awake) = lone;
    damping[0] = body->linear_damping;
    damping[1] = body->angular_damping;
    w->damped += damping[0] > 0.0f || damping[1] > 0.0f;
    w->push_stale = w->kinetic_stale = true;
}

void td_awake_add(thud_world *w, int index) {
    td_body *body = td_body_at(w, index);
    int slot = w->body_of.count;
    td_push_int(&w->body_of, index);
    body->awake = slot;
    float *velocity = td_row(&w->velocity, slot);
    memcpy(velocity, body->velocity, sizeof body->velocity);
    memset(td_row(&w->delta, slot), 0, sizeof(float[4]));
    memset(td_row(&w->damping, slot), 0, sizeof(float[2]));
    *td_row(&w->idle, slot) = 0.0f;
    *(uint8_t *)td_at(&w->direct_steps, slot) = body->direct_steps;
    *(uint16_t *)td_at(&w->slow_steps, slot) = 0;
    *(td_colours *)td_at(&w->colours, slot) = (td_colours){0, 0};
    td_awake_refresh(w, index);
}

static void move_slot(thud_world *w, int from, int to) {
    td_array *arrays[] = {BY_SLOT(w)};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        memcpy(td_at(arrays[i], to), td_at(arrays[i], from), (size_t)arrays[i]->stride);
    }
    td_body *body = td_body_at(w, *(int *)td_at(&w->body_of, to));
    body->awake = to;
    for (int edge = body->first_contact; edge != TD_NONE;) {
        const td_constraint *constraint = td_constraint_at(w, edge / 2);
        if (constraint->state == TD_TOUCHING) {
            td_lane_refresh(w, edge / 2);
        }
        edge = constraint->next[edge & 1];
    }
}

void td_awake_remove(thud_world *w, int index) {
    td_body *body = td_body_at(w, index);
    int slot = body->awake, last = w->body_of.count - 1;
    const float *damping = td_row(&w->damping, slot);
    w->damped -= damping[0] > 0.0f || damping[1] > 0.0f;
    memcpy(body->velocity, td_row(&w->velocity, slot), sizeof body->velocity);
    body->direct_steps = *(uint8_t *)td_at(&w->direct_steps, slot);
    body->awake = TD_NONE;
    if (slot != last) {
        move_slot(w, last, slot);
    }
    memset(td_row(&w->velocity, last), 0, sizeof(float[4]));
    w->body_of.count = last;
    w->kinetic_stale = true;
}
