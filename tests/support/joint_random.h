/* joint_random.h: numbers for random worlds of joints, by a linear congruential generator with
 * Knuth's constants (MMIX), of which the upper 53 bits are used. Each call advances the seed. */
#ifndef JOINT_RANDOM_H
#define JOINT_RANDOM_H

#include <math.h>
#include <stdint.h>

/* A number in [0, 1). */
static inline double next_number(uint64_t *seed) {
    *seed = *seed * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(*seed >> 11) * 0x1p-53;
}

static inline double between_two(uint64_t *seed, double low, double high) {
    return low + (high - low) * next_number(seed);
}

/* A number between `low` and `high`, both > 0, whose logarithm is uniform: each octave is equally
 * likely. */
static inline double in_octaves(uint64_t *seed, double low, double high) {
    return exp(between_two(seed, log(low), log(high)));
}

#endif
