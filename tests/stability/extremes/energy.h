/* energy.h: the part of the extreme "energy" in energy_scenes.c. */
#ifndef THUD_STABILITY_ENERGY_H
#define THUD_STABILITY_ENERGY_H

#include "gas.h"
#include "scenes.h"
#include "trial.h"

/* Adds two figures for each built-in scene: the largest gains of energy (see `gain`). */
void energy_of_scenes(ledger *l);

#endif
