/* resolve_island.c: solves an island directly that was not listed before the soft solver ran: the
 * islands 2. and the linkages 3. of joint_islands.h. The soft solver has already moved its bodies;
 * the direct solve starts again from the velocities at the start of the step. */
#include "direct/joint_islands.h"

#include "direct/elimination_order.h"

#include <string.h>

/* Finds the elimination order, as a further system of td_islands.matrix. False where the factor
 * would be too large. The pairs of bodies that constraints join are appended to td_islands.topology
 * and removed again, since room is reserved for the pairs of one island only. */
static bool find_elimination_order(thud_world *w, td_island *island) {
    td_islands *s = &w->islands;
    int first = s->topology.count;
    td_island_list_ties(w, island);
    const int *ties = (const int *)s->topology.data + first;
    bool ordered = td_island_order(w, island, ties, TD_RESOLVE_ENTRIES_MAX);
    island->system = s->matrix.current; /* which td_island_order has added */
    s->topology.count = first;
    return ordered;
}

/* The warm start is the soft solver's: the direct solver's own impulses are stored by
 * td_island_store_start before the soft solver runs, when this island was not listed yet. */
bool td_joint_island_begin(thud_world *w, td_island *island) {
    td_islands *s = &w->islands;
    if (island->bodies > TD_RESOLVE_BODIES_MAX ||
        island->constraints > TD_RESOLVE_CONSTRAINTS_MAX || !find_elimination_order(w, island)) {
        return false;
    }
    for (int i = island->first_body; i < island->first_body + island->bodies; i++) {
        const float *velocity = td_row(&s->start_velocity, td_slot_in(&s->slots, i));
        memcpy(td_at(&s->island_start_velocity, i), velocity, sizeof(float[4]));
    }
    int end = island->first_constraint + island->constraints;
    for (int i = island->first_constraint; i < end; i++) {
        td_island_store_impulses(w, i, true);
    }
    return true;
}

void td_joint_island_solve(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    if (td_island_solve(w, island)) {
        return;
    }
    for (int i = 0; i < island->bodies; i++) {
        td_awake_slot slot = td_slot_in(&s->slots, island->first_body + i);
        *td_island_local_at(w, slot) =
            TD_ISLAND_REFUSED; /* this value replaces the body's number in the island, which is not
                                  needed any more */
    }
}
