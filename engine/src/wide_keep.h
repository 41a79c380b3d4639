/* wide_keep.h: keeping a manifold while its pair hardly moves.
 *
 * Box2D v3.2 calls this contact recycling; the idea is its author's. It matters twice: resting
 * contacts cost a fraction of the narrowphase, and anchors that stay put make soft stacks stand
 * that would slowly buckle if every step chose them anew (a column of 30 boxes leans over within
 * eight seconds without it). Normal, arms and masses stay; separations follow the poses to first
 * order, from the poses of the manifold, so that nothing accumulates. */
#ifndef TD_WIDE_KEEP_H
#define TD_WIDE_KEEP_H

#include "wide_collide.h"

/* Rotation of either body for which a world-fixed normal is still good: about three degrees. */
#define TD_KEEP_TURN 0.05f
/* Relative motion, in multiples of the smallest half extent and of the speculative margin. A lane
 * with a single point looks for its second one sooner, before that could overlap. */
#define TD_KEEP_SHARE 0.1f
#define TD_KEEP_MARGINS 2.5f
#define TD_KEEP_MARGINS_ONE 0.5f

/* Separation of point k for the present poses. */
TD_INLINE f8 td_keep_separation(td_block *block, const td_pairs8 *p, int k)
{
    const td_second *kept = td_second_of(block);
    const td_point *point = &block->point[k];
    f8 dx = (p->dx - p->bx + p->ax) - kept->dx, dy = (p->dy - p->by + p->ay) - kept->dy;
    f8 turn_a = p->as * kept->ac - p->ac * kept->as, turn_b = p->bs * kept->bc - p->bc * kept->bs;
    return kept->base[k] + (dx * block->nx + dy * block->ny) + turn_b * point->cross_b -
           turn_a * point->cross_a;
}

/* The lanes whose manifold may be kept; p is their present pose. */
TD_INLINE i8 td_keep_mask(td_block *block, const td_pairs8 *p, const td_collide_context *c)
{
    const td_second *kept = td_second_of(block);
    f8 zero = f8_all(0.0f), margin = f8_all(c->margin);
    f8 dx = (p->dx - p->bx + p->ax) - kept->dx, dy = (p->dy - p->by + p->ay) - kept->dy;
    f8 turn_a = p->as * kept->ac - p->ac * kept->as, turn_b = p->bs * kept->bc - p->bc * kept->bs;
    f8 cos_a = p->ac * kept->ac + p->as * kept->as, cos_b = p->bc * kept->bc + p->bs * kept->bs;
    f8 least = f8_min(f8_min(p->ahx, p->ahy), f8_min(p->bhx, p->bhy));
    f8 most = f8_max(f8_max(p->ahx, p->ahy), f8_max(p->bhx, p->bhy));
    i8 has0 = block->point[0].normal_mass > zero, has1 = block->point[1].normal_mass > zero;
    f8 margins = f8_pick(has0 & has1, f8_all(TD_KEEP_MARGINS), f8_all(TD_KEEP_MARGINS_ONE));
    f8 limit = f8_min(f8_all(TD_KEEP_SHARE) * least, margins * margin);
    f8 motion = f8_abs(dx) + f8_abs(dy) + most * f8_abs(turn_a - turn_b);
    i8 near_turn = (f8_abs(turn_a) < f8_all(TD_KEEP_TURN)) &
                   (f8_abs(turn_b) < f8_all(TD_KEEP_TURN)) & (cos_a > zero) & (cos_b > zero);
    i8 touches = (has0 & (td_keep_separation(block, p, 0) < margin)) |
                 (has1 & (td_keep_separation(block, p, 1) < margin));
    return (motion < limit) & near_turn & touches & td_used_mask(block);
}

/* Notes the poses of the lanes in `fresh`, whose manifold has just been made. */
TD_INLINE void td_keep_note(td_block *block, const td_pairs8 *p, i8 fresh)
{
    td_second *kept = td_second_of(block);
    kept->dx = f8_pick(fresh, p->dx - p->bx + p->ax, kept->dx);
    kept->dy = f8_pick(fresh, p->dy - p->by + p->ay, kept->dy);
    kept->ac = f8_pick(fresh, p->ac, kept->ac);
    kept->as = f8_pick(fresh, p->as, kept->as);
    kept->bc = f8_pick(fresh, p->bc, kept->bc);
    kept->bs = f8_pick(fresh, p->bs, kept->bs);
    for (int k = 0; k < 2; k++) {
        kept->base[k] = f8_pick(fresh, block->point[k].base, kept->base[k]);
    }
}

/* Separations and closing speeds of the kept lanes for the present poses. */
TD_INLINE void td_keep_follow(td_block *block, const td_pairs8 *p, i8 keep,
                              const td_collide_context *c)
{
    f8 zero = f8_all(0.0f);
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    for (int k = 0; k < 2; k++) {
        td_point *point = &block->point[k];
        i8 here = keep & (point->normal_mass > zero);
        f8 base = td_keep_separation(block, p, k);
        f8 approach = (vb.x - va.x) * block->nx + (vb.y - va.y) * block->ny +
                      vb.z * point->cross_b - va.z * point->cross_a;
        point->base = f8_pick(here, base, point->base);
        point->separation = f8_pick(here, base, point->separation);
        point->approach = f8_pick(here, approach, point->approach);
        point->total = zero;
    }
}

#endif
