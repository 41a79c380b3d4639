/* stream.h: the numbers of a recording as bytes, the same on every platform: low bytes first.
 * Integers are written with seven bits a byte. Of a floating-point number the low bytes that are 0
 * are left out, which are many in round values. */
#ifndef TD_STREAM_H
#define TD_STREAM_H

#include "base/memory.h"

#include <stddef.h>

/* Bytes that grow. When memory is short, `broken` is set and later writes do nothing. */
typedef struct td_writer {
    td_memory memory;
    uint8_t *bytes;
    size_t count, room;
    bool broken;
} td_writer;

void td_write_bytes(td_writer *to, const void *bytes, size_t count);
void td_write_byte(td_writer *to, unsigned byte);
void td_write_count(td_writer *to, uint64_t value);
/* An integer of either sign; one near 0 takes few bytes. */
void td_write_integer(td_writer *to, int64_t value);
/* `bytes` whole bytes of the value, low ones first. */
void td_write_fixed(td_writer *to, uint64_t value, int bytes);
/* Writes a floating-point number, of which `bits` are the bits and `bytes` the size, 4 or 8. */
void td_write_number(td_writer *to, uint64_t bits, int bytes);
void td_writer_free(td_writer *to);

/* Bytes that are read. Reading beyond their end gives 0, and sets `broken`. */
typedef struct td_reader {
    const uint8_t *bytes;
    size_t at, end;
    bool broken;
} td_reader;

/* The next `count` bytes, or null where there are fewer. */
const uint8_t *td_read_bytes(td_reader *from, uint64_t count);
unsigned td_read_byte(td_reader *from);
uint64_t td_read_count(td_reader *from);
int64_t td_read_integer(td_reader *from);
uint64_t td_read_fixed(td_reader *from, int bytes);
uint64_t td_read_number(td_reader *from, int bytes);

/* A checksum by bytes, which is the same on every platform: FNV-1a of 64 bits (G. Fowler, L. Noll,
 * K.-P. Vo, "The FNV Non-Cryptographic Hash Algorithm"). Each step is a bijection of the sum, so
 * that a change of one byte is always found. */
uint64_t td_stream_sum(const uint8_t *bytes, size_t count);

#endif
