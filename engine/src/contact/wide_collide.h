/* wide_collide.h: what the narrowphase kernels share: reading the shapes of eight pairs, and
 * writing a contact point as the solver needs it (separation, lever arms crossed with the normal,
 * effective masses). */
#ifndef TD_WIDE_COLLIDE_H
#define TD_WIDE_COLLIDE_H

#include "constraint/block.h"

#include <stddef.h>

/* Prefetches the head of the block three ahead, and the velocities that it will read. */
TD_INLINE void td_fetch_block(td_block *const *blocks, int i, int count, int points) {
    td_fetch_early(blocks, i, count, points);
    if (i + 3 < count) {
        const char *head = (const char *)blocks[i + 3];
        __builtin_prefetch(head);
        __builtin_prefetch(head + 64);
        __builtin_prefetch(head + 128, 1);
    }
}

/* Prefetches the shapes of the next block, for kernels with little arithmetic. */
TD_INLINE void td_fetch_shapes(td_block *const *blocks, int i, int count,
                               const td_collide_context *c) {
    for (int k = 0; k < TD_LANES && i + 1 < count; k++) {
        __builtin_prefetch(&c->proxy[blocks[i + 1]->shape_a[k]]);
        __builtin_prefetch(&c->proxy[blocks[i + 1]->shape_b[k]]);
    }
}

/* The shapes of eight pairs, in the world's axes. */
typedef struct td_pairs8 {
    f8 dx, dy;             /* from the centre of shape a to that of b */
    f8 ax, ay, ac, as;     /* a: offset of the shape from its body's centre of mass; cosine, sine */
    f8 bx, by, bc, bs;     /* the same of b */
    f8 ahx, ahy, bhx, bhy; /* half extents */
} td_pairs8;

/* Four floats of each shape proxy from `offset` on, transposed. */
TD_INLINE td_rows td_gather_proxies(const td_collide_context *c, const int32_t *index,
                                    size_t offset) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)((const char *)&c->proxy[index[i]] + offset);
    }
    return td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                        f8_two(r[3], r[7]));
}

/* Exact differences of the centres of two pairs, in quanta, as doubles: x, y, x, y. They are exact
 * up to 2^51 quanta, and shapes whose bounds overlap are nearer than that. */
TD_INLINE d4 td_between(const td_shape_proxy *a0, const td_shape_proxy *b0,
                        const td_shape_proxy *a1, const td_shape_proxy *b1) {
    l4 bits = {b0->center.x - a0->center.x, b0->center.y - a0->center.y,
               b1->center.x - a1->center.x, b1->center.y - a1->center.y};
    bits += TD_ROUND_BITS;
    return (d4)bits - TD_ROUND_SHIFT;
}

/* Reads eight pairs. Offsets from the centres of mass are read where `has_offsets`, and are 0
 * otherwise.
 */
TD_INLINE td_pairs8 td_read_shapes(const int32_t *shape_a, const int32_t *shape_b, int has_offsets,
                                   const td_collide_context *c) {
    td_pairs8 p;
    f4 between[4];
    for (int i = 0; i < 4; i++) {
        int j = i + 4;
        between[i] =
            __builtin_convertvector(td_between(&c->proxy[shape_a[i]], &c->proxy[shape_b[i]],
                                               &c->proxy[shape_a[j]], &c->proxy[shape_b[j]]),
                                    f4);
    }
    f8 r01 = __builtin_shufflevector(between[0], between[1], 0, 4, 1, 5, 2, 6, 3, 7);
    f8 r23 = __builtin_shufflevector(between[2], between[3], 0, 4, 1, 5, 2, 6, 3, 7);
    f8 quantum = f8_all(c->quantum);
    p.dx = quantum * __builtin_shufflevector(r01, r23, 0, 1, 8, 9, 4, 5, 12, 13);
    p.dy = quantum * __builtin_shufflevector(r01, r23, 2, 3, 10, 11, 6, 7, 14, 15);
    td_rows proxy = td_gather_proxies(c, shape_a, offsetof(td_shape_proxy, c));
    p.ac = proxy.x, p.as = proxy.y, p.ahx = proxy.z, p.ahy = proxy.w;
    proxy = td_gather_proxies(c, shape_b, offsetof(td_shape_proxy, c));
    p.bc = proxy.x, p.bs = proxy.y, p.bhx = proxy.z, p.bhy = proxy.w;
    p.ax = p.ay = p.bx = p.by = f8_all(0.0f);
    if (has_offsets) {
        proxy = td_gather_proxies(c, shape_a, offsetof(td_shape_proxy, x));
        p.ax = proxy.x, p.ay = proxy.y;
        proxy = td_gather_proxies(c, shape_b, offsetof(td_shape_proxy, x));
        p.bx = proxy.x, p.by = proxy.y;
    }
    return p;
}

/* The same for the pairs of a block. */
TD_INLINE td_pairs8 td_read_pairs(const td_block *block, const td_collide_context *c) {
    return td_read_shapes(block->shape_a, block->shape_b, block->has_offsets, c);
}

/* The fat bounds of eight shapes: min x, min y, max x, max y. */
TD_INLINE void td_read_bounds(const td_collide_context *c, const int32_t *shapes, i8 out[4]) {
    td_rows rows = td_gather_proxies(c, shapes, offsetof(td_shape_proxy, fat));
    out[0] = (i8)rows.x, out[1] = (i8)rows.y, out[2] = (i8)rows.z, out[3] = (i8)rows.w;
}

/* Sorts eight pairs by their bounds and by `separation`, a lower bound of the exact one. */
TD_INLINE td_sifted td_sift(const int32_t *shape_a, const int32_t *shape_b, f8 separation,
                            const td_collide_context *c) {
    i8 a[4], b[4];
    td_read_bounds(c, shape_a, a);
    td_read_bounds(c, shape_b, b);
    i8 bounds_apart = i8_wrap_sub(a[2], b[0]) | i8_wrap_sub(b[2], a[0]) | i8_wrap_sub(a[3], b[1]) |
                      i8_wrap_sub(b[3], a[1]);
    return (td_sifted){i8_bits(bounds_apart),
                       i8_bits(~bounds_apart & (separation < f8_all(c->margin)))};
}

/* The lanes that are in use. */
TD_INLINE i8 td_used_mask(const td_block *block) {
    i8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    return lane < i8_all(block->used);
}

/* Stores which lanes touch, and lists the block if one does not. */
TD_INLINE void td_set_touching(td_block *block, unsigned touching, const td_collide_context *c) {
    block->touching = touching;
    c->separated[*c->separated_count] = block;
    *c->has_offsets |= block->has_offsets;
    *c->separated_count += touching != (1u << block->used) - 1u;
}

/* A contact point as a kernel finds it; (rax, ray) and (rbx, rby) are its lever arms about the
 * centres of mass. */
typedef struct td_found {
    i8 valid;
    f8 separation, rax, ray, rbx, rby;
} td_found;

/* Writes the lanes in `recomputed`; a null mask writes all, and costs nothing, as it is known when
 * compiling. */
TD_INLINE void td_set_row(f8 *row, const i8 *recomputed, f8 value) {
    *row = recomputed ? f8_pick(*recomputed, value, *row) : value;
}

/* 1 / k in the lanes in `valid` with k > 0, 0 in others. */
TD_INLINE f8 td_inverse_or_zero(i8 valid, f8 k) {
    i8 heavy = valid & (k > f8_all(0.0f));
    return f8_keep(heavy, f8_all(1.0f) / f8_pick(heavy, k, f8_all(1.0f)));
}

/* The point at which friction acts: the middle of the contact points. As they lie on one line along
 * the tangent, the lever arm of the tangent impulse is the same at each of them. */
TD_INLINE td_found middle_of(const td_found *found, int points) {
    if (points == 1) {
        return found[0];
    }
    td_found p = found[0], q = found[1];
    f8 half = f8_all(0.5f);
    f8 share = f8_pick(p.valid & q.valid, half, f8_keep(q.valid, f8_all(1.0f))); /* of q */
    return (td_found){p.valid | q.valid,
                      p.separation,
                      p.rax + (q.rax - p.rax) * share,
                      p.ray + (q.ray - p.ray) * share,
                      p.rbx + (q.rbx - p.rbx) * share,
                      p.rby + (q.rby - p.rby) * share};
}

/* Writes the block's points for its present normal and impulses. A point that is not valid gets an
 * effective mass and an impulse of 0, so that it does nothing in the solver. */
TD_INLINE void td_write_points(td_block *block, const td_found *found, int points,
                               const i8 *recomputed, const td_collide_context *c) {
    f8 apart = f8_all(TD_APART);
    f8 nx = block->nx, ny = block->ny;
    f8 ia = block->inv_inertia_a, ib = block->inv_inertia_b;
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    f8 mass = va.w + vb.w;
    td_found middle = middle_of(found, points);
    f8 turn_a = f8_keep(middle.valid, -(middle.rax * nx + middle.ray * ny));
    f8 turn_b = f8_keep(middle.valid, -(middle.rbx * nx + middle.rby * ny));
    f8 side_a = ia * turn_a, side_b = ib * turn_b;
    td_set_row(&block->tangent_cross_a, recomputed, turn_a);
    td_set_row(&block->tangent_cross_b, recomputed, turn_b);
    td_set_row(&block->tangent_mass, recomputed,
               td_inverse_or_zero(middle.valid, mass + side_a * turn_a + side_b * turn_b));
    td_set_row(&block->tangent_impulse, recomputed, f8_keep(middle.valid, block->tangent_impulse));
    f8 normal_velocity = (vb.x - va.x) * nx + (vb.y - va.y) * ny;
    for (int k = 0; k < points; k++) {
        td_point *point = &block->point[k];
        const td_found *f = &found[k];
        f8 cross_a = f8_keep(f->valid, f->rax * ny - f->ray * nx);
        f8 cross_b = f8_keep(f->valid, f->rbx * ny - f->rby * nx);
        f8 lever_a = ia * cross_a, lever_b = ib * cross_b;
        f8 separation = f8_pick(f->valid, f->separation - f8_all(c->skin), apart);
        td_set_row(&point->separation, recomputed, separation);
        td_set_row(&point->start_separation, recomputed, separation);
        td_set_row(&point->cross_a, recomputed, cross_a);
        td_set_row(&point->cross_b, recomputed, cross_b);
        td_set_row(&point->normal_mass, recomputed,
                   td_inverse_or_zero(f->valid, mass + lever_a * cross_a + lever_b * cross_b));
        td_set_row(&point->normal_impulse, recomputed, f8_keep(f->valid, point->normal_impulse));
        td_set_row(&td_history_of(block, points)[k].normal_velocity, recomputed,
                   f8_keep(f->valid, normal_velocity + vb.z * cross_b - va.z * cross_a));
    }
}

#endif
