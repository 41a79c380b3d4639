/* wide_energy.h: kinetic energies of eight bodies, and sums of them.
 *
 * A body's energy is a float, the same at both ends of a step in which nothing changes it; sums are
 * doubles, so that small changes of a few bodies show among many fast ones. */
#ifndef TD_WIDE_ENERGY_H
#define TD_WIDE_ENERGY_H

#include "base/simd.h"

#define TD_ENERGY_MAX 1e37f

/* (m v^2 + I w^2) / 2, or TD_ENERGY_MAX where that is not finite. */
TD_INLINE f8 td_kinetic_of(const td_rows *v, const float *mass, const float *inertia) {
    f8 twice = f8_load(mass) * (v->x * v->x + v->y * v->y) + f8_load(inertia) * (v->z * v->z);
    return f8_min(f8_all(0.5f) * twice, f8_all(TD_ENERGY_MAX));
}

TD_INLINE double td_total_of(d4 sum) {
    return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

#endif
