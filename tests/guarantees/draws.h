/* draws.h: a few settings for each guarantee, drawn by a seed, in which any two values of two
 * dimensions that it covers come together at least once. */
#ifndef DRAWS_H
#define DRAWS_H

#include "guarantee.h"

enum { DRAWS_MAX = 128 };

/* How many of `out` were drawn; the first ones have each value of each dimension. */
int draws_of(const guarantee *g, uint64_t seed, settings out[DRAWS_MAX]);

#endif
