/* damping.h: motion in a time t under a constant acceleration g and a damping c (1/s), by the exact
 * solution of dv/dt = g - c v. With z = c t and p = (1 - exp(-z)) / z,
 *
 *   v1 = v0 - v0 z p + g t p,   mean velocity = v0 p + g t (1 - p) / z,
 *
 * which without damping is the parabola: v0 + g t, and v0 + g t / 2. */
#ifndef TD_DAMPING_H
#define TD_DAMPING_H

/* lost: z p; gained: p. With gain = g t p the mean velocity is v0 p + gain_share gain. A velocity v
 * is damped as v - lost v, and not as v times 1 - lost: that factor is near 1, and its rounding
 * error, the same in every step, would add up. */
typedef struct td_damping {
    float lost, gained, gain_share;
} td_damping;

/* z >= 0, also infinite. */
td_damping td_damping_of(float z);

#endif
