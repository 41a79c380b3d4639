/* wide_aabb.c: contacts between axis-aligned boxes. Neither side rotates, so one point in the
 * middle of the common edge does the work of two. */
#include "wide_collide.h"

static void aabb_aabb(td_block *const *blocks, int count, const td_collide_context *c)
{
    f8 one = f8_all(1.0f), zero = f8_all(0.0f);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_pairs8 p = td_read_pairs(block, c);
        f8 sx = f8_abs(p.dx) - p.ahx - p.bhx, sy = f8_abs(p.dy) - p.ahy - p.bhy;
        i8 by_x = sx > sy;
        f8 separation = f8_max(sx, sy), other = f8_min(sx, sy);
        /* Corners that only pass each other do not touch. */
        i8 valid = td_used_mask(block) & (separation < f8_all(c->margin)) & (other < zero);
        block->nx = f8_keep(by_x, f8_flip(one, p.dx < zero));
        block->ny = f8_keep(~by_x, f8_flip(one, p.dy < zero));
        td_write_point(block, 0, c, valid, separation, zero, zero, zero, zero);
        block->touching = i8_bits(valid);
    }
}

extern const td_solve_ops TD_WIDE(td_solve_one);

extern const td_pair_ops TD_WIDE(td_pair_aabb_aabb);
const td_pair_ops TD_WIDE(td_pair_aabb_aabb) = {1, aabb_aabb, NULL, &TD_WIDE(td_solve_one)};
