/* draws.h: draws a few settings for each guarantee by a seed (pairwise testing): any two values of
 * two dimensions that the guarantee covers occur together at least once. */
#ifndef DRAWS_H
#define DRAWS_H

#include "guarantee.h"

enum { DRAWS_MAX = 128 };

/* Fills `out` and returns the number of settings; the first ones contain each value of each
 * dimension. */
int draws_of(const guarantee *g, uint64_t seed, settings out[DRAWS_MAX]);

#endif
