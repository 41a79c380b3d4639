/* wide_tally.c: adds up depths, overlaps and numbers of contact points, and finds the fastest
 * closing speed, eight at a time; see tally.h. */
#include "solver/tally.h"

/* Rounds a sum of floats over a few blocks to whole quanta, so that the sums of such values over
 * all blocks are exact in any order. */
TD_INLINE d4 quanta_of(f8 length, double to_fixed) {
    return (d4_folded(length) * to_fixed + TD_ROUND_SHIFT) - TD_ROUND_SHIFT;
}

/* Adds up min(separation, -skin) over the points, which for each is -skin minus its penetration
 * depth. The sum of the depths is the difference between this sum and that of as many points
 * without overlap, -skin each. The order of operands of f8_min leaves separations out that are not
 * a number. */
td_tally_fn TD_WIDE(td_tally_points);
void TD_WIDE(td_tally_points)(td_tally *to, td_block *const *blocks, int count, int points,
                              const td_tally_context *c) {
    f8 zero = f8_all(0.0f), touch = f8_all(-c->skin), limit = f8_all(-c->skin - c->overlap);
    f8 lowest = touch;
    i8 here = i8_all(0), overlaps = i8_all(0);
    for (int first = 0; first < count; first += TD_CHUNK_UNIT) {
        int end = td_min_int(first + TD_CHUNK_UNIT, count);
        f8 sum = zero;
        for (int i = first; i < end; i++) {
            const td_point *point = blocks[i]->point;
            for (int k = 0; k < points; k++) {
                f8 separation = f8_min(point[k].separation, touch);
                lowest = f8_min(separation, lowest);
                sum += separation;
                overlaps -= separation < limit; /* a mask counts as -1 */
                here -= point[k].normal_mass > zero;
            }
        }
        f8 untouched = f8_all((float)((end - first) * points)) * touch;
        to->depth -= quanta_of(sum - untouched, c->to_fixed);
    }
    to->min_distance = f8_min(lowest - touch, to->min_distance);
    to->points += here;
    to->overlaps += overlaps;
}

td_tally_speeds_fn TD_WIDE(td_tally_speeds);
void TD_WIDE(td_tally_speeds)(td_tally *to, td_block *const *blocks, int count, int points,
                              const float (*velocity)[4], float inv_h) {
    f8 zero = f8_all(0.0f), substep_rate = f8_all(inv_h);
    for (int i = 0; i < count; i++) {
        const td_block *block = blocks[i];
        td_rows a = td_gather(velocity, block->a), b = td_gather(velocity, block->b);
        f8 along = (b.x - a.x) * block->nx + (b.y - a.y) * block->ny;
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            f8 speed = along + b.z * p->cross_b - a.z * p->cross_a +
                       f8_max(p->separation, zero) * substep_rate;
            to->min_speed = f8_min(f8_keep(p->normal_mass > zero, speed), to->min_speed);
        }
    }
}
