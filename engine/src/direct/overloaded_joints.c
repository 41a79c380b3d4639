/* overloaded_joints.c: islands in which td_islands_mark_loaded has found a joint that is overloaded
 * in this step. They are solved directly in the same step, from its start, so that the joint never
 * opens. */
#include "direct/joint_islands.h"

#include "constraint/constraint.h"
#include "direct/elimination_order.h"

/* Whether the island of a body was marked as direct in this step (thud_world.direct_steps is
 * TD_DIRECT_STEPS) and has not been listed yet. */
static bool is_newly_marked(const thud_world *w, td_awake_slot slot) {
    return *td_direct_steps_at(w, slot) == TD_DIRECT_STEPS && td_inv_mass_of(w, slot) > 0.0f &&
           *td_island_local_at(w, slot) == 0;
}

static bool has_joints(const thud_world *w, const td_island *island) {
    bool any = false;
    for (int i = 0; i < island->constraints && !any; i++) {
        int index = td_int_at(&w->islands.constraints, island->first_constraint + i);
        any = !td_is_contact(td_constraint_at(w, index));
    }
    return any;
}

/* Solves the island of a body. The island stays in the lists, so that its other bodies are not
 * visited again; its elimination order is dropped. */
static void solve_one(thud_world *w, td_awake_slot slot) {
    td_islands *s = &w->islands;
    int islands = s->island.count, rows = s->matrix.row.count;
    td_islands_list_from(w, slot);
    if (s->island.count == islands) {
        return;
    }
    td_island *island = TD_AT(td_island, &s->island, islands);
    if (has_joints(w, island) && td_joint_island_begin(w, island)) {
        td_joint_island_solve(w, island);
    }
    s->matrix.row.count = rows;
}

void td_overloaded_islands_solve(thud_world *w, td_system last) {
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (is_newly_marked(w, slot)) {
            w->islands.matrix.current = last;
            solve_one(w, slot);
        }
    }
}
