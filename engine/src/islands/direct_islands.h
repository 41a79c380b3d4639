/* direct_islands.h: islands that the soft solver cannot hold, and what is known of them during a
 * step. */
#ifndef TD_ISLANDS_H
#define TD_ISLANDS_H

#include "islands/direct.h"

struct thud_world;

enum { TD_ISLAND_MOST = 16384 }; /* bodies; ordering them takes the square of that in bits */

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
    td_array
        impulses;  /* float[3], as `constraints`: from the step before, of its points and tangent */
    td_array rows; /* td_direct_contact: of the island at hand ... */
    td_array bodies;     /* td_direct_body */
    td_array step, work; /* double[3] */
    td_array moved;      /* double[3]: motion of the bodies */
    td_sparse matrix;
} td_islands;

/* What a quality plugs in. */
struct thud_island_solver {
    /* After the narrowphase: which islands, and room for them. False: out of memory. */
    bool (*find)(struct thud_world *w);
    void (*begin)(struct thud_world *w); /* before the soft solver, which does them too ... */
    void (*end)(struct thud_world *w);   /* ... and is overruled here where the result is better */
};

void td_islands_init(td_islands *islands);
void td_islands_free(td_memory *memory, td_islands *islands);

/* Fills the lists; false when memory is short. */
bool td_islands_find(struct thud_world *w);
/* Now that the step cannot fail: counts down, and leaves alone what has too many bodies. */
void td_islands_settle(struct thud_world *w);
/* Impulse a substep, over the lighter body's mass, under which a contact gives way by as much as
 * the world's max_error allows, or the quality: at its own number of substeps, where the world
 * takes fewer, for whoever asks for less is not to pay for more. `size` is the smaller body's. */
float td_islands_most(const struct thud_world *w, float size);
/* Looks for contacts that give way too much, a part of them each step. */
void td_islands_watch(struct thud_world *w);

/* The speed below which bodies are calm: a few times what gravity gives them in a step. */
float td_calm_speed(const struct thud_world *w);
/* Its solver was of no use: it is not tried again for a while, which doubles each time, or is as
 * long as it can be from the first on. */
void td_islands_leave(struct thud_world *w, const td_island *island, bool for_long);
/* Operations that a matrix of the island takes, with what goes before and after it. */
int64_t td_island_cost(const td_island *island);

/* An island stays with its solver for so many steps after it last had to. */
#define TD_DIRECT_STEPS 60
/* ... which is as long as its sag is above this part of the limit. */
#define TD_DIRECT_LEAVE 0.7
/* In thud_world.hard: more than this is the number of times TD_COOLDOWN_STEPS for which an island
 * is left alone. */
#define TD_DIRECT_COOLDOWN 128
#define TD_COOLDOWN_STEPS 120
/* In thud_world.strain: steps in succession that took the island's solver long; and above them, how
 * often it was left since it last took few. */
#define TD_SLOW_STEPS 4095
#define TD_SLOW_ONCE 4096
#define TD_SLOW_LEFT(slow_steps) ((slow_steps) / TD_SLOW_ONCE)

#endif
