/* direct.h: the velocities of an island of bodies under all of its constraints at once.
 *
 * This is the velocity-level problem of rigid bodies with unilateral contacts (Gauss's principle of
 * least constraint), a convex quadratic programme:
 *
 *     minimise  1/2 (v - v*)' M (v - v*)
 *     subject to  J_i v + known_i >= target_i   for a unilateral row i,
 *                 J_i v + known_i  = target_i   for an equality row i.
 *
 * v has three numbers a body: the linear velocity of its centre of mass (x, y) and its angular
 * velocity (turn). v* are the velocities without constraints, M is the diagonal of masses and
 * moments of inertia, and J_i is the Jacobian of row i. known_i is the speed along the row that
 * comes from bodies outside of the problem (static, kinematic, or of another island), whose
 * velocities are given. target_i is the speed that the row has to reach: the one that corrects an
 * overlap or a joint's gap, the one at which a contact that is apart just closes, or 0. A
 * constraint brings one to three rows. The optimum satisfies the KKT conditions: M (v - v*) = sum_i
 * J_i' impulse_i, and a unilateral row has impulse >= 0, speed >= target_speed, and equality in at
 * least one of the two.
 *
 * Friction is not part of the convex problem. A friction row has |impulse| <= max_impulse;
 * `max_impulse` is kept fixed while velocities are solved for, and then recomputed from the normal
 * impulses (a fixed-point iteration over Coulomb's law).
 *
 * Two methods solve the problem. Both take Newton steps, each with one sparse Cholesky
 * factorisation:
 * - active_set.c, an active set with augmented Lagrangian penalties. It starts from the rows
 *   that were active in the last step and takes one or two factorisations where few of them change.
 * - interior_point.c, a primal-dual interior point. It needs no start and takes ten to twenty
 *   factorisations. */
#ifndef TD_DIRECT_H
#define TD_DIRECT_H

#include "direct/sparse.h"

enum {
    TD_DIRECT_ROWS = 3,   /* rows of a constraint at most: a contact has two points and a tangent */
    TD_DIRECT_TANGENT = 2 /* index of a contact's friction row */
};

/* The code relies on these values: rows of odd kinds (equality and soft rows) are in the active set
 * from the start, and rows of the kinds from TD_ROW_FRICTION on may miss their target speeds
 * without an error, so that the residual leaves them out. */
typedef enum td_row_kind {
    /* A contact point or a joint's limit: impulse >= 0 and speed >= target_speed, with equality in
     * at least one of the two. Never row TD_DIRECT_TANGENT, which loops over unilateral rows leave
     * out (td_direct_load). */
    TD_ROW_UNILATERAL,
    /* A joint's lock: speed = target_speed, with an impulse of any size. */
    TD_ROW_EQUALITY,
    /* Friction or a motor: |impulse| <= max_impulse, with equality where speed differs from
     * target_speed. */
    TD_ROW_FRICTION,
    /* A spring: impulse = weight * (target_speed - speed), clamped to |impulse| <= max_impulse,
     * which is infinite for a spring without a maximum force. */
    TD_ROW_SOFT
} td_row_kind;

/* Lengths, masses and times are the world's own units; angles are radians. */
typedef struct td_direct_body {
    double inverse_mass, inverse_inertia; /* inverse_inertia 0: the body does not turn */
    double free[3];                       /* v*: velocity without constraints (x, y, turn) */
    double velocity[3];                   /* in: a guess; out: the solution */
    double before[3];                     /* velocity at the start of the step, or of the part of it
                                             that is being solved */
    double moved[3];                      /* motion since the start of the step */
    /* The rest is for islands with joints, whose step is divided into parts, each solved by itself:
     * island_step_joints.c. */
    double stiff;               /* sum of the geometric stiffness of the body's joints, which is
                                   added to its moment of inertia; 0 between two sums */
    double former_angular;      /* angular velocity that the Newton iteration before this one found,
                                   rad/s */
    double own_inverse_inertia; /* inverse_inertia without `stiff` */
    double gain[3];             /* what gravity, forces and damping add to the mean velocity in one
                                   part: half of what they add to the velocity by its end */
    bool sweeps;                /* the body's rotation moves an anchor or the axis of a joint */
    bool turn_limited; /* the body has a contact, and is not a single circle about its centre of
                          mass, so that its rotation changes the manifold */
} td_direct_body;

typedef struct td_direct_row {
    td_row_kind kind;
    double a[3], b[3];   /* Jacobian: the part of body a, and that of body b */
    double target_speed; /* target speed along the row; for friction the relative speed of the
                            moving surfaces */
    double known_speed; /* the part of the speed along the row that comes from bodies outside of the
                           problem, whose velocities are given */
    double impulse;     /* in: the warm start; out: the solution */
    double warm_start;  /* copy of the impulse at the start of the solve */
    double closing; /* islands with joints: speed at which the row closes a joint's gap within the
                       part of the step, or pushes apart a contact that overlaps as the step
                       begins */
    double mean_impulse; /* islands with joints: impulse that an equality row keeps, while the
                            velocity at the end of a part is solved for; island_step_joints.c */
    bool used;           /* the constraint has this row */
    bool active;         /* the row is in the matrix, with `weight` */
    double mass;         /* effective mass, 1 / (J M^-1 J') */
    double weight; /* factor of J' J in the matrix: a penalty, or the stiffness of a soft row */
    union {
        double multiplier;  /* active set: Lagrange multiplier of the augmented Lagrangian */
        double soft_weight; /* interior point: `weight` of a soft row */
    };
    double max_impulse; /* bound of |impulse| of a friction or soft row */
    double speed;       /* J v + known */
    double force;       /* impulse on the right-hand side of the Newton step's equations */
    double change;      /* J dv: change of the speed by the whole Newton step */
    union {
        /* interior point: s of a unilateral row in slack[0]; s0 and s1 of a friction or soft row
         * (interior_point.c) */
        double slack[2];
        double bound_change; /* active set: the last change of a friction row's bound */
    };
    double direction[3]; /* interior point: Newton step of the impulse and of the slacks;
                            conjugate_gradients.c: [0] is the search direction */
} td_direct_row;

struct td_block;

typedef struct td_direct_constraint {
    struct td_block *block; /* the lane that the rows are of (constraint/block.h) */
    int lane, kind;         /* kind: td_constraint.kind */
    int a, b;               /* indices of bodies; TD_NONE: the body of that side is outside of the
                               problem */
    int entry;       /* index of the matrix's block between a and b, where both are variables */
    bool b_later;    /* b is eliminated after a: the block's rows are b's, its columns a's */
    double friction; /* friction coefficient: the bound of the friction row per unit of normal
                        impulse */
    double bound;    /* constant part of the friction row's bound, such as the maximum impulse of a
                        motor, whose row is treated like one of friction */
    bool from_soft;  /* a contact that acts by the soft solver's impulses; its rows only keep it
                        from closing further: joint_subsystems.c */
    double stiff[2]; /* of a joint: geometric stiffness against the rotation of a and b */
    td_direct_row row[TD_DIRECT_ROWS];
} td_direct_constraint;

typedef struct td_direct {
    td_direct_body *bodies;
    td_direct_constraint *constraints;
    td_sparse *matrix; /* one block row for each body; the elimination order is already found */
    double (*step)[4]; /* Newton step of each body: x, y, turn, and a number that is not used */
    double (*work)[4]; /* scratch memory of the same size */
    int body_count, constraint_count;
    double unit_speed;    /* g h: the speed that gravity gives a body in a step of length h,
                             length/s */
    int factorings;       /* factorisations so far */
    int factoring_budget; /* budget of factorisations */
    int64_t effort;       /* budget of work that is left, in operations on 3 x 3 blocks */
    const struct td_direct_search *search; /* in: td_direct_line_search, or null */
    bool spent;           /* the budget of work was too small, so that the solve failed */
    bool soft_warm_start; /* the warm start comes from the soft solver, or the impulses are 0 */
    bool measured;        /* in: speeds are those of the present rows and velocities already;
                             td_direct_solve sets it to false */
    bool factored;        /* the matrix holds the factor of the active rows */
} td_direct;

/* Solves the problem, first by the active set, then by the interior point where that fails. The
 * solution is in the bodies' velocities and the rows' impulses. Returns the residual: the greatest
 * speed by which a row misses its target speed, at most `tolerance` where a method converged, and
 * infinite where neither did. */
double td_direct_solve(td_direct *d, double tolerance);
/* The two halves of td_direct_solve. The first one is the active set alone; where it is not found,
 * the result is infinite, and velocities and impulses are those of the last Newton step. */
double td_direct_approach(td_direct *d, double tolerance);
/* The interior point, after td_direct_approach did not find the active set. */
double td_direct_fall_back(td_direct *d, double tolerance);

/* ---- the two methods ---- */

/* Active set. False if it did not converge within its budget of factorisations. */
bool td_direct_solve_active_set(td_direct *d, double tolerance);
/* Solves once more after free velocities and target speeds have changed, with the active set and
 * the factor of the last td_direct_solve_active_set. If the active set changes, the impulses are
 * restored and the result is false. */
bool td_direct_solve_same_active_set(td_direct *d, double tolerance);
/* line_search.c: a line search and damped updates of friction bounds. Without them the active set
 * may cycle where contacts slide. */
typedef struct td_direct_search {
    /* How much of the present Newton step to take, 0 to 1: up to near the minimum of the augmented
     * Lagrangian along it. Where td_direct.search is null, whole steps are taken. */
    double (*part_of_step)(const td_direct *d);
    void (*update_bounds)(td_direct *d); /* in place of td_direct_update_friction */
} td_direct_search;
extern const td_direct_search td_direct_line_search;
/* Interior point. False where a factorisation failed or iterations ran out. */
bool td_direct_solve_interior_point(td_direct *d, double tolerance);

/* ---- what they share ---- */

/* Recomputes the speed of every row from the bodies' velocities. */
void td_direct_update_speeds(td_direct *d);
/* Subtracts the cost of a Newton step with `blocks` operations on 3 x 3 blocks from the budget of
 * work. Where the budget is too small, marks it as spent and returns false. */
bool td_direct_take_effort(td_direct *d, int64_t blocks);
/* Builds and factors M + sum of weight J' J over the active rows. False where the matrix is not
 * positive definite to rounding, or the budget of work is too small. */
bool td_direct_factor(td_direct *d);
/* Solves for the Newton step: (M + sum weight J' J) dv = M (v* - v) + sum J' force. Leaves dv in
 * d->step and J dv in the rows' `change`. False where the budget of work is too small. */
bool td_direct_step(td_direct *d);
/* Adds `part` times the step that td_direct_step has left to velocities and speeds. False where a
 * velocity is not finite. */
bool td_direct_advance(td_direct *d, double part);
/* Reduces the residual of the active rows to `enough` by conjugate gradients on the multipliers,
 * with the present factor and active set. Leaves the impulses in `force`. False where numbers are
 * not finite or the budget of work is too small; a residual that is still above `enough` is not a
 * failure. */
bool td_direct_reduce_residual(td_direct *d, double enough);
/* The residual: the greatest speed by which a unilateral or equality row misses its target speed.
 */
double td_direct_residual(const td_direct *d);
/* The sum of the normal impulses of a contact. */
static inline double td_direct_load(const td_direct_constraint *c) {
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
        load += c->row[k].used && c->row[k].kind == TD_ROW_UNILATERAL ? c->row[k].impulse : 0.0;
    }
    return load;
}
/* The bound of a constraint's friction row, from its present normal impulses and sliding speed. */
double td_direct_friction_bound(const td_direct_constraint *c);
/* Sets the bounds of all friction rows by td_direct_friction_bound. */
void td_direct_update_friction(td_direct *d);
/* Restores the impulses of the warm start after a method has failed, and recomputes friction bounds
 * from them and speeds from the present velocities, which stay. */
void td_direct_restore(td_direct *d);

#endif
