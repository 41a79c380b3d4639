/* reals.h: numbers in double precision of several trees side by side, one tree a lane: as many as a
 * vector register holds. Every operation works on each lane separately and is correctly rounded. */
#ifndef TD_REALS_H
#define TD_REALS_H

#include "base/simd.h"

#if defined(__x86_64__) || defined(__i386__)
#define TD_TREES_OF_FOUR
enum { TD_TREES = 4 };
typedef d4 td_reals;
typedef l4 td_choice; /* a mask: lanes are all ones (-1) or all zeros */
#else
enum { TD_TREES = 2 };
typedef d2 td_reals;
typedef l2 td_choice;
#endif

TD_INLINE_SMALL td_reals td_reals_all(double x) {
    td_reals r = {0};
    return r + x;
}

/* a where the mask is set, else b. */
TD_INLINE_SMALL td_reals td_reals_pick(td_choice mask, td_reals a, td_reals b) {
    return (td_reals)(((td_choice)a & mask) | ((td_choice)b & ~mask));
}

TD_INLINE_SMALL td_reals td_reals_abs(td_reals x) {
    td_choice magnitude = {0};
    return (td_reals)((td_choice)x & (magnitude + INT64_MAX));
}

/* The greater of a and b; b where either is not-a-number, as in td_max_double. */
TD_INLINE_SMALL td_reals td_reals_max(td_reals a, td_reals b) {
#if defined(TD_TREES_OF_FOUR)
    return d4_max(a, b);
#else
    return td_reals_pick((td_choice)(a > b), a, b);
#endif
}

TD_INLINE bool td_choice_any(td_choice mask) {
#if defined(TD_TREES_OF_FOUR)
    return l4_any(mask);
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

#endif
