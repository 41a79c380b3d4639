/* sleep.c: islands fall asleep and wake as a whole.
 *
 * An island is what constraints that act between dynamic bodies connect. Islands are only worked
 * out when a body has been at rest for long enough, and then at most every eighth step: a world in
 * which nothing rests pays nothing. The lanes of a sleeping island are asleep, with their impulses,
 * in bins that no stage visits. */
#include "state/awake.h"
#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "state/shape.h"
#include "api/step.h"

#include <string.h>

static int other_body(const thud_world *w, int edge) {
    return td_constraint_at(w, edge / 2)->body[1 - (edge & 1)];
}

static bool may_wake(const td_body *body) {
    return body->kind == THUD_DYNAMIC && body->awake < 0 &&
           !(body->flags & (TD_BODY_QUARANTINED | TD_BODY_DISABLED)) &&
           !(body->changes & TD_CHANGE_ENTER);
}

static bool lists_room(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.bodies, w->bodies.count) &&
           td_array_reserve(&w->memory, &w->scratch.contacts, w->contacts.count);
}

/* Shapes of a body that slept while others came to rest near it look for them. */
static void look_around(thud_world *w, int index) {
    const td_body *body = td_body_at(w, index);
    if (body->rest_epoch == w->rest_epoch) {
        return;
    }
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_mark_moved(w, i);
        *td_marks_at(w, i) |= TD_MARK_WOKEN;
    }
}

bool td_wake(thud_world *w, int index) {
    td_array *bodies = &w->scratch.bodies, *constraints = &w->scratch.contacts;
    if (!may_wake(td_body_at(w, index))) {
        td_body *body = td_body_at(w, index);
        if (body->awake > 0) {
            *td_row(&w->idle, body->awake) = 0.0f;
        }
        return true;
    }
    if (!lists_room(w)) {
        return false;
    }
    bodies->count = constraints->count = 0;
    td_awake_add(w, index);
    td_push_int(bodies, index);
    for (int i = 0; i < bodies->count; i++) {
        int body = *(int *)td_at(bodies, i);
        for (int e = td_body_at(w, body)->first_contact; e != TD_NONE; e = td_next_edge(w, e)) {
            td_constraint *constraint = td_constraint_at(w, e / 2);
            if (constraint->state != TD_TOUCHING || constraint->bin != TD_SLEEPING ||
                constraint->listed) {
                continue;
            }
            constraint->listed = 1;
            td_push_int(constraints, e / 2);
            int other = other_body(w, e);
            if (may_wake(td_body_at(w, other))) {
                td_awake_add(w, other);
                td_push_int(bodies, other);
            }
        }
    }
    for (int i = 0; i < constraints->count; i++) {
        td_constraint_at(w, *(int *)td_at(constraints, i))->listed = 0;
    }
    if (!td_lanes_place(w, constraints->data, constraints->count, false)) {
        for (int i = bodies->count - 1; i >= 0; i--) {
            td_awake_remove(w, *(int *)td_at(bodies, i));
        }
        return false;
    }
    for (int i = 0; i < bodies->count; i++) {
        int body = *(int *)td_at(bodies, i);
        for (int e = td_body_at(w, body)->first_contact; e != TD_NONE; e = td_next_edge(w, e)) {
            if (td_constraint_at(w, e / 2)->state == TD_RESTING) {
                td_constraint_wait(w, e / 2);
            }
        }
        look_around(w, body);
    }
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    return true;
}

/* ---- falling asleep ---- */

static int find_root(int *parents, int i) {
    while (parents[i] != i) {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    return i;
}

static void join(int *parents, int a, int b) {
    a = find_root(parents, a);
    b = find_root(parents, b);
    /* The lower slot leads, so that roots do not depend on the order of contacts. */
    if (a < b) {
        parents[b] = a;
    } else {
        parents[a] = b;
    }
}

static bool is_dynamic(const thud_world *w, int slot) {
    return td_body_at(w, *(int *)td_at(&w->body_of, slot))->kind == THUD_DYNAMIC;
}

static bool moves(const thud_world *w, int slot) {
    const float *v = td_row(&w->velocity, slot);
    return v[0] != 0.0f || v[1] != 0.0f || v[2] != 0.0f;
}

/* A lane ties two dynamic bodies together; a moving kinematic body keeps its neighbour awake. */
static void tie(thud_world *w, int *parents, int a, int b) {
    if (a == 0 || b == 0) {
        return;
    }
    bool dynamic_a = is_dynamic(w, a), dynamic_b = is_dynamic(w, b);
    if (dynamic_a && dynamic_b) {
        join(parents, a, b);
    } else if (moves(w, dynamic_a ? b : a)) {
        *td_row(&w->idle, dynamic_a ? a : b) = 0.0f;
    }
}

bool td_islands_label(thud_world *w) {
    td_array *parents = &w->scratch.parents;
    if (!td_array_reserve(&w->memory, parents, w->body_of.count)) {
        return false;
    }
    int *parent = parents->data;
    for (int i = 0; i < w->body_of.count; i++) {
        parent[i] = i;
    }
    for (int i = 0; i < w->contacts.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, i);
        if (constraint->state == TD_TOUCHING && constraint->bin != TD_SLEEPING &&
            constraint->live) {
            const td_block *block = td_block_at(w, constraint->kind, constraint->slot / TD_LANES);
            int lane = constraint->slot % TD_LANES;
            tie(w, parent, (int)(block->a[lane] / TD_AWAKE_BYTES),
                (int)(block->b[lane] / TD_AWAKE_BYTES));
        }
    }
    for (int i = 1; i < w->body_of.count; i++) {
        parent[i] = find_root(parent, i);
    }
    return true;
}

/* Puts the bodies listed to sleep; false, and nothing has changed, when memory is short. */
static bool put_to_sleep(thud_world *w) {
    td_array *bodies = &w->scratch.bodies, *constraints = &w->scratch.contacts;
    constraints->count = 0;
    for (int i = 0; i < bodies->count; i++) {
        int e = td_body_at(w, *(int *)td_at(bodies, i))->first_contact;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            td_constraint *constraint = td_constraint_at(w, e / 2);
            if (constraint->state == TD_TOUCHING && !constraint->listed) {
                constraint->listed = 1;
                td_push_int(constraints, e / 2);
            }
        }
    }
    for (int i = 0; i < constraints->count; i++) {
        td_constraint_at(w, *(int *)td_at(constraints, i))->listed = 0;
    }
    if (!td_lanes_place(w, constraints->data, constraints->count, true)) {
        return false;
    }
    for (int i = 0; i < bodies->count; i++) {
        int index = *(int *)td_at(bodies, i);
        td_body *body = td_body_at(w, index);
        td_awake_remove(w, index);
        memset(body->velocity, 0, sizeof body->velocity);
    }
    for (int i = 0; i < bodies->count; i++) {
        td_body *body = td_body_at(w, *(int *)td_at(bodies, i));
        for (int e = body->first_contact; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_body *other = td_body_at(w, other_body(w, e));
            if (td_constraint_at(w, e / 2)->state == TD_WAITING && other->awake < 0) {
                td_constraint_rest(w, e / 2);
            }
        }
    }
    w->rest_epoch++;
    for (int i = 0; i < bodies->count; i++) {
        /* In a crowd, pairs may be missing: who wakes looks around. */
        td_body_at(w, *(int *)td_at(bodies, i))->rest_epoch =
            w->rest_epoch - (w->scratch.crowded.count > 0);
    }
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
    return true;
}

static bool is_due(const thud_world *w, int bodies) {
    return w->def.sleeping && bodies > 0 && w->steps % 8 == 0;
}

bool td_sleep_reserve(thud_world *w) {
    /* A body that enters or wakes has not been counted: a long step by itself may be enough for it.
     */
    bool long_step = (float)w->def.time_step >= TD_SLEEP_TIME;
    /* Room for sleeping lanes may move the blocks, so they are listed again. */
    return !is_due(w, long_step ? w->body_of.count : w->drowsy_bodies) ||
           (lists_room(w) && td_lanes_reserve_sleeping(w) && td_lanes_sequence(w) &&
            td_array_reserve(&w->memory, &w->scratch.parents, w->body_of.count));
}

void td_sleep(thud_world *w) {
    if (!is_due(w, w->idle_bodies) || !td_islands_label(w)) {
        return;
    }
    const int *root = w->scratch.parents.data;
    /* The least idle time of an island, kept at its root's slot; a restless body keeps it up. */
    for (int i = 1; i < w->body_of.count; i++) {
        const td_body *body = td_body_at(w, *(int *)td_at(&w->body_of, i));
        float *least = td_row(&w->idle, root[i]);
        float own = body->flags & TD_BODY_RESTLESS || body->kind != THUD_DYNAMIC
                        ? 0.0f
                        : *td_row(&w->idle, i);
        *least = td_min_float(*least, own);
    }
    w->scratch.bodies.count = 0;
    for (int i = 1; i < w->body_of.count; i++) {
        if (*td_row(&w->idle, root[i]) >= TD_SLEEP_TIME) {
            td_push_int(&w->scratch.bodies, *(int *)td_at(&w->body_of, i));
        }
    }
    if (w->scratch.bodies.count) {
        put_to_sleep(w);
    }
}
