/* wide_energy.h: kinetic energies of eight bodies, and sums of them.
 *
 * The energy of a body is rounded to a float, so that a body whose velocity does not change has the
 * same energy in every step; sums are in double precision, so that small changes of a few bodies
 * are seen among many fast ones. */
#ifndef TD_WIDE_ENERGY_H
#define TD_WIDE_ENERGY_H

#include "solver/motion.h"

/* (m v^2 + I w^2) / 2, or TD_ENERGY_MAX where that is not finite. */
TD_INLINE f8 td_kinetic_of(const td_rows *v, const float *mass, const float *inertia) {
    f8 twice = f8_load(mass) * (v->x * v->x + v->y * v->y) + f8_load(inertia) * (v->z * v->z);
    return f8_min(f8_all(0.5f) * twice, f8_all(TD_ENERGY_MAX));
}

TD_INLINE double td_total_of(const d4 *sum) {
    return ((*sum)[0] + (*sum)[2]) + ((*sum)[1] + (*sum)[3]);
}

#endif
