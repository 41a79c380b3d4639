/* base.h: constants and helpers that every file may use.
 *
 * Lengths named here are multiples of the world's length scale L, the power of two nearest to the
 * caller's length_scale. */
#ifndef TD_BASE_H
#define TD_BASE_H

#include "thud/thud_limits.h"
#include "thud/thud_math.h"

#include <assert.h>
#include <float.h>

/* Every operation rounds to its own type, or the bits would be the compiler's to choose. */
#if FLT_EVAL_METHOD != 0
#error "thud needs float and double arithmetic without excess precision: x86 of 32 bits with \
-msse2 -mfpmath=sse (the x87 cannot), s390x with -fexcess-precision=fast"
#endif

/* Nor may a compiler put sums in another order, take reciprocals or forget not-a-number. The flags
 * of thud_engine_flags see to it; whoever compiles the files with others is told. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "thud needs exact arithmetic: compile the engine with -fno-fast-math after -Ofast, \
-ffast-math and their parts; programs that call it may have them"
#endif

/* The wide files are compiled once more for AVX2; but not by gcc for Windows, which keeps vectors
 * of 32 bytes on a stack that is aligned to 16. See thud_wide_sources. */
#if defined(__x86_64__) && (defined(__clang__) || !defined(_WIN32))
#define TD_HAS_AVX2
#endif

/* A function whose body is smaller than its call, so that it is taken inline for size as well. */
#define TD_INLINE_SMALL static inline __attribute__((always_inline))

#define TD_LANES 8   /* contacts and bodies are worked on eight at a time, whatever the CPU */
#define TD_NONE (-1) /* "no index" in every integer link */

#define TD_PI 3.14159265358979323846

/* Contacts exist from this distance on, so that a pair closing in is caught before it overlaps
 * (speculative margin). */
#define TD_SPECULATIVE 0.02f
/* Overlap that the continuous stage leaves, so that the next step finds a contact. */
#define TD_SLOP 0.005f
/* Separation of a point that is not there: no motion brings it near. */
#define TD_APART 1e18f
/* In a world that is bisected or swept, contacts rest this far apart, so that what load presses
 * together does not overlap. */
#define TD_SKIN 0.004f
/* Swept shapes count as met at this distance, unless they are nearer to begin with. */
#define TD_MEET 0.001f
/* Fat bounds exceed tight ones by TD_MARGIN + min(TD_MARGIN_MORE, extent / 8) when they are made:
 * small enough that few pairs are carried in vain. Shapes drift to the edge of their own, so that
 * those of a touching pair may part: see td_pairs_create. */
#define TD_MARGIN 0.0101f
#define TD_MARGIN_MORE 0.02f
/* A body is at rest below this speed, L/s, of its centre and of its rim. */
#define TD_SLEEP_SPEED 0.05f
/* An island sleeps once all its bodies were at rest for this long, s. wide_finalize.c adds up the
 * time and counts the bodies that reach it; sleep.c asks whether a whole island has; and a body
 * that a caller puts to sleep is given it at once, in changes.c. */
#define TD_SLEEP_TIME 0.5f

/* What default functions leave in defs, and a zeroed one lacks. */
#define TD_COOKIE 0x74687564u

static inline int td_min_int(int a, int b) {
    return a < b ? a : b;
}

static inline int td_max_int(int a, int b) {
    return a > b ? a : b;
}

static inline float td_min_float(float a, float b) {
    return a < b ? a : b;
}

static inline float td_max_float(float a, float b) {
    return a > b ? a : b;
}

static inline double td_min_double(double a, double b) {
    return a < b ? a : b;
}

static inline double td_max_double(double a, double b) {
    return a > b ? a : b;
}

static inline double td_abs(double x) {
    return x < 0.0 ? -x : x;
}

/* False for infinities and not-a-number, without a call to the library. */
static inline bool td_finite(double x) {
    return x - x == 0.0;
}

#endif
