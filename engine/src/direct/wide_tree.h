/* wide_tree.h: the work for one td_lock_body, which stands for one body in each of TD_TREES trees
 * of hinges and welds (lock_tree.h): what it adds to its parent on the way from the ends of the
 * trees to their roots, and its velocity on the way back. joints/wide_lock_tree_parts.c passes over
 * all bodies in these orders, and does all other work for a body in the same passes: a body takes
 * more than a kilobyte, so that each further pass over all of them takes long. */
#ifndef TD_WIDE_TREE_H
#define TD_WIDE_TREE_H

#include "direct/lock_tree.h"

/* The velocity of the point at the end of a lever arm. */
TD_INLINE void td_tree_velocity_at(const td_reals velocity[3], const td_reals arm[2],
                                   td_reals u[2]) {
    u[0] = velocity[0] - velocity[2] * arm[1];
    u[1] = velocity[1] + velocity[2] * arm[0];
}

/* The velocity of the body that holds the joint: the parent, or the body outside. */
TD_INLINE const td_reals *td_tree_holder(const td_lock_body *bodies, const td_lock_body *t) {
    return t->parent == TD_NONE ? t->outside : bodies[t->parent].velocity;
}

/* Moves the point to which A and g of a body refer by (x, y): from its centre of mass to the end of
 * a lever arm, or, with (-x, -y), from there to the centre. */
TD_INLINE void td_tree_shift(td_reals a[6], td_reals g[3], td_reals x, td_reals y) {
    /* u = v + w (-y, x), so that v = u - w (-y, x). */
    td_reals xw = a[3] + a[0] * y - a[1] * x, yw = a[4] + a[1] * y - a[2] * x;
    a[5] += y * (a[3] + xw) - x * (a[4] + yw);
    a[3] = xw;
    a[4] = yw;
    g[2] += g[0] * y - g[1] * x;
}

/* Eliminates the rotation that a hinge leaves free: a and g become M = A_uu - A_uw A_wu / A_ww and
 * m = g_u - A_uw g_w / A_ww of lock_tree.h, with zeros for the rotation. */
TD_INLINE void td_tree_release(td_lock_body *t, td_reals a[6], td_reals g[3]) {
    td_reals xw = a[3], yw = a[4], w = g[2], per = 1.0 / a[5], x = per * xw, y = per * yw;
    t->per_turning = per;
    a[0] -= x * xw;
    a[1] -= x * yw;
    a[2] -= y * yw;
    a[3] = a[4] = a[5] = td_reals_all(0.0);
    g[0] -= x * w;
    g[1] -= y * w;
    g[2] = td_reals_all(0.0);
}

/* Adds a body and all that hangs from it to the parent's A and g: M and m - M t of a hinge, or A
 * and g - A t of a weld, shifted from the anchor to the parent's centre of mass. */
TD_INLINE void td_tree_pass_on(td_lock_body *t, td_lock_body *parent) {
    td_reals a[6], g[3];
    for (int k = 0; k < 6; k++) {
        a[k] = t->a[k];
    }
    for (int k = 0; k < 3; k++) {
        g[k] = t->g[k];
    }
    if (!t->weld) {
        td_tree_release(t, a, g);
    }
    const td_reals *s = t->target;
    g[0] -= a[0] * s[0] + a[1] * s[1];
    g[1] -= a[1] * s[0] + a[2] * s[1];
    if (t->weld) {
        g[0] -= a[3] * t->turn_target;
        g[1] -= a[4] * t->turn_target;
        g[2] -= a[3] * s[0] + a[4] * s[1] + a[5] * t->turn_target;
    }
    td_tree_shift(a, g, -t->holder_now[0], -t->holder_now[1]);
    for (int k = 0; k < 6; k++) {
        parent->a[k] += a[k];
    }
    for (int k = 0; k < 3; k++) {
        parent->g[k] += g[k];
    }
}

/* The velocity of a root that is joined to no body outside: solves A v = g by the factorisation A =
 * L D L'. */
TD_INLINE void td_tree_solve_free(const td_lock_body *t, td_reals v[3]) {
    const td_reals *a = t->a, *g = t->g;
    td_reals per = 1.0 / a[0], ly = a[1] * per, lw = a[3] * per;
    td_reals dy = a[2] - ly * a[1], yw = a[4] - ly * a[3], l = yw / dy;
    td_reals y = g[1] - ly * g[0], w = g[2] - lw * g[0] - l * y;
    v[2] = w / (a[5] - lw * a[3] - l * yw);
    v[1] = y / dy - l * v[2];
    v[0] = g[0] * per - ly * v[1] - lw * v[2];
}

/* Sets the velocity of a body, in v, and the impulse of its joint, in the trees of `which`, from
 * the velocity of its holder: u of the anchor is that in the holder plus the joint's target speed,
 * F = A (u, w) - g is the impulse, and w is the holder's angular velocity plus its target (weld),
 * or the one without moment (hinge): A_ww w = g_w - A_wu u. */
TD_INLINE void td_tree_follow_holder(td_lock_body *t, const td_reals holder[3], td_choice which,
                                     td_reals v[3]) {
    const td_reals *a = t->a, *g = t->g;
    td_reals u[2], w;
    td_tree_velocity_at(holder, t->holder_now, u);
    u[0] += t->target[0];
    u[1] += t->target[1];
    w = t->weld ? holder[2] + t->turn_target : t->per_turning * (g[2] - a[3] * u[0] - a[4] * u[1]);
    td_reals x = a[0] * u[0] + a[1] * u[1] + a[3] * w - g[0];
    td_reals y = a[1] * u[0] + a[2] * u[1] + a[4] * w - g[1];
    t->impulse[0] = td_reals_pick(which, x, t->impulse[0]);
    t->impulse[1] = td_reals_pick(which, y, t->impulse[1]);
    if (t->weld) {
        td_reals turn = a[3] * u[0] + a[4] * u[1] + a[5] * w - g[2];
        t->turn_impulse = td_reals_pick(which, turn, t->turn_impulse);
    }
    v[0] = u[0] + w * t->arm_now[1];
    v[1] = u[1] - w * t->arm_now[0];
    v[2] = w;
}

/* On the way to the root: adds the body's own mass and momentum to A and g, which hold the sums of
 * the bodies that hang from it, shifts them to its anchor, and adds them to its parent. */
TD_INLINE void td_tree_hang(td_lock_body *bodies, td_lock_body *t) {
    t->a[0] += t->mass;
    t->a[2] += t->mass;
    t->a[5] += t->turning;
    for (int k = 0; k < 3; k++) {
        t->g[k] += t->momentum[k];
    }
    td_tree_shift(t->a, t->g, t->arm_now[0], t->arm_now[1]);
    if (t->parent != TD_NONE) {
        td_tree_pass_on(t, &bodies[t->parent]);
    } else {
        t->per_turning = 1.0 / t->a[5];
    }
}

/* Sums and maxima over all bodies of the trees in one solution. */
typedef struct td_tree_sums {
    td_reals sum;     /* of velocities and impulses: not finite if one of them is not */
    td_reals fastest; /* the greatest angular velocity, rad/s */
} td_tree_sums;

/* On the way from the root: sets a body's velocity and the impulse of its joint, in the trees of
 * `which`, and empties `a` and `g` for the next solution. */
TD_INLINE void td_tree_follow(td_lock_body *bodies, td_lock_body *t, td_choice which,
                              td_tree_sums *sums) {
    td_reals v[3];
    if (t->joined) {
        td_tree_follow_holder(t, td_tree_holder(bodies, t), which, v);
    } else {
        td_tree_solve_free(t, v);
    }
    for (int k = 0; k < 3; k++) {
        t->velocity[k] = td_reals_pick(which, v[k], t->velocity[k]);
        t->g[k] = td_reals_all(0.0);
    }
    for (int k = 0; k < 6; k++) {
        t->a[k] = td_reals_all(0.0);
    }
    sums->sum += v[0] + v[1] + t->impulse[0] + t->impulse[1];
    sums->fastest = td_reals_max(sums->fastest, td_reals_abs(v[2]));
}

/* Called after all bodies have their velocities. Returns the trees of `which` in which all numbers
 * are finite and no angular velocity is above THUD_ANGULAR_SPEED_MAX; the velocities of the other
 * trees of `which` become 0. */
TD_INLINE td_choice td_tree_sound(td_lock_body *bodies, int count, td_choice which,
                                  const td_tree_sums *sums) {
    td_reals limit = td_reals_all((double)THUD_ANGULAR_SPEED_MAX), zero = td_reals_all(0.0);
    td_choice sound =
        (td_choice)(sums->sum - sums->sum == zero) & (td_choice)(sums->fastest <= limit);
    td_choice failed = which & ~sound;
    for (int i = 0; i < count && td_choice_any(failed); i++) {
        for (int k = 0; k < 3; k++) {
            bodies[i].velocity[k] = td_reals_pick(failed, zero, bodies[i].velocity[k]);
        }
    }
    return which & sound;
}

/* The greatest speed by which a direction of a body's joint misses its target speed, length/s, or
 * for the rotation of a weld rad/s; `worst` if that is greater. */
TD_INLINE td_reals td_tree_miss(const td_lock_body *bodies, const td_lock_body *t, td_reals worst) {
    if (!t->joined) {
        return worst;
    }
    const td_reals *holder = td_tree_holder(bodies, t);
    td_reals u[2], h[2];
    td_tree_velocity_at(t->velocity, t->arm_now, u);
    td_tree_velocity_at(holder, t->holder_now, h);
    for (int k = 0; k < 2; k++) {
        worst = td_reals_max(worst, td_reals_abs(u[k] - h[k] - t->target[k]));
    }
    if (t->weld) {
        td_reals turn = td_reals_abs(t->velocity[2] - holder[2] - t->turn_target);
        worst = td_reals_max(worst, turn);
    }
    return worst;
}

#endif
