/* wide_manifold_cache.h: keeping a manifold while its pair hardly moves.
 *
 * Box2D v3.2 calls this contact recycling; the idea is its author's. It matters twice: resting
 * contacts cost a fraction of the narrowphase, and anchors that stay put make soft stacks stand
 * that would slowly buckle if every step chose them anew (a column of 30 boxes leans over within
 * eight seconds without it). Normal, arms and masses stay; separations follow the poses to first
 * order, from the poses of the manifold, so that nothing accumulates. */
#ifndef TD_WIDE_KEEP_H
#define TD_WIDE_KEEP_H

#include "contact/wide_collide.h"

/* Rotation of either body for which a world-fixed normal is still good: about three degrees. */
#define TD_KEEP_TURN 0.05f
/* Relative motion, in multiples of the smallest half extent and of the speculative margin. A lane
 * with a single point looks for its second one sooner, before that could overlap. */
#define TD_KEEP_SHARE 0.1f
#define TD_KEEP_MARGINS 2.5f
#define TD_KEEP_MARGINS_ONE 0.5f

/* How a pair has moved since its manifold was made: b against a, and each by itself. */
typedef struct td_moved {
    f8 dx, dy;
    f8 turn_a, turn_b;
    i8 small_turn;
} td_moved;

TD_INLINE i8 small_turn(f8 c, f8 s, f8 old_c, f8 old_s, f8 *turn) {
    *turn = s * old_c - c * old_s;
    return (f8_abs(*turn) < f8_all(TD_KEEP_TURN)) & (c * old_c + s * old_s > f8_all(0.0f));
}

/* Separations of the kept lanes for the present poses, and the lanes that may be kept. The first
 * `points` of separation are written for all lanes; only those of kept ones mean something. */
TD_INLINE i8 td_keep_mask(td_block *block, int points, const td_moved *moved,
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
            kept->base[k] + along + moved->turn_b * p->cross_b - moved->turn_a * p->cross_a;
        touches |= here & (separation[k] < margin);
        whole &= here;
    }
    f8 limit =
        f8_pick(whole, kept->limit, f8_min(kept->limit, f8_all(TD_KEEP_MARGINS_ONE) * margin));
    return (motion < limit) & moved->small_turn & touches & td_used_mask(block);
}

/* Writes the separations of the kept lanes, and closing speeds where they may bounce. */
TD_INLINE void td_keep_follow(td_block *block, int points, i8 keep, const f8 *separation,
                              const td_collide_context *c) {
    for (int k = 0; k < points; k++) {
        td_point *point = &block->point[k];
        i8 here = keep & (point->normal_mass > f8_all(0.0f));
        point->base = f8_pick(here, separation[k], point->base);
        point->separation = f8_pick(here, separation[k], point->separation);
    }
    if (!block->bouncy) {
        return;
    }
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    for (int k = 0; k < points; k++) {
        const td_point *point = &block->point[k];
        td_point_history *history = &td_history_of(block, points)[k];
        f8 approach = (vb.x - va.x) * block->nx + (vb.y - va.y) * block->ny +
                      vb.z * point->cross_b - va.z * point->cross_a;
        history->approach = f8_pick(keep, approach, history->approach);
    }
}

/* Notes separations and limits of the lanes in `fresh`, whose manifold has just been made; `least`
 * and `most` are the half extents of the pair. */
TD_INLINE void td_keep_note(td_block *block, int points, i8 fresh, f8 least, f8 most,
                            const td_collide_context *c) {
    td_manifold_cache *kept = td_manifold_cache_of(block, points);
    /* A circle rolls on: its arm is to be made anew much sooner. */
    float margins = points == 1 ? TD_KEEP_MARGINS_ONE : TD_KEEP_MARGINS;
    f8 limit = f8_min(f8_all(TD_KEEP_SHARE) * least, f8_all(margins * c->margin));
    kept->limit = f8_pick(fresh, limit, kept->limit);
    kept->reach = f8_pick(fresh, most, kept->reach);
    for (int k = 0; k < points; k++) {
        kept->base[k] = f8_pick(fresh, block->point[k].base, kept->base[k]);
    }
}

#endif
