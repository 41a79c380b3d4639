/* direct_islands.h: the islands that are solved directly in a step: how they are found, and their
 * data.
 *
 * The soft solver is the iterative one that solves every island in substeps, with contacts as stiff
 * springs and dampers (solver/solve.c). Its contacts sink in under load by force / stiffness. An
 * island is solved directly if a contact would sink in by more than the quality's overlap_limit (a
 * share of the smaller body's size) or the world's max_error (a length). With overlap_limit 0 every
 * island is solved directly. */
#ifndef TD_DIRECT_ISLANDS_H
#define TD_DIRECT_ISLANDS_H

#include "base/indices.h"
#include "direct/direct.h"

struct thud_world;

/* The outcome of solving an island as a tree (joints/lock_tree_step.c) in this step. */
typedef enum td_tree_outcome {
    TD_TREE_UNTRIED,
    TD_TREE_SOLVED,
    TD_TREE_REFUSED, /* it is no tree of locks, or its result is refused */
    TD_TREE_SPENT    /* the step's budget of work is spent */
} td_tree_outcome;

/* An island: ranges of bodies and constraints in the lists of td_islands, and its elimination
 * order. */
typedef struct td_island {
    int first_body, bodies, first_constraint, constraints;
    td_system system;
    td_tree_outcome tree;
    int parts; /* the number of parts of its step, if it is to be solved as a tree; else 0 */
} td_island;

typedef struct td_islands {
    td_array island;      /* td_island */
    td_array slots;       /* td_awake_slot: bodies, island by island */
    td_array constraints; /* int: constraints, island by island */
    td_array local;       /* int, by awake slot: 1 + the body's number in its island; 0: in no
                             island; negative: the reason why it is in none, see below */
    td_array island_start_velocity; /* float[4], parallel to `slots`: rows of thud_world.velocity
                                       as they were before the soft solver */
    td_array impulses; /* float[4], parallel to `constraints`: warm-start impulses of two points and
                          the tangent, then 1 if they are the soft solver's, else 0 */
    td_array rows; /* td_direct_constraint: rows of the island that is being solved. The next three
                      arrays are also of that island alone */
    td_array bodies;     /* td_direct_body */
    td_array step, work; /* double[4] */
    td_array tree;       /* td_tree_body of joint_tree.c. This array and the next three are used
                            only in worlds with joints */
    td_array locks;      /* td_lock_body of direct/lock_tree.h */
    td_array listed;     /* td_listed_body of direct/lock_tree.h */
    td_array results;    /* td_lock_result of direct/lock_tree.h, parallel to `slots` */
    bool passes_over; /* islands were solved as trees before the soft solver, which skips the blocks
                         of locks in which every lane belongs to such an island (td_block.solved) */
    float trees_residual; /* residual of the islands that td_lock_trees_step solved: the maximum
                             speed along a locked direction of a joint after the step, length/s, or
                             for the rotation of a weld rad/s */
    td_array topology,
        topology_before;     /* int: the graph of all islands, which determines their elimination
                                orders, and the graph for which the present orders were found */
    td_array systems;        /* td_system, parallel to `island`: the present orders */
    td_array start_velocity; /* float[4], by awake slot, in worlds with joints: thud_world.velocity
                                as it was before the soft solver */
    bool adds_up;            /* the soft solver sums up the contacts' impulses over the step
                                (td_point_history.total, td_surface.total), since
                                joint_subsystems.c, which takes them as known, may run after it */
    int64_t
        effort; /* budget of work (td_direct.effort) left for islands with joints in this step */
    float load_max_per_size, /* 1/s: by overlap_limit, see td_islands_load_max */
        load_max;            /* length/s: by max_error, likewise */
    td_sparse matrix;
} td_islands;

/* The island solver of a quality. */
struct thud_island_solver {
    /* After the narrowphase: finds the islands and reserves memory for them. False when memory is
     * short. */
    bool (*find)(struct thud_world *w);
    /* Before the soft solver, which solves these islands as well. */
    void (*begin)(struct thud_world *w);
    /* After the soft solver: solves the islands directly, and keeps the better of the two results
     * of each island. */
    void (*end)(struct thud_world *w);
};

/* Values of td_islands.local of bodies that are in no listed island. */
enum {
    TD_ISLAND_TOO_MANY = -1, /* its island has more bodies than quality.island_limit */
    TD_ISLAND_ALONE = -2,    /* it has no constraint that acts */
    TD_ISLAND_COOLING = -3,  /* its island is in its cooldown. A few of the bodies may still be
                                marked as direct, as those of a machine that has just touched a heap
                                in cooldown */
    TD_ISLAND_REFUSED = -4,  /* its island was listed, and the soft solver's result was kept */
    TD_ISLAND_UNFIT = -5,    /* its linkage cannot be solved in this step (joint_subsystems.c) */
    TD_ISLAND_SOFT = -6      /* its island has joints, and none of its bodies is marked; forget_soft
                                removes it (direct_islands.c) */
};

void td_islands_init(td_islands *islands, bool wide);
void td_islands_free(td_memory *memory, td_islands *islands);

/* Lists the islands that are solved directly in this step. False when memory is short. */
bool td_islands_find(struct thud_world *w);
/* Counts down the cooldowns in thud_world.direct_steps, begins that of islands with too many
 * bodies, gives a short one to marked bodies of islands in their cooldown, so that these islands
 * are not searched in every step, and unmarks bodies without constraints. It is called when the
 * step can no longer fail, so that a step that fails and is repeated counts once. */
void td_islands_count_down(struct thud_world *w);
/* The load above which a contact counts as overloaded, length/s: the impulse of a substep over the
 * lighter body's mass, at which the contact sinks in by max_error, or by overlap_limit times
 * `size`, the size of the smaller body, if that is less. The depth of overlap_limit counts at no
 * fewer substeps than the quality's, so that fewer of them do not send more islands to the direct
 * solver; max_error counts at the present number. */
static inline float td_islands_load_max(const td_islands *islands, float size) {
    return td_min_float(islands->load_max_per_size * size, islands->load_max);
}
/* The size of the smaller of two bodies; slot 0 (static) has none. */
float td_islands_size(const struct thud_world *w, td_awake_slot a, td_awake_slot b);
/* Looks for constraints whose load is above the threshold, and marks their bodies' islands as
 * direct. Each step looks at a share of the constraints. True if one that it found is a joint. */
bool td_islands_mark_loaded(struct thud_world *w);
/* Lists the island of a body, unless it has no constraints, too many bodies, or is in its cooldown.
 */
void td_islands_list_from(struct thud_world *w, td_awake_slot seed);

/* Whether two bodies hardly move against each other: their relative speed is below 4 g time_step,
 * or below four times the sleep speed if that is more. */
bool td_nearly_at_rest(const struct thud_world *w, td_awake_slot a, td_awake_slot b);
/* Begins the cooldown of an island whose direct result was refused: the direct solver is not tried
 * there for `steps` steps. The time doubles with each cooldown in succession; with `for_long` it
 * has its maximum at once. */
void td_islands_begin_cooldown(struct thud_world *w, const td_island *island, int steps,
                               bool for_long);
/* The cost of a factorisation of the island, including the setup of its matrix and the solution, in
 * operations on 3 x 3 blocks: the unit of thud_quality.island_work. */
int64_t td_island_cost(const td_island *island);

/* Hysteresis: an island stays direct for TD_DIRECT_STEPS after a constraint of it last had a load
 * above TD_DIRECT_LEAVE times the threshold. Chosen: a second at 60 steps a second. */
#define TD_DIRECT_STEPS 60
#define TD_DIRECT_LEAVE 0.7
/* thud_world.direct_steps of a body: 0, not direct; 1 to TD_DIRECT_STEPS, direct, counting down;
 * from TD_DIRECT_COOLDOWN + TD_COOLDOWN_STEPS down to TD_DIRECT_COOLDOWN + 1, in the cooldown,
 * after which it is 0. The values fit a byte. */
#define TD_DIRECT_COOLDOWN 128
#define TD_COOLDOWN_STEPS 120
/* Steps of cooldown of islands with joints: under the soft solver the gaps of joints under load
 * widen, so that the cooldown is short. */
#define TD_PAUSE_STEPS 8
/* Steps of cooldown of an island of contacts in motion, whose contacts are soon others; and of a
 * body that is marked while its island is in its cooldown. Half a second at 60 steps a second.
 * Chosen. */
#define TD_MOTION_PAUSE_STEPS 30
/* thud_world.slow_steps of a body holds two counts. Its lower part, up to TD_SLOW_STEPS, is the
 * number of steps in succession in which the direct solver took long, or, at qualities without a
 * limit of such steps, failed; in the cooldown, the number of failures to solve its linkage (bodies
 * that joints connect) (direct/joint_subsystems.c). Its upper part, in multiples of TD_SLOW_ONCE,
 * is the number of cooldowns in succession. */
#define TD_SLOW_STEPS 4095
#define TD_SLOW_ONCE 4096
#define TD_SLOW_LEFT(slow_steps) ((slow_steps) / TD_SLOW_ONCE)

#endif
