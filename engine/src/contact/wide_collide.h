/* wide_collide.h: what the narrowphase kernels share: reading the shapes of eight pairs, and
 * writing a contact point as the solver needs it (separation, lever arms crossed with the normal,
 * effective masses). */
#ifndef TD_WIDE_COLLIDE_H
#define TD_WIDE_COLLIDE_H

#include "constraint/block.h"

#include <stddef.h>

/* Prefetches the rows of block i + 2, which the kernel writes (td_fetch_early), and the head of
 * block i + 3, three cache lines. The distances are chosen, not tuned. */
TD_INLINE void td_fetch_block(td_block *const *blocks, int i, int count, int points) {
    td_fetch_early(blocks, i, count, points);
    if (i + 3 < count) {
        const td_block *block = blocks[i + 3];
        __builtin_prefetch(block->shape_a);
        __builtin_prefetch(block->constraint);
        __builtin_prefetch(&block->next, 1); /* this line has `touching`, which the kernel writes */
    }
}

/* Prefetches the shapes of block i + 1, whose head is in the cache by then (td_fetch_block). For
 * the kernels of circles and AABBs, whose arithmetic is too short to hide the loads. */
TD_INLINE void td_fetch_shapes(td_block *const *blocks, int i, int count,
                               const td_collide_context *c) {
    for (int k = 0; k < TD_LANES && i + 1 < count; k++) {
        __builtin_prefetch(&c->proxy[blocks[i + 1]->shape_a[k]]);
        __builtin_prefetch(&c->proxy[blocks[i + 1]->shape_b[k]]);
    }
}

/* The shapes of eight pairs, in the world's axes; lengths. */
typedef struct td_pairs8 {
    f8 dx, dy;             /* from the centre of shape a to that of b */
    f8 ax, ay, ac, as;     /* a: offset of the shape from its body's centre of mass; cosine, sine */
    f8 bx, by, bc, bs;     /* the same values for shape b */
    f8 ahx, ahy, bhx, bhy; /* half extents */
} td_pairs8;

/* Four floats, or int32, of each shape proxy from byte `offset` on, transposed: x has the first of
 * all eight, and so on. */
TD_INLINE td_rows td_gather_proxies(const td_collide_context *c, const int32_t *index,
                                    size_t offset) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)((const char *)&c->proxy[index[i]] + offset);
    }
    return td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                        f8_two(r[3], r[7]));
}

/* Differences of the centres (b less a) of two pairs, in position quanta, as doubles: x, y, x, y.
 * AVX2 has no conversion from int64: TD_ROUND_BITS are the bits of the double TD_ROUND_SHIFT, to
 * whose low bits the difference is added (base/fixed.h). Exact for differences below 2^51 quanta,
 * 2^19 length scales. For a greater difference the result is wrong, but it is either at least 2^51
 * quanta or not a number, so that the pair does not touch. */
TD_INLINE d4 td_center_differences(const td_shape_proxy *a0, const td_shape_proxy *b0,
                                   const td_shape_proxy *a1, const td_shape_proxy *b1) {
    l4 bits = {b0->center.x - a0->center.x, b0->center.y - a0->center.y,
               b1->center.x - a1->center.x, b1->center.y - a1->center.y};
    bits += TD_ROUND_BITS;
    return (d4)bits - TD_ROUND_SHIFT; /* (d4) keeps the bits */
}

static_assert(offsetof(td_shape_proxy, half_y) == offsetof(td_shape_proxy, c) + 3 * sizeof(float) &&
                  offsetof(td_shape_proxy, y) == offsetof(td_shape_proxy, x) + sizeof(float),
              "td_read_shapes reads c, s, half_x, half_y at once, and x, y");

/* Reads eight pairs. The offsets of the shapes from their bodies' centres of mass are read if
 * `has_offsets` (td_block.has_offsets), which holds for all eight; else they are 0. */
TD_INLINE td_pairs8 td_read_shapes(const int32_t *shape_a, const int32_t *shape_b, int has_offsets,
                                   const td_collide_context *c) {
    td_pairs8 p;
    f4 differences[4]; /* of pairs i and i + 4: x, y, x, y, in quanta */
    for (int i = 0; i < 4; i++) {
        int j = i + 4;
        d4 exact = td_center_differences(&c->proxy[shape_a[i]], &c->proxy[shape_b[i]],
                                         &c->proxy[shape_a[j]], &c->proxy[shape_b[j]]);
        differences[i] = __builtin_convertvector(exact, f4);
    }
    f8 r01 = __builtin_shufflevector(differences[0], differences[1], 0, 4, 1, 5, 2, 6, 3, 7);
    f8 r23 = __builtin_shufflevector(differences[2], differences[3], 0, 4, 1, 5, 2, 6, 3, 7);
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

/* td_read_shapes for the pairs of a block. */
TD_INLINE td_pairs8 td_read_pairs(const td_block *block, const td_collide_context *c) {
    return td_read_shapes(block->shape_a, block->shape_b, block->has_offsets, c);
}

/* The fat bounds of eight shapes: min x, min y, max x, max y, in bounds quanta, which wrap around
 * (base/fixed.h). */
TD_INLINE void td_read_bounds(const td_collide_context *c, const int32_t *shapes, i8 out[4]) {
    td_rows rows = td_gather_proxies(c, shapes, offsetof(td_shape_proxy, fat));
    out[0] = (i8)rows.x, out[1] = (i8)rows.y, out[2] = (i8)rows.z, out[3] = (i8)rows.w;
}

/* The quick test of eight waiting pairs. `separation` is a lower bound of the exact separation,
 * length: pairs whose bounds overlap are near if it is below the margin. */
TD_INLINE td_sifted td_sift(const int32_t *shape_a, const int32_t *shape_b, f8 separation,
                            const td_collide_context *c) {
    i8 a[4], b[4];
    td_read_bounds(c, shape_a, a);
    td_read_bounds(c, shape_b, b);
    /* The sign bit: a maximum of one is below the minimum of the other (td_bounds_overlap). */
    i8 bounds_apart = i8_wrap_sub(a[2], b[0]) | i8_wrap_sub(b[2], a[0]) | i8_wrap_sub(a[3], b[1]) |
                      i8_wrap_sub(b[3], a[1]);
    i8 near = ~bounds_apart & (separation < f8_all(c->margin));
    return (td_sifted){.bounds_apart = i8_bits(bounds_apart), .near = i8_bits(near)};
}

/* The lanes that are in use. */
TD_INLINE i8 td_used_mask(const td_block *block) {
    i8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    return lane < i8_all(block->used);
}

/* Stores which lanes touch, and appends the block to c->separated, whose contacts give their lanes
 * back (narrowphase.c), unless all lanes in use touch. It does so without a branch: the block is
 * always written behind the list, and the list's count grows only if it belongs there. Sets
 * c->has_offsets if the block has offsets: blocks without them are solved by passes with less
 * arithmetic (td_arms, wide_solve.h). */
TD_INLINE void td_set_touching(td_block *block, unsigned touching, const td_collide_context *c) {
    block->touching = touching;
    c->separated[*c->separated_count] = block;
    *c->has_offsets |= block->has_offsets;
    *c->separated_count += touching != (1u << block->used) - 1u;
}

/* A contact point of eight lanes as a kernel finds it. */
typedef struct td_found {
    i8 valid;      /* mask: lanes that have this point */
    f8 separation; /* of the surfaces, length; negative: overlap */
    f8 rax, ray;   /* lever arm of a: from the body's centre of mass to the point */
    f8 rbx, rby;   /* lever arm of b */
} td_found;

/* Writes the lanes in the mask `recomputed`, or all where it is null. Kernels that write all pass a
 * constant null, so that the compiler removes the blend. */
TD_INLINE void td_set_row(f8 *row, const i8 *recomputed, f8 value) {
    *row = recomputed ? f8_pick(*recomputed, value, *row) : value;
}

/* 1 / k in the lanes in `valid` with k > 0, 0 in others. */
TD_INLINE f8 td_inverse_or_zero(i8 valid, f8 k) {
    i8 acts = valid & (k > f8_all(0.0f));
    return f8_keep(acts, f8_all(1.0f) / f8_pick(acts, k, f8_all(1.0f)));
}

/* The point at which the friction of a contact acts, in one row: the middle of its contact points.
 * They lie on one line along the tangent t, so that r x t, and with it the effect of the tangent
 * impulse, would be the same at each of them. */
TD_INLINE td_found middle_of(const td_found *found, int points) {
    if (points == 1) {
        return found[0];
    }
    td_found p = found[0], q = found[1];
    f8 half = f8_all(0.5f);
    f8 share = f8_pick(p.valid & q.valid, half, f8_keep(q.valid, f8_all(1.0f))); /* of q */
    return (td_found){.valid = p.valid | q.valid,
                      .separation = p.separation,
                      .rax = p.rax + (q.rax - p.rax) * share,
                      .ray = p.ray + (q.ray - p.ray) * share,
                      .rbx = p.rbx + (q.rbx - p.rbx) * share,
                      .rby = p.rby + (q.rby - p.rby) * share};
}

/* Writes the block's points and its friction row: separations, crosses of the lever arms, effective
 * masses (wide_solve.h has the equations). The caller has set the normal, and the impulses to start
 * from. A point that is not valid gets an effective mass and an impulse of 0, so that it does
 * nothing in the solver. */
TD_INLINE void td_write_points(td_block *block, const td_found *found, int points,
                               const i8 *recomputed, const td_collide_context *c) {
    f8 apart = f8_all(TD_APART);
    f8 nx = block->nx, ny = block->ny;
    f8 ia = block->inv_inertia_a, ib = block->inv_inertia_b;
    /* Rows of velocities: x, y, turn, inverse mass. */
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    f8 inv_mass = va.w + vb.w;
    td_found middle = middle_of(found, points);
    /* r x t with t = (ny, -nx); spins are angular velocities by a unit of impulse. */
    f8 tangent_cross_a = f8_keep(middle.valid, -(middle.rax * nx + middle.ray * ny));
    f8 tangent_cross_b = f8_keep(middle.valid, -(middle.rbx * nx + middle.rby * ny));
    f8 spin_a = ia * tangent_cross_a, spin_b = ib * tangent_cross_b;
    td_set_row(&block->tangent_cross_a, recomputed, tangent_cross_a);
    td_set_row(&block->tangent_cross_b, recomputed, tangent_cross_b);
    td_set_row(&block->tangent_mass, recomputed,
               td_inverse_or_zero(middle.valid,
                                  inv_mass + spin_a * tangent_cross_a + spin_b * tangent_cross_b));
    td_set_row(&block->tangent_impulse, recomputed, f8_keep(middle.valid, block->tangent_impulse));
    f8 normal_velocity = (vb.x - va.x) * nx + (vb.y - va.y) * ny; /* of the centres of mass */
    for (int k = 0; k < points; k++) {
        td_point *point = &block->point[k];
        const td_found *f = &found[k];
        f8 cross_a = f8_keep(f->valid, f->rax * ny - f->ray * nx);
        f8 cross_b = f8_keep(f->valid, f->rbx * ny - f->rby * nx);
        spin_a = ia * cross_a;
        spin_b = ib * cross_b;
        /* From the distance `skin` at which contacts rest. */
        f8 separation = f8_pick(f->valid, f->separation - f8_all(c->skin), apart);
        td_set_row(&point->separation, recomputed, separation);
        td_set_row(&point->start_separation, recomputed, separation);
        td_set_row(&point->cross_a, recomputed, cross_a);
        td_set_row(&point->cross_b, recomputed, cross_b);
        td_set_row(&point->normal_mass, recomputed,
                   td_inverse_or_zero(f->valid, inv_mass + spin_a * cross_a + spin_b * cross_b));
        td_set_row(&point->normal_impulse, recomputed, f8_keep(f->valid, point->normal_impulse));
        td_set_row(&td_history_of(block, points)[k].normal_velocity, recomputed,
                   f8_keep(f->valid, normal_velocity + vb.z * cross_b - va.z * cross_a));
    }
}

#endif
