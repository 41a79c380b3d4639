/* wide_rod.c: solver passes for locked distances (rods): one equality row along the line between
 * the anchors as it is in the substep, with gap = distance - rest length; and, for rods and locks,
 * the passes of bracing, which bounds the energy that torn joints add (joint_brace.c). */
#include "joints/wide_joint.h"

/* A solve pass (`soft`) or relax pass over a block; `a_static`: side a is static. The equations are
 * those of wide_joint.h, with the gap C = separation and the bias clamped to closing_factor times
 * joint_closing_speed. c->last is set in relax passes alone: the tally gets -|speed|, the residual.
 */
TD_INLINE void solve_rod(td_block *block, const td_solve_context *c, bool a_static, bool soft) {
    td_point *p = &block->point[0];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), length;
    f8 rest_length = td_lock_rows_of(block)->rest_length;
    sides v = read_sides(c->velocity, block, a_static), d = read_sides(c->delta, block, a_static);
    f8 start_length = p->start_separation + rest_length; /* distance as the step began */
    frame8 f = line_now(block, &d, a_static, start_length, zero, &length);
    p->separation = f8_keep(p->normal_mass > zero, length - rest_length); /* 0 in empty lanes */
    td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
    f8 old = p->normal_impulse;
    /* The velocities of a later substep have the impulse along the line of the substep before, by
     * td_integrate_velocity: it is turned to the present line. In the first substep no body has
     * moved since the warm start. */
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
        bias = f8_clamp(p->separation * f8_all(TD_JOINT_GAP_SHARE * c->inv_h), -max, max);
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

/* In the first substep: applies the impulses of the last step along the line as the step begins,
 * and sets c->torn if a gap is so wide that the step braces its joints (flag_torn). */
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

/* The work of impulses p at the relative speeds of a block's lanes, an energy. */
TD_INLINE f8 work_of(const td_applied_impulse *p, const sides *v, bool a_static) {
    f8 work = p->x * v->b.x + p->y * v->b.y + p->moment_b * v->b.z;
    return a_static ? work : work - (p->x * v->a.x + p->y * v->a.y + p->moment_a * v->a.z);
}

/* A pass of bracing (td_brace, block.h) over the block of a rod or lock, for the impulses p that
 * its lanes applied in this substep (td_lock_rows.applied); lanes of groups that are not braced
 * stay as they are. TD_BRACE_WORK stores p.u'. TD_BRACE_REMOVE takes p back, leaves the record of
 * it, and stores the energy p.(v + v') / 2 that this takes out, for the lane's speeds v' before and
 * v after: the sum over all lanes is the energy that they had added together. TD_BRACE_APPLY_SHARE
 * applies the share of p that joint_brace.c has computed, and scales the lane's impulses and the
 * record by it. */
TD_INLINE void brace_block(td_block *block, const td_solve_context *c, bool a_static) {
    td_applied_impulse *applied = &td_lock_rows_of(block)->applied;
    td_brace_rows *rows = td_brace_rows_of(block);
    sides v = read_sides(c->velocity, block, a_static);
    i8 braced = rows->group > f8_all(TD_NOT_BRACED);
    td_applied_impulse p = {f8_keep(braced, applied->x), f8_keep(braced, applied->y),
                            f8_keep(braced, applied->moment_a), f8_keep(braced, applied->moment_b)};
    f8 work = work_of(&p, &v, a_static);
    if (c->brace == TD_BRACE_WORK) {
        rows->work = work;
        return;
    }
    bool remove = c->brace == TD_BRACE_REMOVE;
    f8 factor = remove ? f8_all(-1.0f) : rows->kept_share;
    td_applied_impulse change; /* not used: the record is scaled below */
    clear_applied(&change);
    apply_impulse(block, a_static, &v, &change, factor * p.x, factor * p.y, factor * p.moment_a,
                  factor * p.moment_b);
    if (remove) {
        rows->energy = f8_all(0.5f) * (work + work_of(&p, &v, a_static));
    } else {
        block->point[0].normal_impulse *= factor;
        block->point[1].normal_impulse *= factor;
        block->tangent_impulse *= factor;
        *applied = (td_applied_impulse){factor * applied->x, factor * applied->y,
                                        factor * applied->moment_a, factor * applied->moment_b};
    }
    write_sides(c, block, a_static, &v);
}

TD_INLINE void brace(td_block *const *blocks, int count, const td_solve_context *c, bool a_static) {
    for (int i = 0; i < count; i++) {
        if (((const float *)&td_brace_rows_of(blocks[i])->common_group)[0] != TD_NOT_BRACED) {
            brace_block(blocks[i], c, a_static);
        }
    }
}

void TD_WIDE(td_brace_moving)(td_block *const *blocks, int count, const td_solve_context *c) {
    brace(blocks, count, c, false);
}

void TD_WIDE(td_brace_static)(td_block *const *blocks, int count, const td_solve_context *c) {
    brace(blocks, count, c, true);
}

/* The restitution pass: joints do not bounce. */
static void no_bounce(td_block *const *blocks, int count, const td_solve_context *c) {
    (void)blocks, (void)count, (void)c;
}

TD_PASS(warm_start_moving, warm_start, false)
TD_PASS(warm_start_static, warm_start, true)
TD_PASS(solve_moving, solve, false, true)
TD_PASS(solve_static, solve, true, true)
TD_PASS(relax_moving, solve, false, false)
TD_PASS(relax_static, solve, true, false)

extern const td_solve_ops TD_WIDE(td_solve_rod);
const td_solve_ops TD_WIDE(td_solve_rod) = {.warm_start = {warm_start_moving, warm_start_static},
                                            .solve = {solve_moving, solve_static},
                                            .relax = {relax_moving, relax_static},
                                            .bounce = no_bounce,
                                            .brace = {TD_WIDE(td_brace_moving),
                                                      TD_WIDE(td_brace_static)}};
