/* record.h: writes the results of an extreme as JSON, from which envelope.py makes
 * docs/stability.md. */
#ifndef THUD_STABILITY_RECORD_H
#define THUD_STABILITY_RECORD_H

#include "extremes/extreme.h"
#include "json.h"

/* Writes an object with the extreme's texts and each figure with its bound. An infinite value
 * (fallen or lost) is written as null, NaN as the text "not a number", and entrants that were not
 * measured are left out. */
void record_write(json *out, const extreme *x, const ledger *l);

#endif
