/* island_step.h: the data of one island while the direct solver works on it, and the functions that
 * solve one step of it: set up (island_problem.c), solve and write (island_step.c), and the
 * solution for islands with joints (island_step_joints.c). */
#ifndef TD_ISLAND_STEP_H
#define TD_ISLAND_STEP_H

#include "constraint/joint_hooks.h"
#include "direct/rows.h"

/* The direct solution of one island, or linkage, while it is computed. */
typedef struct td_island_work {
    thud_world *w;
    const td_island *island;
    td_direct problem;
    const td_awake_slot *slots;
    const int *constraints;
    double time;    /* length of the step, or of the part of it that is being solved, s */
    double elapsed; /* time from the start of the step for which td_island_gap computes: the
                       start of the part while contacts get their target speeds, then its
                       end, s */
    double next;    /* length of the next part, s; after the last part, of a whole step */
    bool bounces;   /* the soft solver lets a contact bounce in this step */
    double correction_speed; /* maximum speed at which a row corrects an overlap or a gap, length/s;
                                infinite: the result's motions and impulses are not checked */
    int joints;              /* number of constraints that are not contacts: parts of joints */
    bool closed;             /* set if a part of the step has closed gaps of joints (closes_gaps,
                                island_step_joints.c) */
    double unbalanced; /* greatest unbalanced_speed of island_step_joints.c so far in this step,
                          length/s */
    double turn_max;   /* greatest rotation in the step for which the contacts' lever arms of the
                          start of the step are accurate enough, rad */
} td_island_work;

/* island_problem.c: stores velocities and impulses of all listed islands, before the soft solver
 * changes them. */
void td_island_store_start(thud_world *w);
/* Stores the warm-start impulses of constraint i in td_islands.impulses, summed over a whole step;
 * `from_soft`: they are the soft solver's, not the direct solver's. */
void td_island_store_impulses(thud_world *w, int i, bool from_soft);
/* The work that is left of the quality's island_work in this step; <= 0 if it is spent. */
int64_t td_island_work_left(const thud_world *w);
/* The number of factorisations that the quality's island_work still allows in this step, for an
 * island in which one costs this much (td_island_cost). */
int td_island_factoring_budget(const thud_world *w, int64_t cost);
/* Body i of the island: its velocity before the step, and its mean velocity in the step without
 * constraints (x, y, turn). */
void td_island_free_velocity(const thud_world *w, const td_island *island, int i, double before[3],
                             double free[3]);
/* Sets the speeds that bodies outside of the problem give the rows of a constraint, by the rows'
 * present Jacobians. */
void td_island_set_known(const td_island_work *work, td_direct_constraint *c);
/* The problem of direct.h for the island, from the stored velocities and impulses. In the lanes of
 * drives it also sets the limit for which the step is solved (choose_limit, joint_rows.c); lanes
 * and bodies of the world do not change otherwise. */
td_island_work td_island_set_up(thud_world *w, const td_island *island);

/* island_step.c: solves an island directly and writes the result. False if the soft solver's result
 * is kept. */
bool td_island_solve(thud_world *w, const td_island *island);
/* Computes the result of a problem that td_island_set_up has made, and checks it, but writes
 * nothing to the world. False if the soft solver's result has to be kept. */
bool td_island_compute(td_island_work *work);
/* The speed that gravity gives a body in a step, g h, length/s. */
double td_gravity_speed(const thud_world *w);
/* The tolerance of residuals, length/s. */
double td_island_tolerance(const thud_world *w);
/* Clamps each component of a velocity to the world's maximum speed, and the angular velocity to
 * THUD_ANGULAR_SPEED_MAX. */
void td_island_clamp_velocity(const thud_world *w, double velocity[3]);
/* Whether the load of a constraint is above TD_DIRECT_LEAVE times the threshold, so that its island
 * stays direct. The load is the impulse of a substep over the lighter body's mass, length/s;
 * `impulse` is that of the step, the sum of all rows. */
bool td_island_load_stays(const thud_world *w, td_lane at, double impulse);
/* Sets direct_steps of the island's bodies: back to its full value while a constraint is loaded,
 * otherwise it counts down. */
void td_island_keep_direct(thud_world *w, const td_island *island, bool loaded);
/* Writes the velocities at the end of the step and the motions of the bodies to the world. */
void td_island_write_bodies(const td_island_work *work);
/* thud_island_solver.begin: what the direct solver does before the soft solver runs. */
void td_islands_begin(thud_world *w);
/* Adds the motion of the part, at the mean velocities, to td_direct_body.moved. */
void td_island_add_motion(td_island_work *work);
/* The separation of row k at time `elapsed`, to first order in the motion so far (`moved`);
 * `before` is the separation at the start of the step. */
double td_island_gap(const td_island_work *work, const td_direct_constraint *c, int k,
                     double before);
/* Whether a body is a single circle about its centre of mass, so that its rotation moves no
 * contact. */
bool td_island_is_disc(const td_island_work *work, int body);
/* Replaces the mean velocities v by those at the end of the part, 2 v - v_before, doubles the
 * impulses, which were those of the mean velocity, and sets the target speeds of contacts for the
 * end of the part. */
void td_island_extrapolate(td_island_work *work);

/* island_step_joints.c, linked only with joints: solves the step of an island with joints. Returns
 * the residual, as td_direct_solve does. */
double td_island_solve_joints(td_island_work *work, double tolerance);

/* joints/lock_tree_step.c, linked only with joints: solves the step of an island whose constraints
 * are hinges and welds that form a tree, before the soft solver or after it. `known`: null, or the
 * island's bodies with free velocities that already include the impulses of contacts; these
 * contacts are not among the constraints of the island (joint_subsystems.c). Writes only
 * td_islands.results and the statistics: the caller may still refuse the result, so that it does
 * not count in td_islands.trees_residual. */
td_tree_outcome td_lock_tree_step(thud_world *w, const td_island *island,
                                  const td_direct_body *known);
/* Calls td_lock_tree_step's solver for all listed islands. Islands whose trees have the same graph
 * are solved side by side in the lanes of vectors. */
void td_lock_trees_step(thud_world *w);
/* Writes the result of an island that was solved as such a tree to the world. */
void td_lock_tree_write(thud_world *w, const td_island *island);

/* The lane of constraint i of the island. */
static inline td_lane td_island_lane(const td_island_work *work, int i) {
    const td_direct_constraint *c = &work->problem.constraints[i];
    return (td_lane){c->block, c->lane};
}

/* Whether the island has no contacts. */
static inline bool td_island_is_joints(const td_island_work *work) {
    return work->joints == work->island->constraints;
}

/* The number of points of a constraint's lanes, 1 or 2. */
static inline int td_island_points(const thud_world *w, const td_constraint *constraint) {
    return td_form_points(w->kinds[constraint->kind]->form);
}

#endif
