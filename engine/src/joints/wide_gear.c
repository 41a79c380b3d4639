/* wide_gear.c: solver passes for gears: one equality row with
 *     J x = a . x_a + b . x_b
 * for the motions or velocities x = (x, y, turn) of both sides. The vectors
 *     a = (td_gear_rows.a_x, td_gear_rows.a_y, point[0].cross_a)
 *     b = (block->nx, block->ny, point[0].cross_b)
 * are the gradients of the coordinates of the gear's two joints, the second times the ratio
 * (gear.c). They are computed at the start of the step. Neither side is static. */
#include "joints/wide_joint.h"

/* J x, for velocities or motions. */
TD_INLINE f8 row_speed(const td_block *block, const sides *s) {
    const td_gear_rows *r = td_gear_rows_of((td_block *)block);
    const td_point *p = &block->point[0];
    return r->a_x * s->a.x + r->a_y * s->a.y + p->cross_a * s->a.z + block->nx * s->b.x +
           block->ny * s->b.y + p->cross_b * s->b.z;
}

/* Applies an impulse along the row. */
TD_INLINE void apply_row(const td_block *block, sides *v, f8 impulse) {
    const td_gear_rows *r = td_gear_rows_of((td_block *)block);
    const td_point *p = &block->point[0];
    v->a.x += v->a.w * r->a_x * impulse;
    v->a.y += v->a.w * r->a_y * impulse;
    v->a.z += block->inv_inertia_a * p->cross_a * impulse;
    v->b.x += v->b.w * block->nx * impulse;
    v->b.y += v->b.w * block->ny * impulse;
    v->b.z += block->inv_inertia_b * p->cross_b * impulse;
}

/* A solve pass (`soft`) or relax pass. The last relax pass records the greatest |J v| as the
 * residual, negated as in all tallies (solver/tally.h). */
TD_INLINE void solve_gear(td_block *const *blocks, int count, const td_solve_context *c,
                          bool soft) {
    f8 zero = f8_all(0.0f);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_point *p = &block->point[0];
        sides v = read_sides(c->velocity, block, false), d = read_sides(c->delta, block, false);
        p->separation = f8_keep(p->normal_mass > zero, p->start_separation + row_speed(block, &d));
        f8 bias = zero, scale = f8_all(1.0f), impulse_share = zero;
        if (soft) {
            f8 max = max_bias(c->joint_closing_speed, inverse_or_zero(p->normal_mass),
                              p->normal_impulse);
            bias = f8_clamp(p->separation * f8_all(TD_JOINT_GAP_SHARE * c->inv_h), -max, max);
            scale = f8_all(1.0f - IMPULSE_SCALE);
            impulse_share = f8_all(IMPULSE_SCALE);
        }
        f8 speed = row_speed(block, &v), old = p->normal_impulse;
        p->normal_impulse = old - scale * p->normal_mass * (speed + bias) - impulse_share * old;
        apply_row(block, &v, p->normal_impulse - old);
        write_sides(c, block, false, &v);
        if (c->last) {
            f8 min_speed = f8_keep(p->normal_mass > zero, -f8_abs(speed));
            c->tally->min_speed = f8_min(min_speed, c->tally->min_speed);
        }
    }
}

/* Applies the impulses of the last step. */
static void warm_start(td_block *const *blocks, int count, const td_solve_context *c) {
    for (int i = 0; i < count; i++) {
        sides v = read_sides(c->velocity, blocks[i], false);
        apply_row(blocks[i], &v, blocks[i]->point[0].normal_impulse);
        write_sides(c, blocks[i], false, &v);
    }
}

static void solve(td_block *const *blocks, int count, const td_solve_context *c) {
    solve_gear(blocks, count, c, true);
}

static void relax(td_block *const *blocks, int count, const td_solve_context *c) {
    solve_gear(blocks, count, c, false);
}

/* Both entries of a pair are the same, since neither side of a gear is static. */
extern const td_solve_ops TD_WIDE(td_solve_gear);
const td_solve_ops TD_WIDE(td_solve_gear) = {.warm_start = {warm_start, warm_start},
                                             .solve = {solve, solve},
                                             .relax = {relax, relax}};
