/* wide_collide.h: what the narrowphase kernels share: reading the poses of eight pairs, and turning
 * a contact point into the rows that the solver needs. */
#ifndef TD_WIDE_COLLIDE_H
#define TD_WIDE_COLLIDE_H

#include "block.h"

typedef struct td_pairs8 {
    f8 dx, dy;         /* from a's centre to b's */
    f8 ax, ay, ac, as; /* a: offset from its centre of mass; cosine, sine */
    f8 bx, by, bc, bs;
    f8 ahx, ahy, bhx, bhy; /* half extents */
} td_pairs8;

TD_INLINE td_pairs8 td_read_pairs(const td_block *block, const td_collide_context *c)
{
    td_pairs8 p = {0};
    for (int i = 0; i < TD_LANES; i++) {
        const td_place *a = &c->center[block->shape_a[i]], *b = &c->center[block->shape_b[i]];
        /* Exact differences, rounded once. */
        p.dx[i] = (float)(b->x - a->x);
        p.dy[i] = (float)(b->y - a->y);
    }
    f8 quantum = f8_all(c->quantum);
    p.dx *= quantum;
    p.dy *= quantum;
    td_rows turn = td_gather(c->turn, block->shape_a);
    p.ax = turn.x, p.ay = turn.y, p.ac = turn.z, p.as = turn.w;
    turn = td_gather(c->turn, block->shape_b);
    p.bx = turn.x, p.by = turn.y, p.bc = turn.z, p.bs = turn.w;
    td_rows size = td_gather(c->size, block->shape_a);
    p.ahx = size.x, p.ahy = size.y;
    size = td_gather(c->size, block->shape_b);
    p.bhx = size.x, p.bhy = size.y;
    return p;
}

TD_INLINE i8 td_used_mask(const td_block *block)
{
    i8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    return lane < i8_all(block->used);
}

/* Writes point `index` of the block: r_a and r_b are its arms about the centres of mass. Lanes that
 * are not valid have no mass and no impulse: they neither push nor remember. */
TD_INLINE void td_write_point(td_block *block, int index, const td_collide_context *c, i8 valid,
                              f8 separation, f8 rax, f8 ray, f8 rbx, f8 rby)
{
    td_point *point = &block->point[index];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    f8 nx = block->nx, ny = block->ny, tx = ny, ty = -nx;
    f8 ia = block->inv_inertia_a, ib = block->inv_inertia_b;
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    f8 cross_a = rax * ny - ray * nx, cross_b = rbx * ny - rby * nx;
    f8 tangent_a = rax * ty - ray * tx, tangent_b = rbx * ty - rby * tx;
    f8 mass = va.w + vb.w;
    f8 k = mass + ia * cross_a * cross_a + ib * cross_b * cross_b;
    f8 kt = mass + ia * tangent_a * tangent_a + ib * tangent_b * tangent_b;
    i8 heavy = valid & (k > zero), heavy_t = valid & (kt > zero);
    point->separation = f8_pick(valid, separation, one);
    point->base = point->separation;
    point->cross_a = f8_keep(valid, cross_a);
    point->cross_b = f8_keep(valid, cross_b);
    point->tangent_cross_a = f8_keep(valid, tangent_a);
    point->tangent_cross_b = f8_keep(valid, tangent_b);
    point->normal_mass = f8_keep(heavy, one / f8_pick(heavy, k, one));
    point->tangent_mass = f8_keep(heavy_t, one / f8_pick(heavy_t, kt, one));
    point->normal_impulse = f8_keep(valid, point->normal_impulse);
    point->tangent_impulse = f8_keep(valid, point->tangent_impulse);
    point->approach = f8_keep(valid, (vb.x - va.x) * nx + (vb.y - va.y) * ny + vb.z * cross_b -
                                         va.z * cross_a);
    point->total = zero;
}

#endif
