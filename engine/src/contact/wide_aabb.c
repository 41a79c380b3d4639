/* wide_aabb.c: manifolds of axis-aligned boxes, eight pairs at a time. Neither body rotates, so
 * that one point in the middle of the edge that both boxes share is enough. Its lever arms have no
 * effect on the motion; contact_view.c and manifold.c compute its position from them. */
#include "contact/pair_kinds.h"
#include "contact/wide_collide.h"

enum { POINTS = 1 }; /* of a contact */

/* The separation of two boxes along an axis: `d` from centre to centre, `ha` and `hb` their half
 * extents. Negative where they overlap. */
TD_INLINE_SMALL f8 separation_along(f8 d, f8 ha, f8 hb) {
    return f8_abs(d) - ha - hb;
}

/* A td_collide_fn: the axis, x or y, with the greater separation gives the normal. */
static void aabb_aabb(td_block *const *blocks, int count, const td_collide_context *c) {
    f8 one = f8_all(1.0f), zero = f8_all(0.0f);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_block(blocks, i, count, POINTS);
        td_fetch_shapes(blocks, i, count, c);
        td_pairs8 p = td_read_pairs(block, c);
        f8 sx = separation_along(p.dx, p.ahx, p.bhx), sy = separation_along(p.dy, p.ahy, p.bhy);
        i8 normal_is_x = sx > sy;
        f8 separation = f8_max(sx, sy), along_edge = f8_min(sx, sy);
        /* Boxes must overlap along the edge: corners that pass each other do not touch. */
        i8 valid = td_used_mask(block) & (separation < f8_all(c->margin)) & (along_edge < zero);
        block->nx = f8_keep(normal_is_x, f8_flip(one, p.dx < zero));
        block->ny = f8_keep(~normal_is_x, f8_flip(one, p.dy < zero));
        /* The point, from the centre of a: along the normal halfway between the two faces, along
         * the edge in the middle of what both boxes cover. */
        f8 half = f8_all(0.5f);
        f8 between_x = p.ahx + half * separation, between_y = p.ahy + half * separation;
        f8 min_x = f8_max(-p.ahx, p.dx - p.bhx), max_x = f8_min(p.ahx, p.dx + p.bhx);
        f8 min_y = f8_max(-p.ahy, p.dy - p.bhy), max_y = f8_min(p.ahy, p.dy + p.bhy);
        f8 x = f8_pick(normal_is_x, f8_flip(between_x, p.dx < zero), half * (min_x + max_x));
        f8 y = f8_pick(normal_is_x, half * (min_y + max_y), f8_flip(between_y, p.dy < zero));
        td_found found = {
            .valid = valid,
            .separation = separation,
            .rax = p.ax + x, /* a's centre of mass to its shape's centre, and on to the point */
            .ray = p.ay + y,
            .rbx = p.bx + x - p.dx,
            .rby = p.by + y - p.dy,
        };
        td_write_points(block, &found, POINTS, NULL /* all lanes */, c);
        td_set_touching(block, i8_bits(valid), c);
    }
}

/* A td_sift_fn: of the waiting pairs whose fat bounds overlap, it keeps those whose boxes are
 * within the margin along both axes. The shapes' offsets in their bodies are not needed, and not
 * read. */
static td_sifted sift_aabbs(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, false, c);
    f8 sx = separation_along(p.dx, p.ahx, p.bhx), sy = separation_along(p.dy, p.ahy, p.bhy);
    return td_sift(a, b, f8_max(sx, sy), c);
}

/* Defines the table of the pair kind, which names both functions: pair_kinds.h. */
TD_AABB_PAIRS(TD_DEFINE_PAIR)
