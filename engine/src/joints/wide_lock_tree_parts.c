/* wide_lock_tree_parts.c: solves the step of trees of locks (lock_tree.h), part by part.
 *
 * The method is that of direct/island_step_joints.c: in each part the mean velocities v by Newton's
 * method, with lever arms averaged over the motion (discrete gradients) and the geometric
 * stiffness; then the velocities at the end, 2 v - v_before. A tree that has converged, or failed,
 * keeps its velocities and impulses while the others of its vector go on.
 *
 * The length of a part is chosen for each tree when the part begins, by the angular velocities that
 * the tree's bodies have then (step_parts.c). A part in which a body turns too far is begun once
 * more, shorter.
 *
 * Passes over all bodies are slow (wide_tree.h), so a part has few of them: one where it begins,
 * one where it ends, and in each iteration of Newton's method one towards the root and one back.
 * (Two more where the velocities at the end are solved for.) */
#include "base/trig.h"
#include "direct/joint_parts.h"
#include "direct/step_parts.h"
#include "direct/wide_tree.h"
#include "joints/joint.h"

/* The step of the trees of a vector. */
typedef struct tree_step {
    td_lock_body *bodies;
    int count;
    const td_lock_step *of;
    td_choice going;  /* trees (one in each lane of a vector) whose step has not failed */
    td_choice closed; /* a part has closed gaps */

    /* ---- the part; of a tree that is done, its last one ---- */
    td_choice within;  /* trees that have not reached the end of the step, and have not failed */
    td_choice shorter; /* trees whose part of the step is begun once more with a shorter length,
                          because a body turned too far */
    td_reals required; /* number of parts into which a whole step has to be divided so that no body
                          turns too far in a part; 0: too many */
    td_reals share;    /* length of the part, as a share of the step */
    td_reals part;     /* the same, s; 0 of a tree that is done */
    td_reals half_of;  /* the share of a step over which twice the present impulses of joints act:
                          `share` while they are those of the mean velocity, half of a part's; twice
                          that once they are doubled (end_part). Their warm start in the next part
                          is scaled by the ratio */
    td_reals ended;    /* time since the start of the step that is solved, as a share of the step */
    td_reals elapsed;  /* the same, s */
    td_reals sweeping; /* greatest angular velocity at present of a body whose rotation moves an
                          anchor (td_lock_body.sweeps), rad/s */

    /* ---- results ---- */
    td_reals unbalanced; /* greatest moment out of balance after a part, as a speed: length/s */
    td_reals residual;   /* greatest speed along a locked direction of a joint at the end of a part,
                            length/s */
    int *factorings;     /* solutions, by tree */
} tree_step;

/* ---- rotation ---- */

/* Sine and cosine, by their series where the angle is small (td_joint_sincos). */
TD_INLINE void sincos_of(td_reals angle, td_reals *s, td_reals *c) {
    td_reals xx = angle * angle;
    *s = angle *
         (1.0 + xx * (-1.0 / 6 + xx * (1.0 / 120 + xx * (-1.0 / 5040 + xx * (1.0 / 362880)))));
    *c =
        1.0 + xx * (-0.5 + xx * (1.0 / 24 + xx * (-1.0 / 720 + xx * (1.0 / 40320 - xx / 3628800))));
    td_choice large = ~(td_choice)(td_reals_abs(angle) <= TD_SERIES_ANGLE_MAX);
    for (int i = 0; i < TD_TREES && td_choice_any(large); i++) {
        if (large[i]) {
            double sine, cosine;
            td_sincos(angle[i], &sine, &cosine);
            (*s)[i] = sine;
            (*c)[i] = cosine;
        }
    }
}

/* The rotation by `angle`, or, with `mean`, the average of all rotations from none to `angle`: that
 * by half of it, times the ratio of chord to arc, so that `angle` times the length of an arm turned
 * so is the chord by which the arm's end moves. */
TD_INLINE void rotation_of(td_reals angle, bool mean, td_reals rotation[2]) {
    td_reals half = mean ? 0.5 * angle : angle;
    sincos_of(half, &rotation[1], &rotation[0]);
    if (mean) {
        td_choice bent = (td_choice)(half * half >= TD_CHORD_IS_ARC);
        td_reals shorter = td_reals_pick(bent, rotation[1] / half, td_reals_all(1.0));
        rotation[0] *= shorter;
        rotation[1] *= shorter;
    }
}

/* Turns a lever arm by the rotation of its body. */
TD_INLINE void turn_arm(const td_reals rotation[2], const td_reals from[2], td_reals to[2]) {
    to[0] = rotation[0] * from[0] - rotation[1] * from[1];
    to[1] = rotation[1] * from[0] + rotation[0] * from[1];
}

/* Sets arm_now and holder_now of a body, after those of its parent: at the end of the part, from
 * its motion so far (`ended`), or averaged over the part at the present mean velocities. */
TD_INLINE void turn_arms(const tree_step *s, td_lock_body *t, bool ended) {
    td_reals outside[2];
    const td_reals *holder = outside;
    rotation_of(ended ? t->moved[2] : s->part * t->velocity[2], !ended, t->rotation);
    if (t->parent == TD_NONE) {
        rotation_of(t->outside[2] * (ended ? s->elapsed : s->part), !ended, outside);
    } else {
        holder = s->bodies[t->parent].rotation;
    }
    turn_arm(t->rotation, ended ? t->arm : t->arm_before, t->arm_now);
    turn_arm(holder, ended ? t->holder : t->holder_before, t->holder_now);
}

/* ---- a part ---- */

/* A part is begun once more, with a shorter duration, if a body turns in it by more than this many
 * times TURN_PART (step_parts.c). Measured on twenty chains of 50 links that swing at the quality
 * `default`: at 1.0 a step takes 4 % more solutions than at 1.25, at 1.5 it takes 1 % fewer, and
 * gaps are the same. */
#define TURN_EXCEEDED_MAX 1.25
/* The number of parts into which the rest of the step is divided is rounded up, unless it exceeds a
 * whole number by less than this. Chosen; larger than rounding errors. */
#define PARTS_ROUNDING 1e-9

/* Component k of the motion since the start of the step of the body that holds the joint: the
 * parent, or the body outside. */
TD_INLINE td_reals held_motion(const tree_step *s, const td_lock_body *t, int k) {
    return t->parent == TD_NONE ? s->elapsed * t->outside[k] : s->bodies[t->parent].moved[k];
}

TD_INLINE void scale_impulse(td_lock_body *t, td_reals by) {
    t->impulse[0] *= by;
    t->impulse[1] *= by;
    t->turn_impulse *= by;
}

TD_INLINE td_reals least_of(td_reals a, td_reals b) {
    return td_reals_pick((td_choice)(a < b), a, b);
}

/* td_joint_part_closing, for the trees that are within the step; else 0. */
static td_reals closing_of(const tree_step *s, td_reals gap, double unit) {
    td_reals width = td_reals_abs(gap), zero = td_reals_all(0.0);
    td_reals change =
        width * (TD_GAP_SHARE_PER_STEP * s->part / s->of->time) + TD_GAP_CLOSED_MIN * unit;
    change = least_of(least_of((double)TD_JOINT_CLOSING_SPEED * unit * s->part, change), width);
    td_reals speed = change / s->part;
    td_choice closes = s->within & (td_choice)(width > TD_GAP_IGNORED * unit);
    return td_reals_pick(closes, td_reals_pick((td_choice)(gap > zero), -speed, speed), zero);
}

/* The greater of `fastest` and the magnitude of a body's angular velocity, which counts only if its
 * rotation moves an anchor. */
TD_INLINE td_reals sweeping_of(const td_lock_body *t, td_reals fastest) {
    return td_reals_max(td_reals_abs(t->velocity[2]) * t->sweeps, fastest);
}

/* Sets `required` of the trees of `which` by the present angular velocities. */
static void require_parts(tree_step *s, td_choice which) {
    td_reals parts;
    for (int i = 0; i < TD_TREES; i++) {
        parts[i] = td_parts_of(s->of->world, s->of->island, s->sweeping[i], true, 0.0);
    }
    s->required = td_reals_pick(which, parts, s->required);
}

/* Chooses the length of the next part of each tree, dividing evenly what is left of the step.
 * Returns the factor by which the impulses are to be scaled. A tree that requires too many parts
 * fails. */
static td_reals choose_parts(tree_step *s) {
    td_choice few = (td_choice)(s->required > td_reals_all(0.0));
    s->going &= ~s->within | few;
    s->within &= few;
    td_reals left = td_reals_all(1.0) - s->ended, parts = left * s->required - PARTS_ROUNDING;
    for (int i = 0; i < TD_TREES; i++) {
        parts[i] = __builtin_ceil(parts[i]);
    }
    s->share = td_reals_pick(s->within, left / td_reals_max(parts, td_reals_all(1.0)), s->share);
    s->part = td_reals_pick(s->within, s->share * s->of->time, td_reals_all(0.0));
    td_reals half_of = td_reals_pick(s->within, s->share, s->half_of), scale = half_of / s->half_of;
    s->half_of = half_of;
    return scale;
}

/* Sets the target speeds of a body's joint: those at which its gap closes in this part. */
TD_INLINE void close_gap(const tree_step *s, td_lock_body *t) {
    double unit = (double)s->of->world->length_scale;
    td_reals gap[2], x = t->axis[0], y = t->axis[1];
    for (int k = 0; k < 2; k++) {
        gap[k] = t->gap[k] + (t->moved[k] - held_motion(s, t, k)) + (t->arm_before[k] - t->arm[k]) -
                 (t->holder_before[k] - t->holder[k]);
    }
    td_reals u = closing_of(s, x * gap[0] + y * gap[1], unit);
    td_reals v = closing_of(s, x * gap[1] - y * gap[0], unit);
    t->target[0] = x * u - y * v;
    t->target[1] = y * u + x * v;
    if (t->weld) {
        td_reals turned = t->moved[2] - held_motion(s, t, 2);
        t->turn_target = closing_of(s, t->turn_gap + turned, 1.0);
    }
}

/* Begins a part with the velocities at the end of the part before. */
static void begin_part(tree_step *s) {
    td_reals scale = choose_parts(s);
    td_choice first = (td_choice)(s->ended == td_reals_all(0.0));
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        scale_impulse(t, scale);
        for (int k = 0; k < 3; k++) {
            t->before[k] = td_reals_pick(s->within, t->velocity[k], t->before[k]);
        }
        for (int k = 0; k < 2; k++) {
            t->arm_before[k] = td_reals_pick(first, t->arm[k], t->arm_now[k]);
            t->holder_before[k] = td_reals_pick(first, t->holder[k], t->holder_now[k]);
            t->momentum[k] = t->mass * (t->before[k] + s->share * t->gain[k]);
        }
        t->turn_momentum = t->inertia * (t->before[2] + s->share * t->gain[2]);
        if (t->joined) {
            close_gap(s, t);
        }
        turn_arms(s, t, false);
    }
}

/* The moment of inertia of a body with the geometric stiffness of the joints' impulses
 * (island_step_joints.c describes it), and its momentum without those impulses. */
TD_INLINE void stiffen(const tree_step *s, td_lock_body *t) {
    td_reals zero = td_reals_all(0.0), half = 0.5 * s->part;
    td_reals own = t->arm_now[0] * t->impulse[0] + t->arm_now[1] * t->impulse[1];
    td_reals up = t->holder_now[0] * t->impulse[0] + t->holder_now[1] * t->impulse[1];
    td_reals stiff = t->stiff + half * own;
    t->stiff = zero;
    if (t->parent != TD_NONE) {
        s->bodies[t->parent].stiff -= half * up;
    }
    td_reals more = t->turns ? td_reals_max(stiff, TD_STIFFNESS_MIN * t->inertia) : zero;
    t->turning = t->inertia + more;
    t->momentum[2] = t->turn_momentum + more * t->velocity[2];
}

/* Sets the momentum with which a body enters the solution at the end of a part: in the trees of
 * `anew` the momentum without impulses of joints, else that of the extrapolated velocity, which is
 * to be corrected. */
TD_INLINE void take_end_momentum(const tree_step *s, td_lock_body *t, td_choice anew) {
    t->turning = t->inertia;
    for (int k = 0; k < 3; k++) {
        td_reals unjoined = t->before[k] + 2.0 * (s->share * t->gain[k]);
        td_reals free = td_reals_pick(anew, unjoined, t->velocity[k]);
        t->momentum[k] = (k < 2 ? t->mass : t->inertia) * free;
    }
}

/* The errors that remain after a solution. */
typedef struct tree_misses {
    td_reals speed;      /* greatest speed by which a joint misses its target, length/s */
    td_reals unbalanced; /* greatest speed by which geometric stiffness has kept a body from turning
                            freely (island_step_joints.c), length/s */
} tree_misses;

/* Solves for the velocities of the trees of `which`, some of which may fail. With `mean` these are
 * the mean velocities of the part: an iteration of Newton's method, which also sets the lever arms
 * of the next one. Without `mean` they are those at the end of the part. The impulses found are
 * then corrections, added to the impulses of the mean velocities; in the trees of `anew` they are
 * the whole impulses, and replace these. */
static tree_misses solve(tree_step *s, td_choice which, bool mean, td_choice anew) {
    td_reals zero = td_reals_all(0.0), missing = zero, unbalanced = zero, sweeping = zero;
    td_tree_sums sums = {zero, zero};
    for (int i = s->count - 1; i >= 0; i--) {
        td_lock_body *t = &s->bodies[i];
        if (mean) {
            stiffen(s, t);
        } else {
            take_end_momentum(s, t, anew);
        }
        td_tree_hang(s->bodies, t);
    }
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        td_reals before[3] = {t->impulse[0], t->impulse[1], t->turn_impulse};
        td_reals angular_before = t->velocity[2];
        td_tree_follow(s->bodies, t, which, &sums);
        if (mean) {
            td_reals moment = (t->turning - t->inertia) * (t->velocity[2] - angular_before);
            unbalanced = td_reals_max(unbalanced, moment * moment / (t->inertia * t->mass));
            turn_arms(s, t, false);
        } else {
            t->impulse[0] += td_reals_pick(which & ~anew, before[0], zero);
            t->impulse[1] += td_reals_pick(which & ~anew, before[1], zero);
            t->turn_impulse += td_reals_pick(which & ~anew, before[2], zero);
        }
        sweeping = sweeping_of(t, sweeping);
        missing = td_tree_miss(s->bodies, t, missing);
    }
    for (int i = 0; i < TD_TREES; i++) {
        unbalanced[i] = __builtin_sqrt(unbalanced[i]);
        s->factorings[i] += which[i] != 0;
    }
    s->sweeping = sweeping;
    s->going &= ~which | td_tree_sound(s->bodies, s->count, which, &sums);
    s->within &= s->going;
    return (tree_misses){missing, unbalanced};
}

/* The mean velocities of a part, by Newton's method. A tree that does not converge fails. */
static void solve_mean_velocity(tree_step *s) {
    td_reals unbalanced = td_reals_all(0.0);
    td_choice left = s->within;
    for (int n = 1; n <= TD_NEWTON_ITERATIONS_MAX && td_choice_any(left); n++) {
        bool last = n == TD_NEWTON_ITERATIONS_MAX;
        tree_misses misses = solve(s, left, true, left);
        unbalanced = td_reals_pick(left, misses.unbalanced, unbalanced);
        td_choice near = (td_choice)(misses.speed <= (last ? s->of->tolerance : s->of->enough));
        td_choice balanced = (td_choice)(unbalanced <= TD_BALANCE_ENOUGH * s->of->tolerance);
        left &= s->going & ~(last ? near : near & balanced);
    }
    s->going &= ~left;
    s->within &= ~left;
    s->unbalanced = td_reals_max(s->unbalanced, unbalanced);
}

/* td_island_clamp_velocity */
TD_INLINE td_reals clamp(td_reals x, double bound) {
    td_reals max = td_reals_all(bound);
    x = td_reals_pick((td_choice)(x > max), max, x);
    return td_reals_pick((td_choice)(x < -max), -max, x);
}

TD_INLINE td_reals clamp_component(const tree_step *s, td_reals speed, int k) {
    return clamp(speed, k < 2 ? s->of->speed_max : (double)THUD_ANGULAR_SPEED_MAX);
}

/* Rejects a part in which a body has turned too far, unless it was already begun once more: sets
 * the velocities back to those before it. Its new length follows from `required`, computed here
 * from the mean velocities. */
static void refuse_long_parts(tree_step *s) {
    td_choice first = s->within & ~s->shorter;
    require_parts(s, first);
    td_choice fits = (td_choice)(s->required > td_reals_all(0.0)) &
                     (td_choice)(s->required * s->share <= td_reals_all(TURN_EXCEEDED_MAX));
    s->shorter = first & ~fits;
    for (int i = 0; i < s->count; i++) {
        for (int k = 0; k < 3; k++) {
            td_reals *v = s->bodies[i].velocity;
            v[k] = td_reals_pick(s->shorter, s->bodies[i].before[k], v[k]);
        }
    }
}

/* Whether gaps close at a speed that is not negligible beside the bodies' own (closes_gaps of
 * island_step_joints.c). `closing`: the greatest closing speed; `squared`: the square of the
 * greatest speed of a body. */
TD_INLINE td_choice closes_gaps(const tree_step *s, td_reals closing, td_reals squared) {
    for (int i = 0; i < TD_TREES; i++) {
        squared[i] = __builtin_sqrt(squared[i]);
    }
    return (td_choice)(closing > s->of->tolerance + TD_CLOSING_SHARE * squared);
}

/* Moves a body through a part of the step (td_lock_step is solved in parts) at its mean velocity
 * there, and computes the velocity at the end of the part: twice the mean less the velocity at its
 * start, since the velocity is taken to change linearly within it. Trees whose part does not end
 * (`ends`) stay as they are. */
TD_INLINE void move(const tree_step *s, td_lock_body *t, td_choice ends) {
    for (int k = 0; k < 3; k++) {
        td_reals mean = clamp_component(s, t->velocity[k], k);
        t->moved[k] = td_reals_pick(ends, t->moved[k] + s->part * mean, t->moved[k]);
        t->velocity[k] = td_reals_pick(ends, 2.0 * mean - t->before[k], t->velocity[k]);
    }
}

/* Ends a part, unless it is begun once more. Where gaps were closed, the velocities at its end are
 * solved for anew, with all impulses of joints. Elsewhere the impulses of the mean velocities stay,
 * and a correction is solved for if a joint has more speed than td_lock_step.end_enough. */
static void end_part(tree_step *s) {
    td_choice ends = s->within & ~s->shorter;
    td_reals zero = td_reals_all(0.0), one = td_reals_all(1.0);
    td_reals twice = td_reals_pick(ends, td_reals_all(2.0), one);
    td_choice last = (td_choice)(one - s->ended == s->share);
    td_reals ended = td_reals_pick(last, one, s->ended + s->share);
    s->half_of *= twice;
    s->elapsed = td_reals_pick(ends, s->elapsed + s->part, s->elapsed);
    s->ended = td_reals_pick(ends, ended, s->ended);
    td_reals closing = zero, squared = zero, missing = zero, sweeping = zero;
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        move(s, t, ends);
        scale_impulse(t, twice);
        td_reals x = td_reals_abs(t->target[0]), y = td_reals_abs(t->target[1]);
        closing = td_reals_max(closing, td_reals_max(x, y));
        closing = td_reals_max(closing, td_reals_abs(t->turn_target));
        squared = td_reals_max(squared, t->before[0] * t->before[0] + t->before[1] * t->before[1]);
        t->target[0] = t->target[1] = t->turn_target = zero;
        turn_arms(s, t, true);
        sweeping = sweeping_of(t, sweeping);
        missing = td_tree_miss(s->bodies, t, missing);
    }
    s->sweeping = sweeping;
    s->residual = td_reals_pick(ends, missing, s->residual);
    td_choice anew = closes_gaps(s, closing, squared) & ends;
    s->closed |= anew;
    td_choice which = (anew | (td_choice)(missing > s->of->end_enough)) & ends;
    if (td_choice_any(which)) {
        s->residual = td_reals_pick(which, solve(s, which, false, anew).speed, s->residual);
    }
}

/* Solves all parts. A tree whose velocities at the end would require too many parts fails. */
static void solve_parts(tree_step *s) {
    for (int i = 0; i < s->count; i++) {
        s->sweeping = sweeping_of(&s->bodies[i], s->sweeping);
    }
    while (td_choice_any(s->within)) {
        require_parts(s, s->within & ~s->shorter);
        begin_part(s);
        solve_mean_velocity(s);
        refuse_long_parts(s);
        end_part(s);
        s->within &= (td_choice)(s->ended < td_reals_all(1.0));
    }
    require_parts(s, s->going);
    s->going &= (td_choice)(s->required > td_reals_all(0.0));
}

/* ---- energy ---- */

/* Twice the kinetic energy of a body at a velocity. */
TD_INLINE td_reals energy_at(const td_lock_body *t, const td_reals v[3]) {
    td_reals energy = t->mass * (v[0] * v[0] + v[1] * v[1]);
    return t->turns ? energy + t->inertia * v[2] * v[2] : energy;
}

TD_INLINE td_reals energy_now(const tree_step *s) {
    td_reals sum = td_reals_all(0.0);
    for (int i = 0; i < s->count; i++) {
        sum += energy_at(&s->bodies[i], s->bodies[i].velocity);
    }
    return sum;
}

/* Twice the kinetic energy at the larger of two velocities, component by component: that before a
 * part, and the mean velocity of the part without joints. */
TD_INLINE td_reals free_energy(const tree_step *s) {
    td_reals sum = td_reals_all(0.0);
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        td_reals v[3];
        for (int k = 0; k < 3; k++) {
            td_reals after = t->before[k] + s->share * t->gain[k];
            v[k] = td_reals_max(td_reals_abs(t->before[k]), td_reals_abs(after));
        }
        sum += energy_at(t, v);
    }
    return sum;
}

/* Twice the work that gravity, forces and damping have done in the step. */
TD_INLINE td_reals work_of_forces(const tree_step *s) {
    td_reals work = td_reals_all(0.0);
    for (int i = 0; i < s->count; i++) {
        const td_lock_body *t = &s->bodies[i];
        work += t->mass * (t->gain[0] * t->moved[0] + t->gain[1] * t->moved[1]);
        work += t->turns ? t->inertia * t->gain[2] * t->moved[2] : td_reals_all(0.0);
    }
    return 4.0 * work / s->of->time; /* in the step forces change a velocity by 2 gain */
}

/* Scales down the velocities of trees in which gaps were closed, so that closing gaps adds no
 * energy (td_share_after_closing). `allowed` is twice the kinetic energy that a tree may have. In
 * trees that are joined to no body outside, only velocities relative to the centre of mass are
 * scaled. Trees that are joined to a moving body keep their velocities, since that body may add
 * energy. */
TD_INLINE void pay_for_closing(const tree_step *s, td_reals allowed) {
    td_reals zero = td_reals_all(0.0), mass = zero, mean[2] = {zero, zero}, whole = zero;
    const td_lock_body *root = &s->bodies[0];
    bool loose = !root->joined;
    for (int i = 0; i < s->count && loose; i++) {
        const td_lock_body *t = &s->bodies[i];
        mass += t->mass;
        mean[0] += t->mass * t->velocity[0];
        mean[1] += t->mass * t->velocity[1];
    }
    if (loose) {
        whole = (mean[0] * mean[0] + mean[1] * mean[1]) / mass;
        mean[0] /= mass;
        mean[1] /= mass;
    }
    td_reals now = energy_now(s), share = td_reals_all(1.0);
    for (int i = 0; i < TD_TREES; i++) {
        bool pushed =
            root->outside[0][i] != 0.0 || root->outside[1][i] != 0.0 || root->outside[2][i] != 0.0;
        if (s->closed[i] && !pushed) {
            share[i] = td_share_after_closing(now[i] - whole[i], allowed[i] - whole[i]);
        }
    }
    for (int i = 0; i < s->count; i++) {
        td_lock_body *t = &s->bodies[i];
        for (int k = 0; k < 3; k++) {
            td_reals kept = k < 2 ? mean[k] : zero;
            t->velocity[k] = kept + share * (t->velocity[k] - kept);
        }
    }
}

/* Twice the energy that closing gaps may add (energy_of_closing of island_step_joints.c).
 * `closing`: the greatest closing speed. */
TD_INLINE td_reals energy_of_closing(const tree_step *s, td_reals closing) {
    td_reals mass = td_reals_all(0.0), pushed = closing + s->of->gravity_speed;
    for (int i = 0; i < s->count; i++) {
        mass += s->bodies[i].mass;
    }
    return mass * pushed * pushed * (double)s->count;
}

/* ---- the step ---- */

/* Sets `solved` of each tree: whether it has not failed, and its energy is plausible. */
TD_INLINE void check_energy(const td_lock_trees *trees, const tree_step *s, td_reals start,
                            td_reals free, td_reals work, bool *solved) {
    td_reals now = energy_now(s), pushed = energy_of_closing(s, trees->closing);
    free = td_reals_max(free, free_energy(s));
    for (int i = 0; i < TD_TREES; i++) {
        td_island_energy energy = {.start = start[i],
                                   .now = now[i],
                                   .work = work[i],
                                   .free = free[i],
                                   .pushed = pushed[i]};
        solved[i] = s->going[i] && !td_gains_energy(&energy) &&
                    !td_gains_out_of_balance(&energy, s->unbalanced[i], s->of->tolerance);
    }
}

td_lock_tree_parts_fn TD_WIDE(td_lock_tree_parts);
void TD_WIDE(td_lock_tree_parts)(td_lock_trees *trees, const td_lock_step *step) {
    tree_step s = {.bodies = trees->bodies,
                   .count = trees->count,
                   .of = step,
                   .share = td_reals_all(1.0),
                   .half_of = td_reals_all(1.0),
                   .factorings = trees->factorings};
    for (int i = 0; i < TD_TREES; i++) {
        trees->factorings[i] = 0;
        s.going[i] = s.within[i] = trees->used[i] ? -1 : 0;
    }
    td_reals start = energy_now(&s);
    for (int i = 0; i < s.count; i++) {
        for (int k = 0; k < 3; k++) {
            s.bodies[i].before[k] = s.bodies[i].velocity[k];
        }
    }
    td_reals free = free_energy(&s);
    solve_parts(&s);
    td_reals work = work_of_forces(&s);
    if (td_choice_any(s.closed & s.going)) {
        pay_for_closing(&s, start + work);
    }
    check_energy(trees, &s, start, free, work, trees->solved);
    for (int i = 0; i < s.count; i++) {
        for (int k = 0; k < 3; k++) {
            s.bodies[i].velocity[k] = clamp_component(&s, s.bodies[i].velocity[k], k);
        }
    }
    trees->share = s.share;
    trees->residual = s.residual;
}
