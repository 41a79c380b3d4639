/* wide_bounce.h: restitution, over blocks of one or two points.
 *
 * Before all substeps points that close in fast, and are going to meet in this step, part at once:
 * each pair by itself, so that none gains energy; and again, while what they did has others close
 * in, so that a row hands on what hits it. The solver then finds nothing to stop. Where it has
 * stopped something all the same, as what stands on ground that does not bounce, a last pass after
 * it gives the pair its speed back, with no more than the energy that it had. */
#ifndef TD_WIDE_BOUNCE_H
#define TD_WIDE_BOUNCE_H

#include "solver/wide_solve.h"

TD_INLINE f8 over(f8 x, f8 inverse) {
    return f8_keep(inverse > f8_all(0.0f), x / inverse);
}

/* Twice the kinetic energy of what can be moved of a pair. */
TD_INLINE f8 energy_of(const td_block *block, const sides *v) {
    return over(v->a.x * v->a.x + v->a.y * v->a.y, v->a.w) +
           over(v->b.x * v->b.x + v->b.y * v->b.y, v->b.w) +
           over(v->a.z * v->a.z, block->inv_inertia_a) +
           over(v->b.z * v->b.z, block->inv_inertia_b);
}

/* Velocities without what the substeps have let fall. */
TD_INLINE td_rows unfallen(td_rows v, td_rows push, f8 substeps) {
    return (td_rows){v.x - substeps * push.x, v.y - substeps * push.y, v.z - substeps * push.z,
                     v.w};
}

/* Impulses that take what the points lack that are hit. Of two both act at once, if both push; or
 * else the one after which the other lacks nothing. */
TD_INLINE void take_lacks(const td_block *block, const sides *v, int points, const i8 *hit,
                          const f8 *lacks, f8 *normal) {
    f8 m = block->point[0].normal_mass;
    normal[0] = f8_keep(hit[0], -m * lacks[0]);
    if (points == 2) {
        f8 zero = f8_all(0.0f), n = block->point[1].normal_mass;
        f8 other = by_first(block, v, false), part = f8_all(1.0f) - other * other * m * n;
        f8 p = m * (other * n * lacks[1] - lacks[0]) / part;
        f8 q = n * (other * m * lacks[0] - lacks[1]) / part;
        /* Points in one place would share it at random. */
        i8 both = hit[0] & hit[1] & (p > zero) & (q > zero) & (part > f8_all(0.001f));
        i8 first = hit[0] & (~hit[1] | (lacks[1] + other * normal[0] >= zero));
        normal[1] = f8_pick(both, q, f8_keep(hit[1] & ~first, -n * lacks[1]));
        normal[0] = f8_pick(both, p, f8_keep(first, normal[0]));
    }
}

/* Friction, by the normal impulses of the bounce. */
TD_INLINE f8 rub_off(const td_solve_context *c, td_block *block, int points, const sides *v,
                     const f8 *normal) {
    f8 slide = centres_along(v, false, block->ny, -block->nx);
    slide = at_arms(slide, v, false, block->tangent_cross_a, block->tangent_cross_b);
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        slide += coupling(block, false, p->cross_a, p->cross_b, block->tangent_cross_a,
                          block->tangent_cross_b) *
                 normal[k];
    }
    if (c->surface_speeds) {
        slide -= td_surface_at(block, points)->speed;
    }
    f8 limit =
        td_friction_bound8(block->friction, points == 2 ? normal[0] + normal[1] : normal[0], slide);
    return f8_clamp(-block->tangent_mass * slide, -limit, limit);
}

/* Static sides are read as the dummy, which is at rest and has no mass. */
TD_INLINE void bounce_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                             int points) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), half = f8_all(0.5f);
    bool last = c->bounce == TD_BOUNCE_LAST, any = false;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        bool fixed = block->a[0] == 0;
        if (!block->bouncy || (fixed && last)) {
            continue;
        }
        td_surface *surface = td_surface_at(block, points);
        td_point_history *history = td_history_of(block, points);
        if (c->bounce == TD_BOUNCE_FIRST) {
            surface->energy = -one;
            surface->total = zero;
            for (int k = 0; k < points; k++) {
                history[k].total = zero;
            }
        }
        sides v = read_sides(c->velocity, block, fixed), g = read_sides(c->push, block, fixed);
        f8 closing = centres_along(&v, false, block->nx, block->ny);
        f8 falling = centres_along(&g, false, block->nx, block->ny);
        f8 e = block->restitution, speed[2], wanted[2], lacks[2];
        f8 slow = f8_pick(e < one, f8_all(c->bounce_speed), f8_all(c->elastic_speed));
        i8 bounced = surface->energy >= zero, hit[2], hits = bounced ^ bounced;
        f8 share = f8_pick(bounced, f8_min(e, one), e); /* what is above 1 it gets once */
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            speed[k] = at_point(closing, &v, false, ARMS_ALL, p);
            if (last) {
                wanted[k] = -e * history[k].approach;
                hit[k] = bounced & (speed[k] < wanted[k]);
            } else {
                /* Substeps let fall, then move: by half of one's fall speeds are behind where
                 * bodies are, and an impact would lose as much. */
                f8 behind = half * at_point(falling, &g, false, ARMS_ALL, p);
                wanted[k] = -share * (speed[k] + behind) - behind;
                hit[k] = (speed[k] < slow) & (e > zero) &
                         (p->base + speed[k] * f8_all(c->time_step) < f8_all(c->fall));
            }
            lacks[k] = speed[k] - wanted[k];
            hits |= hit[k];
        }
        if (!last && i8_bits(bounced | hits)) {
            surface->energy = f8_pick(bounced | hits, energy_of(block, &v), surface->energy);
        }
        if (!i8_bits(hits)) {
            continue;
        }
        any = true;
        impulses change = {{zero, zero}, zero};
        take_lacks(block, &v, points, hit, lacks, change.normal);
        if (last) {
            f8 gain = change.normal[0] * (speed[0] + wanted[0]), substeps = f8_all(c->substeps);
            if (points == 2) {
                gain += change.normal[1] * (speed[1] + wanted[1]);
            }
            sides before = {unfallen(v.a, g.a, substeps), unfallen(v.b, g.b, substeps)};
            f8 room = f8_max(surface->energy - energy_of(block, &before), zero);
            f8 part = f8_pick(gain > room, room / gain, one);
            change.normal[0] *= part;
            change.normal[1] *= part;
        }
        for (int k = 0; k < points; k++) {
            history[k].total += change.normal[k];
        }
        if (i8_bits(block->friction > zero)) {
            change.tangent = rub_off(c, block, points, &v, change.normal);
            surface->total += change.tangent;
        }
        push(c, block, points, ARMS_ALL, fixed, true, v, change);
    }
    if (any) {
        atomic_store_explicit(c->bounced, true, memory_order_relaxed);
    }
}

#endif
