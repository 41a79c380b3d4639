/* wide_motion.c: integration of velocities and positions; see motion.h. Two bodies share a vector
 * of eight floats. */
#include "solver/motion.h"

#include "base/simd.h"

TD_INLINE f8 load(const float (*rows)[4], int i) {
    f8 r;
    __builtin_memcpy(&r, rows[i], sizeof r);
    return r;
}

TD_INLINE void store(float (*rows)[4], int i, f8 v) {
    __builtin_memcpy(rows[i], &v, sizeof v);
}

/* Factors of implicit Euler damping, 1 / (1 + h d), which is stable for any d >= 0 (1/s). */
TD_INLINE f8 damping_of(const td_motion_context *c, int i) {
    float l0 = 1.0f / (1.0f + c->h * c->damping[i][0]),
          a0 = 1.0f / (1.0f + c->h * c->damping[i][1]);
    float l1 = 1.0f / (1.0f + c->h * c->damping[i + 1][0]);
    float a1 = 1.0f / (1.0f + c->h * c->damping[i + 1][1]);
    return (f8){l0, l0, a0, 1.0f, l1, l1, a1, 1.0f};
}

/* Clamps velocities to max_speed and THUD_ANGULAR_SPEED_MAX. All passes use the same bound:
 * otherwise the difference would look like an impulse of the last substep and be added again. The
 * order of operands keeps not-a-number, which finalize.c looks for. */
TD_INLINE f8 clamp_velocity(const td_motion_context *c, f8 v) {
    float s = c->max_speed, t = THUD_ANGULAR_SPEED_MAX, m = 3.0e38f;
    f8 max = {s, s, t, m, s, s, t, m};
    return f8_min(max, f8_max(-max, v));
}

td_integrate_velocity_fn TD_WIDE(td_integrate_velocity);
void TD_WIDE(td_integrate_velocity)(const td_motion_context *c, bool first) {
    for (int i = 0; i < c->count; i += 2) {
        /* A caller may have set any velocity. */
        f8 v = clamp_velocity(c, load((const float(*)[4])c->velocity, i));
        f8 gained = load(c->substep_gain, i);
        if (!first) {
            gained = v - load((const float(*)[4])c->start, i);
        }
        if (c->damping) {
            v *= damping_of(c, i);
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
