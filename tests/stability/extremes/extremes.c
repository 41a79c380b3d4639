/* extremes.c: the table of all extremes, in the order of docs/stability.md. */
#include "extremes/extreme.h"

#include <string.h>

extern const extreme extreme_mass_ratio, extreme_columns, extreme_far_away, extreme_sizes,
    extreme_time_step, extreme_energy, extreme_long_run, extreme_crowding, extreme_slopes,
    extreme_speed, extreme_wrong_input, extreme_chains, extreme_linkages, extreme_springs,
    extreme_joint_crowds;

const extreme *const EXTREMES[] = {
    &extreme_mass_ratio, &extreme_columns,      &extreme_far_away,    &extreme_speed,
    &extreme_sizes,      &extreme_time_step,    &extreme_energy,      &extreme_slopes,
    &extreme_long_run,   &extreme_crowding,     &extreme_chains,      &extreme_linkages,
    &extreme_springs,    &extreme_joint_crowds, &extreme_wrong_input,
};
const int EXTREME_COUNT = sizeof EXTREMES / sizeof EXTREMES[0];

const extreme *extreme_find(const char *name) {
    for (int i = 0; i < EXTREME_COUNT; i++)
        if (strcmp(EXTREMES[i]->name, name) == 0)
            return EXTREMES[i];
    return NULL;
}
