/* joint_parts.h: the rules by which the step of an island with joints is solved in parts: by
 * island_step_joints.c for any island, and by joints/lock_tree_step.c for trees of locks. */
#ifndef TD_JOINT_PARTS_H
#define TD_JOINT_PARTS_H

#include "base/base.h"

/* Energies by which a result is judged plausible or not. Each member is twice the energy. */
typedef struct td_island_energy {
    double start, now; /* kinetic energy before and after the step; `start` with what motors and
                          springs may add */
    double work;       /* work of gravity, forces and damping in the step */
    double free;       /* kinetic energy without constraints: that of the first or of the last part,
                          whichever is larger */
    double pushed;     /* energy that closing gaps and overlaps may add */
} td_island_energy;

/* A result is refused if its kinetic energy is more than this many times the energy that the island
 * had or could get from gravity, motors and springs. Chosen: an unstable result exceeds any factor,
 * while a whip of light bodies may have a few times the mean energy. */
#define TD_ENERGY_RATIO_MAX 16.0
/* Factor of the budget of factorisations for islands without contacts: Newton's method needs
 * several factorisations where an island without joints needs one, and if the budget runs out the
 * island is left to the soft solver, under which the gaps of a loaded chain open. */
enum { TD_BUDGET_OF_JOINTS = 8 };
/* Maximum of Newton iterations in a part. Chosen; each takes one or more factorisations. */
enum { TD_NEWTON_ITERATIONS_MAX = 12 };
/* Minimum of the geometric stiffness, in multiples of the moment of inertia: a negative one makes
 * the body turn more easily, and at -1 the matrix would not be positive definite. Chosen. */
#define TD_STIFFNESS_MIN (-0.5)
/* Newton's method ends when the residual is below this share of the tolerance of speeds, at
 * qualities that solve every island directly. At other qualities, and in islands with contacts,
 * whose active set may change in every iteration, it ends below the tolerance itself; gaps then
 * stay open by some micrometres. Chosen; measured on twenty chains of 50 links that swing at the
 * quality `default`: with a share of 0.05 in place of 1 a step takes a third more iterations, and
 * gaps are no smaller, since the budget ends sooner. */
#define TD_RESIDUAL_EXACT 1e-3
/* Rules on unbalanced moments, measured as a speed (unbalanced_speed, island_step_joints.c).
 * Newton's iteration goes on while that speed is above TD_BALANCE_ENOUGH times the tolerance. A
 * result is refused if the speed is above TD_BALANCE_MAX times the tolerance, which is g h (a
 * tolerance is 1e-3 g h: TOLERANCE_SHARE, island_step.c), and the island's energy exceeds the sum
 * of its energy before the step and the work of forces by more than TD_GAIN_MAX times the sum of
 * their magnitudes. Measured on 800 random mechanisms (test_joints_random.c) without gaps or
 * overlaps at the start. Without these rules 10 gained more than 5 % of energy, up to 16 times
 * their own; with them 4 do, up to 0.9 times. TD_BALANCE_ENOUGH 1 would leave 3 of these, but takes
 * half as many factorisations again in ragdolls at the quality `default`. */
#define TD_BALANCE_ENOUGH 100.0
#define TD_BALANCE_MAX 1000.0
#define TD_GAIN_MAX 0.1
/* Velocities at the end of a part that violate the joints' rows by less than this many times g h
 * are left as they are, since correcting them would take energy out of every swing. Chosen. */
#define TD_END_ERROR_MAX 4.0
/* A gap that closes at more than this share of the fastest body's speed is not negligible: the
 * closing speed must then be taken out of the velocities at the end (closes_gaps,
 * island_step_joints.c). Chosen. */
#define TD_CLOSING_SHARE 1e-3

/* Whether the result has more than TD_ENERGY_RATIO_MAX times the energy that it may have. `free`
 * counts the velocities before the first part and those before the last part: a motor may move more
 * bodies than the two whose effective mass energy_of_drives counts, and the energy of these is in
 * the velocities before the last part. Equality rows do no work themselves. */
static inline bool td_gains_energy(const td_island_energy *e) {
    return !(e->now <= TD_ENERGY_RATIO_MAX * (e->free + e->pushed));
}

/* Whether a result is refused by TD_BALANCE_MAX and TD_GAIN_MAX: its moments are far from balance,
 * and its energy has grown. `unbalanced`: unbalanced_speed, length/s. */
static inline bool td_gains_out_of_balance(const td_island_energy *e, double unbalanced,
                                           double tolerance) {
    return unbalanced > TD_BALANCE_MAX * tolerance &&
           e->now > e->start + e->work + TD_GAIN_MAX * (e->start + td_abs(e->work));
}

/* The factor by which velocities are scaled after a step that has closed gaps. Closing a gap moves
 * bodies without giving them velocity. Where it lifts them against gravity, it adds potential
 * energy: a bridge whose joints open in the steps that the soft solver solves, and are closed again
 * in others, would swing higher and higher. So velocities are scaled down until the kinetic energy
 * is at most that before the step plus the work of gravity and forces, or zero. (Locks do no work
 * themselves, contacts and limits take energy out.) `kinetic` and `allowed` are twice these
 * energies. For an island that is joined to nothing outside, velocities and energies are relative
 * to its centre of mass. */
static inline double td_share_after_closing(double kinetic, double allowed) {
    return kinetic <= allowed ? 1.0 : allowed > 0.0 ? __builtin_sqrt(allowed / kinetic) : 0.0;
}

#endif
