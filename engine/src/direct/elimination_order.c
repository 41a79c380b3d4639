/* elimination_order.c: the elimination order of each island's bodies. It depends only on the
 * island's graph (the number of bodies, and which of them constraints join), so that it is kept
 * until the graph changes. */
#include "direct/elimination_order.h"

#include "constraint/constraint.h"

#include <limits.h>
#include <string.h>

bool td_islands_reserve(thud_world *w, td_array *array, int count) {
    return td_array_reserve(&w->memory, array, td_max_int(count, 64));
}

td_awake_slot td_island_neighbour(const thud_world *w, const td_constraint *constraint, int side) {
    const td_body *other = td_body_at(w, constraint->body[1 - side]);
    bool moves = other->kind == THUD_BODY_DYNAMIC && other->awake.at > 0;
    return moves ? other->awake : (td_awake_slot){0};
}

void td_island_list_ties(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    for (int i = 0; i < island->constraints; i++) {
        const td_constraint *constraint =
            td_constraint_at(w, td_int_at(&s->constraints, island->first_constraint + i));
        td_awake_slot a = td_island_neighbour(w, constraint, 1),
                      b = td_island_neighbour(w, constraint, 0);
        int first = a.at ? td_island_number(w, island, a) : TD_NONE;
        int second = b.at ? td_island_number(w, island, b) : TD_NONE;
        bool tied = first != TD_NONE && second != TD_NONE;
        td_push_int(&s->topology, tied ? first : TD_NONE);
        td_push_int(&s->topology, tied ? second : TD_NONE);
    }
}

/* Lists the number of bodies of each island and the pairs that constraints join, which determine
 * the orders. False when memory is short. */
static bool list_topology(thud_world *w) {
    td_islands *s = &w->islands;
    if (!td_islands_reserve(w, &s->topology, 2 * (s->island.count + s->constraints.count))) {
        return false;
    }
    s->topology.count = 0;
    for (int n = 0; n < s->island.count; n++) {
        const td_island *island = TD_AT(td_island, &s->island, n);
        td_push_int(&s->topology, island->bodies);
        td_push_int(&s->topology, island->constraints);
        td_island_list_ties(w, island);
    }
    return true;
}

/* Whether the graphs of all islands are the same as when the present orders were found. */
static bool is_same_topology(const td_islands *s) {
    return s->topology.count == s->topology_before.count && s->topology.count &&
           memcmp(s->topology.data, s->topology_before.data,
                  (size_t)s->topology.count * sizeof(int)) == 0;
}

bool td_island_order(thud_world *w, const td_island *island, const int *ties, int entries_max) {
    td_islands *s = &w->islands;
    if (!td_sparse_begin(&w->memory, &s->matrix, island->bodies)) {
        return false;
    }
    for (int i = 0; i < island->constraints; i++) {
        if (ties[2 * i] != TD_NONE) {
            td_sparse_tie(&s->matrix, ties[2 * i], ties[2 * i + 1]);
        }
    }
    return td_sparse_order(&w->memory, &s->matrix, entries_max);
}

/* Finds the order of every island, or keeps those of the last step where no graph has changed.
 * False when memory is short. */
static bool order_all(thud_world *w) {
    td_islands *s = &w->islands;
    if (!list_topology(w) || !td_islands_reserve(w, &s->systems, s->island.count)) {
        return false;
    }
    if (is_same_topology(s)) {
        return true;
    }
    s->topology_before.count = 0; /* marks the orders as invalid in case this function fails */
    td_sparse_forget(&s->matrix);
    const int *topology = s->topology.data;
    for (int i = 0; i < s->island.count; i++) {
        const td_island *island = TD_AT(td_island, &s->island, i);
        if (!td_island_order(w, island, topology + 2, INT_MAX)) {
            return false;
        }
        *TD_AT(td_system, &s->systems, i) = s->matrix.current;
        topology += 2 + 2 * island->constraints;
    }
    if (!td_islands_reserve(w, &s->topology_before, s->topology.count)) {
        return false;
    }
    memcpy(s->topology_before.data, s->topology.data, (size_t)s->topology.count * sizeof(int));
    s->topology_before.count = s->topology.count;
    return true;
}

bool td_islands_order(thud_world *w) {
    td_islands *s = &w->islands;
    if (!order_all(w)) {
        return false;
    }
    for (int i = 0; i < s->island.count; i++) {
        td_island *island = TD_AT(td_island, &s->island, i);
        island->system = *TD_AT(td_system, &s->systems, i);
        if (!td_islands_reserve(w, &s->rows, island->constraints) ||
            !td_islands_reserve(w, &s->bodies, island->bodies) ||
            !td_islands_reserve(w, &s->step, island->bodies) ||
            !td_islands_reserve(w, &s->work, island->bodies)) {
            return false;
        }
    }
    return true;
}
