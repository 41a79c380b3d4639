/* repeats.c: see repeats.h. */
#include "recording/repeats.h"

#include <string.h>

/* LOOKUP_BITS: bits of the hash of four bytes. REPEAT_MIN: bytes of the shortest repeat that is
 * written as one, since its two numbers take space as well. Chosen. */
enum { LOOKUP_BITS = 12, REPEAT_MIN = 5 };

/* A hash of four bytes: the index in `seen` of the place where they occurred last. */
static uint32_t lookup_of(const uint8_t *bytes) {
    uint32_t four =
        bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
    return four * 0x9e3779b1u >> (32 - LOOKUP_BITS);
}

/* How many bytes from `before` on equal those from `at` on. */
static size_t same_count(const uint8_t *bytes, size_t before, size_t at, size_t count) {
    size_t same = 0;
    while (at + same < count && bytes[before + same] == bytes[at + same]) {
        same++;
    }
    return same;
}

void td_repeats_write(td_writer *to, const uint8_t *bytes, size_t count) {
    uint32_t seen[1 << LOOKUP_BITS] = {0}; /* places plus 1 */
    size_t plain = 0;                      /* start of the bytes that are not part of a repeat */
    for (size_t at = 0; at + REPEAT_MIN <= count;) {
        uint32_t *place = &seen[lookup_of(bytes + at)];
        size_t before = *place, same = before ? same_count(bytes, before - 1, at, count) : 0;
        *place = (uint32_t)at + 1;
        if (same < REPEAT_MIN) {
            at++;
            continue;
        }
        td_write_count(to, at - plain);
        td_write_bytes(to, bytes + plain, at - plain);
        td_write_count(to, same);
        td_write_count(to, at + 1 - before);
        at += same;
        plain = at;
    }
    td_write_count(to, count - plain);
    td_write_bytes(to, bytes + plain, count - plain);
}

bool td_repeats_read(td_reader *from, uint8_t *out, size_t count) {
    for (size_t at = 0;;) {
        uint64_t plain = td_read_count(from);
        const uint8_t *bytes = plain <= count - at ? td_read_bytes(from, plain) : NULL;
        if (!bytes) {
            return false;
        }
        memcpy(out + at, bytes, (size_t)plain);
        at += (size_t)plain;
        if (at == count) {
            return !from->broken;
        }
        uint64_t same = td_read_count(from), distance = td_read_count(from);
        if (from->broken || same > count - at || distance == 0 || distance > at) {
            return false;
        }
        for (uint64_t i = 0; i < same; i++, at++) { /* byte by byte: a repeat may reach into the
                                                       bytes that it has just written */
            out[at] = out[at - (size_t)distance];
        }
    }
}
