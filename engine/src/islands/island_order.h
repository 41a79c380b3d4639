/* island_order.h: the order in which the bodies of islands are eliminated. */
#ifndef TD_ISLAND_ORDER_H
#define TD_ISLAND_ORDER_H

#include "state/world.h"

/* Room from the start for what is usual, so that a world settles into what it has; false when
 * memory is short. */
bool td_islands_room(thud_world *w, td_array *array, int count);

/* A body's number in its island, from 1, or one of the values that tell why it has none. */
static inline int *td_island_local_at(const thud_world *w, td_awake_slot slot) {
    return TD_AT(int, &w->islands.local, slot.at);
}

/* The number of a body in the island, from 0; TD_NONE where it is none of its bodies. */
static inline int td_island_number(const thud_world *w, const td_island *island,
                                   td_awake_slot slot) {
    int number = *td_island_local_at(w, slot) - 1;
    bool is_in = number >= 0 && number < island->bodies &&
                 td_slot_in(&w->islands.slots, island->first_body + number).at == slot.at;
    return is_in ? number : TD_NONE;
}

/* Adds a body to the island that is being listed, which has room. */
static inline void td_island_add(thud_world *w, td_island *island, td_awake_slot slot) {
    td_push_slot(&w->islands.slots, slot);
    *td_island_local_at(w, slot) = ++island->bodies;
}

/* The awake slot of a dynamic body on the other side of a constraint, or 0. */
td_awake_slot td_island_neighbour(const thud_world *w, const td_constraint *constraint, int side);
/* Adds the pairs of bodies that constraints tie, by their numbers in the island, to
 * td_islands.shape, which has room: two ints a constraint, TD_NONE where it ties none. */
void td_island_list_ties(thud_world *w, const td_island *island);
/* Orders the island by these pairs, as a further system. False when memory is short, or when it
 * would fill in more blocks than `most`. */
bool td_island_order(thud_world *w, const td_island *island, const int *ties, int most);
/* Orders the islands that are listed, and makes room for solving them; false when memory is short.
 */
bool td_islands_order(thud_world *w);

#endif
