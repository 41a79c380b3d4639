/* wide_aabb.c: manifolds of axis-aligned boxes. Neither body rotates, so that one point in the
 * middle of the shared edge is enough; its lever arms only say where it is, for the public view. */
#include "contact/pair_kinds.h"
#include "contact/wide_collide.h"

/* A td_collide_fn: the face with the greater separation gives the normal. */
static void aabb_aabb(td_block *const *blocks, int count, const td_collide_context *c) {
    f8 one = f8_all(1.0f), zero = f8_all(0.0f);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_block(blocks, i, count, 1);
        td_fetch_shapes(blocks, i, count, c);
        td_pairs8 p = td_read_pairs(block, c);
        f8 sx = f8_abs(p.dx) - p.ahx - p.bhx, sy = f8_abs(p.dy) - p.ahy - p.bhy;
        i8 by_x = sx > sy;
        f8 separation = f8_max(sx, sy), other = f8_min(sx, sy);
        /* Boxes must overlap along the other axis: corners that pass each other do not touch. */
        i8 valid = td_used_mask(block) & (separation < f8_all(c->margin)) & (other < zero);
        block->nx = f8_keep(by_x, f8_flip(one, p.dx < zero));
        block->ny = f8_keep(~by_x, f8_flip(one, p.dy < zero));
        /* The middle of what the boxes share along the edge, halfway between the faces. */
        f8 half = f8_all(0.5f);
        f8 reach_x = p.ahx + half * separation, reach_y = p.ahy + half * separation;
        f8 low_x = f8_max(-p.ahx, p.dx - p.bhx), high_x = f8_min(p.ahx, p.dx + p.bhx);
        f8 low_y = f8_max(-p.ahy, p.dy - p.bhy), high_y = f8_min(p.ahy, p.dy + p.bhy);
        f8 x = f8_pick(by_x, f8_flip(reach_x, p.dx < zero), half * (low_x + high_x));
        f8 y = f8_pick(by_x, half * (low_y + high_y), f8_flip(reach_y, p.dy < zero));
        td_found found = {valid, separation, p.ax + x, p.ay + y, p.bx + x - p.dx, p.by + y - p.dy};
        td_write_points(block, &found, 1, NULL, c);
        td_set_touching(block, i8_bits(valid), c);
    }
}

/* A td_sift_fn, by the exact separation. */
static td_sifted sift_aabbs(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, 0, c);
    f8 sx = f8_abs(p.dx) - p.ahx - p.bhx, sy = f8_abs(p.dy) - p.ahy - p.bhy;
    return td_sift(a, b, f8_max(sx, sy), c);
}

TD_AABB_PAIRS(TD_DEFINE_PAIR)
