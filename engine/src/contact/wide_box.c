/* wide_box.c: manifolds of boxes of which at least one is oriented, by the separating axis test and
 * clipping (Gottschalk et al., "OBBTree", 1996; Catto, "Contact manifolds", GDC 2007).
 *
 * The axis with the largest separation gives the reference face. The face of the other box that is
 * most opposed to it, the incident edge, is clipped to the reference face's sides and leaves up to
 * two points. Everything is computed in a frame whose +x axis is the reference face's normal, so
 * that eight pairs with different axes run the same instructions with masks. A manifold's feature
 * is the pair of its two faces, whichever is the reference, and its points are ordered along the
 * tangent, so that impulses stay with their points when the roles of the boxes change. */
#include "contact/pair_kinds.h"
#include "contact/wide_manifold_cache.h"

/* The other box as seen in the frame of the reference box. */
typedef struct reference_frame {
    f8 x, y;   /* centre of the other box, in the reference frame */
    f8 c, s;   /* its rotation there */
    f8 ux, uy; /* the frame's x axis in the world */
    f8 rx, ry; /* half extents of the reference box in the frame */
    i8 face;   /* the reference face, 0 to 3: +x, +y, -x, -y of its box */
} reference_frame;

/* Swaps a and b in the lanes of the mask. */
TD_INLINE void swap_where(i8 mask, f8 *a, f8 *b) {
    f8 t = f8_pick(mask, *b, *a);
    *b = f8_pick(mask, *a, *b);
    *a = t;
}

/* Turns the frame so that the reference face's normal is +x: by a quarter turn where the y axis was
 * chosen, then by half a turn where the other box is on the negative side. */
TD_INLINE void rotate_to_face(reference_frame *t, i8 by_y) {
    f8 x = f8_pick(by_y, t->y, t->x), y = f8_pick(by_y, -t->x, t->y);
    f8 c = f8_pick(by_y, t->s, t->c), s = f8_pick(by_y, -t->c, t->s);
    f8 ux = f8_pick(by_y, -t->uy, t->ux), uy = f8_pick(by_y, t->ux, t->uy);
    i8 back = x < f8_all(0.0f);
    t->x = f8_flip(x, back);
    t->y = f8_flip(y, back);
    t->c = f8_flip(c, back);
    t->s = f8_flip(s, back);
    t->ux = f8_flip(ux, back);
    t->uy = f8_flip(uy, back);
    swap_where(by_y, &t->rx, &t->ry);
    t->face = (by_y & i8_all(1)) | (back & i8_all(2));
}

/* The incident edge, in the reference frame. */
typedef struct edge {
    f8 cx, cy; /* middle */
    f8 ex, ey; /* unit direction, ey > 0 */
    f8 half;
    i8 face;
} edge;

/* The face of the other box whose normal is nearest to -x. */
TD_INLINE edge incident_edge(const reference_frame *t, f8 hx, f8 hy) {
    f8 zero = f8_all(0.0f);
    i8 by_x = f8_abs(t->c) >= f8_abs(t->s);
    /* The box's own axes here are (c, s) and (-s, c). */
    i8 x_back = t->c > zero, y_back = -t->s > zero;
    f8 nx = f8_pick(by_x, f8_flip(t->c, x_back), f8_flip(-t->s, y_back));
    f8 ny = f8_pick(by_x, f8_flip(t->s, x_back), f8_flip(t->c, y_back));
    f8 reach = f8_pick(by_x, hx, hy);
    edge e;
    e.cx = t->x + nx * reach;
    e.cy = t->y + ny * reach;
    e.ex = ny; /* perpendicular to the normal, which looks along -x, so that ey > 0 */
    e.ey = -nx;
    e.half = f8_pick(by_x, hy, hx);
    e.face = i8_pick(by_x, x_back & i8_all(2), i8_all(1) | (y_back & i8_all(2)));
    return e;
}

/* The relative pose of two boxes, and the separations along the two axes of each. */
typedef struct axes {
    f8 dax, day, dbx, dby; /* each centre in the other's frame */
    f8 c, s;               /* b's rotation in a's frame */
    f8 sep_ax, sep_ay, sep_bx, sep_by;
} axes;

/* The separating axis test of two boxes (Gottschalk et al., as above): along an axis of a with the
 * half extent h, the separation is |d| - h - r, where d is the distance of the centres along it and
 * r = |c| hx + |s| hy or |s| hx + |c| hy the half extent of b there; and the same with a and b
 * exchanged. */
TD_INLINE axes axes_of(const td_pairs8 *p) {
    axes x = {.dax = p->ac * p->dx + p->as * p->dy,
              .day = p->ac * p->dy - p->as * p->dx,
              .dbx = p->bc * p->dx + p->bs * p->dy,
              .dby = p->bc * p->dy - p->bs * p->dx,
              .c = p->ac * p->bc + p->as * p->bs,
              .s = p->ac * p->bs - p->as * p->bc};
    f8 ca = f8_abs(x.c), sa = f8_abs(x.s);
    x.sep_ax = f8_abs(x.dax) - p->ahx - (ca * p->bhx + sa * p->bhy);
    x.sep_ay = f8_abs(x.day) - p->ahy - (sa * p->bhx + ca * p->bhy);
    x.sep_bx = f8_abs(x.dbx) - p->bhx - (ca * p->ahx + sa * p->ahy);
    x.sep_by = f8_abs(x.dby) - p->bhy - (sa * p->ahx + ca * p->ahy);
    return x;
}

/* Computes the manifolds of the lanes in `recomputed`, or of all where it is null. Returns the
 * lanes that touch. */
TD_INLINE i8 collide_block(td_block *block, const td_pairs8 *pairs, const i8 *recomputed,
                           const td_collide_context *context) {
    f8 half = f8_all(0.5f), margin = f8_all(context->margin);
    td_pairs8 p = *pairs;
    axes x = axes_of(&p);
    f8 sep_a = f8_max(x.sep_ax, x.sep_ay), sep_b = f8_max(x.sep_bx, x.sep_by);
    i8 by_b = sep_b > sep_a + f8_all(context->axis_tolerance);

    reference_frame t;
    t.x = f8_pick(by_b, -x.dbx, x.dax);
    t.y = f8_pick(by_b, -x.dby, x.day);
    t.c = x.c;
    t.s = f8_flip(x.s, by_b);
    t.ux = f8_pick(by_b, p.bc, p.ac);
    t.uy = f8_pick(by_b, p.bs, p.as);
    t.rx = f8_pick(by_b, p.bhx, p.ahx);
    t.ry = f8_pick(by_b, p.bhy, p.ahy);
    rotate_to_face(&t, i8_pick(by_b, x.sep_by > x.sep_bx, x.sep_ay > x.sep_ax));
    edge e = incident_edge(&t, f8_pick(by_b, p.ahx, p.bhx), f8_pick(by_b, p.ahy, p.bhy));

    /* Clip to the sides of the reference face. ey is at least cos 45 degrees, so that the slope is
     * finite. */
    f8 low = e.cy - e.half * e.ey, high = e.cy + e.half * e.ey;
    i8 meets = (low <= t.ry) & (high >= -t.ry) & td_used_mask(block);
    f8 slope = e.ex / e.ey;
    f8 y0 = f8_clamp(low, -t.ry, t.ry), y1 = f8_clamp(high, -t.ry, t.ry);
    f8 x0 = e.cx + (y0 - e.cy) * slope, x1 = e.cx + (y1 - e.cy) * slope;
    f8 s0 = x0 - t.rx, s1 = x1 - t.rx;
    /* With b as the reference, the normal from a is -x, so that the order along the tangent is
     * reversed. */
    swap_where(by_b, &y0, &y1);
    swap_where(by_b, &x0, &x1);
    swap_where(by_b, &s0, &s1);
    i8 valid0 = meets & (s0 < margin), valid1 = meets & (s1 < margin);

    td_set_row(&block->nx, recomputed, f8_flip(t.ux, by_b));
    td_set_row(&block->ny, recomputed, f8_flip(t.uy, by_b));
    i8 face_a = i8_pick(by_b, e.face, t.face), face_b = i8_pick(by_b, t.face, e.face);
    i8 feature = face_a + face_b * i8_all(4) + i8_all(1);
    i8 old = i8_load((const int32_t *)block->feature);
    i8 same = old == feature;
    if (recomputed) {
        same |= ~*recomputed;
        feature = i8_pick(*recomputed, feature, old);
    }
    __builtin_memcpy(block->feature, &feature, sizeof feature);
    block->tangent_impulse = f8_keep(same, block->tangent_impulse);
    td_found found[2];
    for (int k = 0; k < 2; k++) {
        block->point[k].normal_impulse = f8_keep(same, block->point[k].normal_impulse);
        /* (px, py): the contact point, halfway between the surfaces, relative to the centre of the
         * reference box in its frame; (wx, wy): the same vector in world axes. */
        f8 px = (k ? x1 : x0) - half * (k ? s1 : s0), py = k ? y1 : y0;
        f8 wx = px * t.ux - py * t.uy, wy = px * t.uy + py * t.ux;
        found[k] = (td_found){.valid = k ? valid1 : valid0,
                              .separation = k ? s1 : s0,
                              .rax = p.ax + wx + f8_keep(by_b, p.dx),
                              .ray = p.ay + wy + f8_keep(by_b, p.dy),
                              .rbx = p.bx + wx - f8_keep(~by_b, p.dx),
                              .rby = p.by + wy - f8_keep(~by_b, p.dy)};
    }
    td_write_points(block, found, 2, recomputed, context);
    return valid0 | valid1;
}

/* Stores the poses and limits of the lanes in `recomputed` in the manifold cache. */
TD_INLINE void note_poses(td_block *block, const td_pairs8 *p, i8 recomputed, f8 dx, f8 dy,
                          const td_collide_context *context) {
    td_manifold_cache *kept = td_manifold_cache_of(block, 2);
    kept->dx = f8_pick(recomputed, dx, kept->dx);
    kept->dy = f8_pick(recomputed, dy, kept->dy);
    kept->ac = f8_pick(recomputed, p->ac, kept->ac);
    kept->as = f8_pick(recomputed, p->as, kept->as);
    kept->bc = f8_pick(recomputed, p->bc, kept->bc);
    kept->bs = f8_pick(recomputed, p->bs, kept->bs);
    td_cache_store(block, 2, recomputed, f8_min(f8_min(p->ahx, p->ahy), f8_min(p->bhx, p->bhy)),
                   f8_max(f8_max(p->ahx, p->ahy), f8_max(p->bhx, p->bhy)), context);
}

/* A td_collide_fn: keeps the manifolds that are still good, and computes the others. */
static void box_box(td_block *const *blocks, int count, const td_collide_context *context) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        const td_manifold_cache *kept = td_manifold_cache_of(block, 2);
        td_fetch_block(blocks, i, count, 2);
        td_pairs8 p = td_read_pairs(block, context);
        f8 dx = p.dx - p.bx + p.ax, dy = p.dy - p.by + p.ay, separation[2];
        td_moved moved = {.dx = dx - kept->dx, .dy = dy - kept->dy};
        moved.small_turn = small_turn(p.ac, p.as, kept->ac, kept->as, &moved.turn_a) &
                           small_turn(p.bc, p.bs, kept->bc, kept->bs, &moved.turn_b);
        i8 keep = td_cached_lanes(block, 2, &moved, context, separation), recomputed = ~keep;
        unsigned bits = i8_bits(keep), touching = bits;
        if (bits != i8_bits(td_used_mask(block))) {
            i8 valid = bits ? collide_block(block, &p, &recomputed, context) & recomputed
                            : collide_block(block, &p, NULL, context);
            touching |= i8_bits(valid);
            note_poses(block, &p, recomputed, dx, dy, context);
        }
        if (bits) {
            td_cache_update_points(block, 2, keep, separation, context);
        }
        td_set_touching(block, touching, context);
    }
}

/* A td_sift_fn, by the greatest separation along the four axes. */
static td_sifted sift_boxes(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, 0, c);
    axes x = axes_of(&p);
    return td_sift(a, b, f8_max(f8_max(x.sep_ax, x.sep_ay), f8_max(x.sep_bx, x.sep_by)), c);
}

TD_OBB_PAIRS(TD_DEFINE_PAIR)
