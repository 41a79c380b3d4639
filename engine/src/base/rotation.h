/* rotation.h: angles in 32-bit fixed point, and their cosine and sine in single precision.
 *
 * An angle is an integer in quanta of 2^-32 turns, so that it wraps around at a full turn by
 * itself. Cosine and sine are Taylor series for angles up to an eighth of a turn, after reduction
 * to the nearest quarter turn; they end where the next term is below half a unit in the last place
 * of 1. solver/wide_finalize.c does the same operations in the same order, for the same bits. */
#ifndef TD_ROTATION_H
#define TD_ROTATION_H

#include "base/fixed.h"

#define TD_TURN 4294967296.0 /* angle quanta in a full turn */
#define TD_RADIANS_A_QUANTUM (2.0 * TD_PI / TD_TURN)

/* Coefficients of the Taylor series, by power. */
#define TD_SIN3 (-1.0f / 6.0f)
#define TD_SIN5 (1.0f / 120.0f)
#define TD_SIN7 (-1.0f / 5040.0f)
#define TD_SIN9 (1.0f / 362880.0f)
#define TD_COS2 (-0.5f)
#define TD_COS4 (1.0f / 24.0f)
#define TD_COS6 (-1.0f / 720.0f)
#define TD_COS8 (1.0f / 40320.0f)

/* The angle of radians, |radians| <= THUD_ANGLE_MAX. */
static inline uint32_t td_angle_from(double radians) {
    double turns = radians * (1.0 / (2.0 * TD_PI));
    double whole = (double)(int64_t)turns;
    double part = turns - whole;
    return (uint32_t)(uint64_t)(int64_t)((part < 0.0 ? part + 1.0 : part) * TD_TURN + 0.5);
}

/* The angle, in quanta, by which a rotation in radians turns a body; it may be several full turns.
 */
static inline uint32_t td_angle_between(double radians) {
    double quanta = radians * (1.0 / TD_RADIANS_A_QUANTUM);
    double turns = (double)(int64_t)(quanta * (1.0 / TD_TURN));
    return (uint32_t)td_round_increment(quanta - turns * TD_TURN);
}

/* The angle in radians, in (-pi, pi]. */
static inline double td_angle_radians(uint32_t angle) {
    double radians = (double)(int32_t)angle * TD_RADIANS_A_QUANTUM;
    return angle == 0x80000000u ? -radians : radians;
}

/* Cosine and sine of an angle. */
static inline void td_angle_turn(uint32_t angle, float *c, float *s) {
    /* The nearest quarter turn, and the rest, at most an eighth of a turn either way. */
    uint32_t quarter = (angle + 0x20000000u) >> 30;
    float x = (float)(int32_t)(angle - (quarter << 30)) * (float)TD_RADIANS_A_QUANTUM;
    float xx = x * x;
    float sine = x + x * xx * (TD_SIN3 + xx * (TD_SIN5 + xx * (TD_SIN7 + xx * TD_SIN9)));
    float cosine = 1.0f + xx * (TD_COS2 + xx * (TD_COS4 + xx * (TD_COS6 + xx * TD_COS8)));
    float u = quarter & 1 ? sine : cosine, v = quarter & 1 ? cosine : sine;
    *c = (quarter + 1) & 2 ? -u : u;
    *s = quarter & 2 ? -v : v;
}

#endif
