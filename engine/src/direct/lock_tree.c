/* lock_tree.c: eliminates the bodies of a tree of locks one after the other. */
#include "direct/lock_tree.h"

#include "base/base.h"

/* The velocity of the point at the end of a lever arm. */
static void velocity_at(const double velocity[3], const double arm[2], double u[2]) {
    u[0] = velocity[0] - velocity[2] * arm[1];
    u[1] = velocity[1] + velocity[2] * arm[0];
}

/* The velocity of the body that holds the joint: the parent, or the body outside. */
static const double *holder_of(const td_lock_body *bodies, const td_lock_body *t) {
    return t->parent == TD_NONE ? t->outside : bodies[t->parent].velocity;
}

/* Moves the reference point of a body's equation by (x, y): from its centre of mass to the end of a
 * lever arm, or, with (-x, -y), from there to the centre. */
static void shift(double a[6], double g[3], double x, double y) {
    /* u = v + w (-y, x), so that v = u - w (-y, x). */
    double xw = a[3] + a[0] * y - a[1] * x, yw = a[4] + a[1] * y - a[2] * x;
    a[5] += y * (a[3] + xw) - x * (a[4] + yw);
    a[3] = xw;
    a[4] = yw;
    g[2] += g[0] * y - g[1] * x;
}

/* Eliminates the rotation that a hinge leaves free: a and g become M and m. All elements of g are
 * read before one is written: clang 14, for WebAssembly and at -Os, otherwise computes g[0] and
 * g[1] together in one vector, from a g[2] that has become 0 already. */
static void release(td_lock_body *t, double a[6], double g[3]) {
    double xw = a[3], yw = a[4], w = g[2], per = 1.0 / a[5], x = per * xw, y = per * yw;
    double rest_x = g[0] - x * w, rest_y = g[1] - y * w;
    t->per_turning = per;
    a[0] -= x * xw;
    a[1] -= x * yw;
    a[2] -= y * yw;
    a[3] = a[4] = a[5] = 0.0;
    g[0] = rest_x;
    g[1] = rest_y;
    g[2] = 0.0;
}

/* Adds a body and all that hangs from it to its parent. */
static void hang(td_lock_body *t, td_lock_body *parent) {
    double a[6], g[3];
    for (int k = 0; k < 6; k++) {
        a[k] = t->a[k];
    }
    for (int k = 0; k < 3; k++) {
        g[k] = t->g[k];
    }
    if (!t->weld) {
        release(t, a, g);
    }
    const double *s = t->target;
    double w = t->weld ? t->turn_target : 0.0;
    g[0] -= a[0] * s[0] + a[1] * s[1] + a[3] * w;
    g[1] -= a[1] * s[0] + a[2] * s[1] + a[4] * w;
    g[2] -= a[3] * s[0] + a[4] * s[1] + a[5] * w;
    shift(a, g, -t->holder_now[0], -t->holder_now[1]);
    for (int k = 0; k < 6; k++) {
        parent->a[k] += a[k];
    }
    for (int k = 0; k < 3; k++) {
        parent->g[k] += g[k];
    }
}

/* Solves the root that is joined to nothing: A v = g, by L D L'. */
static void solve_free(td_lock_body *t) {
    const double *a = t->a, *g = t->g;
    double per = 1.0 / a[0], ly = a[1] * per, lw = a[3] * per;
    double dy = a[2] - ly * a[1], yw = a[4] - ly * a[3], l = yw / dy;
    double y = g[1] - ly * g[0], w = g[2] - lw * g[0] - l * y;
    t->velocity[2] = w / (a[5] - lw * a[3] - l * yw);
    t->velocity[1] = y / dy - l * t->velocity[2];
    t->velocity[0] = g[0] * per - ly * t->velocity[1] - lw * t->velocity[2];
}

/* Finds the velocity of a body and the impulse of its joint from the velocity of its holder. */
static void follow(td_lock_body *t, const double holder[3]) {
    const double *a = t->a, *g = t->g;
    double u[2], w;
    velocity_at(holder, t->holder_now, u);
    u[0] += t->target[0];
    u[1] += t->target[1];
    w = t->weld ? holder[2] + t->turn_target : t->per_turning * (g[2] - a[3] * u[0] - a[4] * u[1]);
    t->impulse[0] = a[0] * u[0] + a[1] * u[1] + a[3] * w - g[0];
    t->impulse[1] = a[1] * u[0] + a[2] * u[1] + a[4] * w - g[1];
    t->turn_impulse = t->weld ? a[3] * u[0] + a[4] * u[1] + a[5] * w - g[2] : 0.0;
    t->velocity[0] = u[0] + w * t->arm_now[1];
    t->velocity[1] = u[1] - w * t->arm_now[0];
    t->velocity[2] = w;
}

bool td_lock_tree_solve(td_lock_body *bodies, int count) {
    for (int i = 0; i < count; i++) {
        td_lock_body *t = &bodies[i];
        t->a[0] = t->a[2] = t->mass;
        t->a[1] = t->a[3] = t->a[4] = 0.0;
        t->a[5] = t->turning;
        for (int k = 0; k < 3; k++) {
            t->g[k] = t->momentum[k];
        }
    }
    for (int i = count - 1; i >= 0; i--) {
        td_lock_body *t = &bodies[i];
        shift(t->a, t->g, t->arm_now[0], t->arm_now[1]);
        if (t->parent != TD_NONE) {
            hang(t, &bodies[t->parent]);
        } else {
            t->per_turning = 1.0 / t->a[5];
        }
    }
    double sum = 0.0, fastest = 0.0;
    for (int i = 0; i < count; i++) {
        td_lock_body *t = &bodies[i];
        if (t->joined) {
            follow(t, holder_of(bodies, t));
        } else {
            solve_free(t);
        }
        sum += t->velocity[0] + t->velocity[1];
        fastest = td_max_double(fastest, td_abs(t->velocity[2]));
    }
    return td_finite(sum) && fastest <= (double)THUD_ANGULAR_SPEED_MAX;
}

double td_lock_tree_residual(const td_lock_body *bodies, int count) {
    double worst = 0.0;
    for (int i = 0; i < count; i++) {
        const td_lock_body *t = &bodies[i];
        const double *holder = holder_of(bodies, t);
        double u[2], h[2];
        velocity_at(t->velocity, t->arm_now, u);
        velocity_at(holder, t->holder_now, h);
        double x = td_abs(u[0] - h[0] - t->target[0]), y = td_abs(u[1] - h[1] - t->target[1]);
        double w = t->weld ? td_abs(t->velocity[2] - holder[2] - t->turn_target) : 0.0;
        worst = t->joined ? td_max_double(worst, td_max_double(w, td_max_double(x, y))) : worst;
    }
    return worst;
}
