/* wide_seen.c: computes what listeners see of a block's eight lanes; see seen.h. */
#include "listeners/seen.h"

/* Four lengths in position quanta, rounded as td_length_from does. Lever arms are far below its
 * limit of 2^51. */
TD_INLINE l4 quanta_of(f4 length, double to_fixed) {
    d4 shifted = __builtin_convertvector(length, d4) * to_fixed + TD_ROUND_SHIFT;
    return (l4)shifted - TD_ROUND_BITS;
}

/* quanta_of for eight lengths, as two halves. */
TD_INLINE void both_quanta(f8 length, double to_fixed, l4 quanta[2]) {
    quanta[0] = quanta_of(__builtin_shufflevector(length, length, 0, 1, 2, 3), to_fixed);
    quanta[1] = quanta_of(__builtin_shufflevector(length, length, 4, 5, 6, 7), to_fixed);
}

/* Computes td_seen_block for a number of points that is known at compile time. */
TD_INLINE void see(td_block *block, int points, const td_seeing *how, td_seen_block *seen) {
    const td_point_history *history = td_history_of(block, points);
    f8 zero = f8_all(0.0f), separation = f8_all(FLT_MAX), along = zero, impulse = zero;
    i8 count = i8_all(0);
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        i8 here = p->normal_mass != zero;
        separation = f8_pick(here, f8_min(separation, p->separation + how->skin), separation);
        along += f8_keep(here, p->cross_b);
        impulse += f8_keep(here, history[k].total);
        count -= here;
    }
    seen->separation = separation;
    seen->points = count;
    if (how->solved) {
        seen->normal_impulse = impulse;
        seen->tangent_impulse = td_surface_at(block, points)->total;
    }
    if (how->places) {
        /* With r the mean lever arm of b, cn = r x n and ct = r x t with t = (ny, -nx), so that
         * r = (cn ny - ct nx, -cn nx - ct ny). */
        f8 cn = f8_pick(count == 2, along * 0.5f, along), ct = block->tangent_cross_b;
        f8 nx = block->nx, ny = block->ny;
        both_quanta(cn * ny - ct * nx, how->to_fixed, seen->x);
        both_quanta(-cn * nx - ct * ny, how->to_fixed, seen->y);
    }
}

td_see_fn TD_WIDE(td_see_block);
void TD_WIDE(td_see_block)(td_block *block, int points, const td_seeing *how, td_seen_block *seen) {
    if (points == 2) {
        see(block, 2, how, seen);
    } else {
        see(block, 1, how, seen);
    }
}
