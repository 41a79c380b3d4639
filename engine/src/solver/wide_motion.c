/* wide_motion.c: integration of velocities and positions; see motion.h. A vector of eight floats
 * holds the records of two bodies. Damping differs from body to body and is computed coordinate by
 * coordinate. */
#include "solver/motion.h"

#include "base/simd.h"
#include "solver/damping.h"

TD_INLINE f8 load(const float (*rows)[4], int i) {
    f8 r;
    __builtin_memcpy(&r, rows[i], sizeof r);
    return r;
}

TD_INLINE void store(float (*rows)[4], int i, f8 v) {
    __builtin_memcpy(rows[i], &v, sizeof v);
}

/* Clamps velocities to max_speed and THUD_ANGULAR_SPEED_MAX. All passes use the same bound:
 * otherwise the difference would look like an impulse of the last substep and be added again. The
 * fourth value, the inverse mass, is not clamped: its bound is near the largest float. The order of
 * operands keeps not-a-number, which finalize.c looks for. */
TD_INLINE f8 clamp_velocity(const td_motion_context *c, f8 v) {
    float s = c->max_speed, t = THUD_ANGULAR_SPEED_MAX, m = 3.0e38f;
    f8 max = {s, s, t, m, s, s, t, m};
    return f8_min(max, f8_max(-max, v));
}

/* Whether no constraint can change the body's velocity in this step. Kinematic bodies have no
 * colour, but constraints read their velocity in every substep. */
TD_INLINE bool is_free(const td_motion_context *c, int i) {
    return !(c->colours[i][0] | c->colours[i][1]) && c->velocity[i][3] > 0.0f;
}

/* The linear and angular damping of a body over a time. A loop over bodies keeps the last result
 * and reuses it while the rates stay the same, since most bodies of a world are damped alike. */
typedef struct body_damping {
    float time, rate[2]; /* s, 1/s; a negative rate: nothing is computed yet */
    td_damping of[2];
} body_damping;

static body_damping damping_over(float time) {
    return (body_damping){.time = time,
                          .rate = {-1.0f, -1.0f},
                          .of = {{0.0f, 1.0f, 0.5f}, {0.0f, 1.0f, 0.5f}}};
}

/* Sets *d to the damping of body i. Only called where some body of the world is damped (c->damping
 * is not null). */
static void set_damping(body_damping *d, const td_motion_context *c, int i) {
    for (int k = 0; k < 2; k++) {
        float rate = c->damping[i][k];
        if (rate != d->rate[k]) {
            d->rate[k] = rate;
            d->of[k] = td_damping_of(rate * d->time);
        }
    }
}

/* A vector with `first` in all coordinates of its first body, and `second` in those of its second
 * body. The fourth element of either body is no coordinate, and gets `rest`. */
TD_INLINE f8 of_two(float first, float second, float rest) {
    return (f8){first, first, first, rest, second, second, second, rest};
}

/* Begins the motion of two bodies, of which one is free or damped: td_begin_motion_fn. `start` is
 * their velocity before the step, `free` says which of them is free. With the symbols of damping.h
 * (over the step for a free body, else over the first substep), `from` is the damped velocity
 * v0 - v0 z p, `to` is v1, and for a free body, of which each substep adds h v1 to delta, `way` is
 * T (mean velocity - v1) for the step's length T. */
TD_INLINE void begin_pair(const td_motion_context *c, int i, f8 start, const bool free[2],
                          body_damping *substep, body_damping *step) {
    f8 lost = f8_all(0.0f), gained = f8_all(1.0f), share = f8_all(0.5f);
    for (int k = 0; k < 2 && c->damping; k++) {
        body_damping *d = free[k] ? step : substep;
        set_damping(d, c, i + k);
        for (int j = 0; j < 3; j++) {
            lost[4 * k + j] = d->of[j == 2].lost;
            gained[4 * k + j] = d->of[j == 2].gained;
            share[4 * k + j] = d->of[j == 2].gain_share;
        }
    }
    float n = (float)c->substeps;
    f8 substeps = of_two(free[0] ? n : 1.0f, free[1] ? n : 1.0f, 1.0f);
    i8 is_free_lane = of_two(free[0], free[1], 0.0f) > f8_all(0.0f);
    f8 from = start - start * lost;
    f8 to = clamp_velocity(c, from + load(c->substep_gain, i) * substeps * gained);
    f8 way = (start * gained + (to - from) * share - to) * f8_all(step->time);
    store(c->velocity, i, to);
    store(c->start, i, f8_pick(is_free_lane, to, from));
    store(c->delta, i, f8_pick(is_free_lane, way, load((const float(*)[4])c->delta, i)));
}

td_begin_motion_fn TD_WIDE(td_begin_motion);
void TD_WIDE(td_begin_motion)(const td_motion_context *c) {
    body_damping substep = damping_over(c->h), step = damping_over((float)c->substeps * c->h);
    f8 mark = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f};
    for (int i = 0; i < c->count; i += 2) {
        /* A caller may have set a velocity above the bound. */
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        /* Sets the motion to 0 but keeps the marks of the bounce passes. The old motion is finite,
         * so that its product with 0 is 0. */
        store(c->delta, i, c->bouncy ? load((const float(*)[4])c->delta, i) * mark : f8_all(0.0f));
        bool free[2] = {is_free(c, i), is_free(c, i + 1)};
        if (c->damping || free[0] || free[1]) {
            begin_pair(c, i, v, free, &substep, &step);
        } else {
            store(c->start, i, v);
            store(c->velocity, i, clamp_velocity(c, v + load(c->substep_gain, i)));
        }
    }
}

td_integrate_velocity_fn TD_WIDE(td_integrate_velocity);
void TD_WIDE(td_integrate_velocity)(const td_motion_context *c) {
    body_damping substep = damping_over(c->h);
    for (int i = 0; i < c->count; i += 2) {
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        f8 gained = v - load((const float(*)[4])c->start, i);
        for (int k = 0; k < 2 && c->damping; k++) {
            if (!is_free(c, i + k)) {
                set_damping(&substep, c, i + k);
                for (int j = 0; j < 3; j++) {
                    v[4 * k + j] -= v[4 * k + j] * substep.of[j == 2].lost;
                }
            }
        }
        store(c->start, i, v);
        store(c->velocity, i, clamp_velocity(c, v + gained));
    }
}

td_integrate_position_fn TD_WIDE(td_integrate_position);
void TD_WIDE(td_integrate_position)(const td_motion_context *c) {
    f8 h = {c->h, c->h, c->h, 0.0f, c->h, c->h, c->h, 0.0f};
    for (int i = 0; i < c->count; i += 2) {
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        store(c->velocity, i, v);
        store(c->delta, i, load((const float(*)[4])c->delta, i) + v * h);
    }
}
