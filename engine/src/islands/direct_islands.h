/* direct_islands.h: islands that the soft solver cannot hold, and what is known of them during a
 * step. */
#ifndef TD_ISLANDS_H
#define TD_ISLANDS_H

#include "base/indices.h"
#include "islands/direct.h"

struct thud_world;

/* Bodies and constraints of an island, in the lists of td_islands. */
typedef struct td_island {
    int first_body, bodies, first_constraint, constraints;
    td_system system;
} td_island;

typedef struct td_islands {
    td_array island;      /* td_island */
    td_array slots;       /* td_awake_slot: island by island */
    td_array constraints; /* int: island by island */
    td_array local;       /* int, by awake slot: 1 + its number in the island; 0: in none */
    td_array before;      /* float[4], as `slots`: velocity before the soft solver */
    td_array impulses; /* float[4], as `constraints`: of points and tangent, from the step before;
                          and whether they are the soft solver's */
    td_array
        rows; /* td_direct_constraint: of the island that is being solved, as are the next four */
    td_array bodies;              /* td_direct_body */
    td_array step, work;          /* double[4] */
    td_array shape, shape_before; /* int: what the order of all islands follows from, and what the
                                     order that stands was made for */
    td_array systems;             /* td_system, as `island`: the order that stands */
    td_array start; /* float[4], by awake slot, where there are joints: velocity before the soft
                       solver */
    bool adds_up;   /* the soft solver is to keep what contacts give in the step, for linkages.c */
    int64_t effort; /* td_direct.effort that is left to islands with joints in this step */
    td_sparse matrix;
} td_islands;

/* The island solver that a quality plugs in. */
struct thud_island_solver {
    /* After the narrowphase: which islands, and room for them. False: out of memory. */
    bool (*find)(struct thud_world *w);
    /* Before the soft solver, which solves these islands as well. */
    void (*begin)(struct thud_world *w);
    /* After it: solves them directly, and keeps the better result of each. */
    void (*end)(struct thud_world *w);
};

void td_islands_init(td_islands *islands, bool wide);
void td_islands_free(td_memory *memory, td_islands *islands);

/* Fills the lists; false when memory is short. */
bool td_islands_find(struct thud_world *w);
/* Counts down the steps of thud_world.direct_steps, and leaves islands of too many bodies alone.
 * Comes when the step can no longer fail, so that a step that is tried again counts once. */
void td_islands_settle(struct thud_world *w);
/* Impulse a substep, over the lighter body's mass, under which a contact gives way by as much as
 * the world's max_error allows, or the quality: at its own number of substeps, where the world
 * takes fewer, for whoever asks for less is not to pay for more. `size` is the smaller body's. */
float td_islands_most(const struct thud_world *w, float size);
/* The size of the smaller of two bodies, of which slot 0 counts for none. */
float td_islands_size(const struct thud_world *w, td_awake_slot a, td_awake_slot b);
/* Looks for constraints that give way too much, a part of them each step. True where joints do. */
bool td_islands_watch(struct thud_world *w);
/* Lists the island of a body, unless it has no contacts, or too many bodies, or is left alone. */
void td_islands_follow(struct thud_world *w, td_awake_slot seed);

/* The speed below which bodies are calm: a few times what gravity gives them in a step. */
float td_calm_speed(const struct thud_world *w);
/* The direct solver was of no use to the island, and is not tried again for so many steps. That
 * doubles each time; `for_long`, it is as long as it can be at once. */
void td_islands_leave(struct thud_world *w, const td_island *island, int steps, bool for_long);
/* Operations that a matrix of the island takes, with what goes before and after it. */
int64_t td_island_cost(const td_island *island);

/* An island is solved directly for so many steps more after a constraint of it last carried so much
 * that it would sag by more than TD_DIRECT_LEAVE times the limit. */
#define TD_DIRECT_STEPS 60
#define TD_DIRECT_LEAVE 0.7
/* thud_world.direct_steps counts down from TD_DIRECT_STEPS while an island is direct. Values above
 * TD_DIRECT_COOLDOWN mean that it is left alone: they begin TD_COOLDOWN_STEPS above it, and count
 * down to it. */
#define TD_DIRECT_COOLDOWN 128
#define TD_COOLDOWN_STEPS 120
#define TD_PAUSE_STEPS 8 /* the same of what joints hold, which cannot be left for long */
/* thud_world.slow_steps holds two counts: up to TD_SLOW_STEPS, the steps in succession that took
 * the island's solver long, or where no patience ends, that it could not be solved, or while it is
 * left alone, that what its joints tie could not be solved by itself (linkages/linkages.c); and, in
 * multiples of TD_SLOW_ONCE, how often the island was left alone since a step that did not. */
#define TD_SLOW_STEPS 4095
#define TD_SLOW_ONCE 4096
#define TD_SLOW_LEFT(slow_steps) ((slow_steps) / TD_SLOW_ONCE)

#endif
