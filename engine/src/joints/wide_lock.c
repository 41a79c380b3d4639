/* wide_lock.c: solver passes for the locked directions of a joint (along u, across v, turn). The up
 * to three rows are solved at once as one block (lock_matrix_of). Impulses are those of point[0],
 * of point[1], and of the tangent. */
#include "joints/wide_joint.h"

/* The scales of a pass (wide_joint.h): those of a soft constraint in a solve pass; no bias, and a
 * mass scale of 1, in a relax pass. inv_h: substeps per second. closing: TD_JOINT_CLOSING_SPEED in
 * lengths/s. */
typedef struct softness {
    f8 inv_h, mass_scale, impulse_scale, closing;
} softness;

TD_INLINE softness soft_of(const td_solve_context *c) {
    return (softness){f8_all(c->inv_h), f8_all(1.0f - IMPULSE_SCALE), f8_all(IMPULSE_SCALE),
                      f8_all(c->joint_closing_speed)};
}

TD_INLINE softness rigid(void) {
    f8 zero = f8_all(0.0f);
    return (softness){zero, f8_all(1.0f), zero, zero};
}

/* The speed at which a gap is closed (the bias): the gap times `rate` (1/s), clamped to `max`. */
TD_INLINE f8 bias_of(f8 gap, f8 rate, f8 max) {
    return f8_clamp(gap * rate, -max, max);
}

/* K = J M^-1 J' of a lane's rows u, v and turn (t), with t eliminated (Schur complement). */
typedef struct lock_matrix {
    i8 has_u, has_v, has_turn; /* masks: which rows the lane has */
    f8 turn, lever_u, lever_v; /* K_tt; K_ut / K_tt, K_vt / K_tt */
    f8 uu, uv, vv, det;        /* K_uu - K_ut^2 / K_tt and so on, and their determinant */
} lock_matrix;

/* All rows of a lane are solved at once, since Gauss-Seidel over the single rows converges slowly
 * where lever arms are long, that is, where mass times arm^2 is large beside the moment of inertia.
 * With the inverse moments of inertia i_a and i_b, m the sum of inverse masses, a and b the lever
 * arms, d = b - a, and d_u = d x u as arms are crossed with directions, these formulas give the
 * Schur complement without subtractions, which would cancel digits in single precision:
 *     turn locked:  K_uu - K_ut^2 / K_tt = m + i_a i_b / (i_a + i_b) d_u^2
 *                   det = m^2 + m i_a i_b / (i_a + i_b) |d|^2
 *     turn free:    det = m^2 + m (i_a |a|^2 + i_b |b|^2) + i_a i_b (a x b)^2
 * Rows that a lane does not have are decoupled, with 1 on the diagonal. */
TD_INLINE lock_matrix lock_matrix_of(const td_block *block, const sides *v, bool a_static,
                                     const frame8 *f) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    lock_matrix k = {.has_u = block->point[0].normal_mass > zero,
                     .has_v = block->point[1].normal_mass > zero,
                     .has_turn = block->tangent_mass > zero};
    f8 m = a_static ? v->b.w : v->a.w + v->b.w, i_b = block->inv_inertia_b;
    f8 i_a = a_static ? zero : block->inv_inertia_a;
    k.turn = f8_pick(k.has_turn, i_a + i_b, one);
    f8 per_turn = f8_keep(k.has_turn, one / k.turn);
    k.lever_u = per_turn * (i_a * f->a_u + i_b * f->b_u);
    k.lever_v = per_turn * (i_a * f->a_v + i_b * f->b_v);
    f8 d_u = f->b_u - f->a_u, d_v = f->b_v - f->a_v, both = i_a * i_b, pair = both * per_turn;
    f8 cross = f->a_u * f->b_v - f->a_v * f->b_u;
    f8 uu = f8_pick(k.has_turn, pair * d_u * d_u, i_a * f->a_u * f->a_u + i_b * f->b_u * f->b_u);
    f8 vv = f8_pick(k.has_turn, pair * d_v * d_v, i_a * f->a_v * f->a_v + i_b * f->b_v * f->b_v);
    f8 uv = f8_pick(k.has_turn, pair * d_u * d_v, i_a * f->a_u * f->a_v + i_b * f->b_u * f->b_v);
    f8 det = m * (m + uu + vv) + f8_pick(k.has_turn, zero, both * cross * cross);
    i8 point = k.has_u & k.has_v;
    k.uu = f8_pick(k.has_u, m + uu, one);
    k.vv = f8_pick(k.has_v, m + vv, one);
    k.uv = f8_keep(point, uv);
    k.det = f8_pick(point, det, k.uu * k.vv);
    return k;
}

/* Solves K x = -(speeds + bias) for a block, and applies the change of the impulses:
 *     x_u, x_v by Cramer's rule, x_t = -turn / K_tt - lever_u x_u - lever_v x_v.
 * `replace`: first replaces the old impulses, which the velocities contain along the directions of
 * the last substep, by the same impulses along the present directions. In the last relax pass the
 * greatest speeds along u and v go to the tally, with a minus sign. */
TD_INLINE void solve_lock(td_block *block, const softness *s, const td_solve_context *c,
                          bool a_static, bool replace) {
    td_point *p = &block->point[0], *q = &block->point[1];
    td_lock_rows *h = td_lock_rows_of(block);
    sides v = read_sides(c->velocity, block, a_static), d = read_sides(c->delta, block, a_static);
    frame8 f =
        frame_now(block, &d, a_static, p->start_separation, q->start_separation, h->frame_turns);
    lock_matrix k = lock_matrix_of(block, &v, a_static, &f);
    h->turn_gap = h->start_turn_gap + h->turn_sign * (a_static ? d.b.z : d.b.z - d.a.z);
    p->separation = f8_keep(k.has_u, f.gap_u);
    q->separation = f8_keep(k.has_v, f.gap_v);
    f8 old_u = p->normal_impulse, old_v = q->normal_impulse;
    f8 old_turn = h->turn_sign * block->tangent_impulse;

    if (replace) {
        replace_impulse(block, a_static, &v, &h->applied, f.x * old_u - f.y * old_v,
                        f.y * old_u + f.x * old_v, old_turn + f.a_u * old_u + f.a_v * old_v,
                        old_turn + f.b_u * old_u + f.b_v * old_v);
    }
    f8 speed_u = speed_now(&v, a_static, f.x, f.y, f.a_u, f.b_u);
    f8 speed_v = speed_now(&v, a_static, -f.y, f.x, f.a_v, f.b_v);
    f8 spin = a_static ? v.b.z : v.b.z - v.a.z;
    f8 rate = gap_share(h->closing_factor) * s->inv_h;
    f8 max = h->closing_factor * s->closing,
       turn_max = h->closing_factor * f8_all(TD_JOINT_CLOSING_SPEED);
    f8 turn = f8_keep(k.has_turn, spin + h->turn_sign * bias_of(h->turn_gap, rate, turn_max));
    f8 rhs_u = speed_u + bias_of(p->separation, rate, max) - k.lever_u * turn;
    f8 rhs_v = speed_v + bias_of(q->separation, rate, max) - k.lever_v * turn;
    rhs_u = f8_keep(k.has_u, rhs_u);
    rhs_v = f8_keep(k.has_v, rhs_v);
    f8 per_det = inverse_or_zero(k.det);
    f8 x_u = per_det * (k.uv * rhs_v - k.vv * rhs_u);
    f8 x_v = per_det * (k.uv * rhs_u - k.uu * rhs_v);
    f8 x_turn = f8_keep(k.has_turn, -turn / k.turn - k.lever_u * x_u - k.lever_v * x_v);
    f8 change_u = s->mass_scale * x_u - s->impulse_scale * old_u;
    f8 change_v = s->mass_scale * x_v - s->impulse_scale * old_v;
    f8 change_turn = s->mass_scale * x_turn - s->impulse_scale * old_turn;
    p->normal_impulse = old_u + change_u;
    q->normal_impulse = old_v + change_v;
    block->tangent_impulse = h->turn_sign * (old_turn + change_turn);
    apply_impulse(block, a_static, &v, &h->applied, f.x * change_u - f.y * change_v,
                  f.y * change_u + f.x * change_v,
                  change_turn + f.a_u * change_u + f.a_v * change_v,
                  change_turn + f.b_u * change_u + f.b_v * change_v);
    write_sides(c, block, a_static, &v);
    if (c->last) {
        f8 min_speed =
            f8_min(f8_keep(k.has_u, -f8_abs(speed_u)), f8_keep(k.has_v, -f8_abs(speed_v)));
        c->tally->min_speed = f8_min(min_speed, c->tally->min_speed);
    }
}

/* Applies the impulses of the last step, and sets c->torn if a gap is so wide that the step braces
 * its joints (flag_torn). */
TD_INLINE void warm_start(td_block *const *blocks, int count, const td_solve_context *c,
                          bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        const td_point *p = &block->point[0], *q = &block->point[1];
        f8 u = p->normal_impulse, v = q->normal_impulse, x = block->nx, y = block->ny;
        f8 moment = td_lock_rows_of(block)->turn_sign * block->tangent_impulse;
        /* In a frame that turns with a, a's arm ends at b's anchor: a_u - gap_v, a_v + gap_u. */
        f8 turns = td_lock_rows_of(block)->frame_turns;
        td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
        f8 a_u = p->cross_a - turns * q->start_separation,
           a_v = q->cross_a + turns * p->start_separation;
        sides s = read_sides(c->velocity, block, a_static);
        f8 gap = f8_max(f8_abs(p->separation), f8_abs(q->separation)), zero = f8_all(0.0f);
        flag_torn(c, gap,
                  f8_keep(block->tangent_mass > zero, td_lock_rows_of(block)->start_turn_gap));
        clear_applied(applied);
        apply_impulse(block, a_static, &s, applied, x * u - y * v, y * u + x * v,
                      moment + a_u * u + a_v * v, moment + p->cross_b * u + q->cross_b * v);
        write_sides(c, block, a_static, &s);
    }
}

/* Whether the passes skip blocks whose lanes were all solved before the soft solver, in islands
 * that are trees (td_block.solved). Steps that brace their joints (joint_brace.c) skip none, since
 * bracing reads the impulses that these passes leave in all blocks. */
TD_INLINE bool skips_solved_blocks(const td_solve_context *c) {
    return c->passes_over && !atomic_load_explicit(c->torn, memory_order_relaxed);
}

TD_INLINE bool is_solved(const td_block *block) {
    return block->solved == (1u << block->used) - 1u;
}

TD_INLINE void solve(td_block *const *blocks, int count, const td_solve_context *c, bool a_static) {
    softness s = soft_of(c);
    bool over = skips_solved_blocks(c);
    for (int i = 0; i < count; i++) {
        if (!over || !is_solved(blocks[i])) {
            solve_lock(blocks[i], &s, c, a_static, !c->first);
        }
    }
}

TD_INLINE void relax(td_block *const *blocks, int count, const td_solve_context *c, bool a_static) {
    softness s = rigid();
    bool over = skips_solved_blocks(c);
    for (int i = 0; i < count; i++) {
        if (!over || !is_solved(blocks[i])) {
            solve_lock(blocks[i], &s, c, a_static, false);
        }
    }
}

/* A stage of bracing, joint_brace.c. TD_BRACE_WARM_START applies the warm start along the
 * directions of the present substep. */
TD_INLINE void brace(td_block *const *blocks, int count, const td_solve_context *c, bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        if (c->brace != TD_BRACE_WARM_START) {
            TD_WIDE(td_brace_applied)(block, c, a_static);
            continue;
        }
        if (td_brace_rows_of(block)->torn == 0.0f) {
            continue;
        }
        td_point *p = &block->point[0], *q = &block->point[1];
        td_lock_rows *h = td_lock_rows_of(block);
        sides v = read_sides(c->velocity, block, a_static),
              d = read_sides(c->delta, block, a_static);
        frame8 f = frame_now(block, &d, a_static, p->start_separation, q->start_separation,
                             h->frame_turns);
        f8 u = p->normal_impulse, w = q->normal_impulse;
        f8 turn = h->turn_sign * block->tangent_impulse;
        replace_impulse(block, a_static, &v, &h->applied, f.x * u - f.y * w, f.y * u + f.x * w,
                        turn + f.a_u * u + f.a_v * w, turn + f.b_u * u + f.b_v * w);
        write_sides(c, block, a_static, &v);
    }
}

TD_PASS(warm_start_moving, warm_start, false)
TD_PASS(warm_start_static, warm_start, true)
TD_PASS(solve_moving, solve, false)
TD_PASS(solve_static, solve, true)
TD_PASS(relax_moving, relax, false)
TD_PASS(relax_static, relax, true)
TD_PASS(brace_moving, brace, false)
TD_PASS(brace_static, brace, true)

extern const td_solve_ops TD_WIDE(td_solve_lock);
const td_solve_ops TD_WIDE(td_solve_lock) = {.warm_start = {warm_start_moving, warm_start_static},
                                             .solve = {solve_moving, solve_static},
                                             .relax = {relax_moving, relax_static},
                                             .brace = {brace_moving, brace_static}};
