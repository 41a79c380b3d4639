/* decoder.h: a fuzzer's bytes as choices and numbers. One byte makes one value, so that a fuzzer
 * that changes a byte changes one thing; when the bytes are used up every answer is the first. */
#ifndef FUZZ_DECODER_H
#define FUZZ_DECODER_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct fuzz_bytes {
    const uint8_t *at, *end;
    bool hostile; /* numbers may be what no caller means */
} fuzz_bytes;

static inline unsigned next_byte(fuzz_bytes *b) {
    return b->at < b->end ? *b->at++ : 0;
}

static inline int next_choice(fuzz_bytes *b, int count) {
    return (int)(next_byte(b) % (unsigned)count);
}

/* True once in so many of the 256 bytes, and never at their end. */
static inline bool next_chance(fuzz_bytes *b, int one_in) {
    return next_byte(b) % (unsigned)one_in == (unsigned)one_in - 1;
}

/* ---- numbers ---- */

enum { FIRST_HOSTILE = 240 }; /* bytes from here on mean a hostile number, where those are wanted */

static inline double hostile_number(unsigned byte) {
    static const double numbers[] = {NAN,     INFINITY,     -INFINITY,
                                     -0.0,    DBL_TRUE_MIN, (double)FLT_TRUE_MIN,
                                     1e-30,   -1e-4,        1e-4,
                                     16384,   1e6,          1e9,
                                     -1e9,    1e12,         3e38,
                                     -DBL_MAX};
    return numbers[byte % (sizeof numbers / sizeof *numbers)];
}

/* From low in steps; hostile now and then. */
static inline double next_number(fuzz_bytes *b, double low, double step) {
    unsigned byte = next_byte(b);
    return b->hostile && byte >= FIRST_HOSTILE ? hostile_number(byte) : low + step * (double)byte;
}

/* As a float, which what is beyond its range becomes infinite in. */
static inline float next_float(fuzz_bytes *b, double low, double step) {
    double wide = next_number(b, low, step);
    return fabs(wide) <= (double)FLT_MAX || isnan(wide) ? (float)wide
           : wide > 0                                   ? INFINITY
                                                        : -INFINITY;
}

/* Small counts, and what is none: -1, 0, and more than anybody means. */
static inline int next_count(fuzz_bytes *b, int most) {
    unsigned byte = next_byte(b);
    if (b->hostile && byte >= FIRST_HOSTILE) {
        static const int wrong[] = {-1, 0, INT32_MIN, 1 << 20};
        return wrong[byte % 4];
    }
    return (int)(byte % (unsigned)(most + 1));
}

#endif
