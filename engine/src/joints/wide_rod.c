/* wide_rod.c: solver passes for locked distances (rods): one equality row along the line between
 * the anchors as it is in the substep, with gap = distance - rest length; and, for rods and locks,
 * the passes of bracing, which bounds the energy that torn joints add (joint_brace.c). */
#include "joints/wide_joint.h"

/* A solve pass (`soft`) or relax pass over a block; `a_static`: side a is static. The equations are
 * those of wide_joint.h, with the gap C = separation and the bias clamped to closing_factor times
 * joint_closing_speed. c->last is set only in the relax pass of the last substep: there the speed
 * along the rod is entered in the error statistics (c->tally) as its residual, as -|speed|, since
 * td_tally.min_speed keeps the least value. */
TD_INLINE void solve_rod(td_block *block, const td_solve_context *c, bool a_static, bool soft) {
    td_point *p = &block->point[0];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), length;
    f8 rest_length = td_lock_rows_of(block)->rest_length;
    sides v = read_sides(c->velocity, block, a_static), d = read_sides(c->delta, block, a_static);
    f8 start_length = p->start_separation + rest_length; /* distance at the start of the step */
    frame8 f = line_now(block, &d, a_static, start_length, zero, &length);
    p->separation = f8_keep(p->normal_mass > zero, length - rest_length); /* 0 in empty lanes */
    td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
    f8 old = p->normal_impulse;
    /* In later substeps the velocities contain the impulse along the line of the substep before
     * (td_integrate_velocity): it is replaced by one along the present line. In the first substep
     * no body has moved since the warm start. */
    if (soft && !c->first) {
        replace_impulse(block, a_static, &v, applied, f.x * old, f.y * old, f.a_u * old,
                        f.b_u * old);
    }
    /* Effective mass along the present line; 0 in empty lanes. */
    f8 mass =
        inverse_or_zero(inverse_mass_entry(block, &v, a_static, one, f.a_u, f.b_u, f.a_u, f.b_u));
    f8 bias = zero, scale = one, impulse_share = zero;
    if (soft) {
        f8 factor = td_lock_rows_of(block)->closing_factor;
        f8 max = factor * f8_all(c->joint_closing_speed);
        bias = f8_clamp(p->separation * gap_share(factor) * f8_all(c->inv_h), -max, max);
        scale = f8_all(1.0f - IMPULSE_SCALE);
        impulse_share = f8_all(IMPULSE_SCALE);
    }
    f8 speed = speed_now(&v, a_static, f.x, f.y, f.a_u, f.b_u);
    f8 now = old - scale * mass * (speed + bias) - impulse_share * old;
    p->normal_impulse = now;
    f8 change = now - old;
    apply_impulse(block, a_static, &v, applied, f.x * change, f.y * change, f.a_u * change,
                  f.b_u * change);
    write_sides(c, block, a_static, &v);
    if (c->last) {
        c->tally->min_speed = f8_min(f8_keep(mass > zero, -f8_abs(speed)), c->tally->min_speed);
    }
}

/* In the first substep: applies the impulses of the last step along the line at the start of this
 * step, and sets c->torn if a gap is so wide that the step braces its joints (flag_torn). */
TD_INLINE void warm_start(td_block *const *blocks, int count, const td_solve_context *c,
                          bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        const td_point *p = &block->point[0];
        f8 impulse = p->normal_impulse;
        td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
        sides v = read_sides(c->velocity, block, a_static);
        f8 angle_gap = f8_all(0.0f); /* a rod locks no rotation */
        flag_torn(c, p->separation, angle_gap);
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

/* A pass of bracing (td_brace, block.h) on the impulses p that the lanes of a rod's or lock's block
 * applied in this substep (td_lock_rows.applied). TD_BRACE_WORK_WITH and TD_BRACE_WORK_WITHOUT
 * store p times the relative speed along it, an energy: p.u', by the speeds u' with the impulses of
 * all locks, and p.u, by the speeds u without them. TD_BRACE_REMOVE removes p from the velocities,
 * but not from the record (`applied`). TD_BRACE_APPLY_SHARE applies the share of p that
 * joint_brace.c has computed from the two (kept_share), and scales the lane's impulses and the
 * record by it. Blocks without a torn group are left out, but in the first pass of a step, before
 * joint_brace.c finds the groups. */
void TD_WIDE(td_brace_applied)(td_block *block, const td_solve_context *c, bool a_static) {
    td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
    td_brace_rows *rows = td_brace_rows_of(block);
    sides v = read_sides(c->velocity, block, a_static);
    if (rows->torn == 0.0f && !(c->first && c->brace == TD_BRACE_WORK_WITH)) {
        return;
    }
    if (c->brace == TD_BRACE_WORK_WITHOUT || c->brace == TD_BRACE_WORK_WITH) {
        f8 work = applied->x * v.b.x + applied->y * v.b.y + applied->moment_b * v.b.z;
        if (!a_static) {
            work -= applied->x * v.a.x + applied->y * v.a.y + applied->moment_a * v.a.z;
        }
        *(c->brace == TD_BRACE_WORK_WITH ? &rows->work_with : &rows->work_without) = work;
        return;
    }
    bool removes = c->brace == TD_BRACE_REMOVE; /* else TD_BRACE_APPLY_SHARE */
    f8 factor = removes ? f8_all(-1.0f) : rows->kept_share;
    td_applied_impulse change; /* what this pass applies */
    clear_applied(&change);
    apply_impulse(block, a_static, &v, &change, factor * applied->x, factor * applied->y,
                  factor * applied->moment_a, factor * applied->moment_b);
    if (!removes) {
        block->point[0].normal_impulse *= factor;
        block->point[1].normal_impulse *= factor;
        block->tangent_impulse *= factor;
        *applied = change;
    }
    write_sides(c, block, a_static, &v);
}

/* A pass of bracing of rods. TD_BRACE_WARM_START replaces the impulses of the substep before by
 * impulses along the present line; td_brace_applied does the other passes. */
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
        td_lock_rows *rows = td_lock_rows_of(block);
        f8 length, impulse = block->point[0].normal_impulse;
        sides v = read_sides(c->velocity, block, a_static),
              d = read_sides(c->delta, block, a_static);
        f8 start_length = block->point[0].start_separation + rows->rest_length;
        frame8 f = line_now(block, &d, a_static, start_length, f8_all(0.0f), &length);
        replace_impulse(block, a_static, &v, &rows->applied, f.x * impulse, f.y * impulse,
                        f.a_u * impulse, f.b_u * impulse);
        write_sides(c, block, a_static, &v);
    }
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
const td_solve_ops TD_WIDE(td_solve_rod) = {.warm_start = {warm_start_moving, warm_start_static},
                                            .solve = {solve_moving, solve_static},
                                            .relax = {relax_moving, relax_static},
                                            .brace = {brace_moving, brace_static}};
