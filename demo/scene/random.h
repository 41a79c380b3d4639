/* random.h: the random numbers of scenes, the same on every platform: SplitMix64 (Steele, Lea and
 * Flood, "Fast Splittable Pseudorandom Number Generators", 2014). */
#ifndef THUD_DEMO_RANDOM_H
#define THUD_DEMO_RANDOM_H

#include <stdint.h>

typedef struct scene_random {
    uint64_t state;
} scene_random;

static inline uint64_t scene_random_bits(scene_random *r) {
    uint64_t z = r->state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* Uniform in [low, high), in steps of 2^-53 of the range. */
static inline double scene_random_range(scene_random *r, double low, double high) {
    return low + (high - low) * ((double)(scene_random_bits(r) >> 11) * 0x1p-53);
}

#endif
