/* decoder.h: turns a fuzzer's bytes into choices and numbers. Each value takes one byte, so that a
 * fuzzer that changes a byte changes one value. When the bytes are used up every byte is 0, so that
 * every choice is the first. */
#ifndef FUZZ_DECODER_H
#define FUZZ_DECODER_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct fuzz_bytes {
    const uint8_t *at, *end;
    bool hostile; /* some bytes mean numbers that are out of range, infinite or NaN */
} fuzz_bytes;

static inline unsigned next_byte(fuzz_bytes *b) {
    return b->at < b->end ? *b->at++ : 0;
}

static inline int next_choice(fuzz_bytes *b, int count) {
    return (int)(next_byte(b) % (unsigned)count);
}

/* True for one in `one_in` of the 256 bytes; false when the bytes are used up. */
static inline bool next_chance(fuzz_bytes *b, int one_in) {
    return next_byte(b) % (unsigned)one_in == (unsigned)one_in - 1;
}

/* ---- numbers ---- */

enum {
    FIRST_HOSTILE = 240
}; /* where numbers are hostile, bytes from here on mean a hostile number */

static inline double hostile_number(unsigned byte) {
    static const double numbers[] = {NAN,     INFINITY,     -INFINITY,
                                     -0.0,    DBL_TRUE_MIN, (double)FLT_TRUE_MIN,
                                     1e-30,   -1e-4,        1e-4,
                                     16384,   1e6,          1e9,
                                     -1e9,    1e12,         3e38,
                                     -DBL_MAX};
    return numbers[byte % (sizeof numbers / sizeof *numbers)];
}

/* low + step * byte; with hostile numbers, one of hostile_number for the highest bytes. */
static inline double next_number(fuzz_bytes *b, double low, double step) {
    unsigned byte = next_byte(b);
    return b->hostile && byte >= FIRST_HOSTILE ? hostile_number(byte) : low + step * (double)byte;
}

/* The same as a float; numbers beyond the range of floats become infinite. */
static inline float next_float(fuzz_bytes *b, double low, double step) {
    double wide = next_number(b, low, step);
    return fabs(wide) <= (double)FLT_MAX || isnan(wide) ? (float)wide
           : wide > 0                                   ? INFINITY
                                                        : -INFINITY;
}

/* A count between 0 and `most`; with hostile numbers also -1, 0, INT32_MIN and 2^20. */
static inline int next_count(fuzz_bytes *b, int most) {
    unsigned byte = next_byte(b);
    if (b->hostile && byte >= FIRST_HOSTILE) {
        static const int wrong[] = {-1, 0, INT32_MIN, 1 << 20};
        return wrong[byte % 4];
    }
    return (int)(byte % (unsigned)(most + 1));
}

#endif
