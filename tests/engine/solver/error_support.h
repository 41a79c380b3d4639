/* error_support.h: the energy of a world, and one step with the error that it reports. */
#ifndef ERROR_SUPPORT_H
#define ERROR_SUPPORT_H

#include "engine_support.h"

static inline double energy_of(const thud_world *world) {
    thud_measure m = thud_measure_of(world);
    return m.kinetic_energy + m.potential_energy;
}

static inline thud_step_error error_of_step(thud_world *world) {
    OK(thud_world_step(world));
    return thud_step_error_of(world);
}

#endif
