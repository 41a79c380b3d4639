/* stream.c: see stream.h. */
#include "recording/stream.h"

#include <string.h>

/* ---- writing ---- */

/* The first room that a writer takes, bytes. Chosen. */
enum { FIRST_ROOM = 4096 };

void td_write_bytes(td_writer *to, const void *bytes, size_t count) {
    if (to->broken || count == 0) {
        return;
    }
    if (count > to->room - to->count) {
        size_t room = to->room ? to->room : FIRST_ROOM;
        while (room - to->count < count && room <= SIZE_MAX / 4) {
            room *= 2;
        }
        uint8_t *grown = room - to->count < count ? NULL : td_memory_get(&to->memory, room);
        if (!grown) {
            to->broken = true;
            return;
        }
        if (to->count > 0) {
            memcpy(grown, to->bytes, to->count);
        }
        td_memory_put(&to->memory, to->bytes, to->room);
        to->bytes = grown;
        to->room = room;
    }
    memcpy(to->bytes + to->count, bytes, count);
    to->count += count;
}

void td_write_byte(td_writer *to, unsigned byte) {
    uint8_t one = (uint8_t)byte;
    td_write_bytes(to, &one, 1);
}

void td_write_count(td_writer *to, uint64_t value) {
    while (value > 0x7f) {
        td_write_byte(to, (unsigned)(value & 0x7f) | 0x80u);
        value >>= 7;
    }
    td_write_byte(to, (unsigned)value);
}

void td_write_integer(td_writer *to, int64_t value) {
    td_write_count(to, (uint64_t)value << 1 ^ (value < 0 ? UINT64_MAX : 0));
}

void td_write_fixed(td_writer *to, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        td_write_byte(to, (unsigned)(value >> 8 * i) & 0xffu);
    }
}

void td_write_number(td_writer *to, uint64_t bits, int bytes) {
    int zeros = 0;
    while (zeros < bytes && (bits >> 8 * zeros & 0xff) == 0) {
        zeros++;
    }
    td_write_byte(to, (unsigned)(bytes - zeros));
    td_write_fixed(to, zeros < bytes ? bits >> 8 * zeros : 0, bytes - zeros);
}

void td_writer_free(td_writer *to) {
    td_memory_put(&to->memory, to->bytes, to->room);
    to->bytes = NULL;
    to->count = to->room = 0;
}

/* ---- reading ---- */

const uint8_t *td_read_bytes(td_reader *from, uint64_t count) {
    if (from->broken || count > from->end - from->at) {
        from->broken = true;
        return NULL;
    }
    const uint8_t *bytes = from->bytes + from->at;
    from->at += (size_t)count;
    return bytes;
}

unsigned td_read_byte(td_reader *from) {
    const uint8_t *byte = td_read_bytes(from, 1);
    return byte ? *byte : 0;
}

uint64_t td_read_count(td_reader *from) {
    uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        unsigned byte = td_read_byte(from);
        value |= (uint64_t)(byte & 0x7f) << shift;
        if (byte < 0x80) {
            return value;
        }
    }
    from->broken = true;
    return 0;
}

int64_t td_read_integer(td_reader *from) {
    uint64_t value = td_read_count(from);
    return (int64_t)(value >> 1 ^ (value & 1 ? UINT64_MAX : 0));
}

uint64_t td_read_fixed(td_reader *from, int bytes) {
    const uint8_t *at = td_read_bytes(from, (uint64_t)bytes);
    uint64_t value = 0;
    for (int i = 0; at && i < bytes; i++) {
        value |= (uint64_t)at[i] << 8 * i;
    }
    return value;
}

uint64_t td_read_number(td_reader *from, int bytes) {
    unsigned kept = td_read_byte(from);
    if (kept > (unsigned)bytes) {
        from->broken = true;
        return 0;
    }
    uint64_t high = td_read_fixed(from, (int)kept);
    return kept > 0 ? high << 8 * (bytes - (int)kept) : 0;
}

uint64_t td_stream_sum(const uint8_t *bytes, size_t count) {
    uint64_t sum = 0xcbf29ce484222325ull;
    for (size_t i = 0; i < count; i++) {
        sum = (sum ^ bytes[i]) * 0x100000001b3ull;
    }
    return sum;
}
