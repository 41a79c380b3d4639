/* label.c: union-find over the constraints that act; see label.h. */
#include "islands/label.h"

#include "constraint/lanes.h"

bool td_join_trees(td_awake_slot *parents, td_awake_slot a, td_awake_slot b) {
    a = td_root_of(parents, a);
    b = td_root_of(parents, b);
    if (a.at < b.at) {
        parents[b.at] = a;
    } else {
        parents[a.at] = b;
    }
    return a.at != b.at;
}

static bool is_dynamic(const thud_world *w, td_awake_slot slot) {
    return td_body_at(w, td_body_of(w, slot))->kind == THUD_BODY_DYNAMIC;
}

static bool moves(const thud_world *w, td_awake_slot slot) {
    const float *v = td_row(&w->velocity, slot);
    return v[0] != 0.0f || v[1] != 0.0f || v[2] != 0.0f;
}

/* Unites the islands of two bodies that a constraint joins, if both are dynamic. With `keeps`
 * (keep_awake of td_islands_label), the idle time of a body that is joined to a moving kinematic
 * body becomes 0. Slot 0 stands for all static bodies. */
static void join_islands(thud_world *w, td_awake_slot *parents, td_awake_slot a, td_awake_slot b,
                         bool keeps) {
    if (a.at == 0 || b.at == 0) {
        return;
    }
    bool dynamic_a = is_dynamic(w, a), dynamic_b = is_dynamic(w, b);
    if (dynamic_a && dynamic_b) {
        td_join_trees(parents, a, b);
    } else if (keeps && moves(w, dynamic_a ? b : a)) {
        *td_row(&w->idle, dynamic_a ? a : b) = 0.0f;
    }
}

bool td_islands_label(thud_world *w, bool keep_awake) {
    td_array *parents = &w->scratch.parents;
    if (!td_array_reserve(&w->memory, parents, w->body_of.count)) {
        return false;
    }
    td_awake_slot *parent = parents->data;
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parent[slot.at] = slot;
    }
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, i);
        if (constraint->state == TD_TOUCHING && constraint->bin != TD_SLEEPING &&
            constraint->live) {
            td_lane at = td_lane_of(w, constraint);
            join_islands(w, parent, td_slot_of_side(at.block->a[at.lane]),
                         td_slot_of_side(at.block->b[at.lane]), keep_awake);
        }
    }
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        parent[slot.at] = td_root_of(parent, slot);
    }
    return true;
}
