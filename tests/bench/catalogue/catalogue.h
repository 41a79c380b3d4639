/* catalogue.h: the parts of thud-catalogue: the cost and the error of each system of the engine. */
#ifndef THUD_BENCH_CATALOGUE_H
#define THUD_BENCH_CATALOGUE_H

#include "json.h"

/* Each prints tables and writes members of the results' JSON object. `quick` takes small inputs, to
 * test that it runs. Returns false and prints a line on stderr on failure. */
bool catalogue_broadphases(bool quick, json *out); /* "growth", "coherence", "sizes", "gathering" */
bool catalogue_detections(bool quick, json *out);  /* "detections", of whole scenes */
bool catalogue_walls(bool quick, json *out);   /* "walls": bodies that pass through thin walls */
bool catalogue_throws(bool quick, json *out);  /* "throws": paths compared with parabolas */
bool catalogue_prices(bool quick, json *out);  /* "prices": error over time of each detection */
bool catalogue_levels(bool quick, json *out);  /* "levels": pairs that each volume lets through */
bool catalogue_volumes(bool quick, json *out); /* "volumes": nanoseconds of making and testing
                                                  bounding volumes */
bool catalogue_calls(bool quick, json *out);   /* "calls", "tolerances": nanoseconds of geometry
                                                  functions */
bool catalogue_grounds(bool quick, json *out); /* "grounds", "digging": terrain */
bool catalogue_queries(bool quick, json *out); /* "queries", "mover" */

#endif
