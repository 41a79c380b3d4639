/* wide_joint.h: where eight joints are in a substep, and how they push. The arms and axes of a
 * joint turn with its bodies in each substep: a hinge that swings would open by the square of its
 * turn in a step otherwise. */
#ifndef TD_WIDE_JOINT_H
#define TD_WIDE_JOINT_H

#include "base/rotation.h"
#include "solver/wide_solve.h"

#define ANGLE TD_JOINT_ANGLE
#define GAP_SHARE TD_JOINT_PULL
#define IMPULSE_SCALE                                                                             \
    (1.0f / (1.0f + ANGLE * (2.0f + ANGLE))) /* part of its impulse that it loses in one \
                                              */

/* In a ring that would add energy, no more than this: what many rows share of which each moves
 * little swings, and grows, unless LOST (1 + s) > s PULL with s = 1 - LOST, which takes the part of
 * an impulse that both passes of a substep correct over what a gap adds to it. */
#define GAP_SHARE_TORN (0.95f * IMPULSE_SCALE * (2.0f - IMPULSE_SCALE) / (1.0f - IMPULSE_SCALE))

TD_INLINE f8 gap_share(f8 haste) {
    return f8_pick(haste > f8_all(1.0f), f8_all(GAP_SHARE), f8_all(GAP_SHARE_TORN));
}

/* A limit or a gear bears a load L at rest by a bias of LOST / (1 - LOST) K L, where K is 1 / the
 * mass that the row feels. Its bias may be twice that on top of what gaps close at. */
#define LOAD_BIAS (IMPULSE_SCALE / (1.0f - IMPULSE_SCALE))

TD_INLINE f8 max_bias(float closing, f8 k, f8 impulse) {
    return f8_all(TD_JOINT_HASTE * closing) + f8_all(LOAD_BIAS) * k * f8_abs(impulse);
}

/* Adding and taking away 1.5 * 2^23 rounds to whole numbers. */
#define ROUNDING 12582912.0f
#define TURN_MAX 1e5f /* rad in a step: whoever turns so much is anywhere */

/* Cosine and sine of a turn within a step; good to the last bits up to a radian or so, and never
 * far from 1 at most. */
TD_INLINE void cosine_and_sine(f8 x, f8 *c, f8 *s) {
    f8 turns = f8_clamp(x, f8_all(-TURN_MAX), f8_all(TURN_MAX));
    f8 whole = turns * f8_all((float)(0.5 / TD_PI)) + f8_all(ROUNDING) - f8_all(ROUNDING);
    x = turns - whole * f8_all((float)(2.0 * TD_PI));
    f8 xx = x * x;
    *s = x + x * xx * (TD_SIN3 + xx * (TD_SIN5 + xx * (TD_SIN7 + xx * TD_SIN9)));
    *c = f8_all(1.0f) + xx * (TD_COS2 + xx * (TD_COS4 + xx * (TD_COS6 + xx * TD_COS8)));
}

/* A joint's frame u, v = (-u.y, u.x), as it stands now. */
typedef struct frame8 {
    f8 x, y;               /* u */
    f8 a_u, a_v, b_u, b_v; /* arms x u, arms x v, so that arm . u = a_v and arm . v = -a_u */
    f8 gap_u, gap_v;       /* from a's anchor to b's */
} frame8;

/* Arms that turned with their body, against a frame that did not: *u, *v are the arms' crosses. */
TD_INLINE void rotate_arms(f8 angle, f8 *u, f8 *v) {
    f8 c, s, x = *u, y = *v;
    cosine_and_sine(angle, &c, &s);
    *u = c * x - s * y;
    *v = c * y + s * x;
}

/* From the frame at the start of the step and the motion since. Where `turns` is 1, the frame turns
 * with a, whose arm then ends at b's anchor. */
TD_INLINE frame8 frame_now(const td_block *block, const sides *d, bool fixed, f8 gap_u, f8 gap_v,
                           f8 turns) {
    const td_point *p = &block->point[0], *q = &block->point[1];
    frame8 f = {block->nx, block->ny, p->cross_a, q->cross_a, p->cross_b, q->cross_b, gap_u, gap_v};
    rotate_arms(d->b.z, &f.b_u, &f.b_v);
    f.gap_u += centres_along(d, fixed, f.x, f.y) + (f.b_v - q->cross_b);
    f.gap_v += centres_along(d, fixed, -f.y, f.x) - (f.b_u - p->cross_b);
    if (fixed) {
        return f;
    }
    rotate_arms(d->a.z, &f.a_u, &f.a_v);
    f.gap_u -= f.a_v - q->cross_a;
    f.gap_v += f.a_u - p->cross_a;
    /* a x u = -(a . v), a x v = a . u */
    f8 c, s, one = f8_all(1.0f);
    cosine_and_sine(d->a.z, &c, &s);
    c = one + turns * (c - one);
    s = turns * s;
    f8 a_u = f.a_u - turns * f.gap_v, a_v = f.a_v + turns * f.gap_u;
    f.a_u = c * a_u + s * a_v;
    f.a_v = c * a_v - s * a_u;
    f8 b_u = f.b_u, b_v = f.b_v, x = f.x, y = f.y, u = f.gap_u, v = f.gap_v;
    f.b_u = c * b_u + s * b_v;
    f.b_v = c * b_v - s * b_u;
    f.gap_u = c * u + s * v;
    f.gap_v = c * v - s * u;
    f.x = c * x - s * y;
    f.y = c * y + s * x;
    return f;
}

/* The same with u along the gap, whose length *length gets. */
TD_INLINE frame8 line_now(const td_block *block, const sides *d, bool fixed, f8 gap_u, f8 gap_v,
                          f8 *length) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    frame8 f = frame_now(block, d, fixed, gap_u, gap_v, zero);
    *length = f8_sqrt(f.gap_u * f.gap_u + f.gap_v * f.gap_v);
    /* Where both ends meet any direction will do. */
    i8 apart = *length > zero;
    f8 divisor = f8_pick(apart, *length, one);
    f8 c = f8_pick(apart, f.gap_u / divisor, one), s = f8_keep(apart, f.gap_v / divisor);
    f8 x = f.x, y = f.y;
    f.x = c * x - s * y;
    f.y = c * y + s * x;
    f.a_u = c * f.a_u + s * f.a_v;
    f.b_u = c * f.b_u + s * f.b_v;
    return f;
}

/* Speed of b past a in a direction. */
TD_INLINE f8 speed_now(const sides *v, bool fixed, f8 x, f8 y, f8 cross_a, f8 cross_b) {
    return at_arms(centres_along(v, fixed, x, y), v, fixed, cross_a, cross_b);
}

/* What one unit of impulse along one direction of a frame gives in another one's speed; `linear`
 * is the product of both directions. */
TD_INLINE f8 inverse_mass_entry(const td_block *block, const sides *v, bool fixed, f8 linear, f8 from_a,
                   f8 from_b, f8 to_a, f8 to_b) {
    f8 mass = fixed ? v->b.w : v->a.w + v->b.w;
    return mass * linear + coupling(block, fixed, from_a, from_b, to_a, to_b);
}

/* Gives both sides an impulse, and its moments. */
TD_INLINE void apply_impulse(const td_block *block, bool fixed, sides *v, td_applied_impulse *applied, f8 x,
                    f8 y, f8 moment_a, f8 moment_b) {
    applied->x += x;
    applied->y += y;
    applied->moment_a += moment_a;
    applied->moment_b += moment_b;
    if (!fixed) {
        v->a.x -= v->a.w * x;
        v->a.y -= v->a.w * y;
        v->a.z -= block->inv_inertia_a * moment_a;
    }
    v->b.x += v->b.w * x;
    v->b.y += v->b.w * y;
    v->b.z += block->inv_inertia_b * moment_b;
}

/* Gives both sides these instead of what they were given. */
TD_INLINE void replace_impulse(const td_block *block, bool fixed, sides *v, td_applied_impulse *applied,
                         f8 x, f8 y, f8 moment_a, f8 moment_b) {
    apply_impulse(block, fixed, v, applied, x - applied->x, y - applied->y, moment_a - applied->moment_a,
         moment_b - applied->moment_b);
}

TD_INLINE void write_sides(const td_solve_context *c, const td_block *block, bool fixed,
                           const sides *v) {
    if (!fixed) {
        td_scatter(c->velocity, block->a, v->a);
    }
    td_scatter(c->velocity, block->b, v->b);
}

TD_INLINE void clear_applied(td_applied_impulse *applied) {
    f8 zero = f8_all(0.0f);
    *applied = (td_applied_impulse){zero, zero, zero, zero};
}

/* wide_rod.c: a pass of bracing over what lanes of any kind were given. Where it measures, the
 * totals of their points get the power before and after; the first one has the share that is kept.
 */
typedef void td_brace_fn(td_block *block, const td_solve_context *c, bool fixed);
td_brace_fn TD_WIDE(td_brace_applied);

/* Tells whether gaps at the start of the step are beyond what a bias may close. */
TD_INLINE void flag_torn(const td_solve_context *c, f8 gap, f8 turn) {
    f8 rate = f8_all(GAP_SHARE * c->inv_h);
    i8 torn = (f8_abs(gap) * rate > f8_all(c->joint_closing)) |
              (f8_abs(turn) * rate > f8_all(TD_JOINT_CLOSING));
    if (i8_bits(torn)) {
        atomic_store_explicit(c->torn, true, memory_order_relaxed);
    }
}

/* 1 / x, and 0 for 0. */
TD_INLINE f8 inverse_or_zero(f8 x) {
    i8 acts = x > f8_all(0.0f);
    return f8_keep(acts, f8_all(1.0f) / f8_pick(acts, x, f8_all(1.0f)));
}

#endif
