/* snapshot_checksum.c: the checksum of a snapshot: the multiplicative step of FNV-1a (Fowler, Noll,
 * Vo) on words of 64 bits, with a rotation, in eight independent lanes that are mixed at the end.
 *
 * A step is a bijection of the running sum for a given word, and of the word for a given sum: two
 * snapshots of the same size that differ in one word only have different checksums. Words are in
 * the byte order of the machine, as the snapshot is. The result is stored in snapshots, so that
 * TD_SNAPSHOT_VERSION has to be raised if this function changes. */
#include "api/snapshot.h"

#include <string.h>

#define FNV_PRIME 0x100000001b3ull /* the prime of FNV-1a for 64 bits */
enum { ROTATION = 29 };            /* bits. Chosen; not tuned */

/* One step: the running sum after the next word. The rotation carries high bits, which a product
 * never moves down, to low places. */
static uint64_t mix(uint64_t sum, uint64_t word) {
    sum = (sum ^ word) * FNV_PRIME;
    return sum << ROTATION | sum >> (64 - ROTATION);
}

uint64_t td_snapshot_checksum(const void *bytes, size_t count) {
    enum { LANES = 8 }; /* with a single lane, each product would have to wait for the one before */
    /* The start values are arbitrary, but not 0: mix(0, 0) is 0, so that a lane would stay 0
     * through any number of zero words at the beginning. */
    uint64_t lane[LANES] = {1, 2, 3, 4, 5, 6, 7, 8}, words[LANES], sum = count;
    const char *from = bytes;
    size_t in_groups = count - count % sizeof words; /* bytes in whole groups of a word a lane */
    for (size_t i = 0; i < in_groups; i += sizeof words) {
        memcpy(words, from + i, sizeof words);
        for (int k = 0; k < LANES; k++) {
            lane[k] = mix(lane[k], words[k]);
        }
    }
    /* The last bytes, filled up with zeros. A snapshot that ends in zeros has another sum than a
     * shorter one that is filled up, since the sum begins with the count of bytes. */
    memset(words, 0, sizeof words);
    memcpy(words, from + in_groups, count - in_groups);
    for (int k = 0; k < LANES; k++) {
        sum = mix(sum, mix(lane[k], words[k]));
    }
    return sum;
}
