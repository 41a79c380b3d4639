/* island_step_joints.c: a step of an island with joints, solved directly by an energy-momentum
 * method.
 *
 * The step is divided into parts (step_parts.c). In a part of length h the unknown is the mean
 * velocity v of each body, so that its motion is h v and its velocity at the end 2 v - v_before, as
 * in the implicit midpoint rule. Joint rows change as bodies turn. Their Jacobian is a discrete
 * gradient: J(h v) (h v) = q(after) - q(before) exactly, for the joint's coordinate q (Gonzalez,
 * "Time integration and discrete Hamiltonian systems", 1996; td_update_rows_fn computes it). Then
 * the impulses J' l of locked rows, with the multipliers l, do no work, and a gap that is to be
 * closed is exactly closed at the end of the part, not only to first order.
 *
 * Since J depends on v, the equations are solved by Newton's method: solve direct.h's problem with
 * the present rows, compute the rows for the new motion, and so on. The derivative of J' l with
 * respect to the rotation, the geometric stiffness, is added to the moments of inertia.
 *
 * A second problem gives the velocity at the end of the part, for the rows as they are there: see
 * solve_end_velocity. Contacts in the island keep the normals and arms of the start of the step. */
#include "direct/island_step.h"

#include "constraint/joint_hooks.h"
#include "direct/contact_check.h"
#include "direct/joint_parts.h"
#include "direct/joint_tree.h"
#include "direct/step_parts.h"

/* Factor of the budget of factorisations for islands with contacts; those without have
 * TD_BUDGET_OF_JOINTS. */
enum { BUDGET_WITH_CONTACTS = 2 };

/* The motion of one body from the start of the step to the start of the part (motion[0]) and, at
 * the mean velocity, to the end of the part (motion[1]). `start` is the time of the part's start in
 * the step, s. */
static void span_of_side(const td_island_work *work, int body, uint32_t record, double start,
                         double motion[2][3]) {
    const float *v = td_row(&work->w->velocity, td_slot_of_side(record));
    for (int k = 0; k < 3; k++) {
        const td_direct_body *b = body == TD_NONE ? NULL : &work->problem.bodies[body];
        double speed = b ? b->velocity[k] : (double)v[k];
        motion[0][k] = b ? b->moved[k] : start * (double)v[k];
        motion[1][k] = motion[0][k] + work->time * speed;
    }
}

/* Sets to 0 the angular part of the Jacobians of the island's bodies that do not turn. */
static void clear_arms(const td_direct *d, td_direct_constraint *c) {
    bool turns_a = c->a == TD_NONE || d->bodies[c->a].inverse_inertia > 0.0;
    bool turns_b = c->b == TD_NONE || d->bodies[c->b].inverse_inertia > 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        c->row[k].a[2] *= turns_a;
        c->row[k].b[2] *= turns_b;
    }
}

/* Computes the rows of all joints for the motion at the present mean velocities in the part that
 * begins at `start`. With `ended`: the ordinary Jacobian for the poses at the end of a part, and
 * `start` is the time of that end. */
static void update_joint_rows(td_island_work *work, double start, bool ended) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        if (c->kind < TD_PAIR_COUNT) {
            continue;
        }
        td_lane at = td_island_lane(work, i);
        td_span span = {.start = start, .time = ended ? 0.0 : work->time};
        span_of_side(work, c->a, at.block->a[at.lane], start, span.a);
        span_of_side(work, c->b, at.block->b[at.lane], start, span.b);
        for (int k = 0; k < 3 && ended; k++) {
            span.a[1][k] = span.a[0][k];
            span.b[1][k] = span.b[0][k];
        }
        work->w->kinds[c->kind]->lanes->update_rows(work->w, at.block, at.lane, &span, c);
        clear_arms(&work->problem, c);
        td_island_set_known(work, c);
    }
    td_direct_update_speeds(&work->problem);
    work->problem.measured = true;
}

/* Adds the geometric stiffness k of the joints' impulses to the moments of inertia. The moment of
 * an impulse that turns with its body changes by -k per unit of the body's mean angular velocity.
 * Near the angular velocity w that the last iteration found, the body therefore behaves as one of
 * inertia I + k that is pulled towards w: (I + k) w_new = I w_free + k w + impulses. Without k, the
 * iteration overshoots for a light body between heavy ones. k is at least TD_STIFFNESS_MIN I. */
static void add_geometric_stiffness(td_island_work *work) {
    td_direct *d = &work->problem;
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        const int side[2] = {c->a, c->b};
        for (int k = 0; k < 2; k++) {
            if (side[k] != TD_NONE) {
                d->bodies[side[k]].stiff += c->stiff[k];
            }
        }
    }
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        if (b->inverse_inertia > 0.0) {
            double own = 1.0 / b->own_inverse_inertia;
            double more = td_max_double(b->stiff, TD_STIFFNESS_MIN * own);
            b->inverse_inertia = 1.0 / (own + more);
            b->free[2] =
                (own * (b->before[2] + b->gain[2]) + more * b->velocity[2]) * b->inverse_inertia;
        }
        b->stiff = 0.0;
        b->former_angular = b->velocity[2];
    }
}

/* The greatest speed by which geometric stiffness has kept a body from turning freely: its moment k
 * (w_new - w), which vanishes when the iteration has converged, over the moment of inertia, times
 * the radius of gyration. Redundant joints may have impulses, and so k, of any size (self-stress);
 * the rows are then satisfied long before the moments are in balance, and the mechanism would go on
 * turning as before, whatever gravity and contacts do to it. */
static double unbalanced_speed(const td_island_work *work) {
    double worst = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        if (b->inverse_inertia > 0.0) {
            double own = 1.0 / b->own_inverse_inertia, more = 1.0 / b->inverse_inertia - own;
            double turn =
                td_abs(more * (b->velocity[2] - b->former_angular)) * b->own_inverse_inertia;
            worst = td_max_double(worst, turn * __builtin_sqrt(own * b->inverse_mass));
        }
    }
    return worst;
}

/* Restores the moments of inertia and free velocities. */
static void remove_geometric_stiffness(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        b->inverse_inertia = b->own_inverse_inertia;
        b->free[2] = (b->before[2] + b->gain[2]);
    }
}

/* The residual below which Newton's method ends, in multiples of the tolerance. */
static double newton_residual(const td_island_work *work) {
    bool everywhere = work->w->quality.overlap_limit == 0.0f;
    return everywhere && td_island_is_joints(work) ? TD_RESIDUAL_EXACT : 1.0;
}

/* Newton's method is given up after its first iteration if the residual is then more than
 * FAR_RESIDUAL tolerances, and fewer factorisations are left of the budget than MORE_SOLVES times
 * those of the first solve: two further iterations and the velocities at the end of the part need
 * at least that. Measured on walkers, ragdolls and bridges under falling boxes, at the quality
 * `default`: islands that converged within the budget had left at most 270 tolerances; of 61
 * attempts at a bridge none converged, and each had left more than 900. Where fewer than
 * FAR_BUDGET_MIN factorisations are left and, in an island with contacts, the first iteration does
 * not find the active set, the velocities of that search serve as an approximation: the rows change
 * with the velocities anyway, and the second iteration often finds the active set. Where a later
 * iteration begins with more than FAR_RESIDUAL tolerances and does not find it, the method is given
 * up too, since an interior point takes some twenty factorisations more. Under falling boxes an
 * attempt without a result takes 15 factorisations on average; without this rule it takes 24. */
#define FAR_RESIDUAL 500.0
enum { MORE_SOLVES = 3, FAR_BUDGET_MIN = 90 };

/* Whether all velocities are finite, and no body turns faster than THUD_ANGULAR_SPEED_MAX. */
static bool velocities_are_valid(const td_island_work *work) {
    bool all = true;
    for (int i = 0; i < work->island->bodies; i++) {
        const double *v = work->problem.bodies[i].velocity;
        all &= td_finite(v[0]) && td_finite(v[1]) && td_abs(v[2]) <= (double)THUD_ANGULAR_SPEED_MAX;
    }
    return all;
}

/* Solves for the present rows: by the tree of joints, or by the methods for any island. Returns the
 * residual, as td_direct_solve does. */
static double solve_rows(td_island_work *work, double tolerance) {
    double residual;
    return td_joint_tree_solve(&work->problem, work->w->islands.tree.data, tolerance, &residual)
               ? residual
               : td_direct_solve(&work->problem, tolerance);
}

/* solve_rows for iteration n of Newton's method. `far`: the residual before it is more than
 * FAR_RESIDUAL tolerances. Out: *rough, whether the active set was not found, and the velocities
 * are only an approximation. */
static double approach_rows(td_island_work *work, double tolerance, int n, bool far, bool *rough) {
    td_direct *d = &work->problem;
    double residual;
    *rough = false;
    if (td_joint_tree_solve(d, work->w->islands.tree.data, tolerance, &residual)) {
        return residual;
    }
    residual = td_direct_approach(d, tolerance);
    if (!td_finite(residual)) {
        bool little_left = d->factoring_budget - d->factorings < FAR_BUDGET_MIN;
        *rough = n == 0 && little_left && !td_island_is_joints(work);
        bool give_up = n > 0 && far && little_left;
        residual = *rough || give_up ? residual : td_direct_fall_back(d, tolerance);
    }
    return residual;
}

/* The first problem: mean velocities, by Newton's method. Returns the residual, as a speed;
 * infinite where a solve failed. */
static double solve_mean_velocity(td_island_work *work, double start, double tolerance) {
    td_direct *d = &work->problem;
    double missing = __builtin_inf(), unbalanced = 0.0;
    double enough = newton_residual(work) * tolerance;
    int before = d->factorings;
    bool rough = false;
    for (int n = 0; velocities_are_valid(work); n++) {
        update_joint_rows(work, start, false);
        double residual = n ? td_direct_residual(d) : __builtin_inf();
        bool far = residual > FAR_RESIDUAL * tolerance;
        if (n == TD_NEWTON_ITERATIONS_MAX) {
            work->unbalanced = td_max_double(work->unbalanced, unbalanced);
            return td_max_double(missing, residual);
        }
        if (!rough && residual <= enough && unbalanced <= TD_BALANCE_ENOUGH * tolerance) {
            return missing;
        }
        int left = d->factoring_budget - d->factorings;
        if (n == 1 && far && left < MORE_SOLVES * (d->factorings - before)) {
            break;
        }
        add_geometric_stiffness(work);
        missing = approach_rows(work, tolerance, n, far, &rough);
        if (!td_finite(missing) && !rough) {
            break;
        }
        unbalanced = unbalanced_speed(work);
        d->soft_warm_start = false; /* the next iteration starts from this one's active set */
    }
    return __builtin_inf();
}

/* Prepares motors and springs for the second problem, which finds the velocities at the end of the
 * part (solve_end_velocity). Its impulses change the velocity over the whole part; those of the
 * first problem, which finds the mean velocities, over half of it. So bounds are doubled, and a
 * spring gets the target speed at which it keeps the mean force that it had in the part. */
static void set_end_drives(td_direct_constraint *c) {
    c->bound *= 2.0;
    c->row[TD_DIRECT_TANGENT].max_impulse +=
        c->row[TD_DIRECT_TANGENT].kind == TD_ROW_FRICTION ? 0.5 * c->bound : 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        if (r->used && r->kind == TD_ROW_SOFT) {
            r->max_impulse *= 2.0;
            r->target_speed = r->speed + r->impulse / r->weight;
        }
    }
}

/* Removes an impulse along the Jacobian j from a free velocity. */
static void remove_impulse(td_direct_body *b, const double *j, double impulse) {
    b->free[0] -= b->inverse_mass * j[0] * impulse;
    b->free[1] -= b->inverse_mass * j[1] * impulse;
    b->free[2] -= b->inverse_inertia * j[2] * impulse;
}

/* Whether a joint's gap closes in this part, at a speed that is not negligible beside the bodies'
 * own. That speed is position correction, and must not remain in the velocities at the end. */
static bool closes_gaps(const td_island_work *work, double tolerance) {
    double worst = 0.0, fastest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const double *v = work->problem.bodies[i].before;
        fastest = td_max_double(fastest, v[0] * v[0] + v[1] * v[1]);
    }
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            bool locks = r->used && r->kind == TD_ROW_EQUALITY;
            worst = locks ? td_max_double(worst, r->closing) : worst;
        }
    }
    return worst > tolerance + TD_CLOSING_SHARE * __builtin_sqrt(fastest);
}

/* Lets the second problem start from the extrapolated velocities, with the impulses of equality
 * rows still in them: these impulses are kept in `mean_impulse`, and the rows' own are set to 0, so
 * that the second problem finds only what has to be added. The impulses of all other rows are taken
 * out of the free velocities, and solved for anew. (Solving for the whole impulses of equality rows
 * in their directions at the end of the part would lose energy, in proportion to the square of the
 * angle by which a direction turns.) */
static void keep_lock_impulses(td_island_work *work) {
    td_direct *d = &work->problem;
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        for (int k = 0; k < 3; k++) {
            b->free[k] = b->velocity[k];
        }
    }
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            bool locks = r->used && r->kind == TD_ROW_EQUALITY;
            r->mean_impulse = locks ? r->impulse : 0.0;
            r->impulse -= r->mean_impulse;
            if (r->used && !locks && c->a != TD_NONE) {
                remove_impulse(&d->bodies[c->a], r->a, r->impulse);
            }
            if (r->used && !locks && c->b != TD_NONE) {
                remove_impulse(&d->bodies[c->b], r->b, r->impulse);
            }
        }
    }
}

/* Adds the kept impulses of equality rows (mean_impulse) to those that the second problem has
 * found. */
static void restore_lock_impulses(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &work->problem.constraints[i].row[k];
            r->impulse += r->mean_impulse;
        }
    }
}

/* Whether the island has equality rows and springs alone: no contact, limit or motor. */
static bool has_only_locks_and_springs(const td_island_work *work) {
    bool any = false;
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            any |= r->used && (r->kind == TD_ROW_UNILATERAL || r->kind == TD_ROW_FRICTION);
        }
    }
    return !any;
}

/* The second problem: velocities at the end of the part, the time `end`. They start from 2 v -
 * v_before.
 * - Where gaps were closed, all rows are solved for anew, from the velocities without impulses.
 * - Otherwise the impulses of equality rows are kept, and the problem is solved for what has to be
 * added to them and for all other rows. If the island has equality rows and springs alone, nothing
 * is solved unless the velocities violate a row by more than TD_END_ERROR_MAX g h. Returns the
 * residual, as a speed. */
static double solve_end_velocity(td_island_work *work, double end, double tolerance) {
    td_direct *d = &work->problem;
    td_island_extrapolate(work);
    for (int i = 0; i < work->island->constraints; i++) {
        set_end_drives(&d->constraints[i]);
    }
    if (closes_gaps(work, tolerance)) {
        work->closed = true;
        update_joint_rows(work, end, true);
        return solve_rows(work, tolerance);
    }
    keep_lock_impulses(work);
    update_joint_rows(work, end, true);
    bool stays = has_only_locks_and_springs(work) &&
                 td_direct_residual(d) <= TD_END_ERROR_MAX * d->unit_speed;
    double missing = stays ? 0.0 : solve_rows(work, tolerance);
    restore_lock_impulses(work);
    return missing;
}

/* Prepares the step for `parts` parts: what gravity, forces and damping add to the mean velocity of
 * a part (gain), the moments of inertia without geometric stiffness, and the speeds at which
 * overlaps of contacts are pushed apart (closing; those of joints are set with their rows). */
static void begin_step(td_island_work *work, int parts) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            td_direct_row *r = &work->problem.constraints[i].row[k];
            r->closing = td_max_double(r->target_speed, 0.0);
        }
    }
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        for (int k = 0; k < 3; k++) {
            b->gain[k] = (b->free[k] - b->before[k]) / parts;
        }
        b->own_inverse_inertia = b->inverse_inertia;
    }
}

/* Sets the target speeds of contacts from their separations at the start of the part, which follow
 * from the motion so far with the normals and arms of the start of the step. The speed at which an
 * overlap is pushed apart is that of the start of the step. */
static void set_contact_speeds(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        td_lane at = td_island_lane(work, i);
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            td_direct_row *r = &c->row[k];
            if (r->used && c->kind < TD_PAIR_COUNT) {
                double gap =
                    td_island_gap(work, c, k, (double)at.block->point[k].start_separation[at.lane]);
                r->target_speed = gap > 0.0 ? -gap / work->time : r->closing;
            }
        }
    }
}

/* Begins a part with the velocities at the end of the part before; the first one with those before
 * the step, as td_island_set_up leaves them. */
static void begin_part(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        for (int k = 0; k < 3; k++) {
            b->before[k] = b->velocity[k];
            b->free[k] = b->before[k] + b->gain[k];
        }
    }
}

static void scale_impulses(td_island_work *work, double by) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            work->problem.constraints[i].row[k].impulse *= by;
        }
    }
}

/* Twice the kinetic energy of the island. With `free`, an upper bound of what it may be: each
 * component of a body's velocity counts as the larger of its value before the part and its value
 * without constraints. */
static double energy_of(const td_island_work *work, bool free) {
    double sum = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        double v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = free ? td_max_double(td_abs(b->free[k]), td_abs(b->before[k])) : b->velocity[k];
        }
        sum += (v[0] * v[0] + v[1] * v[1]) / b->inverse_mass;
        sum += b->inverse_inertia > 0.0 ? v[2] * v[2] / b->inverse_inertia : 0.0;
    }
    return sum;
}

/* Twice the energy that springs and motors may add in a step: a spring its potential energy, a
 * motor the kinetic energy of its effective mass at its target speed. */
static double energy_of_drives(const td_island_work *work) {
    double sum = 0.0;
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            bool drives = r->used && r->kind >= TD_ROW_FRICTION;
            double mass = r->kind == TD_ROW_SOFT ? r->weight : r->mass;
            sum += drives ? mass * r->target_speed * r->target_speed : 0.0;
        }
    }
    return sum;
}

/* Twice the energy that closing gaps and overlaps may add: the mass of the island times the square
 * of the maximum closing speed, times the number of its bodies, since corrections add up along a
 * chain. */
static double energy_of_closing(const td_island_work *work) {
    double mass = 0.0, pushed = work->correction_speed + work->problem.unit_speed;
    for (int i = 0; i < work->island->bodies; i++) {
        mass += 1.0 / work->problem.bodies[i].inverse_mass;
    }
    return mass * pushed * pushed * work->island->bodies;
}

/* Twice the work that gravity, forces and damping do in a step that is divided into parts of length
 * h = part_time: a body whose velocity they change by 2 gain in a part is under the force 2 m gain
 * / h. */
static double work_of_forces(const td_island_work *work, double part_time) {
    double sum = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        sum += (b->gain[0] * b->moved[0] + b->gain[1] * b->moved[1]) / b->inverse_mass;
        sum += b->inverse_inertia > 0.0 ? b->gain[2] * b->moved[2] / b->inverse_inertia : 0.0;
    }
    return 4.0 * sum / part_time;
}

/* Whether a motor, a spring, or a body outside of the island that moves may add energy. */
static bool is_driven(const td_island_work *work) {
    bool driven = false;
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_constraint *c = &work->problem.constraints[i];
            const td_direct_row *r = &c->row[k];
            bool motor = r->kind == TD_ROW_FRICTION && c->kind >= TD_PAIR_COUNT;
            driven |= r->used && (r->kind == TD_ROW_SOFT || motor || r->known_speed != 0.0);
        }
    }
    return driven;
}

/* Whether a constraint joins the island to a body outside of it, which may take up its momentum. */
static bool is_held(const td_island_work *work) {
    bool held = false;
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &work->problem.constraints[i];
        held |= c->a == TD_NONE || c->b == TD_NONE;
    }
    return held;
}

/* Scales down the velocities, so that closing gaps adds no energy (td_share_after_closing). In an
 * island that is joined to nothing outside, only velocities relative to its centre of mass are
 * scaled, which keeps its momentum. `allowed` is twice the kinetic energy that the island may have.
 */
static void remove_closing_energy(td_island_work *work, double allowed) {
    td_direct *d = &work->problem;
    double mass = 0.0, mean[2] = {0.0, 0.0};
    bool held = is_held(work);
    for (int i = 0; i < work->island->bodies && !held; i++) {
        double own = 1.0 / d->bodies[i].inverse_mass;
        mass += own;
        mean[0] += own * d->bodies[i].velocity[0];
        mean[1] += own * d->bodies[i].velocity[1];
    }
    double whole = mass > 0.0 ? (mean[0] * mean[0] + mean[1] * mean[1]) / mass : 0.0;
    double share = td_share_after_closing(energy_of(work, false) - whole, allowed - whole);
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        for (int k = 0; k < 3; k++) {
            double kept = k < 2 && mass > 0.0 ? mean[k] / mass : 0.0;
            b->velocity[k] = kept + share * (b->velocity[k] - kept);
        }
    }
}

double td_island_solve_joints(td_island_work *work, double tolerance) {
    double missing = 0.0, whole = work->time;
    double drives = energy_of_drives(work);
    td_island_energy energy = {.start = energy_of(work, false) + drives,
                               .free = energy_of(work, true) + drives};
    int parts = td_island_parts(work);
    if (parts == 0) {
        return __builtin_inf();
    }
    work->problem.effort = work->w->islands.effort;
    /* Qualities that solve every island directly (overlap_limit 0, as `exact`) do without the line
     * search: their budgets are large, so that it would save little, and one of 48 chains of soft
     * welds on a floor gains energy with it (test_joints_stiff.c). */
    work->problem.search = work->w->quality.overlap_limit > 0.0f ? &td_direct_line_search : NULL;
    work->problem.factoring_budget *=
        td_island_is_joints(work) ? TD_BUDGET_OF_JOINTS : BUDGET_WITH_CONTACTS;
    work->time = whole / parts;
    scale_impulses(work, 1.0 / parts);
    begin_step(work, parts);
    for (int part = 0; part < parts && td_finite(missing); part++) {
        begin_part(work);
        work->elapsed = part * work->time;
        if (parts > 1) {
            set_contact_speeds(work);
        }
        work->elapsed = (part + 1) * work->time;
        work->next = part + 1 < parts ? work->time : whole;
        double then = solve_mean_velocity(work, part * work->time, tolerance);
        remove_geometric_stiffness(work);
        td_island_add_motion(work);
        missing = td_max_double(missing, then);
        if (td_finite(missing)) {
            then = solve_end_velocity(work, (part + 1) * work->time, tolerance);
            missing = td_max_double(missing, then);
        }
        /* The first problem of the next part starts from half of the impulses of the second one,
         * since they act over half of the part. The caller expects those of the whole step. */
        scale_impulses(work, part + 1 < parts ? 0.5 : (double)parts);
    }
    work->w->islands.effort = work->problem.effort;
    energy.work = work_of_forces(work, work->time);
    if (work->closed && td_finite(missing) && !is_driven(work)) {
        remove_closing_energy(work, energy.start + energy.work);
    }
    energy.now = energy_of(work, false);
    if (td_gains_out_of_balance(&energy, work->unbalanced, tolerance)) {
        missing = __builtin_inf();
    }
    work->time = work->elapsed = whole;
    /* The result is refused if a velocity is not finite, as after an overflow where lever arms are
     * long, or if a body with contacts has turned further than turn_max, for which its contacts'
     * lever arms of the start of the step are still accurate enough. td_island_compute need not
     * check rotations again: turn_max becomes infinite. */
    missing = td_finite(energy.now) && !td_island_turns_too_far(work) ? missing : __builtin_inf();
    work->turn_max = __builtin_inf();
    if (td_finite(missing) && missing > tolerance && !td_island_is_joints(work) &&
        td_island_sinks(work, tolerance * whole)) {
        missing = __builtin_inf();
    }
    if (td_island_is_joints(work)) {
        energy.free = td_max_double(energy.free, energy_of(work, true));
        energy.pushed = energy_of_closing(work);
        missing = td_gains_energy(&energy) ? __builtin_inf() : missing;
        work->correction_speed = __builtin_inf();
        /* The number of factorisations depends on how fast the bodies turn, so that it does not
         * count as a slow step, which would predict that the island stays expensive. */
        work->w->stats.factorings += work->problem.factorings;
        work->w->stats.island_work += work->problem.factorings * td_island_cost(work->island);
        work->problem.factorings = 0;
    }
    return missing;
}
