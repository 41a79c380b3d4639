/* wide_manifold_cache.h: reuses a manifold while the two shapes hardly move against each other
 * (contact recycling in Box2D v3.2, whose idea it is).
 *
 * Resting contacts then cost a fraction of the narrowphase. Besides, contact points that do not
 * move keep soft stacks standing: with points chosen anew in every step, a column of 30 boxes leans
 * over within eight seconds. Normal, lever arms and effective masses are kept. Separations are
 * updated to first order, from the poses for which the manifold was computed, so that errors do not
 * add up:
 *     separation = kept separation + n . (relative motion of the centres)
 *                  + turn_b (r_b x n) - turn_a (r_a x n) */
#ifndef TD_WIDE_MANIFOLD_CACHE_H
#define TD_WIDE_MANIFOLD_CACHE_H

#include "contact/wide_collide.h"

/* A manifold is kept only while neither body has rotated by more than the angle with this sine,
 * about three degrees, since it was computed. The kept normal does not rotate with the body, so
 * that up to this share of an impulse along it acts across the true normal. Chosen. */
#define TD_KEEP_TURN 0.05f
/* Maximum relative motion since then: the lesser of TD_KEEP_SHARE of the smallest half extent and
 * TD_KEEP_MARGINS times the speculative margin. For a lane with one point it is only
 * TD_KEEP_MARGINS_ONE times that margin, so that a second point is found before it overlaps.
 * Chosen. */
#define TD_KEEP_SHARE 0.1f
#define TD_KEEP_MARGINS 2.5f
#define TD_KEEP_MARGINS_ONE 0.5f

/* Motion since the manifold was computed: of b relative to a, and the rotation of each (its sine).
 */
typedef struct td_moved {
    f8 dx, dy;
    f8 turn_a, turn_b;
    i8 small_turn; /* both rotations are below TD_KEEP_TURN */
} td_moved;

/* Sine of the rotation from (old_c, old_s) to (c, s); returns whether it is small. */
TD_INLINE i8 small_turn(f8 c, f8 s, f8 old_c, f8 old_s, f8 *turn) {
    *turn = s * old_c - c * old_s;
    return (f8_abs(*turn) < f8_all(TD_KEEP_TURN)) & (c * old_c + s * old_s > f8_all(0.0f));
}

/* The lanes whose manifold may be kept, and their separations for the present poses. Separations of
 * other lanes are written, too, and mean nothing. */
TD_INLINE i8 td_cached_lanes(td_block *block, int points, const td_moved *moved,
                             const td_collide_context *c, f8 *separation) {
    const td_manifold_cache *kept = td_manifold_cache_of(block, points);
    f8 zero = f8_all(0.0f), margin = f8_all(c->margin);
    f8 motion =
        f8_abs(moved->dx) + f8_abs(moved->dy) + kept->reach * f8_abs(moved->turn_a - moved->turn_b);
    f8 along = moved->dx * block->nx + moved->dy * block->ny;
    i8 touches = zero < zero, whole = zero == zero;
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        i8 here = p->normal_mass > zero;
        separation[k] =
            kept->separation[k] + along + moved->turn_b * p->cross_b - moved->turn_a * p->cross_a;
        touches |= here & (separation[k] < margin);
        whole &= here;
    }
    f8 limit =
        f8_pick(whole, kept->limit, f8_min(kept->limit, f8_all(TD_KEEP_MARGINS_ONE) * margin));
    return (motion < limit) & moved->small_turn & touches & td_used_mask(block);
}

/* Writes the separations of kept lanes, and the normal velocities of blocks with restitution. */
TD_INLINE void td_cache_update_points(td_block *block, int points, i8 keep, const f8 *separation,
                                      const td_collide_context *c) {
    for (int k = 0; k < points; k++) {
        td_point *point = &block->point[k];
        i8 here = keep & (point->normal_mass > f8_all(0.0f));
        point->start_separation = f8_pick(here, separation[k], point->start_separation);
        point->separation = f8_pick(here, separation[k], point->separation);
    }
    if (!block->bouncy) {
        return;
    }
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    for (int k = 0; k < points; k++) {
        const td_point *point = &block->point[k];
        td_point_history *history = &td_history_of(block, points)[k];
        f8 normal_velocity = (vb.x - va.x) * block->nx + (vb.y - va.y) * block->ny +
                             vb.z * point->cross_b - va.z * point->cross_a;
        history->normal_velocity = f8_pick(keep, normal_velocity, history->normal_velocity);
    }
}

/* Stores separations and motion limits of the lanes in `recomputed`, whose manifold has just been
 * computed; `min_extent` and `max_extent` are the smallest and the largest half extent of the pair.
 */
TD_INLINE void td_cache_store(td_block *block, int points, i8 recomputed, f8 min_extent,
                              f8 max_extent, const td_collide_context *c) {
    td_manifold_cache *kept = td_manifold_cache_of(block, points);
    /* The contact point of a rolling circle moves along its rim, so that its lever arm has to be
     * computed anew after a shorter motion. */
    float margins = points == 1 ? TD_KEEP_MARGINS_ONE : TD_KEEP_MARGINS;
    f8 limit = f8_min(f8_all(TD_KEEP_SHARE) * min_extent, f8_all(margins * c->margin));
    kept->limit = f8_pick(recomputed, limit, kept->limit);
    kept->reach = f8_pick(recomputed, max_extent, kept->reach);
    for (int k = 0; k < points; k++) {
        kept->separation[k] =
            f8_pick(recomputed, block->point[k].start_separation, kept->separation[k]);
    }
}

#endif
