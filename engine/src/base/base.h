/* base.h: constants and helpers that every file may use.
 *
 * Constants that are lengths are multiples of the world's length scale L (thud_world.length_scale):
 * the greatest power of two that is not above the caller's length_scale. L is about the size of a
 * typical body, and a power of two, so that multiplying by it is exact. */
#ifndef TD_BASE_H
#define TD_BASE_H

#include "thud/thud_limits.h"
#include "thud/thud_math.h"

#include <assert.h>
#include <float.h>

/* The engine gives the same bits on all platforms. This needs every operation to round to its own
 * type: with excess precision the result depends on which values the compiler keeps in registers.
 */
#if FLT_EVAL_METHOD != 0
#error "thud needs float and double arithmetic without excess precision: x86 of 32 bits with \
-msse2 -mfpmath=sse (the x87 cannot), s390x with -fexcess-precision=fast"
#endif

/* The same bits everywhere also need a compiler that does not reorder sums, use reciprocals or
 * assume that no value is NaN. thud_engine_flags in cmake/thud.cmake sets the flags; a build with
 * other flags stops here. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "thud needs exact arithmetic: compile the engine with -fno-fast-math after -Ofast, \
-ffast-math and their parts; programs that call it may have them"
#endif

/* The wide files (wide_*.c) are compiled a second time for AVX2 (thud_wide_sources in
 * cmake/thud.cmake); not by gcc for Windows, which puts vectors of 32 bytes on a stack that is
 * aligned to 16. */
#if defined(__x86_64__) && (defined(__clang__) || !defined(_WIN32))
#define TD_HAS_AVX2
#endif

/* For functions whose body is smaller than a call: they are inlined even where the compiler
 * optimises for size. */
#define TD_INLINE_SMALL static inline __attribute__((always_inline))

/* Lanes of a block and of a vector. Eight on every processor, since the number decides the order of
 * solving, and with it the bits of the result. */
#define TD_LANES 8
#define TD_NONE (-1) /* "no index", in every field that is an index or a link */

#define TD_PI 3.14159265358979323846

/* Speculative margin, L: a pair has contact points as soon as its shapes are nearer than this, so
 * that the solver can stop bodies before they overlap. Chosen, the same as Box2D's
 * B2_SPECULATIVE_DISTANCE. */
#define TD_SPECULATIVE 0.02f
/* An overlap, L, that is too small to matter. Continuous detection lets a body stop with an overlap
 * of at most twice this, so that the next step finds a contact; and the error statistics count
 * overlaps that are deeper than this. Chosen, the same as Box2D's B2_LINEAR_SLOP. */
#define TD_SLOP 0.005f
/* Separation of a contact point that does not exist, a length: no motion makes it negative. */
#define TD_APART 1e18f
/* Distance, L, at which soft contacts rest in a world that is bisected or swept, so that bodies
 * under load do not overlap although the contacts give way. At qualities that solve all islands
 * directly it is TD_IMPACT_DISTANCE. Chosen: bodies that the caller places so that they touch are
 * pushed apart by this distance, which moves the top of a pyramid of 30 rows by 49 mm at the
 * quality default. (Under the detection continuous, without a skin, it sinks by 51 mm.) Measured:
 * with 0.004 it moves by 84 mm; with 0.002, where the load presses the boxes of the base into each
 * other, by 101 mm. */
#define TD_SKIN 0.003f
/* Whether the machine can fetch memory into its cache ahead of use. WebAssembly cannot, and code
 * that only prefetches is left out there. */
#ifdef __wasm__
enum { TD_HAS_PREFETCH = 0 };
#else
enum { TD_HAS_PREFETCH = 1 };
#endif

/* Distance, L, at which two shapes that close count as having met: the time of impact is when they
 * are this near, unless they are nearer at the start. Chosen. */
#define TD_IMPACT_DISTANCE 0.001f
/* When fat bounds are made, they exceed the tight bounds by TD_MARGIN + min(TD_MARGIN_MORE, extent
 * / 8), L. TD_MARGIN is a little more than half of TD_SPECULATIVE, so that the fat bounds of two
 * shapes overlap before they are as near as that. (A shape then moves within its fat bounds, so
 * that the bounds of a touching pair may stop overlapping: td_pairs_create.) Larger margins mean
 * that bounds are made less often, but that more pairs are kept that do not touch. Chosen. */
#define TD_MARGIN 0.0101f
#define TD_MARGIN_MORE 0.02f
/* A body is at rest below this speed, L/s, of its centre of mass, and by rotation of its farthest
 * point. Chosen, the same as Box2D's default sleepThreshold. */
#define TD_SLEEP_SPEED 0.05f
/* An island falls asleep when all its bodies have been at rest for this time, s. wide_finalize.c
 * counts the time, sleep.c compares it; a body that the caller puts to sleep gets it at once
 * (changes.c). Chosen, the same as Box2D's B2_TIME_TO_SLEEP. */
#define TD_SLEEP_TIME 0.5f

/* The value of `cookie` that default functions set in defs ("thud" in ASCII). A def without it was
 * not made by its default function, and is refused. */
#define TD_COOKIE 0x74687564u
/* The cookie of a world def whose world is not to use AVX2; see thud_testing.h. */
#define TD_COOKIE_BASELINE 0x74687563u

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
