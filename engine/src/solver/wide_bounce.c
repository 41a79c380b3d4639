/* wide_bounce.c: restitution by Newton's impact law, v_after = -e v_before along the normal,
 * over blocks of one or two points.
 *
 * Before the substeps, a point that closes faster than a threshold and will touch within the step,
 * or the substep after it, gets its impulse at once, one contact after the other (sequential
 * impacts), so that no pair gains energy. Passes are repeated while an impact makes another contact
 * close, so that an impact at one end of a row of balls is passed on to its other end. The soft
 * solver then finds separating contacts. Where it has stopped a pair all the same, as a body on
 * ground without restitution, a last pass after the substeps (TD_BOUNCE_LAST) gives the pair its
 * speed back, with no more energy than the pair had. */
#include "solver/motion.h"
#include "solver/wide_solve.h"

/* x / inverse, and 0 for an infinite mass (inverse 0). */
TD_INLINE f8 divide_by_inverse(f8 x, f8 inverse) {
    return f8_keep(inverse > f8_all(0.0f), x / inverse);
}

/* Twice the kinetic energy of both bodies, m v^2 + I w^2 each; the share of an infinite mass or
 * inertia, which an impulse does not change, is left out. */
TD_INLINE f8 energy_of(const td_block *block, const sides *v) {
    return divide_by_inverse(v->a.x * v->a.x + v->a.y * v->a.y, v->a.w) +
           divide_by_inverse(v->b.x * v->b.x + v->b.y * v->b.y, v->b.w) +
           divide_by_inverse(v->a.z * v->a.z, block->inv_inertia_a) +
           divide_by_inverse(v->b.z * v->b.z, block->inv_inertia_b);
}

/* Velocities without what gravity and forces have added in the substeps. */
TD_INLINE td_rows without_forces(td_rows v, td_rows substep_gain, f8 substeps) {
    return (td_rows){v.x - substeps * substep_gain.x, v.y - substeps * substep_gain.y,
                     v.z - substeps * substep_gain.z, v.w};
}

/* The normal impulses of the points that are hit; `lacks` is their speed less the target speed,
 * which is negative. With the effective masses m and n of the two points and their coupling k, both
 * impulses p, q together solve
 *     p / m + k q = -lacks[0],   k p + q / n = -lacks[1],
 * a complementarity problem: if one of them is not positive, the other point's impulse alone must
 * satisfy both. */
TD_INLINE void solve_impacts(const td_block *block, const sides *v, int points, const i8 *hit,
                             const f8 *lacks, f8 *normal) {
    f8 m = block->point[0].normal_mass;
    normal[0] = f8_keep(hit[0], -m * lacks[0]);
    if (points == 2) {
        f8 zero = f8_all(0.0f), n = block->point[1].normal_mass;
        f8 other = by_first(block, v, false), part = f8_all(1.0f) - other * other * m * n;
        f8 p = m * (other * n * lacks[1] - lacks[0]) / part;
        f8 q = n * (other * m * lacks[0] - lacks[1]) / part;
        /* `part` is the determinant times m n. It is 0 for two points in one place; below 0.001 the
         * difference has less than four correct digits. */
        i8 both = hit[0] & hit[1] & (p > zero) & (q > zero) & (part > f8_all(0.001f));
        i8 first = hit[0] & (~hit[1] | (lacks[1] + other * normal[0] >= zero));
        normal[1] = f8_pick(both, q, f8_keep(hit[1] & ~first, -n * lacks[1]));
        normal[0] = f8_pick(both, p, f8_keep(first, normal[0]));
    }
}

/* The friction impulse of an impact: the one that stops the sliding that is left after the normal
 * impulses, but at most friction times these (Coulomb's bound). */
TD_INLINE f8 impact_friction(const td_solve_context *c, td_block *block, int points, const sides *v,
                             const f8 *normal) {
    f8 slip = centres_along(v, false, block->ny, -block->nx);
    slip = at_arms(slip, v, false, block->tangent_cross_a, block->tangent_cross_b);
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        slip += coupling(block, false, p->cross_a, p->cross_b, block->tangent_cross_a,
                         block->tangent_cross_b) *
                normal[k];
    }
    if (c->surface_speeds) {
        slip -= td_surface_at(block, points)->speed;
    }
    f8 bound =
        td_friction_bound8(block->friction, points == 2 ? normal[0] + normal[1] : normal[0], slip);
    return f8_clamp(-block->tangent_mass * slip, -bound, bound);
}

/* Marks the dynamic bodies of the lanes in `bits` for td_end_flights: sets the fourth value of
 * their delta. */
TD_INLINE void mark_flights(const td_solve_context *c, const td_block *block, unsigned bits) {
    for (; bits; bits &= bits - 1) {
        int lane = __builtin_ctz(bits);
        for (int k = 0; k < 2; k++) {
            td_awake_slot slot = td_slot_of_side(k ? block->b[lane] : block->a[lane]);
            if (slot.at > 0 && c->velocity[slot.at][3] > 0.0f) {
                c->delta[slot.at][3] = 1.0f;
            }
        }
    }
}

/* One bounce pass over blocks. Static bodies are read as slot 0, which is at rest and has an
 * inverse mass of 0. */
TD_INLINE void bounce_blocks(td_block *const *blocks, int count, const td_solve_context *c,
                             int points) {
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    bool last = c->bounce == TD_BOUNCE_LAST, any = false;
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        bool a_static = block->a[0] == 0;
        if (!block->bouncy || (a_static && last)) {
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
        sides v = read_sides(c->velocity, block, a_static);
        f8 closing = centres_along(&v, false, block->nx, block->ny);
        f8 e = block->restitution, speed[2], target[2], lacks[2];
        f8 slow = f8_pick(e < one, f8_all(c->bounce_speed), f8_all(c->elastic_speed));
        i8 bounced = surface->energy >= zero, hit[2], hits = bounced ^ bounced, fast = hits;
        f8 share =
            f8_pick(bounced, f8_min(e, one), e); /* a restitution above 1 adds energy once a step */
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            speed[k] = at_point(closing, &v, false, ARMS_ALL, p);
            if (last) {
                target[k] = -e * history[k].normal_velocity;
                hit[k] = bounced & (speed[k] < target[k]);
            } else {
                target[k] = -share * speed[k];
                /* The point closes fast enough, and its gap at the end of bounce_time would be
                 * below `fall`, g time_step^2, the distance that gravity can close in addition. */
                hit[k] =
                    (speed[k] < slow) & (e > zero) &
                    (p->start_separation + speed[k] * f8_all(c->bounce_time) < f8_all(c->fall));
            }
            lacks[k] = speed[k] - target[k];
            fast |= (e > zero) & (f8_abs(speed[k]) > -slow);
            hits |= hit[k];
        }
        if (!last && i8_bits(bounced | hits)) {
            surface->energy = f8_pick(bounced | hits, energy_of(block, &v), surface->energy);
        }
        if (c->bounce == TD_BOUNCE_FIRST) {
            mark_flights(c, block, i8_bits(fast));
        }
        if (!i8_bits(hits)) {
            continue;
        }
        any = true;
        impulses change = {{zero, zero}, zero};
        solve_impacts(block, &v, points, hit, lacks, change.normal);
        if (last) {
            /* An impulse p that changes the speed at its point from u to u' does the work p (u +
             * u') / 2: it adds p (u + u') to twice the energy. */
            f8 gain = change.normal[0] * (speed[0] + target[0]), substeps = f8_all(c->substeps);
            if (points == 2) {
                gain += change.normal[1] * (speed[1] + target[1]);
            }
            sides g = read_sides(c->substep_gain, block, a_static);
            sides before = {without_forces(v.a, g.a, substeps), without_forces(v.b, g.b, substeps)};
            f8 room = f8_max(surface->energy - energy_of(block, &before), zero);
            f8 part = f8_pick(gain > room, room / gain, one);
            change.normal[0] *= part;
            change.normal[1] *= part;
        }
        for (int k = 0; k < points; k++) {
            history[k].total += change.normal[k];
        }
        if (i8_bits(block->friction > zero)) {
            change.tangent = impact_friction(c, block, points, &v, change.normal);
            surface->total += change.tangent;
        }
        apply_impulses(c, block, points, ARMS_ALL, a_static, true, v, change);
    }
    if (any) {
        atomic_store_explicit(c->bounced, true, memory_order_relaxed);
    }
}

td_solve_fn TD_WIDE(td_bounce_one);
void TD_WIDE(td_bounce_one)(td_block *const *blocks, int count, const td_solve_context *c) {
    bounce_blocks(blocks, count, c, 1);
}

td_solve_fn TD_WIDE(td_bounce_two);
void TD_WIDE(td_bounce_two)(td_block *const *blocks, int count, const td_solve_context *c) {
    bounce_blocks(blocks, count, c, 2);
}

/* The share of a velocity that counts as its rounding: two units of single precision of the
 * velocity at either end of a substep. */
#define ROUNDING 0x1p-22f

/* Moves a marked body on to the exact path where only gravity and forces have changed its velocity,
 * and removes the mark. Substeps of semi-implicit Euler, with a gain g in each of n substeps, have
 * moved what ends with v by n h (v - g (n - 1) / 2); the path is n h (v - n g / 2). */
static void end_flight(const td_motion_context *c, int i) {
    float n = (float)c->substeps, time = n * c->h;
    for (int k = 0; k < 3; k++) {
        float v = c->velocity[i][k], start = c->start[i][k], gain = c->substep_gain[i][k];
        float tolerance = ROUNDING * (__builtin_fabsf(start) + __builtin_fabsf(v));
        float way = time * (v - 0.5f * (n - 1.0f) * gain), *delta = &c->delta[i][k];
        if (__builtin_fabsf(v - start - gain) <= tolerance &&
            __builtin_fabsf(*delta - way) <= tolerance * time) {
            *delta -= 0.5f * time * gain;
        }
    }
    c->delta[i][3] = 0.0f;
}

td_end_flights_fn TD_WIDE(td_end_flights);
void TD_WIDE(td_end_flights)(const td_motion_context *c) {
    for (int i = 0; i < c->count; i++) {
        if (c->delta[i][3] > 0.0f) {
            end_flight(c, i);
        }
    }
}
