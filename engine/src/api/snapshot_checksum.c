/* snapshot_checksum.c: the checksum of a snapshot: the multiplicative step of FNV-1a (Fowler, Noll,
 * Vo) on words of 64 bits, with a rotation, in eight independent lanes that are mixed at the end.
 * Each step is a bijection of the sum, so that a change within one word is always found. */
#include "api/snapshot.h"

#include <string.h>

/* One step. The rotation carries high bits, which the product never moves down, to low ones. */
static uint64_t mix(uint64_t sum, uint64_t word) {
    sum = (sum ^ word) * 0x100000001b3ull;
    return sum << 29 | sum >> 35;
}

uint64_t td_snapshot_checksum(const void *bytes, size_t count) {
    enum { LANES = 8 }; /* a single lane would wait for the latency of each product */
    uint64_t lane[LANES] = {1, 2, 3, 4, 5, 6, 7, 8}, words[LANES], sum = count;
    const char *at = bytes;
    size_t whole = count - count % sizeof words;
    for (size_t i = 0; i < whole; i += sizeof words) {
        memcpy(words, at + i, sizeof words);
        for (int k = 0; k < LANES; k++) {
            lane[k] = mix(lane[k], words[k]);
        }
    }
    memset(words, 0, sizeof words);
    memcpy(words, at + whole, count - whole);
    for (int k = 0; k < LANES; k++) {
        sum = mix(sum, mix(lane[k], words[k]));
    }
    return sum;
}
