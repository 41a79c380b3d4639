/* wide_rod.c: solver passes for rods: one row that pulls as well as it pushes. */
#include "solver/wide_solve.h"

/* Does what solve_blocks of wide_solve.h does, but for one impulse that may pull as well as push.
 */
TD_INLINE void pull_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                           bool fixed) {
    f8 zero = f8_all(0.0f), most = f8_all(c->push_speed), bias_rate = f8_all(c->bias_rate[fixed]);
    f8 mass_scale = f8_all(c->mass_scale[fixed]), impulse_scale = f8_all(c->impulse_scale[fixed]);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_point *p = &block->point[0];
        sides v = read_sides(c->velocity, block, fixed);
        f8 closing = centres_along(&v, fixed, block->nx, block->ny);
        f8 bias = f8_clamp(p->separation * bias_rate, -most, most);
        f8 speed = at_point(closing, &v, fixed, ARMS_ALL, p) + bias;
        f8 old = p->normal_impulse;
        f8 now = old - mass_scale * p->normal_mass * speed - impulse_scale * old;
        p->normal_impulse = now;
        impulses change = {{now - old, zero}, zero};
        push(c, block, 1, ARMS_ALL, fixed, false, v, change);
    }
}

TD_INLINE void ease_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                           bool fixed) {
    f8 zero = f8_all(0.0f), slowest = zero;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_point *p = &block->point[0];
        sides v = read_sides(c->velocity, block, fixed), d = read_sides(c->delta, block, fixed);
        f8 closing = centres_along(&v, fixed, block->nx, block->ny);
        f8 opened = centres_along(&d, fixed, block->nx, block->ny);
        p->separation = p->base + at_point(opened, &d, fixed, ARMS_ALL, p);
        f8 speed = at_point(closing, &v, fixed, ARMS_ALL, p);
        slowest = f8_min(f8_min(speed, -speed), slowest);
        f8 old = p->normal_impulse;
        f8 now = old - p->normal_mass * speed;
        p->normal_impulse = now;
        impulses change = {{now - old, zero}, zero};
        push(c, block, 1, ARMS_ALL, fixed, false, v, change);
    }
    if (c->last) {
        c->tally->slowest = f8_min(slowest, c->tally->slowest);
    }
}

/* Nothing bounces off a rod. */
static void rest(td_block *const *blocks, int count, const td_solve_context *c) {
    (void)blocks, (void)count, (void)c;
}

TD_PASS(warm_start_moving, warm_start_blocks, 1, ARMS_ALL, false)
TD_PASS(warm_start_fixed, warm_start_blocks, 1, ARMS_ALL, true)
TD_PASS(pull_moving, pull_blocks, false)
TD_PASS(pull_fixed, pull_blocks, true)
TD_PASS(ease_moving, ease_blocks, false)
TD_PASS(ease_fixed, ease_blocks, true)

extern const td_solve_ops TD_WIDE(td_solve_rod);
const td_solve_ops TD_WIDE(td_solve_rod) = {{warm_start_moving, warm_start_fixed},
                                            {pull_moving, pull_fixed},
                                            {ease_moving, ease_fixed},
                                            rest};
