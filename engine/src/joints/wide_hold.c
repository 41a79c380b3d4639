/* wide_hold.c: solver passes for the locked directions of joints: `turn` first, then `along` and
 * `across` together. */
#include "joints/wide_joint.h"

/* What a pass does with the gaps. */
typedef struct softness {
    f8 bias_rate, mass_scale, impulse_scale, most, turn_most;
} softness;

/* The same of its turn, rad/s. */
#define TURN_MOST 300.0f

TD_INLINE softness soft_of(const td_solve_context *c) {
    return (softness){f8_all(PULL * c->inv_h), f8_all(1.0f - LOST), f8_all(LOST),
                      f8_all(HASTE * c->push_speed), f8_all(TURN_MOST)};
}

TD_INLINE softness rigid(void) {
    f8 zero = f8_all(0.0f);
    return (softness){zero, f8_all(1.0f), zero, zero, zero};
}

TD_INLINE f8 bias_of(f8 gap, const softness *s, f8 most) {
    return f8_clamp(gap * s->bias_rate, -most, most);
}

/* The change of the impulse about `turn`. */
TD_INLINE f8 hold_turn(td_block *block, const softness *s, bool fixed, const sides *v, f8 turn_sign,
                       f8 gap) {
    f8 speed = turn_sign * (fixed ? v->b.z : v->b.z - v->a.z);
    f8 old = block->tangent_impulse;
    f8 now = old - s->mass_scale * block->tangent_mass * (speed + bias_of(gap, s, s->turn_most)) -
             s->impulse_scale * old;
    now = f8_keep(block->tangent_mass > f8_all(0.0f), now);
    block->tangent_impulse = now;
    return now - old;
}

TD_INLINE void hold_block(td_block *block, const softness *s, const td_solve_context *c, bool fixed,
                          bool anew) {
    td_point *p = &block->point[0], *q = &block->point[1];
    td_hold_rows *h = td_hold_rows_of(block);
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    sides v = read_sides(c->velocity, block, fixed), d = read_sides(c->delta, block, fixed);
    frame8 f = frame_now(block, &d, fixed, p->base, q->base, h->frame);
    h->turn_apart = h->turn_base + h->turn_sign * (fixed ? d.b.z : d.b.z - d.a.z);
    i8 has_u = p->normal_mass > zero, has_v = q->normal_mass > zero;
    p->separation = f8_keep(has_u, f.gap_u);
    q->separation = f8_keep(has_v, f.gap_v);

    if (anew) {
        f8 u = p->normal_impulse, w = q->normal_impulse;
        f8 turn = h->turn_sign * block->tangent_impulse;
        give_anew(block, fixed, &v, &h->given, f.x * u - f.y * w, f.y * u + f.x * w,
                  turn + f.a_u * u + f.a_v * w, turn + f.b_u * u + f.b_v * w);
    }
    f8 moment = h->turn_sign * hold_turn(block, s, fixed, &v, h->turn_sign, h->turn_apart);
    give(block, fixed, &v, &h->given, zero, zero, moment, moment);

    f8 speed_u = speed_now(&v, fixed, f.x, f.y, f.a_u, f.b_u);
    f8 speed_v = speed_now(&v, fixed, -f.y, f.x, f.a_v, f.b_v);
    f8 k_uu = yield(block, &v, fixed, one, f.a_u, f.b_u, f.a_u, f.b_u);
    f8 k_vv = yield(block, &v, fixed, one, f.a_v, f.b_v, f.a_v, f.b_v);
    f8 k_uv = f8_keep(has_u & has_v, yield(block, &v, fixed, zero, f.a_u, f.b_u, f.a_v, f.b_v));
    f8 want_u = f8_keep(has_u, speed_u + bias_of(p->separation, s, s->most));
    f8 want_v = f8_keep(has_v, speed_v + bias_of(q->separation, s, s->most));
    f8 scale = s->mass_scale * inverse_or_zero(k_uu * k_vv - k_uv * k_uv);
    f8 old_u = p->normal_impulse, old_v = q->normal_impulse;
    f8 change_u =
        f8_keep(has_u, scale * (k_uv * want_v - k_vv * want_u) - s->impulse_scale * old_u);
    f8 change_v =
        f8_keep(has_v, scale * (k_uv * want_u - k_uu * want_v) - s->impulse_scale * old_v);
    p->normal_impulse = old_u + change_u;
    q->normal_impulse = old_v + change_v;
    give(block, fixed, &v, &h->given, f.x * change_u - f.y * change_v,
         f.y * change_u + f.x * change_v, f.a_u * change_u + f.a_v * change_v,
         f.b_u * change_u + f.b_v * change_v);
    write_sides(c, block, fixed, &v);
    if (c->last) {
        f8 slowest = f8_min(f8_keep(has_u, -f8_abs(speed_u)), f8_keep(has_v, -f8_abs(speed_v)));
        c->tally->slowest = f8_min(slowest, c->tally->slowest);
    }
}

TD_INLINE void warm_start(td_block *const *blocks, int count, const td_solve_context *c,
                          bool fixed) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        const td_point *p = &block->point[0], *q = &block->point[1];
        f8 u = p->normal_impulse, v = q->normal_impulse, x = block->nx, y = block->ny;
        f8 moment = td_hold_rows_of(block)->turn_sign * block->tangent_impulse;
        /* The lever of a frame that turns with a ends at b's anchor. */
        f8 turns = td_hold_rows_of(block)->frame;
        td_given *given = &td_hold_rows_of(block)->given;
        f8 a_u = p->cross_a - turns * q->base, a_v = q->cross_a + turns * p->base;
        sides s = read_sides(c->velocity, block, fixed);
        forget_given(given);
        give(block, fixed, &s, given, x * u - y * v, y * u + x * v, moment + a_u * u + a_v * v,
             moment + p->cross_b * u + q->cross_b * v);
        write_sides(c, block, fixed, &s);
    }
}

TD_INLINE void pull(td_block *const *blocks, int count, const td_solve_context *c, bool fixed) {
    softness s = soft_of(c);
    for (int i = 0; i < count; i++) {
        hold_block(blocks[i], &s, c, fixed, !c->first);
    }
}

TD_INLINE void ease(td_block *const *blocks, int count, const td_solve_context *c, bool fixed) {
    softness s = rigid();
    for (int i = 0; i < count; i++) {
        hold_block(blocks[i], &s, c, fixed, false);
    }
}

/* Nothing bounces off a joint. */
static void rest(td_block *const *blocks, int count, const td_solve_context *c) {
    (void)blocks, (void)count, (void)c;
}

TD_PASS(warm_start_moving, warm_start, false)
TD_PASS(warm_start_fixed, warm_start, true)
TD_PASS(pull_moving, pull, false)
TD_PASS(pull_fixed, pull, true)
TD_PASS(ease_moving, ease, false)
TD_PASS(ease_fixed, ease, true)

extern const td_solve_ops TD_WIDE(td_solve_hold);
const td_solve_ops TD_WIDE(td_solve_hold) = {{warm_start_moving, warm_start_fixed},
                                             {pull_moving, pull_fixed},
                                             {ease_moving, ease_fixed},
                                             rest};
