/* joint_islands.c: see joint_islands.h. */
#include "direct/joint_islands.h"

#include "direct/elimination_order.h"
#include "solver/error.h"

#include <string.h>

/* ---- before the soft solver ---- */

/* A system of the greatest size is begun, and forgotten. */
static bool reserve_system(thud_world *w) {
    td_sparse *s = &w->islands.matrix;
    td_memory *memory = &w->memory;
    td_system now = s->now;
    bool room = td_sparse_reserve(memory, s, w->body_of.count + TD_LATE_BODIES) &&
                td_sparse_begin(memory, s, TD_LATE_BODIES);
    s->now = now;
    return room && td_array_reserve(memory, &s->row, s->row.count + TD_LATE_ENTRIES) &&
           td_array_reserve(memory, &s->entry, TD_LATE_ENTRIES);
}

static bool find(thud_world *w) {
    td_islands *s = &w->islands;
    return td_islands_find(w) && td_array_reserve(&w->memory, &s->start, w->body_of.count) &&
           td_islands_room(w, &s->topology, s->topology.count + 2 * TD_LATE_CONSTRAINTS) &&
           td_islands_room(w, &s->rows, TD_LATE_CONSTRAINTS) &&
           td_islands_room(w, &s->bodies, TD_LATE_BODIES) &&
           td_islands_room(w, &s->step, TD_LATE_BODIES) &&
           td_islands_room(w, &s->work, TD_LATE_BODIES) && reserve_system(w);
}

/* Effort of islands with joints in a step, in operations of some 7 ns each, whatever their quality
 * allows: loops that are stretched may take any number of Newton steps, and a matrix in which each
 * body is tied to many takes the cube of their number. It is EFFORT_OF_BODY for each body of the
 * world, or of MANY bodies where there are fewer. */
enum { EFFORT_OF_BODY = 4000, MANY = 1000 };

static void begin(thud_world *w) {
    td_islands_begin(w);
    w->islands.effort = (int64_t)EFFORT_OF_BODY * td_max_int(w->body_of.count, MANY);
    memcpy(w->islands.start.data, w->velocity.data, (size_t)w->body_of.count * sizeof(float[4]));
    w->islands.adds_up = w->islands.island.count || td_linkages_may_come(w);
}

/* ---- after it ---- */

/* Each island may take what its own bodies bring, and what islands before it have left: a heap that
 * takes all it can leaves those that come after it their share. */
static td_system solve_found(thud_world *w) {
    td_islands *s = &w->islands;
    td_system last = {0};
    int64_t kept = 0;
    for (int i = 0; i < s->island.count; i++) {
        kept += (int64_t)EFFORT_OF_BODY * TD_AT(td_island, &s->island, i)->bodies;
    }
    for (int i = 0; i < s->island.count; i++) {
        const td_island *island = TD_AT(td_island, &s->island, i);
        kept -= (int64_t)EFFORT_OF_BODY * island->bodies;
        s->effort -= kept;
        td_joint_island_solve(w, island);
        s->effort += kept;
        last = island->system;
    }
    return last;
}

static void end(thud_world *w) {
    td_islands *s = &w->islands;
    td_system last = solve_found(w);
    if (td_islands_watch(w)) {
        td_late_solve(w, last);
    }
    if (s->adds_up) {
        td_linkages_solve(w, last);
        s->adds_up = false;
    }
    if (w->stats.direct_islands > w->stats.soft_islands) {
        td_error_recount(w);
    }
}

const thud_island_solver td_islands_of_joints = {find, begin, end};
