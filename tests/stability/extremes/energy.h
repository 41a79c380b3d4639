/* energy.h: the two halves of the energy extreme. */
#ifndef THUD_STABILITY_ENERGY_H
#define THUD_STABILITY_ENERGY_H

#include "gas.h"
#include "scenes.h"
#include "trial.h"

/* Two figures for each built-in scene: the most energy that it ever gained. */
void energy_of_scenes(ledger *l);

#endif
