/* wide_solve.h: the passes of the contact solver over blocks of one or two points.
 *
 * Soft contacts with substeps after E. Catto, "Solver2D" (2024): a soft solve with bias, then the
 * positions move, then a relax pass without bias takes the push out of the velocities. Rows hold
 * scalars along normal and tangent, rotation is linearised over the step. The relax pass leaves the
 * separation that it computed, and the next solve pass starts from it: nothing moves in between.
 * Friction acts in the relax pass only. */
#ifndef TD_WIDE_SOLVE_H
#define TD_WIDE_SOLVE_H

#include "block.h"

/* Velocities of both sides; side a stays zero where it is static. */
typedef struct sides {
    td_rows a, b;
} sides;

TD_INLINE sides read_sides(const td_block *block, const td_solve_context *c, bool fixed)
{
    f8 zero = f8_all(0.0f);
    sides v = {{zero, zero, zero, zero}, td_gather(c->velocity, block->b)};
    if (!fixed) {
        v.a = td_gather(c->velocity, block->a);
    }
    return v;
}

TD_INLINE void write_sides(const td_block *block, const td_solve_context *c, bool fixed, sides v)
{
    if (!fixed) {
        td_scatter(c->velocity, block->a, v.a);
    }
    td_scatter(c->velocity, block->b, v.b);
}

/* Impulse p along (x, y), whose arms' crosses are given. */
TD_INLINE void push(sides *v, const td_block *block, bool fixed, f8 x, f8 y, f8 cross_a, f8 cross_b,
                    f8 p)
{
    if (!fixed) {
        f8 ma = v->a.w * p;
        v->a.x -= ma * x;
        v->a.y -= ma * y;
        v->a.z -= block->inv_inertia_a * (cross_a * p);
    }
    f8 mb = v->b.w * p;
    v->b.x += mb * x;
    v->b.y += mb * y;
    v->b.z += block->inv_inertia_b * (cross_b * p);
}

TD_INLINE f8 speed_along(const sides *v, bool fixed, f8 x, f8 y, f8 cross_a, f8 cross_b)
{
    f8 speed = v->b.x * x + v->b.y * y + v->b.z * cross_b;
    return fixed ? speed : speed - (v->a.x * x + v->a.y * y + v->a.z * cross_a);
}

TD_INLINE void warm_start_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                                 int points, bool fixed)
{
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        sides v = read_sides(block, c, fixed);
        f8 nx = block->nx, ny = block->ny;
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            push(&v, block, fixed, nx, ny, p->cross_a, p->cross_b, p->normal_impulse);
            push(&v, block, fixed, ny, -nx, p->tangent_cross_a, p->tangent_cross_b,
                 p->tangent_impulse);
        }
        write_sides(block, c, fixed, v);
    }
}

TD_INLINE void solve_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, bool fixed)
{
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), inv_h = f8_all(c->inv_h);
    f8 bias_rate = f8_all(c->bias_rate[fixed]), most = f8_all(-c->push_speed);
    f8 mass_scale = f8_all(c->mass_scale[fixed]), impulse_scale = f8_all(c->impulse_scale[fixed]);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        sides v = read_sides(block, c, fixed);
        f8 nx = block->nx, ny = block->ny;
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            /* Apart: reach zero at the end of the substep at the earliest. Overlapping: a spring. */
            i8 apart = p->separation > zero;
            f8 bias = f8_pick(apart, p->separation * inv_h,
                              f8_max(p->separation * bias_rate, most));
            f8 scale = p->normal_mass * f8_pick(apart, one, mass_scale);
            f8 keep = f8_keep(~apart, impulse_scale);
            f8 speed = speed_along(&v, fixed, nx, ny, p->cross_a, p->cross_b);
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - scale * (speed + bias) - keep * old, zero);
            p->normal_impulse = now;
            push(&v, block, fixed, nx, ny, p->cross_a, p->cross_b, now - old);
        }
        write_sides(block, c, fixed, v);
    }
}

/* How far the contact opened since the start of the step, along (x, y). */
TD_INLINE f8 opened(const td_rows *da, const td_rows *db, bool fixed, const td_block *block,
                    const td_point *p)
{
    f8 d = db->x * block->nx + db->y * block->ny + db->z * p->cross_b;
    return fixed ? d : d - (da->x * block->nx + da->y * block->ny + da->z * p->cross_a);
}

TD_INLINE void relax_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                            int points, bool fixed)
{
    f8 zero = f8_all(0.0f), inv_h = f8_all(c->inv_h);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        sides v = read_sides(block, c, fixed);
        td_rows da = {zero, zero, zero, zero}, db = td_gather(c->delta, block->b);
        if (!fixed) {
            da = td_gather(c->delta, block->a);
        }
        f8 nx = block->nx, ny = block->ny;
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            f8 limit = block->friction * p->normal_impulse;
            f8 slide = speed_along(&v, fixed, ny, -nx, p->tangent_cross_a, p->tangent_cross_b);
            f8 old = p->tangent_impulse;
            f8 now = f8_clamp(old - p->tangent_mass * slide, -limit, limit);
            p->tangent_impulse = now;
            push(&v, block, fixed, ny, -nx, p->tangent_cross_a, p->tangent_cross_b, now - old);
        }
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            f8 separation = p->base + opened(&da, &db, fixed, block, p);
            p->separation = separation;
            f8 bias = f8_max(separation, zero) * inv_h;
            f8 speed = speed_along(&v, fixed, nx, ny, p->cross_a, p->cross_b);
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - p->normal_mass * (speed + bias), zero);
            p->normal_impulse = now;
            push(&v, block, fixed, nx, ny, p->cross_a, p->cross_b, now - old);
        }
        if (c->keep_totals) {
            for (int k = 0; k < points; k++) {
                block->point[k].total += block->point[k].normal_impulse;
            }
        }
        write_sides(block, c, fixed, v);
    }
}

/* Restitution, once after all substeps: a point that closed in fast and was really pushed leaves
 * with its share of the speed. */
TD_INLINE void bounce_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                             int points, bool fixed)
{
    f8 zero = f8_all(0.0f), threshold = f8_all(-c->bounce_speed);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        if (!block->bouncy) {
            continue;
        }
        sides v = read_sides(block, c, fixed);
        f8 nx = block->nx, ny = block->ny;
        for (int k = 0; k < points; k++) {
            td_point *p = &block->point[k];
            i8 hit = (p->approach < threshold) & (p->total > zero) &
                     (block->restitution > zero);
            f8 speed = speed_along(&v, fixed, nx, ny, p->cross_a, p->cross_b);
            f8 old = p->normal_impulse;
            f8 now = f8_max(old - p->normal_mass * (speed + block->restitution * p->approach),
                            zero);
            now = f8_pick(hit, now, old);
            p->normal_impulse = now;
            p->total += now - old;
            push(&v, block, fixed, nx, ny, p->cross_a, p->cross_b, now - old);
        }
        write_sides(block, c, fixed, v);
    }
}

/* The eight passes for blocks of `points` points, as one table `td_solve_<word>`. */
#define TD_SOLVE_PASSES(points)                                                                    \
    static void warm_start_moving(td_block *const *b, int n, const td_solve_context *c)            \
    {                                                                                              \
        warm_start_blocks(b, n, c, points, false);                                                 \
    }                                                                                              \
    static void warm_start_fixed(td_block *const *b, int n, const td_solve_context *c)             \
    {                                                                                              \
        warm_start_blocks(b, n, c, points, true);                                                  \
    }                                                                                              \
    static void solve_moving(td_block *const *b, int n, const td_solve_context *c)                 \
    {                                                                                              \
        solve_blocks(b, n, c, points, false);                                                      \
    }                                                                                              \
    static void solve_fixed(td_block *const *b, int n, const td_solve_context *c)                  \
    {                                                                                              \
        solve_blocks(b, n, c, points, true);                                                       \
    }                                                                                              \
    static void relax_moving(td_block *const *b, int n, const td_solve_context *c)                 \
    {                                                                                              \
        relax_blocks(b, n, c, points, false);                                                      \
    }                                                                                              \
    static void relax_fixed(td_block *const *b, int n, const td_solve_context *c)                  \
    {                                                                                              \
        relax_blocks(b, n, c, points, true);                                                       \
    }                                                                                              \
    static void bounce_moving(td_block *const *b, int n, const td_solve_context *c)                \
    {                                                                                              \
        bounce_blocks(b, n, c, points, false);                                                     \
    }                                                                                              \
    static void bounce_fixed(td_block *const *b, int n, const td_solve_context *c)                 \
    {                                                                                              \
        bounce_blocks(b, n, c, points, true);                                                      \
    }

#define TD_SOLVE_TABLE                                                                             \
    {{warm_start_moving, warm_start_fixed},                                                        \
     {solve_moving, solve_fixed},                                                                  \
     {relax_moving, relax_fixed},                                                                  \
     {bounce_moving, bounce_fixed}}

#endif
