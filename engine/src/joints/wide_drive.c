/* wide_drive.c: solver passes for driven directions of joints. A direction has up to three rows
 * with the same Jacobian, which are solved one after the other (Gauss-Seidel):
 *     spring: a soft constraint of its own frequency and damping ratio (E. Catto, "Soft
 *             Constraints", 2011); impulse: point[1]
 *     motor:  speed = motor_speed, within its maximum force; impulse: tangent
 *     limits: lower <= value <= upper, as a unilateral row for the limit that is nearer by the end
 *             of the substep (choose_limit); impulse: point[0] */
#include "joints/wide_joint.h"

/* TD_CONSTRAINT_DRIVE_LINE, _AXIS, _TURN: along the line between the anchors, along an axis of the
 * frame, or the rotation. */
typedef enum drive_kind { LINE, AXIS, TURN } drive_kind;

/* The driven direction (x, y) in the present substep, the lever arms crossed with it, and the
 * coordinate along it (length or rad). */
typedef struct direction8 {
    f8 x, y, cross_a, cross_b, value;
    f8 k, mass; /* J M^-1 J', the speed that a unit of impulse causes; and its inverse */
} direction8;

TD_INLINE direction8 direction_now(const td_block *block, const td_drive_rows *r,
                                   const td_solve_context *c, bool a_static, drive_kind which,
                                   const sides *v) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    sides d = read_sides(c->delta, block, a_static);
    direction8 now = {zero, zero, r->turn_sign, r->turn_sign, zero, zero, zero};
    if (which == TURN) {
        now.value = r->start_value + r->turn_sign * (a_static ? d.b.z : d.b.z - d.a.z);
    } else {
        frame8 f = which == LINE ? line_now(block, &d, a_static, r->gap_u, r->gap_v, &now.value)
                                 : frame_now(block, &d, a_static, r->gap_u, r->gap_v, one);
        now.value = which == LINE ? now.value : f.gap_u;
        now = (direction8){f.x, f.y, f.a_u, f.b_u, now.value, zero, zero};
    }
    f8 linear = which == TURN ? zero : one;
    now.k = inverse_mass_entry(block, v, a_static, linear, now.cross_a, now.cross_b, now.cross_a,
                               now.cross_b);
    now.mass = inverse_or_zero(now.k);
    return now;
}

/* The speed of the driven coordinate, by the present velocities of both sides. */
TD_INLINE f8 speed_along(const direction8 *n, const sides *v, bool a_static) {
    return speed_now(v, a_static, n->x, n->y, n->cross_a, n->cross_b);
}

/* Applies an impulse along the direction. */
TD_INLINE void apply_along(td_block *block, const direction8 *n, bool a_static, sides *v,
                           f8 change) {
    apply_impulse(block, a_static, v, &td_drive_rows_of(block)->applied, n->x * change,
                  n->y * change, n->cross_a * change, n->cross_b * change);
}

/* Replaces the impulses of the last substep, which the velocities contain along the direction of
 * that substep, by their sum along the present direction. */
TD_INLINE void replace_along(td_block *block, const direction8 *n, bool a_static, sides *v) {
    td_drive_rows *r = td_drive_rows_of(block);
    f8 all = block->point[1].normal_impulse + block->tangent_impulse +
             r->limit_side * block->point[0].normal_impulse;
    replace_impulse(block, a_static, v, &r->applied, n->x * all, n->y * all, n->cross_a * all,
                    n->cross_b * all);
}

/* Solves springs. With a1 = 2 damping + h omega, a2 = h omega a1, a3 = 1 / (1 + a2):
 *     impulse = old - a2 a3 m (speed + omega / a1 x) - a3 old,
 * within the spring's maximum force times h. omega is limited to TD_SPRING_PHASE / h. */
TD_INLINE void solve_spring(td_block *block, const td_drive_rows *r, const td_solve_context *c,
                            const direction8 *n, bool a_static, sides *v) {
    td_point *q = &block->point[1];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), h = one / f8_all(c->inv_h);
    i8 acts = r->frequency > zero;
    q->separation = f8_keep(acts, n->value - r->target);
    if (!i8_bits(acts)) {
        return;
    }
    f8 omega =
        f8_min(f8_all(2.0f * (float)TD_PI) * r->frequency, f8_all(TD_SPRING_PHASE * c->inv_h));
    f8 a1 = f8_all(2.0f) * r->damping + h * omega, a2 = h * omega * a1, a3 = one / (one + a2);
    f8 speed =
        speed_along(n, v, a_static) + q->separation * f8_keep(acts, omega / f8_pick(acts, a1, one));
    f8 old = q->normal_impulse, max = r->max_spring_force * h;
    f8 now = f8_clamp(old - a2 * a3 * n->mass * speed - a3 * old, -max, max);
    now = f8_keep(acts, now);
    q->normal_impulse = now;
    apply_along(block, n, a_static, v, now - old);
}

/* Solves motors: speed = motor_speed, with an impulse of at most the maximum force times h. */
TD_INLINE void solve_motor(td_block *block, const td_drive_rows *r, const td_solve_context *c,
                           const direction8 *n, bool a_static, sides *v) {
    f8 max = r->max_motor_force / f8_all(c->inv_h);
    if (!i8_bits(max > f8_all(0.0f))) {
        return;
    }
    f8 old = block->tangent_impulse;
    f8 now = f8_clamp(old - n->mass * (speed_along(n, v, a_static) - r->motor_speed), -max, max);
    block->tangent_impulse = now;
    apply_along(block, n, a_static, v, now - old);
}

/* Chooses the limit that is nearer at the end of the substep; `ahead` is the displacement in the
 * substep at the present speed. If the other limit becomes the nearer one, the sign of the impulse
 * is changed, since both limits push in opposite directions: it is still the impulse that the
 * velocities contain, but for the new limit it is negative, and solve_limit then removes it. Sets
 * limit, limit_side, start_separation and separation. */
TD_INLINE void choose_limit(td_block *block, td_drive_rows *r, const direction8 *n, f8 ahead) {
    td_point *p = &block->point[0];
    f8 one = f8_all(1.0f), value = n->value + ahead;
    i8 lower = value - r->lower <= r->upper - value;
    f8 side = f8_keep(r->limited, f8_pick(lower, one, -one));
    p->normal_impulse *= side * r->limit_side;
    r->limit_side = side;
    r->limit = f8_pick(lower, r->lower, r->upper);
    p->start_separation = side * (r->start_value - r->limit);
    p->separation = side * (n->value - r->limit);
}

/* The maximum of a limit's bias, a speed. Angles exceed their limits by a few radians at most, so
 * that a constant maximum is enough. A limit of length may be exceeded at the start of a step by so
 * much that its bias would be above TD_JOINT_CLOSING_SPEED, as in a rope that is much too short.
 * The limit then closes at that speed, plus the bias that it needs to carry its present load
 * (LOAD_BIAS, wide_joint.h). A higher bias would do harm: a contact in the way turns a part of the
 * closing speed into another direction, and the bodies keep that part after the gap has closed. */
TD_INLINE f8 max_limit_bias(const td_point *p, const td_solve_context *c, f8 k, drive_kind which) {
    if (which == TURN) {
        return f8_all(TD_JOINT_CLOSING_FACTOR * TD_JOINT_CLOSING_SPEED);
    }
    i8 far = p->start_separation * f8_all(-TD_JOINT_GAP_SHARE * c->inv_h) >
             f8_all(c->joint_closing_speed);
    return max_bias(c->joint_closing_speed, k, p->normal_impulse) -
           f8_keep(far, f8_all((TD_JOINT_CLOSING_FACTOR - 1.0f) * c->joint_closing_speed));
}

/* Solves limits like contacts. While a limit is not reached, the coordinate may just reach it by
 * the end of the substep; while it is exceeded, it acts as a damped spring. If both limits are
 * equal, it is an equality row. `soft`: solve pass, false: relax pass. */
TD_INLINE void solve_limit(td_block *block, td_drive_rows *r, const td_solve_context *c,
                           const direction8 *n, bool a_static, drive_kind which, bool soft,
                           sides *v) {
    td_point *p = &block->point[0];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), inv_h = f8_all(c->inv_h);
    i8 locked = r->locked > zero, acts = r->limited;
    if (!i8_bits(acts)) {
        return;
    }
    f8 along = speed_along(n, v, a_static);
    choose_limit(block, r, n, along / inv_h);
    f8 gap = p->separation;
    i8 apart = (gap > zero) & ~locked;
    f8 bias = zero, scale = one, impulse_share = zero;
    if (soft) {
        f8 max = max_limit_bias(p, c, n->k, which);
        bias = f8_clamp(gap * f8_all(TD_JOINT_GAP_SHARE * c->inv_h), -max, max);
        scale = f8_pick(apart, one, f8_all(1.0f - IMPULSE_SCALE));
        impulse_share = f8_keep(~apart, f8_all(IMPULSE_SCALE));
    }
    bias = f8_pick(apart, gap * inv_h, bias);
    f8 old = p->normal_impulse;
    f8 speed = r->limit_side * along + bias;
    f8 now = old - scale * n->mass * speed - impulse_share * old;
    now = f8_keep(acts, f8_pick(locked, now, f8_max(now, zero)));
    p->normal_impulse = now;
    apply_along(block, n, a_static, v, r->limit_side * (now - old));
}

/* A solve pass (`soft`) or relax pass over blocks of drives. */
TD_INLINE void solve_drive(td_block *const *blocks, int count, const td_solve_context *c,
                           bool a_static, drive_kind which, bool soft) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_drive_rows *r = td_drive_rows_of(block);
        sides v = read_sides(c->velocity, block, a_static);
        direction8 n = direction_now(block, r, c, a_static, which, &v);
        if (soft && !c->first) {
            replace_along(block, &n, a_static, &v);
        }
        solve_spring(block, r, c, &n, a_static, &v);
        solve_motor(block, r, c, &n, a_static, &v);
        solve_limit(block, r, c, &n, a_static, which, soft, &v);
        write_sides(c, block, a_static, &v);
    }
}

/* Applies the impulses of the last step. */
TD_INLINE void warm_start(td_block *const *blocks, int count, const td_solve_context *c,
                          bool a_static, drive_kind which) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_drive_rows *r = td_drive_rows_of(block);
        sides v = read_sides(c->velocity, block, a_static);
        direction8 n = direction_now(block, r, c, a_static, which, &v);
        clear_applied(&r->applied);
        replace_along(block, &n, a_static, &v);
        write_sides(c, block, a_static, &v);
    }
}

/* Defines the passes td_solve_drive_NAME of a kind of drive. */
#define DRIVE_PASSES(name, which)                                                              \
    TD_PASS(warm_start_##name, warm_start, false, which)                                       \
    TD_PASS(warm_start_static_##name, warm_start, true, which)                                 \
    TD_PASS(solve_##name, solve_drive, false, which, true)                                     \
    TD_PASS(solve_static_##name, solve_drive, true, which, true)                               \
    TD_PASS(relax_##name, solve_drive, false, which, false)                                    \
    TD_PASS(relax_static_##name, solve_drive, true, which, false)                              \
    extern const td_solve_ops TD_WIDE(td_solve_drive_##name);                                  \
    const td_solve_ops TD_WIDE(                                                                \
        td_solve_drive_##name) = {.warm_start = {warm_start_##name, warm_start_static_##name}, \
                                  .solve = {solve_##name, solve_static_##name},                \
                                  .relax = {relax_##name, relax_static_##name}};

DRIVE_PASSES(line, LINE)
DRIVE_PASSES(axis, AXIS)
DRIVE_PASSES(turn, TURN)
