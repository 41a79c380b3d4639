/* constraint.c: see constraint.h. Lists are doubly linked; waiting lists are arrays in which the
 * last element takes the place of one that leaves. */
#include "constraint/constraint.h"

#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"

bool td_constraints_reserve(thud_world *w, const int more[TD_CONSTRAINT_KINDS]) {
    int sum = 0;
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        sum += more[kind];
        if (!td_array_reserve(&w->memory, &w->waiting[kind],
                              w->constraint_count[kind] + more[kind])) {
            return false;
        }
    }
    return td_slots_reserve(&w->memory, &w->constraints, sum);
}

/* Adds an edge to the front of its body's list. */
static void link_edge(thud_world *w, int index, int side) {
    td_constraint *constraint = td_constraint_at(w, index);
    td_body *body = td_body_at(w, constraint->body[side]);
    int edge = td_edge_of(index, side), head = body->first_constraint;
    constraint->next[side] = head;
    constraint->prev[side] = TD_NONE;
    if (head != TD_NONE) {
        td_constraint_at(w, td_edge_constraint(head))->prev[td_edge_side(head)] = edge;
    }
    body->first_constraint = edge;
}

/* Takes an edge out of its body's list. */
static void unlink_edge(thud_world *w, int index, int side) {
    const td_constraint *constraint = td_constraint_at(w, index);
    int next = constraint->next[side], prev = constraint->prev[side];
    if (next != TD_NONE) {
        td_constraint_at(w, td_edge_constraint(next))->prev[td_edge_side(next)] = prev;
    }
    if (prev != TD_NONE) {
        td_constraint_at(w, td_edge_constraint(prev))->next[td_edge_side(prev)] = next;
    } else {
        td_body_at(w, constraint->body[side])->first_constraint = next;
    }
}

void td_constraint_wait(thud_world *w, int index) {
    td_constraint *constraint = td_constraint_at(w, index);
    td_array *waiting = &w->waiting[constraint->kind];
    constraint->state = TD_WAITING;
    constraint->slot = waiting->count;
    td_push_int(waiting, index);
}

/* Takes a constraint out of its kind's waiting list. */
static void leave_waiting(thud_world *w, const td_constraint *constraint) {
    td_array *waiting = &w->waiting[constraint->kind];
    int last = td_int_at(waiting, waiting->count - 1);
    if (TD_HAS_PREFETCH &&
        waiting->count > 8) { /* it will be the last after eight more have left; chosen */
        __builtin_prefetch(td_constraint_at(w, td_int_at(waiting, waiting->count - 9)), 1);
    }
    td_int_set(waiting, constraint->slot, last);
    td_constraint_at(w, last)->slot = constraint->slot;
    waiting->count--;
}

void td_constraint_rest(thud_world *w, int index) {
    td_constraint *constraint = td_constraint_at(w, index);
    leave_waiting(w, constraint);
    constraint->state = TD_RESTING;
    constraint->slot = TD_NONE;
}

int td_constraint_create(thud_world *w, int kind, td_body_index body_a, td_body_index body_b) {
    int index = td_slots_take(&w->constraints);
    td_constraint *constraint = td_constraint_at(w, index);
    *constraint = (td_constraint){.shape_a = TD_NONE,
                                  .shape_b = TD_NONE,
                                  .body = {body_a, body_b},
                                  .joint = TD_NONE,
                                  .kind = (uint8_t)kind,
                                  .live = 1};
    link_edge(w, index, 0);
    link_edge(w, index, 1);
    w->constraint_count[kind]++;
    td_constraint_wait(w, index);
    return index;
}

void td_constraint_destroy(thud_world *w, int index) {
    td_constraint *constraint = td_constraint_at(w, index);
    if (constraint->state == TD_TOUCHING) {
        td_lane_remove(w, index);
    } else if (constraint->state == TD_WAITING) {
        leave_waiting(w, constraint);
    }
    unlink_edge(w, index, 0);
    unlink_edge(w, index, 1);
    w->constraint_count[constraint->kind]--;
    if (!td_is_contact(constraint)) {
        w->joint_hooks->remove_part(w, constraint->joint, index);
    }
    constraint->live = 0;
    td_slots_give(&w->constraints, index);
}
