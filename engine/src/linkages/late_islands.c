/* late_islands.c: islands whose joints have just given way under the soft solver. They are solved
 * directly in the same step, from where it began, so that nothing is open before it holds. */
#include "constraint/constraint.h"
#include "constraint/joining.h"
#include "islands/island_order.h"
#include "islands/island_solve.h"

#include <string.h>

/* The room that they need is there beforehand, since no step fails once it has begun to move
 * bodies. What needs more is solved directly from the next step on. */
enum { BODIES_MOST = 128, CONSTRAINTS_MOST = 512, ENTRIES_MOST = 8 * BODIES_MOST };

/* A system of the greatest size is begun, and forgotten. */
static bool reserve_system(thud_world *w) {
    td_sparse *s = &w->islands.matrix;
    td_memory *memory = &w->memory;
    td_system now = s->now;
    bool room = td_sparse_reserve(memory, s, w->body_of.count + BODIES_MOST) &&
                td_sparse_begin(memory, s, BODIES_MOST);
    s->now = now;
    return room && td_array_reserve(memory, &s->row, s->row.count + ENTRIES_MOST) &&
           td_array_reserve(memory, &s->entry, ENTRIES_MOST);
}

bool td_late_reserve(thud_world *w) {
    td_islands *s = &w->islands;
    td_memory *memory = &w->memory;
    return td_array_reserve(memory, &s->start, w->body_of.count) &&
           td_islands_room(w, &s->rows, CONSTRAINTS_MOST) &&
           td_islands_room(w, &s->bodies, BODIES_MOST) &&
           td_islands_room(w, &s->step, BODIES_MOST) && td_islands_room(w, &s->work, BODIES_MOST) &&
           reserve_system(w);
}

void td_late_note(thud_world *w) {
    memcpy(w->islands.start.data, w->velocity.data, (size_t)w->body_of.count * sizeof(float[4]));
}

/* ---- which ---- */

static bool is_late(const thud_world *w, td_awake_slot slot) {
    return *td_direct_steps_at(w, slot) == TD_DIRECT_STEPS &&
           td_row(&w->velocity, slot)[3] > 0.0f && *TD_AT(int, &w->islands.local, slot.at) == 0;
}

static bool has_joints(const thud_world *w, const td_island *island) {
    bool any = false;
    for (int i = 0; i < island->constraints && !any; i++) {
        int index = td_int_at(&w->islands.constraints, island->first_constraint + i);
        any = !td_is_contact(td_constraint_at(w, index));
    }
    return any;
}

/* In an order of its own, behind those that were found before the soft solver. */
static bool order(thud_world *w, td_island *island) {
    td_islands *s = &w->islands;
    if (!td_sparse_begin(&w->memory, &s->matrix, island->bodies)) {
        return false;
    }
    for (int i = 0; i < island->constraints; i++) {
        const td_constraint *constraint =
            td_constraint_at(w, td_int_at(&s->constraints, island->first_constraint + i));
        td_awake_slot a = td_island_neighbour(w, constraint, 1),
                      b = td_island_neighbour(w, constraint, 0);
        if (a.at && b.at) {
            td_sparse_tie(&s->matrix, td_int_at(&s->local, a.at) - 1,
                          td_int_at(&s->local, b.at) - 1);
        }
    }
    bool ordered = td_sparse_order(&w->memory, &s->matrix, ENTRIES_MOST);
    island->system = s->matrix.now;
    return ordered;
}

/* ---- what there was ---- */

/* Velocities of the start; impulses can only be guessed from those of the soft solver. */
static void recall(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    for (int i = island->first_body; i < s->slots.count; i++) {
        memcpy(td_at(&s->before, i), td_row(&s->start, td_slot_in(&s->slots, i)), sizeof(float[4]));
    }
    float steps = (float)w->substeps;
    for (int i = island->first_constraint; i < s->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, td_int_at(&s->constraints, i));
        td_lane at = td_lane_of(w, constraint);
        float *impulses = td_at(&s->impulses, i);
        for (int k = 0; k < td_island_points(w, constraint); k++) {
            impulses[k] = steps * at.block->point[k].normal_impulse[at.lane];
        }
        impulses[TD_DIRECT_TANGENT] = steps * at.block->tangent_impulse[at.lane];
        impulses[TD_DIRECT_ROWS] = 1.0f;
    }
}

/* Lists are as they were afterwards where its island is not to be solved now. */
static void solve_one(thud_world *w, td_awake_slot slot) {
    td_islands *s = &w->islands;
    int islands = s->island.count, rows = s->matrix.row.count;
    td_islands_follow(w, slot);
    if (s->island.count == islands) {
        return;
    }
    td_island *island = TD_AT(td_island, &s->island, islands);
    if (island->bodies <= BODIES_MOST && island->constraints <= CONSTRAINTS_MOST &&
        has_joints(w, island) && order(w, island)) {
        recall(w, island);
        td_island_solve(w, island);
    }
    s->matrix.row.count = rows;
}

void td_late_solve(thud_world *w) {
    td_islands *s = &w->islands;
    int islands = s->island.count;
    td_system last = islands ? TD_AT(td_island, &s->island, islands - 1)->system : (td_system){0};
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (is_late(w, slot)) {
            s->matrix.now = last;
            solve_one(w, slot);
        }
    }
}
