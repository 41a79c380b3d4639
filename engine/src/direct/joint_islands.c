/* joint_islands.c: the island solver of a world with joints, in the order that joint_islands.h
 * describes (1., 2., 3.); and the budget of work that islands with joints share in a step. */
#include "direct/joint_islands.h"

#include "constraint/lanes.h"
#include "direct/elimination_order.h"
#include "direct/lock_tree.h"
#include "solver/error.h"

#include <string.h>

/* ---- before the soft solver ---- */

/* Reserves memory for one more system of the maximum size, by beginning such a system, which makes
 * the arrays grow, and dropping it. False when memory is short. */
static bool reserve_system(thud_world *w) {
    td_sparse *s = &w->islands.matrix;
    td_memory *memory = &w->memory;
    td_system saved = s->current;
    bool room = td_sparse_reserve(memory, s, w->body_of.count + TD_RESOLVE_BODIES_MAX) &&
                td_sparse_begin(memory, s, TD_RESOLVE_BODIES_MAX);
    s->current = saved;
    return room && td_array_reserve(memory, &s->row, s->row.count + TD_RESOLVE_ENTRIES_MAX) &&
           td_array_reserve(memory, &s->entry, TD_RESOLVE_ENTRIES_MAX);
}

/* Reserves the memory of joint_tree.c and of lock_tree_step.c for the largest island. False when
 * memory is short. */
static bool reserve_tree(thud_world *w) {
    int bodies = TD_RESOLVE_BODIES_MAX;
    for (int i = 0; i < w->islands.island.count; i++) {
        bodies = td_max_int(bodies, TD_AT(td_island, &w->islands.island, i)->bodies);
    }
    return td_islands_reserve(w, &w->islands.tree, bodies) &&
           td_islands_reserve(w, &w->islands.results, w->body_of.count) &&
           td_islands_reserve(w, &w->islands.locks, bodies) &&
           td_islands_reserve(w, &w->islands.listed, td_max_int(bodies, w->islands.slots.count));
}

/* thud_island_solver.find: lists the islands of 1., and reserves memory for the largest island
 * that 2. or 3. may solve. False when memory is short. */
static bool find(thud_world *w) {
    td_islands *s = &w->islands;
    return td_islands_find(w) &&
           td_array_reserve(&w->memory, &s->start_velocity, w->body_of.count) &&
           td_islands_reserve(w, &s->topology,
                              s->topology.count + 2 * TD_RESOLVE_CONSTRAINTS_MAX) &&
           td_islands_reserve(w, &s->rows, TD_RESOLVE_CONSTRAINTS_MAX) &&
           td_islands_reserve(w, &s->bodies, TD_RESOLVE_BODIES_MAX) &&
           td_islands_reserve(w, &s->step, TD_RESOLVE_BODIES_MAX) &&
           td_islands_reserve(w, &s->work, TD_RESOLVE_BODIES_MAX) && reserve_tree(w) &&
           reserve_system(w);
}

/* Budget of work (td_direct.effort) of islands with joints in a step, at any quality, in operations
 * on 3 x 3 blocks of some 7 ns each: EFFORT_OF_BODY for each body of the world, counted as
 * EFFORT_BODIES_MIN bodies if there are fewer, which is some 30 ms. Loops of joints that are
 * stretched may take any number of Newton steps, and a body that is joined to many others makes a
 * factorisation take the cube of their number: without a budget a hub with 900 rods took up to a
 * second in one step at the quality `exact`. Both numbers are chosen; with half of them, islands
 * are left to the soft solver once they have taken 15 ms in a step; with twice as much a step may
 * take 60 ms. */
enum { EFFORT_OF_BODY = 4000, EFFORT_BODIES_MIN = 1000 };

/* The sum of the shares of the budget of all listed islands that are not solved yet: EFFORT_OF_BODY
 * for each of their bodies. solve_found takes the shares of later islands out of the budget while
 * it solves an island, so that this island may spend its own share, and what the islands before it
 * have left of theirs. Without this reserve, a heap that spent the whole budget would send all
 * later islands to the soft solver. */
static int64_t reserved_effort(const thud_world *w) {
    int64_t reserved = 0;
    for (int i = 0; i < w->islands.island.count; i++) {
        const td_island *island = TD_AT(td_island, &w->islands.island, i);
        reserved += island->tree == TD_TREE_SOLVED ? 0 : (int64_t)EFFORT_OF_BODY * island->bodies;
    }
    return reserved;
}

/* Sets td_block.solved of all blocks of locks: the lanes whose islands were solved as trees. */
static void mark_solved_lanes(thud_world *w) {
    td_islands *s = &w->islands;
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        for (int k = 0; k < run->count && run->kind == TD_CONSTRAINT_LOCK; k++) {
            (*TD_AT(td_block *, &w->scratch.blocks, run->first + k))->solved = 0;
        }
    }
    for (int i = 0; i < s->island.count; i++) {
        const td_island *island = TD_AT(td_island, &s->island, i);
        const td_lock_result *results = s->results.data;
        results += island->first_body;
        for (int k = 0; k < island->bodies && island->tree == TD_TREE_SOLVED; k++) {
            if (results[k].block) {
                results[k].block->solved |= 1u << results[k].lane;
            }
        }
    }
}

/* Solves the islands whose joints are hinges and welds that form a tree (direct/lock_tree.h). They
 * need no result of the soft solver, which then skips their joints. */
static void solve_trees(thud_world *w) {
    td_islands *s = &w->islands;
    s->passes_over = false;
    s->trees_residual = 0.0f;
    w->joint_hooks->solve_trees(w);
    for (int i = 0; i < s->island.count; i++) {
        s->passes_over |= TD_AT(td_island, &s->island, i)->tree == TD_TREE_SOLVED;
    }
    if (s->passes_over) {
        mark_solved_lanes(w);
    }
}

/* thud_island_solver.begin: sets the budget, and stores the velocities at the start of the step,
 * from which islands of 2. and 3. are solved after the soft solver has changed them; then solves
 * trees of locks. */
static void begin(thud_world *w) {
    td_islands_begin(w);
    w->islands.effort = (int64_t)EFFORT_OF_BODY * td_max_int(w->body_of.count, EFFORT_BODIES_MIN);
    memcpy(w->islands.start_velocity.data, w->velocity.data,
           (size_t)w->body_of.count * sizeof(float[4]));
    w->islands.adds_up = w->islands.island.count || td_joint_subsystems_expected(w);
    solve_trees(w);
}

/* ---- after the soft solver ---- */

/* Solves the islands of 1. that are no trees, and writes the results of all islands, trees
 * included. Returns the last system of td_islands.matrix, behind which 2. and 3. append theirs. */
static td_system solve_found(thud_world *w) {
    td_islands *s = &w->islands;
    td_system last = {0};
    int64_t reserved = reserved_effort(w);
    for (int i = 0; i < s->island.count; i++) {
        const td_island *island = TD_AT(td_island, &s->island, i);
        bool solved = island->tree == TD_TREE_SOLVED;
        reserved -= solved ? 0 : (int64_t)EFFORT_OF_BODY * island->bodies;
        s->effort -= reserved;
        td_joint_island_solve(w, island);
        s->effort += reserved;
        last = island->system;
    }
    return last;
}

/* thud_island_solver.end: the islands of 1., 2. and 3. */
static void end(thud_world *w) {
    td_islands *s = &w->islands;
    td_system last = solve_found(w);
    if (td_islands_mark_loaded(w)) {
        td_overloaded_islands_solve(w, last);
    }
    if (s->adds_up) {
        td_joint_subsystems_solve(w, last);
        s->adds_up = false;
    }
    if (w->stats.direct_islands > w->stats.soft_islands) {
        td_errors_recount(w);
    }
    if (s->passes_over) { /* joints/lock.c leaves the lanes of trees out of the residual */
        w->errors.residual = td_max_float(s->trees_residual, w->errors.residual);
    }
    s->passes_over = false;
}

const thud_island_solver td_islands_of_joints = {find, begin, end};
