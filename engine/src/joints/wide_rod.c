/* wide_rod.c: solver passes for locked distances: one equality row along the line between the
 * anchors as it is in the substep, with gap = distance - length; and the bracing of rods and locks.
 */
#include "joints/wide_joint.h"

/* A solve pass (`soft`) or relax pass over a block. The last relax pass notes the greatest speed as
 * the residual, with a minus sign. */
TD_INLINE void solve_rod(td_block *block, const td_solve_context *c, bool a_static, bool soft) {
    td_point *p = &block->point[0];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), length;
    f8 rest_length = td_lock_rows_of(block)->rest_length;
    sides v = read_sides(c->velocity, block, a_static), d = read_sides(c->delta, block, a_static);
    frame8 f = line_now(block, &d, a_static, p->start_separation + rest_length, zero, &length);
    p->separation = f8_keep(p->normal_mass > zero, length - rest_length);
    td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
    if (soft && !c->first) {
        f8 old = p->normal_impulse;
        replace_impulse(block, a_static, &v, applied, f.x * old, f.y * old, f.a_u * old,
                        f.b_u * old);
    }
    f8 mass =
        inverse_or_zero(inverse_mass_entry(block, &v, a_static, one, f.a_u, f.b_u, f.a_u, f.b_u));
    f8 bias = zero, scale = one, impulse_share = zero;
    if (soft) {
        f8 max = td_lock_rows_of(block)->closing_factor * f8_all(c->joint_closing_speed);
        bias = f8_clamp(p->separation * gap_share(td_lock_rows_of(block)->closing_factor) *
                            f8_all(c->inv_h),
                        -max, max);
        scale = f8_all(1.0f - IMPULSE_SCALE);
        impulse_share = f8_all(IMPULSE_SCALE);
    }
    f8 speed = speed_now(&v, a_static, f.x, f.y, f.a_u, f.b_u), old = p->normal_impulse;
    f8 now = old - scale * mass * (speed + bias) - impulse_share * old;
    p->normal_impulse = now;
    f8 change = now - old;
    apply_impulse(block, a_static, &v, applied, f.x * change, f.y * change, f.a_u * change,
                  f.b_u * change);
    write_sides(c, block, a_static, &v);
    if (c->last) {
        c->tally->slowest = f8_min(f8_keep(mass > zero, -f8_abs(speed)), c->tally->slowest);
    }
}

/* Applies the impulses of the last step, and looks for gaps that make the step brace its joints. */
TD_INLINE void warm_start(td_block *const *blocks, int count, const td_solve_context *c,
                          bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        const td_point *p = &block->point[0];
        f8 impulse = p->normal_impulse;
        td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
        sides v = read_sides(c->velocity, block, a_static);
        flag_torn(c, p->separation, f8_all(0.0f));
        clear_applied(applied);
        apply_impulse(block, a_static, &v, applied, block->nx * impulse, block->ny * impulse,
                      p->cross_a * impulse, p->cross_b * impulse);
        write_sides(c, block, a_static, &v);
    }
}

TD_INLINE void solve(td_block *const *blocks, int count, const td_solve_context *c, bool a_static,
                     bool soft) {
    for (int i = 0; i < count; i++) {
        solve_rod(blocks[i], c, a_static, soft);
    }
}

/* See wide_joint.h. The "powers" are products of the impulses that a lane applied in this substep
 * and the speeds along them, p.u and p.u'. TD_BRACE_KEEP scales both the lane's impulses and the
 * record of what it applied. */
void TD_WIDE(td_brace_applied)(td_block *block, const td_solve_context *c, bool a_static) {
    td_applied_impulse *g = &td_lock_rows_of(block)->applied;
    td_brace_rows *rows = td_brace_rows_of(block);
    sides v = read_sides(c->velocity, block, a_static);
    if (c->brace == TD_BRACE_BEFORE || c->brace == TD_BRACE_AFTER) {
        f8 power = g->x * v.b.x + g->y * v.b.y + g->moment_b * v.b.z;
        if (!a_static) {
            power -= g->x * v.a.x + g->y * v.a.y + g->moment_a * v.a.z;
        }
        *(c->brace == TD_BRACE_AFTER ? &rows->power_after : &rows->power_before) = power;
        return;
    }
    td_applied_impulse sum;
    clear_applied(&sum);
    if (c->brace == TD_BRACE_TAKE) {
        apply_impulse(block, a_static, &v, &sum, -g->x, -g->y, -g->moment_a, -g->moment_b);
    } else {
        f8 kept = rows->kept_share;
        block->point[0].normal_impulse *= kept;
        block->point[1].normal_impulse *= kept;
        block->tangent_impulse *= kept;
        apply_impulse(block, a_static, &v, &sum, kept * g->x, kept * g->y, kept * g->moment_a,
                      kept * g->moment_b);
        *g = sum;
    }
    write_sides(c, block, a_static, &v);
}

/* A stage of bracing, joint_brace.c. TD_BRACE_GIVE applies the warm start along the lines of the
 * present substep. */
TD_INLINE void brace(td_block *const *blocks, int count, const td_solve_context *c, bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        if (c->brace != TD_BRACE_GIVE) {
            TD_WIDE(td_brace_applied)(block, c, a_static);
            continue;
        }
        td_lock_rows *h = td_lock_rows_of(block);
        f8 length, u = block->point[0].normal_impulse;
        sides v = read_sides(c->velocity, block, a_static),
              d = read_sides(c->delta, block, a_static);
        frame8 f = line_now(block, &d, a_static, block->point[0].start_separation + h->rest_length,
                            f8_all(0.0f), &length);
        replace_impulse(block, a_static, &v, &h->applied, f.x * u, f.y * u, f.a_u * u, f.b_u * u);
        write_sides(c, block, a_static, &v);
    }
}

/* The restitution pass: joints have none. */
static void no_bounce(td_block *const *blocks, int count, const td_solve_context *c) {
    (void)blocks, (void)count, (void)c;
}

TD_PASS(warm_start_moving, warm_start, false)
TD_PASS(warm_start_static, warm_start, true)
TD_PASS(solve_moving, solve, false, true)
TD_PASS(solve_static, solve, true, true)
TD_PASS(relax_moving, solve, false, false)
TD_PASS(relax_static, solve, true, false)
TD_PASS(brace_moving, brace, false)
TD_PASS(brace_static, brace, true)

extern const td_solve_ops TD_WIDE(td_solve_rod);
const td_solve_ops TD_WIDE(td_solve_rod) = {{warm_start_moving, warm_start_static},
                                            {solve_moving, solve_static},
                                            {relax_moving, relax_static},
                                            no_bounce,
                                            {brace_moving, brace_static}};
