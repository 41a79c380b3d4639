/* simd.h: vectors of eight floats or ints, by the vector extensions of gcc and clang.
 *
 * Every operation works on each lane separately and is exact or correctly rounded (no fused
 * multiply-add, no approximate reciprocal), so that SSE2, AVX2, NEON, wasm SIMD128 and scalar code
 * give the same bits. All intrinsics of the engine are in this file.
 *
 * Types: f, i, u, d, l, v are float, int32_t, uint32_t, double, int64_t, uint64_t; the digit is the
 * number of lanes. A mask is an i8 whose lanes are all ones (-1) or all zeros, as comparisons give
 * it. */
#ifndef TD_SIMD_H
#define TD_SIMD_H

#include "base/base.h"

/* The smallest header that has the instruction set: <immintrin.h> takes longer to parse than most
 * files of the engine take to compile. */
#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSSE3__)
#include <tmmintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#if defined(__GNUC__) && !defined(__clang__)
/* The warning is about the calling convention of vectors; they are passed to inlined functions
 * alone. */
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

/* TD_WIDE(name) in a wide file is the name with the suffix of the instruction set for which the
 * file is compiled (TD_ISA: base or avx2). */
#define TD_JOIN_(a, b) a##_##b
#define TD_JOIN(a, b) TD_JOIN_(a, b)
#ifdef TD_ISA
#define TD_WIDE(name) TD_JOIN(name, TD_ISA)
#endif

/* Wide files are compiled for every processor and, on x86-64, again for AVX2. TD_PICK_WIDE chooses
 * one at run time: `of` is a pointer to a struct whose field `wide` says whether AVX2 may be used.
 */
#if defined(TD_HAS_AVX2)
#define TD_PICK_WIDE(of, name) (*((of)->wide ? &TD_JOIN(name, avx2) : &TD_JOIN(name, base)))
#define TD_DECLARE_WIDE(type, name) extern type TD_JOIN(name, base), TD_JOIN(name, avx2)
#else
#define TD_PICK_WIDE(of, name) TD_JOIN(name, base)
#define TD_DECLARE_WIDE(type, name) extern type TD_JOIN(name, base)
#endif

typedef float f8 __attribute__((vector_size(32)));
typedef int32_t i8 __attribute__((vector_size(32)));
typedef uint32_t u8 __attribute__((vector_size(32)));
typedef float f4 __attribute__((vector_size(16)));
typedef int32_t i4 __attribute__((vector_size(16)));
typedef double d4 __attribute__((vector_size(32)));
typedef int64_t l4 __attribute__((vector_size(32)));
typedef double d2 __attribute__((vector_size(16)));
typedef int64_t l2 __attribute__((vector_size(16)));
typedef uint64_t v2 __attribute__((vector_size(16)));
typedef uint64_t v4 __attribute__((vector_size(32)));

/* For the functions that make up the kernels (loops over vectors): always inlined, unless the
 * compiler optimises for size. Functions of one or two instructions are TD_INLINE_SMALL: vectors of
 * eight are passed through memory, so that a call would take more bytes than the function. */
#if defined(__OPTIMIZE_SIZE__)
#define TD_INLINE static inline
#else
#define TD_INLINE static inline __attribute__((always_inline))
#endif

/* A vector with all lanes x. */
TD_INLINE_SMALL f8 f8_all(float x) {
    return (f8){x, x, x, x, x, x, x, x};
}

TD_INLINE_SMALL i8 i8_all(int32_t x) {
    return (i8){x, x, x, x, x, x, x, x};
}

/* Whether the program can have more than one thread: WebAssembly without atomics cannot, and does
 * not link the code that workers share. */
#if defined(__wasm__) && !defined(__wasm_atomics__)
enum { TD_HAS_THREADS = 0 };
#else
enum { TD_HAS_THREADS = 1 };
#endif

/* For loops that wait for another thread: tells the processor so. */
TD_INLINE void td_pause(void) {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

/* ---- the floating-point mode ----
 *
 * The calling thread may flush denormals to zero, round in another direction, or trap exceptions,
 * which would change results. API functions that compute the state of a world therefore set one
 * mode (round to nearest, keep denormals, trap nothing) and restore the thread's own when they
 * return. wasm has this mode alone. On processors other than those below the caller must have it
 * set. */
#if defined(__SSE2__)
typedef unsigned td_float_mode;
#define TD_FLOAT_MODE_GET(mode) __asm__ volatile("stmxcsr %0" : "+m"(mode)::"memory")
#define TD_FLOAT_MODE_SET(mode) __asm__ volatile("ldmxcsr %0" ::"m"(mode) : "memory")
#define TD_FLOAT_MODE_OWN 0x1f80u
#define TD_FLOAT_MODE_FLAGS                                               \
    0x3fu /* flags of exceptions that have occurred, which are no part of \
             the mode */
#elif defined(__aarch64__)
typedef uint64_t td_float_mode;
#define TD_FLOAT_MODE_GET(mode) __asm__ volatile("mrs %0, fpcr" : "=r"(mode)::"memory")
#define TD_FLOAT_MODE_SET(mode) __asm__ volatile("msr fpcr, %0" ::"r"(mode) : "memory")
#define TD_FLOAT_MODE_OWN 0u
#define TD_FLOAT_MODE_FLAGS 0u
#endif

#if defined(TD_FLOAT_MODE_OWN)
/* Sets the engine's mode, and returns the one before. Writing the register waits for all operations
 * under way, so that it is written only where the mode differs. `mode` is initialised for clang's
 * memory sanitizer, which does not see that the assembly writes it. */
static inline td_float_mode td_float_mode_enter(void) {
    td_float_mode mode = TD_FLOAT_MODE_OWN, own = TD_FLOAT_MODE_OWN;
    TD_FLOAT_MODE_GET(mode);
    if (__builtin_expect((mode & ~(td_float_mode)TD_FLOAT_MODE_FLAGS) != TD_FLOAT_MODE_OWN, 0)) {
        TD_FLOAT_MODE_SET(own);
    }
    return mode;
}

/* Restores the mode that td_float_mode_enter returned. */
static inline void td_float_mode_restore(const td_float_mode *mode) {
    if (__builtin_expect((*mode & ~(td_float_mode)TD_FLOAT_MODE_FLAGS) != TD_FLOAT_MODE_OWN, 0)) {
        TD_FLOAT_MODE_SET(*mode);
    }
}

/* Stands as the first line of a function, which then runs in the engine's mode until it returns. */
#define TD_IN_OWN_FLOAT_MODE                                                           \
    __attribute__((cleanup(td_float_mode_restore))) const td_float_mode callers_mode = \
        td_float_mode_enter();                                                         \
    (void)callers_mode
#else
#define TD_IN_OWN_FLOAT_MODE (void)0
#endif

/* `yes` in the lanes of the mask, `no` in the others. */
TD_INLINE_SMALL f8 f8_pick(i8 mask, f8 yes, f8 no) {
#if defined(__AVX2__)
    return (f8)_mm256_blendv_ps((__m256)no, (__m256)yes, (__m256)mask);
#else
    return (f8)((mask & (i8)yes) | (~mask & (i8)no));
#endif
}

TD_INLINE_SMALL i8 i8_pick(i8 mask, i8 yes, i8 no) {
    return (mask & yes) | (~mask & no);
}

TD_INLINE_SMALL f8 f8_keep(i8 mask, f8 x) /* x where the mask is set, else 0 */
{
    return (f8)(mask & (i8)x);
}

TD_INLINE f8 f8_min(f8 a, f8 b) /* b where a lane is not-a-number, as on x86 */
{
#if defined(__AVX2__)
    return (f8)_mm256_min_ps((__m256)a, (__m256)b);
#else
    return f8_pick(a < b, a, b);
#endif
}

TD_INLINE f8 f8_max(f8 a, f8 b) /* b where a lane is not-a-number, as on x86 */
{
#if defined(__AVX2__)
    return (f8)_mm256_max_ps((__m256)a, (__m256)b);
#else
    return f8_pick(a > b, a, b);
#endif
}

TD_INLINE_SMALL d4 d4_max(d4 a, d4 b) /* b where a lane is not-a-number, as on x86 */
{
#if defined(__AVX2__)
    return (d4)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    l4 above = (l4)(a > b);
    return (d4)(((l4)a & above) | ((l4)b & ~above));
#endif
}

/* Whether a lane of a mask is set. */
TD_INLINE bool l4_any(l4 mask) {
#if defined(__AVX2__)
    return _mm256_movemask_pd((__m256d)mask) != 0;
#else
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}

TD_INLINE f8 f8_clamp(f8 x, f8 low, f8 high) {
    return f8_min(f8_max(x, low), high);
}

TD_INLINE_SMALL f8 f8_abs(f8 x) {
    return (f8)((i8)x & i8_all(0x7fffffff));
}

TD_INLINE_SMALL f8 f8_flip(f8 x, i8 mask) /* -x where the mask is set */
{
    return (f8)((i8)x ^ (mask & i8_all((int32_t)0x80000000u)));
}

TD_INLINE f8 f8_sqrt(f8 x) {
#if defined(__AVX2__)
    return (f8)_mm256_sqrt_ps((__m256)x);
#elif defined(__SSE2__)
    f4 low = __builtin_shufflevector(x, x, 0, 1, 2, 3);
    f4 high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
    low = (f4)_mm_sqrt_ps((__m128)low);
    high = (f4)_mm_sqrt_ps((__m128)high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#elif defined(__wasm_simd128__)
    f4 low = __builtin_shufflevector(x, x, 0, 1, 2, 3);
    f4 high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
    low = (f4)wasm_f32x4_sqrt((v128_t)low);
    high = (f4)wasm_f32x4_sqrt((v128_t)high);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    f8 r;
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = __builtin_sqrtf(x[i]);
    }
    return r;
#endif
}

/* The sums of lanes i and i + 4, rounded to float, as doubles. */
TD_INLINE d4 d4_folded(f8 x) {
    f4 sums = __builtin_shufflevector(x, x, 0, 1, 2, 3) + __builtin_shufflevector(x, x, 4, 5, 6, 7);
#if defined(__AVX2__)
    return (d4)_mm256_cvtps_pd((__m128)sums); /* gcc does not find this instruction itself */
#else
    return __builtin_convertvector(sums, d4);
#endif
}

/* An integer in which bit i is set where lane i is negative: the bits of a mask. */
TD_INLINE unsigned i8_bits(i8 x) {
#if defined(__AVX2__)
    return (unsigned)_mm256_movemask_ps((__m256)x);
#elif defined(__SSE2__)
    i4 low = __builtin_shufflevector(x, x, 0, 1, 2, 3);
    i4 high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
    return (unsigned)_mm_movemask_ps((__m128)low) | (unsigned)_mm_movemask_ps((__m128)high) << 4;
#elif defined(__wasm_simd128__)
    i4 low = __builtin_shufflevector(x, x, 0, 1, 2, 3);
    i4 high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
    return (unsigned)wasm_i32x4_bitmask((v128_t)low) | (unsigned)wasm_i32x4_bitmask((v128_t)high)
                                                           << 4;
#else
    unsigned bits = 0;
    for (int i = 0; i < TD_LANES; i++) {
        bits |= (unsigned)(x[i] < 0) << i;
    }
    return bits;
#endif
}

TD_INLINE_SMALL i8 i8_wrap_sub(i8 a, i8 b) /* modulo 2^32 */
{
    return (i8)((u8)a - (u8)b);
}

TD_INLINE_SMALL f8 f8_load(const float *p) {
    f8 r;
    __builtin_memcpy(&r, p, sizeof r);
    return r;
}

TD_INLINE i8 i8_load(const int32_t *p) /* p needs no alignment of a vector */
{
    i8 r;
    __builtin_memcpy(&r, p, sizeof r);
    return r;
}

/* Compacts: of the eight ints at `from` it copies those whose bit is set to `to`, without gaps, and
 * returns their number. It may write all eight ints of `to`. */
TD_INLINE int i8_pack(int32_t *to, const int32_t *from, unsigned bits) {
#if defined(__SSSE3__) || defined(__wasm_simd128__)
#define TD_BYTES(i) 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3
#define TD_PACK(a, b, c, d) \
    { TD_BYTES(a), TD_BYTES(b), TD_BYTES(c), TD_BYTES(d) }
    static const _Alignas(16)
        uint8_t order[16][16] = {TD_PACK(0, 0, 0, 0), TD_PACK(0, 0, 0, 0), TD_PACK(1, 0, 0, 0),
                                 TD_PACK(0, 1, 0, 0), TD_PACK(2, 0, 0, 0), TD_PACK(0, 2, 0, 0),
                                 TD_PACK(1, 2, 0, 0), TD_PACK(0, 1, 2, 0), TD_PACK(3, 0, 0, 0),
                                 TD_PACK(0, 3, 0, 0), TD_PACK(1, 3, 0, 0), TD_PACK(0, 1, 3, 0),
                                 TD_PACK(2, 3, 0, 0), TD_PACK(0, 2, 3, 0), TD_PACK(1, 2, 3, 0),
                                 TD_PACK(0, 1, 2, 3)};
#undef TD_PACK
#undef TD_BYTES
    int low = __builtin_popcount(bits & 15u);
#if defined(__SSSE3__)
    const __m128i *orders = (const __m128i *)(const void *)order;
    __m128i a = _mm_loadu_si128((const __m128i *)(const void *)from);
    __m128i b = _mm_loadu_si128((const __m128i *)(const void *)(from + 4));
    _mm_storeu_si128((__m128i *)(void *)to, _mm_shuffle_epi8(a, orders[bits & 15u]));
    _mm_storeu_si128((__m128i *)(void *)(to + low), _mm_shuffle_epi8(b, orders[bits >> 4]));
#else
    v128_t a = wasm_v128_load(from), b = wasm_v128_load(from + 4);
    wasm_v128_store(to, wasm_i8x16_swizzle(a, wasm_v128_load(order[bits & 15u])));
    wasm_v128_store(to + low, wasm_i8x16_swizzle(b, wasm_v128_load(order[bits >> 4])));
#endif
    return low + __builtin_popcount(bits >> 4);
#else
    int count = 0;
    for (; bits; bits &= bits - 1) {
        to[count++] = from[__builtin_ctz(bits)];
    }
    return count;
#endif
}

/* Eight records of four floats as four vectors of eight: x has the first floats of all records, and
 * so on. */
typedef struct td_rows {
    f8 x, y, z, w;
} td_rows;

/* A vector of four floats at `low` and four at `high`. */
TD_INLINE_SMALL f8 f8_two(const float *low, const float *high) {
    f4 a, b;
    __builtin_memcpy(&a, low, sizeof a);
    __builtin_memcpy(&b, high, sizeof b);
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

/* Transposes: r0 has the records 0 and 4, r1 the records 1 and 5, r2 2 and 6, r3 3 and 7. */
TD_INLINE td_rows td_transpose(f8 r0, f8 r1, f8 r2, f8 r3) {
    f8 t0 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
    f8 t1 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
    f8 t2 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
    f8 t3 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
    return (td_rows){
        __builtin_shufflevector(t0, t1, 0, 1, 8, 9, 4, 5, 12, 13),
        __builtin_shufflevector(t0, t1, 2, 3, 10, 11, 6, 7, 14, 15),
        __builtin_shufflevector(t2, t3, 0, 1, 8, 9, 4, 5, 12, 13),
        __builtin_shufflevector(t2, t3, 2, 3, 10, 11, 6, 7, 14, 15),
    };
}

/* Reads the records at eight offsets. Offsets are in bytes, not in records: the multiplications for
 * addresses would otherwise take a tenth of the time of a solver pass. */
TD_INLINE td_rows td_gather(const float (*records)[4], const uint32_t *offset) {
    const char *base = (const char *)records;
    const float *r[8];
    for (int i = 0; i < 8; i++) {
        r[i] = (const float *)(const void *)(base + offset[i]);
    }
    return td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                        f8_two(r[3], r[7]));
}

/* Reads eight consecutive records. */
TD_INLINE td_rows td_load_rows(const float (*records)[4]) {
    return td_transpose(f8_two(records[0], records[4]), f8_two(records[1], records[5]),
                        f8_two(records[2], records[6]), f8_two(records[3], records[7]));
}

/* The inverse of td_transpose: `out` gets the eight records in their order. */
TD_INLINE void td_transpose_back(td_rows v, f4 out[8]) {
    f8 t0 = __builtin_shufflevector(v.x, v.y, 0, 8, 1, 9, 4, 12, 5, 13);
    f8 t1 = __builtin_shufflevector(v.x, v.y, 2, 10, 3, 11, 6, 14, 7, 15);
    f8 t2 = __builtin_shufflevector(v.z, v.w, 0, 8, 1, 9, 4, 12, 5, 13);
    f8 t3 = __builtin_shufflevector(v.z, v.w, 2, 10, 3, 11, 6, 14, 7, 15);
    f8 r[4] = {__builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13),
               __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15),
               __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13),
               __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (int i = 0; i < 4; i++) {
        out[i] = __builtin_shufflevector(r[i], r[i], 0, 1, 2, 3);
        out[i + 4] = __builtin_shufflevector(r[i], r[i], 4, 5, 6, 7);
    }
}

/* Writes eight records to offsets in bytes. Where two offsets are equal, the later lane's stays. */
TD_INLINE void td_scatter(float (*records)[4], const uint32_t *offset, td_rows v) {
    f4 r[8];
    td_transpose_back(v, r);
    for (int i = 0; i < 8; i++) {
        __builtin_memcpy((char *)records + offset[i], &r[i], sizeof r[i]);
    }
}

#endif
