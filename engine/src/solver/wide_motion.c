/* wide_motion.c: integration of velocities and positions; see motion.h. Two bodies share a vector
 * of eight floats; what only some bodies need is done for one of them, coordinate by coordinate. */
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
 * order of operands keeps not-a-number, which finalize.c looks for. */
TD_INLINE f8 clamp_velocity(const td_motion_context *c, f8 v) {
    float s = c->max_speed, t = THUD_ANGULAR_SPEED_MAX, m = 3.0e38f;
    f8 max = {s, s, t, m, s, s, t, m};
    return f8_min(max, f8_max(-max, v));
}

/* The same of coordinate k. */
static float clamp_coordinate(const td_motion_context *c, int k, float v) {
    float max = k < 2 ? c->max_speed : THUD_ANGULAR_SPEED_MAX;
    float low = -max > v ? -max : v;
    return max < low ? max : low;
}

/* Whether no constraint can change the body's velocity in this step. Kinematic bodies have no
 * colour, but constraints read their velocity in every substep. */
TD_INLINE bool is_free(const td_motion_context *c, int i) {
    return !(c->colours[i][0] | c->colours[i][1]) && c->velocity[i][3] > 0.0f;
}

/* The damping of a body over a time, linear and angular. It is kept from body to body, since most
 * bodies of a world are damped alike. */
typedef struct body_damping {
    float time, rate[2]; /* s, 1/s; a negative rate: nothing is computed yet */
    td_damping of[2];
} body_damping;

static body_damping damping_over(float time) {
    return (body_damping){.time = time,
                          .rate = {-1.0f, -1.0f},
                          .of = {{0.0f, 1.0f, 0.5f}, {0.0f, 1.0f, 0.5f}}};
}

/* Sets it to that of body i; without damping it stays that of none. */
static void set_damping(body_damping *d, const td_motion_context *c, int i) {
    for (int k = 0; k < 2 && c->damping; k++) {
        float rate = c->damping[i][k];
        if (rate != d->rate[k]) {
            d->rate[k] = rate;
            d->of[k] = td_damping_of(rate * d->time);
        }
    }
}

/* Begins the motion of a body that is free or damped: td_begin_motion_fn. Its start is the velocity
 * before the step. */
static void begin_alone(const td_motion_context *c, int i, body_damping *d) {
    bool free = is_free(c, i);
    float substeps = free ? (float)c->substeps : 1.0f;
    set_damping(d, c, i);
    for (int k = 0; k < 3; k++) {
        const td_damping *of = &d->of[k == 2];
        float v = c->start[i][k], from = v - v * of->lost;
        float to = clamp_coordinate(c, k, from + c->substep_gain[i][k] * substeps * of->gained);
        c->velocity[i][k] = to;
        c->start[i][k] = free ? to : from;
        if (free) {
            c->delta[i][k] = (v * of->gained + (to - from) * of->gain_share - to) * d->time;
        }
    }
}

td_begin_motion_fn TD_WIDE(td_begin_motion);
void TD_WIDE(td_begin_motion)(const td_motion_context *c) {
    body_damping substep = damping_over(c->h), step = damping_over((float)c->substeps * c->h);
    f8 mark = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f};
    for (int i = 0; i < c->count; i += 2) {
        /* A caller may have set any velocity. */
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        store(c->start, i, v);
        store(c->velocity, i, clamp_velocity(c, v + load(c->substep_gain, i)));
        /* Motions of the step before are finite, and marks are 0 or 1. */
        store(c->delta, i, c->bouncy ? load((const float(*)[4])c->delta, i) * mark : f8_all(0.0f));
        for (int k = i; k < i + 2; k++) {
            if (c->damping || is_free(c, k)) {
                begin_alone(c, k, is_free(c, k) ? &step : &substep);
            }
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

/* The share of a velocity that counts as its rounding: two units of single precision of the
 * velocity at either end of a substep. */
#define ROUNDING 0x1p-22f

/* Moves a marked body on to the exact path where only gravity and forces have changed its velocity,
 * and removes the mark. Substeps of semi-implicit Euler, with a gain g in each of n substeps, have
 * moved what ends with v by n h (v - g (n - 1) / 2); the path is n h (v - n g / 2). */
static void end_flight(const td_motion_context *c, int i) {
    float n = (float)c->substeps, time = n * c->h;
    for (int k = 0; k < 3; k++) {
        float v = c->velocity[i][k], start = c->start[i][k], gain = c->substep_gain[i][k];
        float tolerance = ROUNDING * (__builtin_fabsf(start) + __builtin_fabsf(v));
        float way = time * (v - 0.5f * (n - 1.0f) * gain), *delta = &c->delta[i][k];
        if (__builtin_fabsf(v - start - gain) <= tolerance &&
            __builtin_fabsf(*delta - way) <= tolerance * time) {
            *delta -= 0.5f * time * gain;
        }
    }
    c->delta[i][3] = 0.0f;
}

td_integrate_position_fn TD_WIDE(td_integrate_position);
void TD_WIDE(td_integrate_position)(const td_motion_context *c, bool last) {
    f8 h = {c->h, c->h, c->h, 0.0f, c->h, c->h, c->h, 0.0f};
    for (int i = 0; i < c->count; i += 2) {
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        store(c->velocity, i, v);
        store(c->delta, i, load((const float(*)[4])c->delta, i) + v * h);
        for (int k = i; last && c->bouncy && k < i + 2; k++) {
            if (c->delta[k][3] > 0.0f) {
                end_flight(c, k);
            }
        }
    }
}
