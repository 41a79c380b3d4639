/* wide_motion.c: see motion.h. Two bodies share a vector of eight floats. */
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

/* 1 / (1 + h d): stable for any damping. */
TD_INLINE f8 damping_of(const td_motion_context *c, int i) {
    float l0 = 1.0f / (1.0f + c->h * c->damping[i][0]),
          a0 = 1.0f / (1.0f + c->h * c->damping[i][1]);
    float l1 = 1.0f / (1.0f + c->h * c->damping[i + 1][0]);
    float a1 = 1.0f / (1.0f + c->h * c->damping[i + 1][1]);
    return (f8){l0, l0, a0, 1.0f, l1, l1, a1, 1.0f};
}

/* Velocities within bounds, so that they do not overflow. One and the same bound everywhere, or
 * what it takes off would be taken for something that contacts gave, and come off again in each
 * substep. In this order of operands not-a-number stays what it is, for finalize.c to see. */
TD_INLINE f8 held(const td_motion_context *c, f8 v) {
    float s = c->max_speed, t = THUD_SPIN_MAX, m = 3.0e38f;
    f8 most = {s, s, t, m, s, s, t, m};
    return f8_min(most, f8_max(-most, v));
}

td_integrate_velocity_fn TD_WIDE(td_integrate_velocity);
void TD_WIDE(td_integrate_velocity)(const td_motion_context *c, bool first) {
    for (int i = 0; i < c->count; i += 2) {
        /* Callers may have set any velocity, and contacts would hand it on. */
        f8 v = held(c, load((const float(*)[4])c->velocity, i));
        f8 gained = load(c->push, i);
        if (!first) {
            gained = v - load((const float(*)[4])c->start, i);
        }
        if (c->damping) {
            v *= damping_of(c, i);
        }
        store(c->start, i, v);
        store(c->velocity, i, held(c, v + gained));
    }
}

td_integrate_position_fn TD_WIDE(td_integrate_position);
void TD_WIDE(td_integrate_position)(const td_motion_context *c) {
    f8 h = {c->h, c->h, c->h, 0.0f, c->h, c->h, c->h, 0.0f};
    for (int i = 0; i < c->count; i += 2) {
        f8 v = held(c, load((const float(*)[4])c->velocity, i));
        store(c->velocity, i, v);
        store(c->delta, i, load((const float(*)[4])c->delta, i) + v * h);
    }
}
