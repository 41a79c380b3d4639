/* resolve_island.c: solves an island after the soft solver has already moved it; see
 * joint_islands.h.
 */
#include "direct/joint_islands.h"

#include "direct/elimination_order.h"

#include <string.h>

/* Finds the elimination order. False where the factor would be too large. */
static bool order(thud_world *w, td_island *island) {
    td_islands *s = &w->islands;
    int first = s->topology.count;
    td_island_list_ties(w, island);
    const int *ties = (const int *)s->topology.data + first;
    bool ordered = td_island_order(w, island, ties, TD_RESOLVE_ENTRIES_MAX);
    s->topology.count = first;
    island->system = s->matrix.now;
    return ordered;
}

/* Of this step only the soft solver's impulses are known, which serve as the warm start. */
bool td_joint_island_begin(thud_world *w, td_island *island) {
    td_islands *s = &w->islands;
    if (island->bodies > TD_RESOLVE_BODIES_MAX ||
        island->constraints > TD_RESOLVE_CONSTRAINTS_MAX || !order(w, island)) {
        return false;
    }
    for (int i = island->first_body; i < s->slots.count; i++) {
        memcpy(td_at(&s->before, i), td_row(&s->start, td_slot_in(&s->slots, i)), sizeof(float[4]));
    }
    for (int i = island->first_constraint; i < s->constraints.count; i++) {
        td_island_store_impulses(w, i, 1.0f);
    }
    return true;
}

void td_joint_island_solve(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    bool solved = td_island_solve(w, island);
    for (int i = 0; i < island->bodies && !solved; i++) {
        td_awake_slot slot = td_slot_in(&s->slots, island->first_body + i);
        *td_island_local_at(w, slot) = TD_ISLAND_REFUSED;
    }
}
