/* plane_sweep_widest.c: the broadphase that sorts and sweeps along the axis along which shapes are
 * spread more widely, so that fewer of them begin before another one ends (C. Ericson, "Real-Time
 * Collision Detection", 2005, 7.5.1); see plane_sweep.c. */
#include "broadphase/plane_sweep.h"
#include "state/kinds.h"

/* How many times the variance along the other axis must be that along the present one before the
 * axis changes, since all keys are then sorted anew. Chosen; not tuned. */
#define VARIANCE_RATIO 1.5

/* The variance of `count` values of which the sum and the sum of squares are given, times count^2.
 */
static double spread_of(double sum, double squares, int count) {
    return td_max_double(squares * (double)count - sum * sum, 0.0);
}

/* The axis along which the centres of the bounds have the greater variance; the present axis is
 * kept unless the other variance is VARIANCE_RATIO times as great. Centres are relative to that of
 * the first shape in the list, so that the sums stay exact. */
static td_axis choose_axis(const thud_world *w, const td_proxy_set *set) {
    const int32_t *list = set->list.data;
    double sum[TD_AXES] = {0.0}, squares[TD_AXES] = {0.0};
    int64_t first_x = 0, first_y = 0;
    for (int i = 0; i < set->list.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, list[i]);
        const td_bounds *b = &proxy->fat;
        int64_t x = td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x);
        int64_t y = td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y);
        first_x = i ? first_x : x;
        first_y = i ? first_y : y;
        double dx = (double)(x - first_x), dy = (double)(y - first_y);
        sum[TD_AXIS_X] += dx;
        sum[TD_AXIS_Y] += dy;
        squares[TD_AXIS_X] += dx * dx;
        squares[TD_AXIS_Y] += dy * dy;
    }
    td_axis now = set->axis, other = now == TD_AXIS_X ? TD_AXIS_Y : TD_AXIS_X;
    double here = spread_of(sum[now], squares[now], set->list.count);
    double there = spread_of(sum[other], squares[other], set->list.count);
    return there > VARIANCE_RATIO * here ? other : now;
}

/* thud_broadphase.build: chooses the axis, sorts the keys and makes `ids` their order. */
static bool build(thud_world *w, td_proxy_set *set, bool few_moved) {
    (void)few_moved;
    return td_sweep_build(w, set, choose_axis(w, set));
}

const thud_broadphase thud_broadphase_sweep_widest = {
    .name = "plane sweep widest",
    .build = build,
    .sweep = TD_BOTH_WIDE(td_sorted_axis_sweep),
    .find = TD_BOTH_WIDE(td_sorted_axis_find),
};
