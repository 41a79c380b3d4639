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

/* A contact point as a kernel finds it: r_a and r_b are its arms about the centres of mass. */
typedef struct td_found {
    i8 valid;
    f8 separation, rax, ray, rbx, rby;
} td_found;

/* Lanes that keep their old rows; kernels that keep none pass no mask, which costs nothing. */
TD_INLINE void td_set_row(f8 *row, const i8 *fresh, f8 value)
{
    *row = fresh ? f8_pick(*fresh, value, *row) : value;
}

TD_INLINE f8 td_inverse_or_zero(i8 valid, f8 k)
{
    i8 heavy = valid & (k > f8_all(0.0f));
    return f8_keep(heavy, f8_all(1.0f) / f8_pick(heavy, k, f8_all(1.0f)));
}

/* Friction acts at the middle of the points, which is the same for the bodies as at each of them:
 * they lie on one tangent line. */
TD_INLINE td_found td_middle(const td_found *found, int points)
{
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

/* Writes the rows of the block's points, for its normal and impulses as they stand. Points that are
 * not valid have no mass and no impulse: they neither push nor remember. */
TD_INLINE void td_write_points(td_block *block, const td_found *found, int points,
                               const i8 *fresh, const td_collide_context *c)
{
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    f8 nx = block->nx, ny = block->ny;
    f8 ia = block->inv_inertia_a, ib = block->inv_inertia_b;
    td_rows va = td_gather(c->velocity, block->a), vb = td_gather(c->velocity, block->b);
    f8 mass = va.w + vb.w;
    td_found middle = td_middle(found, points);
    f8 turn_a = f8_keep(middle.valid, -(middle.rax * nx + middle.ray * ny));
    f8 turn_b = f8_keep(middle.valid, -(middle.rbx * nx + middle.rby * ny));
    f8 side_a = ia * turn_a, side_b = ib * turn_b;
    td_set_row(&block->tangent_cross_a, fresh, turn_a);
    td_set_row(&block->tangent_cross_b, fresh, turn_b);
    td_set_row(&block->tangent_mass, fresh,
               td_inverse_or_zero(middle.valid, mass + side_a * turn_a + side_b * turn_b));
    td_set_row(&block->tangent_impulse, fresh, f8_keep(middle.valid, block->tangent_impulse));
    f8 approach = (vb.x - va.x) * nx + (vb.y - va.y) * ny;
    f8 first_a = zero, first_b = zero;
    for (int k = 0; k < points; k++) {
        td_point *point = &block->point[k];
        const td_found *f = &found[k];
        f8 cross_a = f8_keep(f->valid, f->rax * ny - f->ray * nx);
        f8 cross_b = f8_keep(f->valid, f->rbx * ny - f->rby * nx);
        f8 lever_a = ia * cross_a, lever_b = ib * cross_b;
        f8 separation = f8_pick(f->valid, f->separation, one);
        td_set_row(&point->separation, fresh, separation);
        td_set_row(&point->base, fresh, separation);
        td_set_row(&point->cross_a, fresh, cross_a);
        td_set_row(&point->cross_b, fresh, cross_b);
        td_set_row(&point->normal_mass, fresh,
                   td_inverse_or_zero(f->valid, mass + lever_a * cross_a + lever_b * cross_b));
        td_set_row(&point->normal_impulse, fresh, f8_keep(f->valid, point->normal_impulse));
        td_set_row(&point->by_tangent, fresh, side_a * cross_a + side_b * cross_b);
        td_set_row(&point->approach, fresh,
                   f8_keep(f->valid, approach + vb.z * cross_b - va.z * cross_a));
        point->total = zero;
        if (k) {
            td_set_row(&td_second_of(block)->by_first, fresh,
                       mass + first_a * cross_a + first_b * cross_b);
        }
        first_a = lever_a;
        first_b = lever_b;
    }
}

#endif
