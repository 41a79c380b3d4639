/* wide_solve.h: the passes of the contact solver over blocks of one or two points.
 *
 * Soft contacts with substeps after E. Catto, "Solver2D" (2024): a soft solve with bias, then the
 * positions move, then a relax pass without bias takes the push out of the velocities. Rows hold
 * scalars along normal and tangent, rotation is linearised over the step. The relax pass leaves the
 * separation that it computed, and the next solve pass starts from it: nothing moves in between.
 * Friction acts in the relax pass only. */
#ifndef TD_WIDE_SOLVE_H
#define TD_WIDE_SOLVE_H

#include "solver/friction.h"
#include "solver/tally.h"

/* Velocities (or motions) of both sides; side a stays zero where it is static. */
typedef struct sides {
    td_rows a, b;
} sides;

TD_INLINE sides read_sides(const float (*records)[4], const td_block *block, bool fixed) {
    f8 zero = f8_all(0.0f);
    sides v = {{zero, zero, zero, zero}, td_gather(records, block->b)};
    if (!fixed) {
        v.a = td_gather(records, block->a);
    }
    return v;
}

/* Impulses: along the normal at each point, and along the tangent. */
typedef struct impulses {
    f8 normal[2], tangent;
} impulses;

/* Which rows turn the bodies. */
typedef enum td_arms {
    ARMS_ALL,     /* any may */
    ARMS_TANGENT, /* only friction: normals go through the centres of mass */
    ARMS_NONE     /* nothing turns */
} td_arms;

/* Gives both sides the impulses and writes them back. `friction`: whether there is a tangential
 * one. */
TD_INLINE void push(const td_solve_context *c, const td_block *block, int points, td_arms arms,
                    bool fixed, bool friction, sides v, impulses p) {
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
    if (!fixed) {
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

/* Relative velocity of two points along a direction, from that of the centres along it. */
TD_INLINE f8 at_arms(f8 centres, const sides *v, bool fixed, f8 cross_a, f8 cross_b) {
    f8 speed = centres + v->b.z * cross_b;
    return fixed ? speed : speed - v->a.z * cross_a;
}

TD_INLINE f8 at_point(f8 centres, const sides *v, bool fixed, td_arms arms, const td_point *p) {
    return arms == ARMS_ALL ? at_arms(centres, v, fixed, p->cross_a, p->cross_b) : centres;
}

TD_INLINE f8 centres_along(const sides *v, bool fixed, f8 x, f8 y) {
    return fixed ? v->b.x * x + v->b.y * y : (v->b.x - v->a.x) * x + (v->b.y - v->a.y) * y;
}

/* Normal speed that a unit of impulse along the first row brings to the point of another one, whose
 * crosses are given. */
TD_INLINE_SMALL f8 coupling(const td_block *block, bool fixed, f8 from_a, f8 from_b, f8 to_a,
                            f8 to_b) {
    f8 k = block->inv_inertia_b * from_b * to_b;
    return fixed ? k : k + block->inv_inertia_a * from_a * to_a;
}

/* Normal speed that a unit of impulse at the first point brings to the second, along the same
 * normal. */
TD_INLINE f8 by_first(const td_block *block, const sides *v, bool fixed) {
    const td_point *p = &block->point[0], *q = &block->point[1];
    f8 mass = fixed ? v->b.w : v->a.w + v->b.w;
    return mass + coupling(block, fixed, p->cross_a, p->cross_b, q->cross_a, q->cross_b);
}

TD_INLINE void warm_start_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                                 int points, td_arms arms, bool fixed) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        impulses p = {.tangent = block->tangent_impulse};
        for (int k = 0; k < points; k++) {
            p.normal[k] = block->point[k].normal_impulse;
        }
        push(c, block, points, arms, fixed, true, read_sides(c->velocity, block, fixed), p);
    }
}

/* All speeds of a block are computed from the velocities at its start; what a row changed in the
 * ones after it is added through the couplings. That is Gauss-Seidel with a shorter chain of
 * operations that wait for each other. */
TD_INLINE void solve_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, td_arms arms, bool fixed) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), inv_h = f8_all(c->inv_h);
    f8 bias_rate = f8_all(c->bias_rate[fixed]), most = f8_all(-c->push_speed);
    f8 mass_scale = f8_all(c->mass_scale[fixed]), impulse_scale = f8_all(c->impulse_scale[fixed]);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_early(blocks, i, count, points);
        sides v = read_sides(c->velocity, block, fixed);
        f8 closing = centres_along(&v, fixed, block->nx, block->ny);
        impulses change = {{zero, zero}, zero};
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            /* Apart: reach zero at the end of the substep at the earliest. Overlapping: a spring.
             */
            i8 apart = p->separation > zero;
            f8 bias =
                f8_pick(apart, p->separation * inv_h, f8_max(p->separation * bias_rate, most));
            f8 scale = p->normal_mass * f8_pick(apart, one, mass_scale);
            f8 keep = f8_keep(~apart, impulse_scale);
            f8 speed = at_point(closing, &v, fixed, arms, p) + bias;
            if (k) {
                speed += by_first(block, &v, fixed) * change.normal[0];
            }
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - scale * speed - keep * old, zero);
            p->normal_impulse = now;
            change.normal[k] = now - old;
        }
        push(c, block, points, arms, fixed, false, v, change);
    }
}

/* Friction, by the normal impulses as they stand; returns the change of its impulse. */
TD_INLINE f8 rub(const td_solve_context *c, td_block *block, int points, td_arms arms, bool fixed,
                 const sides *v) {
    f8 normal = block->point[0].normal_impulse;
    if (points == 2) {
        normal += block->point[1].normal_impulse;
    }
    f8 slide = centres_along(v, fixed, block->ny, -block->nx);
    if (arms != ARMS_NONE) {
        slide = at_arms(slide, v, fixed, block->tangent_cross_a, block->tangent_cross_b);
    }
    if (c->surface_speeds) {
        slide -= td_surface_at(block, points)->speed;
    }
    f8 limit = td_friction_bound8(block->friction, normal, slide);
    f8 old = block->tangent_impulse;
    f8 now = f8_clamp(old - block->tangent_mass * slide, -limit, limit);
    block->tangent_impulse = now;
    return now - old;
}

/* The last relax pass of a step also notes the fastest approach that it finds. */
TD_INLINE void relax_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, td_arms arms, bool fixed) {
    f8 zero = f8_all(0.0f), inv_h = f8_all(c->inv_h), slowest = zero;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_early(blocks, i, count, points);
        bool anew = c->first && !c->again && !(c->bounces && block->bouncy);
        sides v = read_sides(c->velocity, block, fixed), d = read_sides(c->delta, block, fixed);
        f8 nx = block->nx, ny = block->ny;
        impulses change = {.tangent = zero};
        if (i8_bits(block->friction > zero)) { /* without friction it costs a look */
            change.tangent = rub(c, block, points, arms, fixed, &v);
        }
        if (c->keep_tangents) {
            td_surface *surface = td_surface_at(block, points);
            f8 more = c->again ? change.tangent : block->tangent_impulse;
            surface->total = more + (anew ? zero : surface->total);
        }
        f8 closing = centres_along(&v, fixed, nx, ny), opened = centres_along(&d, fixed, nx, ny);
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            /* How far the point opened since the start of the step, rotation linearised. */
            f8 separation = p->base + at_point(opened, &d, fixed, arms, p);
            p->separation = separation;
            f8 speed = at_point(closing, &v, fixed, arms, p) + f8_max(separation, zero) * inv_h;
            if (arms == ARMS_ALL) {
                speed += coupling(block, fixed, block->tangent_cross_a, block->tangent_cross_b,
                                  p->cross_a, p->cross_b) *
                         change.tangent;
            }
            if (k) {
                speed += by_first(block, &v, fixed) * change.normal[0];
            }
            slowest = f8_min(speed, slowest);
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - p->normal_mass * speed, zero);
            p->normal_impulse = now;
            change.normal[k] = now - old;
            if (c->keep_totals) {
                td_point_history *history = &td_history_of(block, points)[k];
                f8 more = c->again ? now - old : now;
                history->total = anew ? more : history->total + more;
            }
        }
        push(c, block, points, arms, fixed, true, v, change);
    }
    if (c->last) {
        c->tally->slowest = f8_min(slowest, c->tally->slowest);
    }
}

/* Makes a function `name` of one of the passes above; the rest says for which blocks. */
#define TD_PASS(name, pass, ...)                                                      \
    static void name(td_block *const *blocks, int count, const td_solve_context *c) { \
        pass(blocks, count, c, __VA_ARGS__);                                          \
    }

#endif
