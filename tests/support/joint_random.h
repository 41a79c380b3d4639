/* joint_random.h: numbers for random worlds of joints, from a seed that each call moves on: a
 * linear congruential generator with Knuth's constants (MMIX), of which the upper 53 bits are used.
 */
#ifndef JOINT_RANDOM_H
#define JOINT_RANDOM_H

#include <math.h>
#include <stdint.h>

/* In [0, 1). */
static inline double next_number(uint64_t *seed) {
    *seed = *seed * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(*seed >> 11) * 0x1p-53;
}

static inline double between_two(uint64_t *seed, double low, double high) {
    return low + (high - low) * next_number(seed);
}

/* Each octave between the two, which are > 0, is as likely as any other. */
static inline double in_octaves(uint64_t *seed, double low, double high) {
    return exp(between_two(seed, log(low), log(high)));
}

#endif
