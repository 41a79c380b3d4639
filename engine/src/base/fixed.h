/* fixed.h: world positions in 64-bit fixed point, and bounds (AABBs) in 32-bit fixed point.
 *
 * Positions are integers, in position quanta of L * 2^-32. The engine uses differences of positions
 * alone, which are exact, so that a scene behaves the same, bit for bit, wherever in the world it
 * is.
 *
 * Bounds are integers, in bounds quanta of L * 2^-14, which wrap around every 2^18 L. They are
 * compared by differences. The worst effect of a wrap is that two distant shapes become a pair, and
 * the narrowphase, which computes their separation from their positions, finds that they do not
 * touch. */
#ifndef TD_FIXED_H
#define TD_FIXED_H

#include "base/base.h"

#define TD_FIXED_ONE 4294967296.0 /* quanta in L */
#define TD_COARSE_SHIFT 18        /* position quanta in a bounds quantum, as a shift */
#define TD_COARSE_ONE 16384.0     /* bounds quanta in L */

/* A position, in position quanta. */
typedef struct td_position {
    int64_t x, y;
} td_position;

/* An axis-aligned bounding box, in bounds quanta; the maxima belong to it. */
typedef struct td_bounds {
    int32_t min_x, min_y, max_x, max_y;
} td_bounds;

/* Rounds to the nearest integer, halves up: the same result after x has been shifted by an integer.
 * |x| < 2^63. */
static inline int64_t td_round64(double x) {
    double low = (double)(int64_t)x;
    if (low > x) {
        low -= 1.0;
    }
    return (int64_t)low + (x - low >= 0.5 ? 1 : 0);
}

/* Rounds to the nearest integer, halves to even, as the wide kernels do eight at a time; for
 * |x| < 2^51. Adding 1.5 * 2^52 (TD_ROUND_SHIFT, whose bits are TD_ROUND_BITS) leaves the integer
 * in the low bits of the double. */
#define TD_ROUND_SHIFT 6755399441055744.0
#define TD_ROUND_BITS 0x4338000000000000

static inline int64_t td_round_increment(double x) {
    double shifted = x + TD_ROUND_SHIFT;
    int64_t bits;
    __builtin_memcpy(&bits, &shifted, sizeof bits);
    return bits - TD_ROUND_BITS;
}

/* Addition and subtraction modulo 2^32. */
static inline int32_t td_wrap_add(int32_t a, int32_t b) {
    return (int32_t)((uint32_t)a + (uint32_t)b);
}

static inline int32_t td_wrap_sub(int32_t a, int32_t b) {
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

/* Sums and differences modulo 2^64, for positions: a body that leaves their range, 2^31 L either
 * way, enters it again at the other end. */
TD_INLINE_SMALL int64_t td_wrap_add64(int64_t a, int64_t b) {
    return (int64_t)((uint64_t)a + (uint64_t)b);
}

TD_INLINE_SMALL int64_t td_wrap_sub64(int64_t a, int64_t b) {
    return (int64_t)((uint64_t)a - (uint64_t)b);
}

/* A coordinate of a position in bounds quanta, rounded down and wrapped. */
static inline int32_t td_coarse(int64_t position) {
    return (int32_t)(uint32_t)(uint64_t)(position >> TD_COARSE_SHIFT);
}

/* Whether two boxes overlap or touch: none of four differences is negative. */
static inline bool td_bounds_overlap(const td_bounds *a, const td_bounds *b) {
    return (td_wrap_sub(a->max_x, b->min_x) | td_wrap_sub(b->max_x, a->min_x) |
            td_wrap_sub(a->max_y, b->min_y) | td_wrap_sub(b->max_y, a->min_y)) >= 0;
}

/* Whether `inner` lies within `outer`. */
static inline bool td_bounds_contain(const td_bounds *outer, const td_bounds *inner) {
    return (td_wrap_sub(inner->min_x, outer->min_x) | td_wrap_sub(outer->max_x, inner->max_x) |
            td_wrap_sub(inner->min_y, outer->min_y) | td_wrap_sub(outer->max_y, inner->max_y)) >= 0;
}

/* The smallest box that contains both, which must be within 2^17 L of each other. */
static inline td_bounds td_bounds_around(const td_bounds *a, const td_bounds *b) {
    return (td_bounds){td_wrap_sub(b->min_x, a->min_x) < 0 ? b->min_x : a->min_x,
                       td_wrap_sub(b->min_y, a->min_y) < 0 ? b->min_y : a->min_y,
                       td_wrap_sub(b->max_x, a->max_x) > 0 ? b->max_x : a->max_x,
                       td_wrap_sub(b->max_y, a->max_y) > 0 ? b->max_y : a->max_y};
}

/* The box about a position, with half extents in bounds quanta. The position is rounded down, so
 * that the maxima get one quantum more. */
static inline td_bounds td_bounds_about(td_position center, int32_t half_x, int32_t half_y) {
    int32_t x = td_coarse(center.x), y = td_coarse(center.y);
    return (td_bounds){td_wrap_sub(x, half_x), td_wrap_sub(y, half_y), td_wrap_add(x, half_x + 1),
                       td_wrap_add(y, half_y + 1)};
}

/* The box grown by a margin on all sides, in bounds quanta. */
static inline td_bounds td_bounds_grown(td_bounds b, int32_t margin) {
    return (td_bounds){td_wrap_sub(b.min_x, margin), td_wrap_sub(b.min_y, margin),
                       td_wrap_add(b.max_x, margin), td_wrap_add(b.max_y, margin)};
}

/* The coordinate `value` of bounds without wrapping, in bounds quanta, given the coordinate of a
 * position within 2^17 L of it. */
static inline int64_t td_unwrap(int32_t value, int64_t near_position) {
    int64_t near_coarse = near_position >> TD_COARSE_SHIFT;
    return near_coarse + td_wrap_sub(value, (int32_t)(uint32_t)(uint64_t)near_coarse);
}

#endif
