/* elimination_order.h: bodies of islands by number, and the order in which a factorisation
 * eliminates them. */
#ifndef TD_ELIMINATION_ORDER_H
#define TD_ELIMINATION_ORDER_H

#include "state/world.h"

/* Reserves at least 64 elements, so that arrays of small islands do not grow step by step. False
 * when memory is short. */
bool td_islands_reserve(thud_world *w, td_array *array, int count);

/* A body's number in its island, from 1. Zero and negative values say why it has none:
 * td_islands.local. */
static inline int *td_island_local_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(int, &w->islands.local, slot.at);
}

/* The number of a body in this island, from 0, or TD_NONE where it is not in it. */
static inline int td_island_number(const thud_world *w, const td_island *island,
                                   td_awake_slot slot) {
    int number = *td_island_local_at(w, slot) - 1;
    bool is_in = number >= 0 && number < island->bodies &&
                 td_slot_in(&w->islands.slots, island->first_body + number).at == slot.at;
    return is_in ? number : TD_NONE;
}

/* Adds a body to the island that is being listed; td_islands.slots must have room. */
static inline void td_island_add(thud_world *w, td_island *island, td_awake_slot slot) {
    td_push_slot(&w->islands.slots, slot);
    *td_island_local_at(w, slot) = ++island->bodies;
}

/* The awake slot of the body on the other side of a constraint; slot 0 where that body is not
 * dynamic, or asleep. `side`: 0 or 1, the side that is known. */
td_awake_slot td_island_neighbour(const thud_world *w, const td_constraint *constraint, int side);
/* Appends the pairs of bodies that the island's constraints join, by their numbers in the island,
 * to td_islands.topology, which must have room: two ints for each constraint, both TD_NONE if
 * either body is not in the island. */
void td_island_list_ties(thud_world *w, const td_island *island);
/* Orders the island by these pairs, as a further system of td_islands.matrix. False when memory is
 * short, or when the factor would have more than `entries_max` blocks below its diagonal. */
bool td_island_order(thud_world *w, const td_island *island, const int *ties, int entries_max);
/* Orders all islands that are listed, and reserves memory for solving them. False when memory is
 * short. */
bool td_islands_order(thud_world *w);

#endif
