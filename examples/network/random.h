/* random.h: random numbers that are the same on every platform: splitmix64 (Steele, Lea, Flood:
 * Fast splittable pseudorandom number generators, 2014). */
#ifndef THUD_NETWORK_RANDOM_H
#define THUD_NETWORK_RANDOM_H

#include <stdint.h>

/* The next number. */
static inline uint64_t random_next(uint64_t *state) {
    uint64_t x = *state += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/* The next number as a real number in [0, 1). */
static inline double random_chance(uint64_t *state) {
    return (double)(random_next(state) >> 11) * 0x1p-53;
}

#endif
