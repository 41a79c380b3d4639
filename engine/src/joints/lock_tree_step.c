/* lock_tree_step.c: solves the step of a direct island whose constraints are hinges and welds,
 * without limits, springs or motors, that form a tree joined to the world at one body at most.
 *
 * The method is that of direct/island_step_joints.c: parts, in each the mean velocities v by
 * Newton's method, with lever arms averaged over the motion (discrete gradients) and the geometric
 * stiffness; then the velocities at the end, 2 v - v_before. That file solves it for any island; in
 * a tree of locks the rows need no matrix (lock_tree.h), so that an iteration takes a fraction of
 * the time. Whatever is refused here is solved there. */
#include "direct/island_step.h"

#include "constraint/joint_hooks.h"
#include "direct/elimination_order.h"
#include "direct/joint_parts.h"
#include "direct/lock_tree.h"
#include "direct/step_parts.h"
#include "joints/joint.h"

#include <string.h>

/* The step of one island. Bodies are numbered as in lock_tree.h, the root first. */
typedef struct tree_step {
    thud_world *w;
    const td_island *island;
    const td_direct_body *known; /* null, or the bodies with the impulses of contacts */
    td_lock_body *bodies;
    int count;
    double part;       /* length of a part, s */
    double tolerance;  /* td_island_tolerance, length/s */
    double unbalanced; /* greatest moment out of balance after a part, as a speed: length/s */
    double closing;    /* greatest speed at which a gap may be closed, length/s or rad/s */
    double speed_max;  /* of a body, length/s */
    double residual;   /* greatest speed that a joint has at the end of a part, length/s */
    bool closed;       /* a part has closed gaps */
    int factorings, factorings_max;
} tree_step;

/* What a solution costs for each body, in operations on 3 x 3 blocks: thud_quality.island_work.
 * Measured in instructions, with what comes before and after the iterations. */
enum { TREE_COST = 2 };
/* The budget of a linkage (joint_subsystems.c), beside the island budget of the step, as many
 * factorisations times TD_BUDGET_OF_JOINTS. Chosen: a chain that whips is solved in many parts. */
enum { LINKAGE_BUDGET = 64 };

/* ---- the tree ---- */

/* The number in the island of a lane's body, or TD_NONE if it does not move. */
static int number_of(const tree_step *s, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return td_inv_mass_of(s->w, slot) > 0.0f ? td_island_number(s->w, s->island, slot) : TD_NONE;
}

/* Lists the joint of every body to the one before it, and finds the body that is joined to a body
 * outside of the island: *held and *hold, its joint; TD_NONE where there is none. False where a
 * constraint is no lock of a point, or the joints do not form a tree. */
static bool list_joints(const tree_step *s, td_listed_body *list, int *held, int *hold) {
    const thud_world *w = s->w;
    for (int i = 0; i < s->count; i++) {
        list[i] = (td_listed_body){TD_NONE, TD_NONE, TD_NONE};
    }
    *held = *hold = TD_NONE;
    for (int i = 0; i < s->island->constraints; i++) {
        int index = td_int_at(&w->islands.constraints, s->island->first_constraint + i);
        const td_constraint *constraint = td_constraint_at(w, index);
        if (constraint->kind != TD_CONSTRAINT_LOCK) {
            return false;
        }
        td_lane at = td_lane_of(w, constraint);
        const td_point *p = at.block->point;
        bool is_point = p[0].normal_mass[at.lane] > 0.0f && p[1].normal_mass[at.lane] > 0.0f &&
                        td_lock_rows_at(at.block)->frame_turns[at.lane] <= 0.0f;
        int a = number_of(s, at.block->a[at.lane]), b = number_of(s, at.block->b[at.lane]);
        int later = td_max_int(a, b), before = td_min_int(a, b);
        if (!is_point || (before != TD_NONE ? list[later].link : *held) != TD_NONE) {
            return false;
        }
        if (before != TD_NONE) {
            list[later].before = before;
            list[later].link = i;
        } else {
            *held = later;
            *hold = i;
        }
    }
    return true;
}

/* Puts a body of the list at an index of the tree. `link`: the joint to its parent, or TD_NONE. */
static void place(const tree_step *s, td_listed_body *list, int number, int index, int parent,
                  int link) {
    list[number].place = index;
    s->bodies[index] =
        (td_lock_body){.number = number, .parent = parent, .link = link, .joined = link != TD_NONE};
}

/* Numbers the bodies so that each comes after its parent. The root is the body that is joined to
 * the outside: the bodies from it to the first of the list are turned over, so that each hangs from
 * the one that hung from it. */
static void set_order(const tree_step *s, td_listed_body *list, int held, int hold) {
    int placed = 0, link = hold;
    for (int n = held == TD_NONE ? 0 : held; n != TD_NONE; n = list[n].before) {
        place(s, list, n, placed, placed ? placed - 1 : TD_NONE, link);
        link = list[n].link;
        placed++;
    }
    for (int n = 0; n < s->count; n++) {
        if (list[n].place == TD_NONE) {
            place(s, list, n, placed++, list[list[n].before].place, list[n].link);
        }
    }
}

/* What forces, damping and the known impulses of contacts add to the mean velocity of a body in the
 * step. Without the last two it is half of what forces add in all substeps; td_island_free_velocity
 * gives the same, but for rounding. */
static void take_gain(const tree_step *s, td_lock_body *t, const td_body *body,
                      td_awake_slot slot) {
    const float *substep_gain = td_row(&s->w->substep_gain, slot);
    bool damped = body->linear_damping > 0.0f || body->angular_damping > 0.0f;
    double before[3], free[3];
    if (s->known) {
        memcpy(free, s->known[t->number].free, sizeof free);
    } else if (damped) {
        td_island_free_velocity(s->w, s->island, t->number, before, free);
    }
    for (int k = 0; k < 3; k++) {
        double gain = 0.5 * s->w->substeps * (double)substep_gain[k];
        t->gain[k] = s->known || damped ? free[k] - t->before[k] : gain;
    }
}

/* Sets mass and velocities of a body, for a step of one part. */
static void take_body(const tree_step *s, td_lock_body *t) {
    const td_islands *islands = &s->w->islands;
    int place = s->island->first_body + t->number;
    td_awake_slot slot = td_slot_in(&islands->slots, place);
    const td_body *body = td_body_at(s->w, td_body_of(s->w, slot));
    const float *start = td_at(&islands->island_start_velocity, place);
    for (int k = 0; k < 3; k++) {
        t->velocity[k] = t->before[k] = (double)start[k];
    }
    take_gain(s, t, body, slot);
    t->turns = body->inv_inertia > 0.0f;
    t->mass = 1.0 / (double)body->inv_mass;
    t->inertia = t->turns ? 1.0 / (double)body->inv_inertia : 1.0;
}

/* A lever arm from its crosses with the directions u and v of a joint's frame. */
static void arm_of(double x, double y, float cross_u, float cross_v, bool turns, double arm[2]) {
    double u = turns ? (double)cross_u : 0.0, v = turns ? (double)cross_v : 0.0;
    arm[0] = x * v + y * u;
    arm[1] = y * v - x * u;
}

/* Sets the joint of a body, likewise. False where it welds a body that does not turn. */
static bool take_joint(const tree_step *s, td_lock_body *t) {
    td_lane at =
        td_lane_of(s->w, td_constraint_at(s->w, td_int_at(&s->w->islands.constraints,
                                                          s->island->first_constraint + t->link)));
    const td_point *p = &at.block->point[0], *q = &at.block->point[1];
    const td_lock_rows *rows = td_lock_rows_at(at.block);
    const float *impulses = td_at(&s->w->islands.impulses, s->island->first_constraint + t->link);
    int lane = at.lane;
    bool is_b = number_of(s, at.block->b[lane]) == t->number;
    bool holder_turns = t->parent == TD_NONE || s->bodies[t->parent].turns;
    double x = t->axis[0] = (double)at.block->nx[lane], y = t->axis[1] = (double)at.block->ny[lane];
    double sign = t->sign = is_b ? 1.0 : -1.0;
    double half = 0.5; /* the impulses of the mean velocity are half of those of the step */
    t->block = at.block;
    t->lane = lane;
    double u = sign * (double)p->start_separation[lane],
           v = sign * (double)q->start_separation[lane];
    arm_of(x, y, p->cross_a[lane], q->cross_a[lane], is_b ? holder_turns : t->turns,
           is_b ? t->holder : t->arm);
    arm_of(x, y, p->cross_b[lane], q->cross_b[lane], is_b ? t->turns : holder_turns,
           is_b ? t->arm : t->holder);
    t->gap[0] = x * u - y * v;
    t->gap[1] = y * u + x * v;
    t->impulse[0] = half * sign * (x * (double)impulses[0] - y * (double)impulses[1]);
    t->impulse[1] = half * sign * (y * (double)impulses[0] + x * (double)impulses[1]);
    t->weld = at.block->tangent_mass[lane] > 0.0f;
    if (t->weld) {
        double turn_sign = sign * (double)rows->turn_sign[lane];
        t->turn_gap = turn_sign * (double)rows->start_turn_gap[lane];
        t->turn_impulse = half * turn_sign * (double)impulses[TD_DIRECT_TANGENT];
    }
    if (t->parent == TD_NONE) {
        const float *outside =
            td_row(&s->w->velocity, td_slot_of_side((is_b ? at.block->a : at.block->b)[lane]));
        for (int k = 0; k < 3; k++) {
            t->outside[k] = (double)outside[k];
        }
    }
    t->sweeps |= !td_arm_is_centred(s->w, t->arm[0], t->arm[1]);
    if (t->parent != TD_NONE) {
        s->bodies[t->parent].sweeps |= !td_arm_is_centred(s->w, t->holder[0], t->holder[1]);
    }
    return !t->weld || (t->turns && holder_turns);
}

/* The number of parts that the present velocities require: from the fastest rotation that moves an
 * anchor. */
static int parts_of(const tree_step *s) {
    double fastest = 0.0;
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        fastest = t->sweeps ? td_max_double(fastest, td_abs(t->velocity[2])) : fastest;
    }
    return td_parts_of(s->w, s->island, fastest, true, 0.0);
}

/* ---- a part ---- */

/* Turns a lever arm by the rotation of its body. */
static void turn_arm(const double rotation[2], const double from[2], double to[2]) {
    to[0] = rotation[0] * from[0] - rotation[1] * from[1];
    to[1] = rotation[1] * from[0] + rotation[0] * from[1];
}

/* The rotation by `angle`, or, with `mean`, its average while it grows to `angle`: by half of it,
 * shortened by the ratio of chord to arc, so that an arm times the rotation is the chord by which
 * its end moves. */
static void rotation_of(double angle, bool mean, double rotation[2]) {
    double half = mean ? 0.5 * angle : angle;
    td_joint_sincos(half, &rotation[1], &rotation[0]);
    if (mean && half * half >= TD_CHORD_IS_ARC) {
        double shorter = rotation[1] / half;
        rotation[0] *= shorter;
        rotation[1] *= shorter;
    }
}

/* Sets arm_now and holder_now: at the end of the part, from its motion so far (`ended`), or
 * averaged over the part at the present mean velocities. */
static void turn_arms(const tree_step *s, bool ended, double elapsed) {
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        double outside[2];
        const double *holder = outside;
        rotation_of(ended ? t->moved[2] : s->part * t->velocity[2], !ended, t->rotation);
        if (t->parent == TD_NONE) {
            rotation_of(t->outside[2] * (ended ? elapsed : s->part), !ended, outside);
        } else {
            holder = s->bodies[t->parent].rotation;
        }
        turn_arm(t->rotation, ended ? t->arm : t->arm_before, t->arm_now);
        turn_arm(holder, ended ? t->holder : t->holder_before, t->holder_now);
    }
}

/* The gap of a body's joint after the motion so far, with these lever arms. */
static void gap_of(const tree_step *s, const td_lock_body *t, const double arm[2],
                   const double holder[2], double elapsed, double gap[2]) {
    for (int k = 0; k < 2; k++) {
        double held =
            t->parent == TD_NONE ? elapsed * t->outside[k] : s->bodies[t->parent].moved[k];
        gap[k] =
            t->gap[k] + (t->moved[k] - held) + (arm[k] - t->arm[k]) - (holder[k] - t->holder[k]);
    }
}

/* The gap of a weld's rotation, likewise. */
static double turn_gap_of(const tree_step *s, const td_lock_body *t, double elapsed) {
    double held = t->parent == TD_NONE ? elapsed * t->outside[2] : s->bodies[t->parent].moved[2];
    return t->turn_gap + (t->moved[2] - held);
}

static void scale_impulse(td_lock_body *t, double by) {
    t->impulse[0] *= by;
    t->impulse[1] *= by;
    t->turn_impulse *= by;
}

/* Begins a part with the velocities at the end of the part before, and sets the speeds at which the
 * gaps close in it. `elapsed`: time from the start of the step. */
static void begin_part(tree_step *s, double elapsed) {
    const thud_world *w = s->w;
    double unit = (double)w->length_scale;
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        for (int k = 0; k < 3; k++) {
            t->before[k] = t->velocity[k];
        }
        for (int k = 0; k < 2; k++) {
            t->arm_before[k] = elapsed > 0.0 ? t->arm_now[k] : t->arm[k];
            t->holder_before[k] = elapsed > 0.0 ? t->holder_now[k] : t->holder[k];
        }
        if (!t->joined) {
            continue;
        }
        double gap[2], x = t->axis[0], y = t->axis[1];
        gap_of(s, t, t->arm_before, t->holder_before, elapsed, gap);
        double u = td_joint_part_closing(w, x * gap[0] + y * gap[1], unit, s->part);
        double v = td_joint_part_closing(w, x * gap[1] - y * gap[0], unit, s->part);
        t->closing[0] = x * u - y * v;
        t->closing[1] = y * u + x * v;
        if (t->weld) {
            t->turn_closing = td_joint_part_closing(w, turn_gap_of(s, t, elapsed), 1.0, s->part);
        }
    }
}

/* Solves for the velocities. False where a number is not finite, a rotation is too fast for td_sin,
 * or the budget of work is spent. */
static bool solve(tree_step *s) {
    int64_t *effort = &s->w->islands.effort;
    if (s->factorings == s->factorings_max || *effort < TREE_COST * s->count) {
        return false;
    }
    *effort -= TREE_COST * s->count;
    s->factorings++;
    return td_lock_tree_solve(s->bodies, s->count);
}

/* Sets the joints' targets: the closing of their gaps, or no speed. */
static void set_targets(const tree_step *s, bool close) {
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        t->target[0] = close ? t->closing[0] : 0.0;
        t->target[1] = close ? t->closing[1] : 0.0;
        t->turn_target = close ? t->turn_closing : 0.0;
    }
}

/* The moments of inertia with the geometric stiffness of the joints' impulses (island_step_joints.c
 * describes it), and the momenta without those impulses. */
static void set_momenta(const tree_step *s) {
    double half = 0.5 * s->part;
    for (int i = s->count - 1; i >= 0; i--) {
        td_lock_body *t = &s->bodies[i];
        double own = t->arm_now[0] * t->impulse[0] + t->arm_now[1] * t->impulse[1];
        double up = t->holder_now[0] * t->impulse[0] + t->holder_now[1] * t->impulse[1];
        t->stiff += half * own;
        if (t->parent != TD_NONE) {
            s->bodies[t->parent].stiff -= half * up;
        }
        double more = t->turns ? td_max_double(t->stiff, TD_STIFFNESS_MIN * t->inertia) : 0.0;
        t->turning = t->inertia + more;
        t->momentum[0] = t->mass * (t->before[0] + t->gain[0]);
        t->momentum[1] = t->mass * (t->before[1] + t->gain[1]);
        t->momentum[2] = t->inertia * (t->before[2] + t->gain[2]) + more * t->velocity[2];
        t->turned = t->velocity[2];
        t->stiff = 0.0;
    }
}

/* The greatest speed by which geometric stiffness has kept a body from turning freely
 * (island_step_joints.c). */
static double unbalanced_speed(const tree_step *s) {
    double worst = 0.0;
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        double moment = (t->turning - t->inertia) * (t->velocity[2] - t->turned);
        worst = td_max_double(worst, moment * moment / (t->inertia * t->mass));
    }
    return __builtin_sqrt(worst);
}

/* The mean velocities of a part, by Newton's method. False where it does not converge. */
static bool solve_mean_velocity(tree_step *s) {
    bool everywhere = s->w->quality.overlap_limit == 0.0f;
    double enough = (everywhere ? TD_RESIDUAL_EXACT : 1.0) * s->tolerance;
    double unbalanced = 0.0;
    set_targets(s, true);
    for (int n = 0;; n++) {
        turn_arms(s, false, 0.0);
        double missing = n ? td_lock_tree_residual(s->bodies, s->count) : 0.0;
        bool last = n == TD_NEWTON_ITERATIONS_MAX;
        if (n && missing <= (last ? s->tolerance : enough) &&
            (last || unbalanced <= TD_BALANCE_ENOUGH * s->tolerance)) {
            s->unbalanced = td_max_double(s->unbalanced, unbalanced);
            return true;
        }
        set_momenta(s);
        if (last || !solve(s)) {
            return false;
        }
        unbalanced = unbalanced_speed(s);
    }
}

/* td_island_clamp_velocity */
static void clamp_velocity(const tree_step *s, double velocity[3]) {
    for (int k = 0; k < 3; k++) {
        double max = k < 2 ? s->speed_max : (double)THUD_ANGULAR_SPEED_MAX;
        velocity[k] = velocity[k] > max ? max : velocity[k] < -max ? -max : velocity[k];
    }
}

/* Moves the bodies at their mean velocities, and extrapolates these to the end of the part. */
static void move(tree_step *s) {
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        clamp_velocity(s, t->velocity);
        for (int k = 0; k < 3; k++) {
            t->moved[k] += s->part * t->velocity[k];
            t->velocity[k] = 2.0 * t->velocity[k] - t->before[k];
        }
        scale_impulse(t, 2.0);
    }
}

/* Whether gaps close at a speed that is not negligible beside the bodies' own (closes_gaps of
 * island_step_joints.c). */
static bool closes_gaps(const tree_step *s) {
    double worst = 0.0, fastest = 0.0;
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        double x = td_abs(t->closing[0]), y = td_abs(t->closing[1]);
        worst = td_max_double(worst, td_max_double(td_abs(t->turn_closing), td_max_double(x, y)));
        fastest = td_max_double(fastest, t->before[0] * t->before[0] + t->before[1] * t->before[1]);
    }
    return worst > s->tolerance + TD_CLOSING_SHARE * __builtin_sqrt(fastest);
}

/* Keeps the present impulses while further ones are solved for. */
static void keep_impulses(const tree_step *s) {
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        t->kept[0] = t->impulse[0];
        t->kept[1] = t->impulse[1];
        t->kept[2] = t->turn_impulse;
    }
}

/* Adds the impulses that were kept. */
static void restore_impulses(const tree_step *s) {
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        t->impulse[0] += t->kept[0];
        t->impulse[1] += t->kept[1];
        t->turn_impulse += t->kept[2];
    }
}

/* The velocities at the end of a part: all joints anew where gaps were closed; otherwise the
 * impulses of the mean velocity stay, and what velocities miss is corrected where it is too much.
 * `elapsed`: time from the start of the step. */
static bool solve_end_velocity(tree_step *s, double elapsed) {
    bool anew = closes_gaps(s);
    s->closed |= anew;
    double enough = TD_END_ERROR_MAX * td_gravity_speed(s->w);
    turn_arms(s, true, elapsed);
    set_targets(s, false);
    if (!anew) {
        s->residual = td_lock_tree_residual(s->bodies, s->count);
        if (s->residual <= enough) {
            return true;
        }
    }
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        t->turning = t->inertia;
        for (int k = 0; k < 3; k++) {
            double free = anew ? t->before[k] + 2.0 * t->gain[k] : t->velocity[k];
            t->momentum[k] = (k < 2 ? t->mass : t->inertia) * free;
        }
    }
    keep_impulses(s);
    bool solved = solve(s);
    s->residual = td_lock_tree_residual(s->bodies, s->count);
    if (!anew) {
        restore_impulses(s);
    }
    return solved;
}

/* ---- the result ---- */

/* Twice the kinetic energy of a velocity. */
static double energy_at(const td_lock_body *t, const double v[3]) {
    return t->mass * (v[0] * v[0] + v[1] * v[1]) + (t->turns ? t->inertia * v[2] * v[2] : 0.0);
}

/* Twice the kinetic energy of the larger of two velocities, component by component: before a part,
 * and after it without joints. */
static double free_energy(const tree_step *s) {
    double sum = 0.0;
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        double v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = td_max_double(td_abs(t->before[k]), td_abs(t->before[k] + t->gain[k]));
        }
        sum += energy_at(t, v);
    }
    return sum;
}

/* Twice the work that gravity, forces and damping have done in the step. */
static double work_of_forces(const tree_step *s) {
    double work = 0.0;
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        work += t->mass * (t->gain[0] * t->moved[0] + t->gain[1] * t->moved[1]);
        work += t->turns ? t->inertia * t->gain[2] * t->moved[2] : 0.0;
    }
    return 4.0 * work / s->part; /* a part adds 2 gain to a velocity */
}

static double energy_now(const tree_step *s) {
    double sum = 0.0;
    for (int i = 0; i < s->count; i++) {
        sum += energy_at(&s->bodies[i], s->bodies[i].velocity);
    }
    return sum;
}

/* Takes from the velocities the energy that closing gaps has added: td_share_after_closing.
 * `allowed` is twice the kinetic energy that the island may have. */
static void pay_for_closing(const tree_step *s, double allowed) {
    double mass = 0.0, mean[2] = {0.0, 0.0};
    for (int i = 0; i < s->count && !s->bodies[0].joined; i++) {
        const td_lock_body *t = &s->bodies[i];
        mass += t->mass;
        mean[0] += t->mass * t->velocity[0];
        mean[1] += t->mass * t->velocity[1];
    }
    double whole = mass > 0.0 ? (mean[0] * mean[0] + mean[1] * mean[1]) / mass : 0.0;
    double share = td_share_after_closing(energy_now(s) - whole, allowed - whole);
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        for (int k = 0; k < 3; k++) {
            double kept = k < 2 && mass > 0.0 ? mean[k] / mass : 0.0;
            t->velocity[k] = kept + share * (t->velocity[k] - kept);
        }
    }
}

/* The mass of the island times the square of the speed at which gaps may close, for each of its
 * bodies. */
static double energy_of_closing(const tree_step *s) {
    double mass = 0.0, pushed = s->closing + td_gravity_speed(s->w);
    for (int i = 0; i < s->count; i++) {
        mass += s->bodies[i].mass;
    }
    return mass * pushed * pushed * s->count;
}

/* Keeps the result of a body and of its joint. */
static void keep_result(const tree_step *s, td_lock_body *t, int parts, td_lock_result *result) {
    *result = (td_lock_result){.slot = td_slot_in(&s->w->islands.slots,
                                                  s->island->first_body + t->number),
                               .block = t->joined ? t->block : NULL,
                               .lane = t->lane};
    clamp_velocity(s, t->velocity);
    for (int k = 0; k < 3; k++) {
        result->velocity[k] = (float)t->velocity[k];
        result->moved[k] = (float)t->moved[k];
    }
    if (!t->joined) {
        return;
    }
    double gap[2], x = t->axis[0], y = t->axis[1], of_substep = (double)parts / s->w->substeps;
    double sign = t->sign, turn_sign = sign * (double)td_lock_rows_at(t->block)->turn_sign[t->lane];
    gap_of(s, t, t->arm_now, t->holder_now, s->w->def.time_step, gap);
    result->impulse[0] = (float)(of_substep * sign * (x * t->impulse[0] + y * t->impulse[1]));
    result->impulse[1] = (float)(of_substep * sign * (x * t->impulse[1] - y * t->impulse[0]));
    result->impulse[TD_DIRECT_TANGENT] = (float)(of_substep * turn_sign * t->turn_impulse);
    result->separation[0] = (float)(sign * (x * gap[0] + y * gap[1]));
    result->separation[1] = (float)(sign * (x * gap[1] - y * gap[0]));
    result->turn_gap = (float)(turn_sign * turn_gap_of(s, t, s->w->def.time_step));
}

/* The island as a tree, in `s`. False where it is none. */
static bool set_up(tree_step *s) {
    td_islands *islands = &s->w->islands;
    td_listed_body *list = islands->listed.data;
    int held, hold;
    if (!list_joints(s, list, &held, &hold)) {
        return false;
    }
    set_order(s, list, held, hold);
    bool sound = true;
    s->closing = s->unbalanced = 0.0;
    s->closed = false;
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        take_body(s, t);
        if (t->joined) {
            sound &= take_joint(s, t);
            for (int k = 0; k < 2; k++) {
                double speed = td_abs(t->gap[k]) / s->w->def.time_step;
                s->closing = td_max_double(s->closing, speed);
            }
        }
    }
    double most = (double)(TD_JOINT_CLOSING_SPEED * s->w->length_scale);
    s->closing = td_min_double(s->closing, most);
    return sound;
}

/* Divides gains and impulses among the parts. */
static void divide(tree_step *s, int parts) {
    s->part = s->w->def.time_step / parts;
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        for (int k = 0; k < 3; k++) {
            t->gain[k] /= parts;
        }
        scale_impulse(t, 1.0 / parts);
    }
}

/* Solves all parts. False where one fails. */
static bool solve_parts(tree_step *s, int parts) {
    bool solved = true;
    for (int part = 0; part < parts && solved; part++) {
        for (int i = 0; i < s->count && part; i++) {
            scale_impulse(&s->bodies[i], 0.5); /* those of the end are of the whole part */
        }
        begin_part(s, part * s->part);
        solved = solve_mean_velocity(s);
        if (solved) {
            move(s);
            solved = solve_end_velocity(s, (part + 1) * s->part);
        }
    }
    return solved;
}

/* Solves the step in so many parts. False where a part fails, or the result is not plausible. */
static bool solve_step(tree_step *s, int parts) {
    td_island_energy energy = {.start = energy_now(s), .free = free_energy(s)};
    divide(s, parts);
    if (!solve_parts(s, parts)) {
        return false;
    }
    const double *outside = s->bodies[0].outside;
    bool pushed = outside[0] != 0.0 || outside[1] != 0.0 || outside[2] != 0.0;
    energy.work = work_of_forces(s);
    if (s->closed && !pushed) {
        pay_for_closing(s, energy.start + energy.work);
    }
    energy.now = energy_now(s);
    energy.free = parts > 1 ? td_max_double(energy.free, free_energy(s)) : energy.free;
    energy.pushed = energy_of_closing(s);
    return !td_gains_energy(&energy) &&
           !td_gains_out_of_balance(&energy, s->unbalanced, s->tolerance);
}

/* Solves the step in as many parts as the velocities before it require; and once more where those
 * after it require more. Returns the number of parts, 0 where none leads to a result. */
static int solve_in_parts(tree_step *s) {
    int parts = parts_of(s);
    bool solved = parts > 0 && solve_step(s, parts);
    int required = solved ? parts_of(s) : 0;
    if (required > parts) {
        set_up(s);
        solved = solve_step(s, required);
        parts = required;
    }
    return solved && required > 0 ? parts : 0;
}

td_tree_outcome td_lock_tree_step(thud_world *w, const td_island *island,
                                  const td_direct_body *known) {
    tree_step s = {.w = w,
                   .island = island,
                   .known = known,
                   .bodies = w->islands.locks.data,
                   .count = island->bodies,
                   .tolerance = td_island_tolerance(w),
                   .speed_max = (double)(w->def.maximum_speed * w->length_scale)};
    int left = known ? LINKAGE_BUDGET : td_island_factoring_budget(w, (int64_t)TREE_COST * s.count);
    s.factorings_max = TD_BUDGET_OF_JOINTS * left;
    if (!set_up(&s)) {
        return TD_TREE_REFUSED;
    }
    if (left == 0) {
        return TD_TREE_SPENT;
    }
    int parts = solve_in_parts(&s);
    w->stats.factorings += s.factorings;
    w->stats.island_work += (int64_t)s.factorings * TREE_COST * s.count;
    if (parts == 0) {
        return s.factorings == s.factorings_max ? TD_TREE_SPENT : TD_TREE_REFUSED;
    }
    for (int i = 0; i < s.count; i++) {
        keep_result(&s, &s.bodies[i], parts, td_at(&w->islands.results, island->first_body + i));
    }
    w->islands.tree_residual = (float)s.residual;
    return TD_TREE_SOLVED;
}

/* Writes the result of a joint to its lane. Returns whether its load keeps the island direct;
 * `known`: that of another joint does. */
static bool write_joint(thud_world *w, const td_lock_result *result, bool known) {
    td_lane at = {result->block, result->lane};
    for (int k = 0; k < 2; k++) {
        at.block->point[k].normal_impulse[at.lane] = result->impulse[k];
        at.block->point[k].separation[at.lane] = result->separation[k];
    }
    at.block->tangent_impulse[at.lane] = result->impulse[TD_DIRECT_TANGENT];
    td_lock_rows_of(at.block)->turn_gap[at.lane] = result->turn_gap;
    at.block->mark[at.lane].loaded |= TD_DIRECT;
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        load += td_abs((double)result->impulse[k]);
    }
    return known || td_island_load_stays(w, at, load * w->substeps);
}

void td_lock_tree_write(thud_world *w, const td_island *island) {
    const td_lock_result *results = w->islands.results.data;
    results += island->first_body;
    bool loaded = false;
    for (int i = 0; i < island->bodies; i++) {
        const td_lock_result *result = &results[i];
        memcpy(td_row(&w->velocity, result->slot), result->velocity, sizeof result->velocity);
        memcpy(td_row(&w->delta, result->slot), result->moved, sizeof result->moved);
        *td_slow_steps_at(w, result->slot) = 0;
        loaded = result->block ? write_joint(w, result, loaded) : loaded;
    }
    td_island_keep_direct(w, island, loaded);
}
