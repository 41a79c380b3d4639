/* catalogue.h: what each system of the catalogue costs, and what it gets wrong. */
#ifndef THUD_BENCH_CATALOGUE_H
#define THUD_BENCH_CATALOGUE_H

#include "json.h"

/* Each prints tables and writes members of the results' object. `quick` proves only that it runs.
 * False, and a line on stderr, when something fails. */
bool catalogue_broadphases(bool quick, json *out); /* "growth", "coherence", "sizes", "gathering" */
bool catalogue_detections(bool quick, json *out);  /* "detections", of whole scenes */
bool catalogue_walls(bool quick, json *out);       /* "walls": who passes through thin ones */
bool catalogue_throws(bool quick, json *out);      /* "throws": paths against parabolas */
bool catalogue_levels(bool quick, json *out);  /* "levels": pairs that each volume lets through */
bool catalogue_volumes(bool quick, json *out); /* "volumes": making and asking them, by the call */
bool catalogue_calls(bool quick, json *out);   /* "calls", "tolerances": geometry, by the call */
bool catalogue_grounds(bool quick, json *out); /* "grounds", "digging": terrain */
bool catalogue_queries(bool quick, json *out); /* "queries", "mover" */

#endif
