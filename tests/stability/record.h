/* record.h: what an extreme reached, as JSON; envelope.py makes docs/stability.md of it. */
#ifndef THUD_STABILITY_RECORD_H
#define THUD_STABILITY_RECORD_H

#include "extremes/extreme.h"
#include "json.h"

/* An object: the extreme's texts and each figure with its bound. What fell or was lost is null,
 * what is not a number the text "not a number", and whoever was not measured is left out. */
void record_write(json *out, const extreme *x, const ledger *l);

#endif
