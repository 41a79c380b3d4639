/* wide_joint.h: functions that the soft solver's passes over joints share: frames of eight joints
 * in a substep, the softness of their rows, and the application of impulses.
 *
 * Soft constraints with substeps as for contacts (solver/wide_solve.h; E. Catto, "Soft
 * Constraints", 2011, and Box2D's joints): a solve pass with bias, positions, a relax pass without
 * bias. Lever arms and axes are rotated with their bodies in each substep. With those of the start
 * of the step, the gap of a hinge on a swinging body would grow in proportion to the square of its
 * rotation in the step. The velocities already contain the impulses of the last substep (motion.h),
 * along the directions of that substep: a pass removes them and applies them along the present
 * directions (replace_impulse).
 *
 * In a substep of length h, a row with effective mass m, gap C and speed v changes its impulse p in
 * a solve pass by
 *     -mass_scale m (v + bias) - impulse_scale p,  bias = clamp(TD_JOINT_GAP_SHARE C / h),
 * and in a relax pass by -m v. The scales follow from TD_JOINT_PHASE (IMPULSE_SCALE below). The
 * bias is clamped to a maximum closing speed. */
#ifndef TD_WIDE_JOINT_H
#define TD_WIDE_JOINT_H

#include "base/rotation.h"
#include "solver/wide_solve.h"

/* The scales of a soft constraint with the phase TD_JOINT_PHASE = omega h in a substep, at damping
 * ratio 1 (block.h): the share TD_JOINT_GAP_SHARE = 1/2 of a gap closes in a substep, and an
 * impulse loses the share IMPULSE_SCALE = 1/9; the mass scale is 1 - IMPULSE_SCALE. */
#define IMPULSE_SCALE (1.0f / (1.0f + TD_JOINT_PHASE * (2.0f + TD_JOINT_PHASE)))

/* The share of a gap that closes in a substep in braced groups, which would add energy
 * (closing_factor <= 1, joint_brace.c). A low-frequency mode of many rows, each of which moves
 * little, oscillates with growing amplitude unless
 *     IMPULSE_SCALE (1 + s) > s g
 * for the mass scale s = 1 - IMPULSE_SCALE and the share g: both passes of a substep must reduce an
 * impulse by more than its gap increases it. The value is the g of equality, less 5 %: 0.22. */
#define GAP_SHARE_BRACED (0.95f * IMPULSE_SCALE * (2.0f - IMPULSE_SCALE) / (1.0f - IMPULSE_SCALE))

/* The share of a gap that closes in a substep. */
TD_INLINE f8 gap_share(f8 closing_factor) {
    return f8_pick(closing_factor > f8_all(1.0f), f8_all(TD_JOINT_GAP_SHARE),
                   f8_all(GAP_SHARE_BRACED));
}

/* A row in a solve pass loses the share IMPULSE_SCALE of its impulse. If it carries a load at rest
 * that needs the impulse L in each substep, it settles at the gap at which its bias restores just
 * this loss: the bias is then LOAD_BIAS K L, where K is the inverse of its effective mass. */
#define LOAD_BIAS (IMPULSE_SCALE / (1.0f - IMPULSE_SCALE))

/* Maximum bias of a joint's limit or of a gear, a speed: the bias that its present impulse needs
 * (LOAD_BIAS), plus TD_JOINT_CLOSING_FACTOR times `closing`, so that it can carry any load. */
TD_INLINE f8 max_bias(float closing, f8 k, f8 impulse) {
    return f8_all(TD_JOINT_CLOSING_FACTOR * closing) + f8_all(LOAD_BIAS) * k * f8_abs(impulse);
}

/* Adding and then subtracting 1.5 * 2^23 rounds a float to a whole number. */
#define ROUNDING_SHIFT 12582912.0f
/* Rotations in a step are clamped to this, rad. A float of this size has a rounding error of 0.004
 * rad, and its number of whole turns can still be rounded by ROUNDING_SHIFT. */
#define STEP_TURN_MAX 1e5f

/* Cosine and sine of a rotation within a step, by their Taylor polynomials of degree 8 and 9:
 * errors are below 3e-7 up to a radian, 0.024 and 0.007 at half a turn. */
TD_INLINE void cosine_and_sine(f8 x, f8 *c, f8 *s) {
    f8 turns = f8_clamp(x, f8_all(-STEP_TURN_MAX), f8_all(STEP_TURN_MAX));
    f8 whole =
        turns * f8_all((float)(0.5 / TD_PI)) + f8_all(ROUNDING_SHIFT) - f8_all(ROUNDING_SHIFT);
    x = turns - whole * f8_all((float)(2.0 * TD_PI));
    f8 xx = x * x;
    *s = x + x * xx * (TD_SIN3 + xx * (TD_SIN5 + xx * (TD_SIN7 + xx * TD_SIN9)));
    *c = f8_all(1.0f) + xx * (TD_COS2 + xx * (TD_COS4 + xx * (TD_COS6 + xx * TD_COS8)));
}

/* The frames u, v = (-u.y, u.x) of eight joints in the present substep. */
typedef struct frame8 {
    f8 x, y;               /* u */
    f8 a_u, a_v, b_u, b_v; /* lever arms of a and b crossed with u and v: arm . u = a_v, and
                              arm . v = -a_u */
    f8 gap_u, gap_v;       /* from a's anchor to b's, along u and v */
} frame8;

/* Rotates lever arms relative to a frame that does not turn; *u, *v are their cross products with u
 * and v. */
TD_INLINE void rotate_arms(f8 angle, f8 *u, f8 *v) {
    f8 c, s, x = *u, y = *v;
    cosine_and_sine(angle, &c, &s);
    *u = c * x - s * y;
    *v = c * y + s * x;
}

/* The present frames, from those at the start of the step (block->nx, ny, the cross products of its
 * points, gap_u and gap_v) and the motions d since. If `turns` is 1, the frame turns with a, whose
 * lever arm then ends at b's anchor; if 0, u and v do not change. `a_static`: side a is static. */
TD_INLINE frame8 frame_now(const td_block *block, const sides *d, bool a_static, f8 gap_u, f8 gap_v,
                           f8 turns) {
    const td_point *p = &block->point[0], *q = &block->point[1];
    frame8 f = {block->nx, block->ny, p->cross_a, q->cross_a, p->cross_b, q->cross_b, gap_u, gap_v};
    rotate_arms(d->b.z, &f.b_u, &f.b_v);
    f.gap_u += centres_along(d, a_static, f.x, f.y) + (f.b_v - q->cross_b);
    f.gap_v += centres_along(d, a_static, -f.y, f.x) - (f.b_u - p->cross_b);
    if (a_static) {
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

/* frame_now for a rod or a line drive, whose axis u points along the gap. *length: the length of
 * the gap. gap_u, gap_v and the cross products with v are not set. */
TD_INLINE frame8 line_now(const td_block *block, const sides *d, bool a_static, f8 gap_u, f8 gap_v,
                          f8 *length) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    frame8 f = frame_now(block, d, a_static, gap_u, gap_v, zero);
    *length = f8_sqrt(f.gap_u * f.gap_u + f.gap_v * f.gap_v);
    /* If the anchors coincide, u does not change: any direction is valid. */
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

/* Speed of b's anchor relative to a's along (x, y). */
TD_INLINE f8 speed_now(const sides *v, bool a_static, f8 x, f8 y, f8 cross_a, f8 cross_b) {
    return at_arms(centres_along(v, a_static, x, y), v, a_static, cross_a, cross_b);
}

/* An entry of K = J M^-1 J': the speed along one direction that a unit of impulse along another one
 * causes. `linear`: the dot product of the two directions. */
TD_INLINE f8 inverse_mass_entry(const td_block *block, const sides *v, bool a_static, f8 linear,
                                f8 from_a, f8 from_b, f8 to_a, f8 to_b) {
    f8 mass = a_static ? v->b.w : v->a.w + v->b.w;
    return mass * linear + coupling(block, a_static, from_a, from_b, to_a, to_b);
}

/* Applies an impulse (x, y) and its moments to the velocities of both sides, and adds it to the
 * record of the joint's impulses in this substep (`applied`). */
TD_INLINE void apply_impulse(const td_block *block, bool a_static, sides *v,
                             td_applied_impulse *applied, f8 x, f8 y, f8 moment_a, f8 moment_b) {
    applied->x += x;
    applied->y += y;
    applied->moment_a += moment_a;
    applied->moment_b += moment_b;
    if (!a_static) {
        v->a.x -= v->a.w * x;
        v->a.y -= v->a.w * y;
        v->a.z -= block->inv_inertia_a * moment_a;
    }
    v->b.x += v->b.w * x;
    v->b.y += v->b.w * y;
    v->b.z += block->inv_inertia_b * moment_b;
}

/* Replaces the impulse that the joint has applied in this substep by this one: applies the
 * difference. */
TD_INLINE void replace_impulse(const td_block *block, bool a_static, sides *v,
                               td_applied_impulse *applied, f8 x, f8 y, f8 moment_a, f8 moment_b) {
    apply_impulse(block, a_static, v, applied, x - applied->x, y - applied->y,
                  moment_a - applied->moment_a, moment_b - applied->moment_b);
}

/* Writes the velocities of both sides back. */
TD_INLINE void write_sides(const td_solve_context *c, const td_block *block, bool a_static,
                           const sides *v) {
    if (!a_static) {
        td_scatter(c->velocity, block->a, v->a);
    }
    td_scatter(c->velocity, block->b, v->b);
}

TD_INLINE void clear_applied(td_applied_impulse *applied) {
    f8 zero = f8_all(0.0f);
    *applied = (td_applied_impulse){zero, zero, zero, zero};
}

/* wide_rod.c: a stage of bracing (joint_brace.c), selected by c->brace, on the impulses that the
 * lanes of a block of rods or locks applied: measures p.u or p.u' into td_brace_rows, removes the
 * impulses, or applies the share to keep. */
typedef void td_brace_fn(td_block *block, const td_solve_context *c, bool a_static);
td_brace_fn TD_WIDE(td_brace_applied);

/* Sets c->torn, so that the step braces its joints (joint_brace.c), if a gap (`gap`, a length, or
 * `turn`, rad) at the start of the step is so wide that its bias would close it faster than
 * TD_JOINT_CLOSING_SPEED. */
TD_INLINE void flag_torn(const td_solve_context *c, f8 gap, f8 turn) {
    f8 rate = f8_all(TD_JOINT_GAP_SHARE * c->inv_h);
    i8 torn = (f8_abs(gap) * rate > f8_all(c->joint_closing_speed)) |
              (f8_abs(turn) * rate > f8_all(TD_JOINT_CLOSING_SPEED));
    if (i8_bits(torn)) {
        atomic_store_explicit(c->torn, true, memory_order_relaxed);
    }
}

/* 1 / x; 0 where x <= 0. */
TD_INLINE f8 inverse_or_zero(f8 x) {
    i8 acts = x > f8_all(0.0f);
    return f8_keep(acts, f8_all(1.0f) / f8_pick(acts, x, f8_all(1.0f)));
}

#endif
