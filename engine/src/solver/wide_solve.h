/* wide_solve.h: the passes of the contact solver over blocks of one or two points: warm start, soft
 * solve, and relax.
 *
 * The method is "soft step" of E. Catto, "Solver2D" (2024, box2d.org; src/solve_soft_step.c), which
 * Box2D v3 has in src/contact_solver.c: sequential impulses (projected Gauss-Seidel) with soft
 * constraints in substeps of length h, lever arms fixed at the start of the step, and after each
 * substep's motion a relax pass without bias, which takes the velocity of the position correction
 * out again. Symbols, for a point of a contact between bodies a and b:
 *
 *     n, t           normal from a to b, and tangent t = (n.y, -n.x)
 *     r_a, r_b       lever arms from the centres of mass to the point; cross_a = r_a x n,
 *                    tangent_cross_a = r_a x t (of the points' mean arm)
 *     v              normal speed  n . (v_b - v_a) + w_b cross_b - w_a cross_a, with the angular
 *                    speeds w; negative: it closes
 *     m              effective mass (normal_mass): 1 / m = 1/m_a + 1/m_b + cross_a^2 / I_a
 *                    + cross_b^2 / I_b; 0 where there is no point
 *     s              separation: s_start + n . (d_b - d_a) + q_b cross_b - q_a cross_a, with the
 *                    motions d and rotations q since the start of the step (to first order)
 *     p              impulse of the substep (normal_impulse). The velocities have it already, by
 *                    the warm start in the first substep, by td_integrate_velocity in later ones
 *     p_t, m_t, mu   tangent impulse, its effective mass, and the friction coefficient
 *
 * Soft solve, for one point after the other, without friction:
 *
 *     s > 0:   bias = s / h, mass_scale = 1, impulse_scale = 0
 *              (a speculative contact: the gap closes by the end of the substep at the earliest)
 *     s <= 0:  bias = max(bias_rate s, -push_speed), mass_scale and impulse_scale < 1
 *              (a damped spring; solve.c derives the three coefficients)
 *     p'  = max(0, p - m mass_scale (v + bias) - impulse_scale p)
 *
 * Relax, with s computed anew, friction first:
 *
 *     p_t' = clamp(p_t - m_t (slip - surface speed), -mu sum p, mu sum p)
 *     p'  = max(0, p - m (v + max(s, 0) / h))
 *
 * No body moves between a relax pass and the next soft solve, so that the soft solve takes the
 * separation that the relax pass computed. */
#ifndef TD_WIDE_SOLVE_H
#define TD_WIDE_SOLVE_H

#include "solver/friction.h"
#include "solver/tally.h"

/* Velocities (or motions) of both sides: x, y, z = turn, w = inverse mass. Side a stays zero where
 * it is static. */
typedef struct sides {
    td_rows a, b;
} sides;

/* Reads the records (velocities or motions) of a block's lanes. `a_static`: side a is static. */
TD_INLINE sides read_sides(const float (*records)[4], const td_block *block, bool a_static) {
    f8 zero = f8_all(0.0f);
    sides v = {{zero, zero, zero, zero}, td_gather(records, block->b)};
    if (!a_static) {
        v.a = td_gather(records, block->a);
    }
    return v;
}

/* Impulses: along the normal at each point, and along the tangent. */
typedef struct impulses {
    f8 normal[2], tangent;
} impulses;

/* Which impulses have lever arms that may differ from 0, and so change the bodies' rotation. Passes
 * for simpler shapes leave out the arithmetic of arms that are 0. */
typedef enum td_arms {
    ARMS_ALL,     /* all */
    ARMS_TANGENT, /* only friction: normals go through the centres of mass (circles) */
    ARMS_NONE     /* none: bodies do not turn (AABBs) */
} td_arms;

/* Adds impulses to the velocities `v` of both sides, and writes them back: x and y change by the
 * inverse mass times the impulse, z by the inverse inertia times its moment, on side a negatively.
 * `friction`: whether there is a tangential impulse. */
TD_INLINE void apply_impulses(const td_solve_context *c, const td_block *block, int points,
                              td_arms arms, bool a_static, bool friction, sides v, impulses p) {
    const td_point *point = block->point;
    f8 nx = block->nx, ny = block->ny, normal = p.normal[0];
    f8 moment_a = f8_all(0.0f), moment_b = moment_a;
    if (arms == ARMS_ALL) {
        moment_a = point[0].cross_a * p.normal[0];
        moment_b = point[0].cross_b * p.normal[0];
    }
    if (points == 2) {
        normal += p.normal[1];
        moment_a += point[1].cross_a * p.normal[1];
        moment_b += point[1].cross_b * p.normal[1];
    }
    f8 x = nx * normal, y = ny * normal;
    if (friction) {
        x += ny * p.tangent;
        y -= nx * p.tangent;
    }
    if (friction && arms == ARMS_TANGENT) {
        moment_a = block->tangent_cross_a * p.tangent;
        moment_b = block->tangent_cross_b * p.tangent;
    } else if (friction && arms == ARMS_ALL) {
        moment_a += block->tangent_cross_a * p.tangent;
        moment_b += block->tangent_cross_b * p.tangent;
    }
    bool turns = arms == ARMS_ALL || (friction && arms == ARMS_TANGENT);
    if (!a_static) {
        v.a.x -= v.a.w * x;
        v.a.y -= v.a.w * y;
        if (turns) {
            v.a.z -= block->inv_inertia_a * moment_a;
        }
        td_scatter(c->velocity, block->a, v.a);
    }
    v.b.x += v.b.w * x;
    v.b.y += v.b.w * y;
    if (turns) {
        v.b.z += block->inv_inertia_b * moment_b;
    }
    td_scatter(c->velocity, block->b, v.b);
}

/* The speed of a point of b relative to one of a along a direction. `centres`: that of the centres
 * of mass; cross_a, cross_b: lever arms crossed with the direction. */
TD_INLINE f8 at_arms(f8 centres, const sides *v, bool a_static, f8 cross_a, f8 cross_b) {
    f8 speed = centres + v->b.z * cross_b;
    return a_static ? speed : speed - v->a.z * cross_a;
}

/* at_arms along the normal, at a contact point. */
TD_INLINE f8 at_point(f8 centres, const sides *v, bool a_static, td_arms arms, const td_point *p) {
    return arms == ARMS_ALL ? at_arms(centres, v, a_static, p->cross_a, p->cross_b) : centres;
}

/* The speed of b's centre of mass relative to a's along (x, y). */
TD_INLINE f8 centres_along(const sides *v, bool a_static, f8 x, f8 y) {
    return a_static ? v->b.x * x + v->b.y * y : (v->b.x - v->a.x) * x + (v->b.y - v->a.y) * y;
}

/* The part of J M^-1 J' between two rows that comes from rotation: the speed along one row that a
 * unit of impulse along the other gives by turning the bodies. `from_` and `to_` are the rows'
 * lever arms crossed with their directions. */
TD_INLINE_SMALL f8 coupling(const td_block *block, bool a_static, f8 from_a, f8 from_b, f8 to_a,
                            f8 to_b) {
    f8 k = block->inv_inertia_b * from_b * to_b;
    return a_static ? k : k + block->inv_inertia_a * from_a * to_a;
}

/* J M^-1 J' between a block's two points: the normal speed at the second point that a unit of
 * impulse at the first one gives. */
TD_INLINE f8 by_first(const td_block *block, const sides *v, bool a_static) {
    const td_point *p = &block->point[0], *q = &block->point[1];
    f8 mass = a_static ? v->b.w : v->a.w + v->b.w;
    return mass + coupling(block, a_static, p->cross_a, p->cross_b, q->cross_a, q->cross_b);
}

/* The warm start of the first substep: adds the stored impulses, which are those of one substep, to
 * the velocities. */
TD_INLINE void warm_start_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                                 int points, td_arms arms, bool a_static) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        impulses p = {.tangent = block->tangent_impulse};
        for (int k = 0; k < points; k++) {
            p.normal[k] = block->point[k].normal_impulse;
        }
        apply_impulses(c, block, points, arms, a_static, true,
                       read_sides(c->velocity, block, a_static), p);
    }
}

/* The soft solve. The speeds of both points are computed from the velocities as they were when the
 * block was read, and the change by the first point's impulse is added to the second one's speed
 * (by_first): the same as Gauss-Seidel, to rounding, with a shorter chain of dependent operations.
 */
TD_INLINE void solve_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, td_arms arms, bool a_static) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), inv_h = f8_all(c->inv_h);
    f8 bias_rate = f8_all(c->bias_rate[a_static]), bias_min = f8_all(-c->push_speed);
    f8 mass_scale = f8_all(c->mass_scale[a_static]),
       impulse_scale = f8_all(c->impulse_scale[a_static]);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_early(blocks, i, count, points);
        sides v = read_sides(c->velocity, block, a_static);
        f8 closing = centres_along(&v, a_static, block->nx, block->ny);
        impulses change = {{zero, zero}, zero};
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            i8 apart = p->separation > zero;
            f8 bias =
                f8_pick(apart, p->separation * inv_h, f8_max(p->separation * bias_rate, bias_min));
            f8 scale = p->normal_mass * f8_pick(apart, one, mass_scale);
            f8 keep = f8_keep(~apart, impulse_scale);
            f8 speed = at_point(closing, &v, a_static, arms, p) + bias;
            if (k) {
                speed += by_first(block, &v, a_static) * change.normal[0];
            }
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - scale * speed - keep * old, zero);
            p->normal_impulse = now;
            change.normal[k] = now - old;
        }
        apply_impulses(c, block, points, arms, a_static, false, v, change);
    }
}

/* Updates the friction impulse of a block, bounded by the present normal impulses. Returns the
 * change of the impulse along t. */
TD_INLINE f8 update_friction(const td_solve_context *c, td_block *block, int points, td_arms arms,
                             bool a_static, const sides *v) {
    f8 normal = block->point[0].normal_impulse;
    if (points == 2) {
        normal += block->point[1].normal_impulse;
    }
    f8 slip = centres_along(v, a_static, block->ny, -block->nx);
    if (arms != ARMS_NONE) {
        slip = at_arms(slip, v, a_static, block->tangent_cross_a, block->tangent_cross_b);
    }
    if (c->surface_speeds) {
        slip -= td_surface_at(block, points)->speed;
    }
    f8 bound = td_friction_bound8(block->friction, normal, slip);
    f8 old = block->tangent_impulse;
    f8 now = f8_clamp(old - block->tangent_mass * slip, -bound, bound);
    block->tangent_impulse = now;
    return now - old;
}

/* The relax pass. It also adds this substep's impulses to the totals of the step: the first substep
 * sets them (`restarts`), except in blocks whose totals the bounce passes have set; a second relax
 * pass of the same substep (c->again) adds only what it changes. The last relax pass of a step
 * notes the greatest closing speed that it finds, for the error statistics. */
TD_INLINE void relax_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, td_arms arms, bool a_static) {
    f8 zero = f8_all(0.0f), inv_h = f8_all(c->inv_h), min_speed = zero;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_early(blocks, i, count, points);
        bool restarts = c->first && !c->again && !(c->bounces && block->bouncy);
        sides v = read_sides(c->velocity, block, a_static),
              d = read_sides(c->delta, block, a_static);
        f8 nx = block->nx, ny = block->ny;
        impulses change = {.tangent = zero};
        if (i8_bits(block->friction > zero)) { /* skipped where no lane has friction */
            change.tangent = update_friction(c, block, points, arms, a_static, &v);
        }
        if (c->keep_tangents) {
            td_surface *surface = td_surface_at(block, points);
            f8 more = c->again ? change.tangent : block->tangent_impulse;
            surface->total = more + (restarts ? zero : surface->total);
        }
        f8 closing = centres_along(&v, a_static, nx, ny),
           opened = centres_along(&d, a_static, nx, ny);
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            f8 separation = p->start_separation + at_point(opened, &d, a_static, arms, p);
            p->separation = separation;
            f8 speed = at_point(closing, &v, a_static, arms, p) + f8_max(separation, zero) * inv_h;
            if (arms == ARMS_ALL) {
                speed += coupling(block, a_static, block->tangent_cross_a, block->tangent_cross_b,
                                  p->cross_a, p->cross_b) *
                         change.tangent;
            }
            if (k) {
                speed += by_first(block, &v, a_static) * change.normal[0];
            }
            min_speed = f8_min(speed, min_speed);
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - p->normal_mass * speed, zero);
            p->normal_impulse = now;
            change.normal[k] = now - old;
            if (c->keep_totals) {
                td_point_history *history = &td_history_of(block, points)[k];
                f8 more = c->again ? now - old : now;
                history->total = restarts ? more : history->total + more;
            }
        }
        apply_impulses(c, block, points, arms, a_static, true, v, change);
    }
    if (c->last) {
        c->tally->min_speed = f8_min(min_speed, c->tally->min_speed);
    }
}

/* Defines a td_solve_fn `name` that is one of the passes above; the further arguments are the
 * pass's own (points, arms, a_static), constants by which the compiler specialises it. */
#define TD_PASS(name, pass, ...)                                                      \
    static void name(td_block *const *blocks, int count, const td_solve_context *c) { \
        pass(blocks, count, c, __VA_ARGS__);                                          \
    }

#endif
