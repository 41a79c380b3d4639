/* wide_circle.c: manifolds of circles with circles and with boxes, eight pairs at a time: one
 * contact point, in the middle between the two surfaces. */
#include "contact/pair_kinds.h"
#include "contact/wide_collide.h"

/* Normalises (x, y) and returns its length. A vector shorter than 1e-18, whose square is close to
 * the smallest normal float, counts as zero, and becomes (0, 1). */
TD_INLINE f8 normalise(f8 *x, f8 *y) {
    f8 length = f8_sqrt(*x * *x + *y * *y);
    i8 long_enough = length > f8_all(1e-18f);
    f8 divisor = f8_pick(long_enough, length, f8_all(1.0f));
    *x = f8_keep(long_enough, *x / divisor);
    *y = f8_pick(long_enough, *y / divisor, f8_all(1.0f));
    return f8_keep(long_enough, length);
}

/* A pseudo-random point of a square for each shape index: a multiplicative hash by a prime near
 * 2^32 over the golden ratio (D. Knuth, "The Art of Computer Programming", vol. 3, 6.4), mixed once
 * more with the first factor of MurmurHash3's finaliser. */
TD_INLINE void scatter(int32_t shape, float *x, float *y) {
    uint32_t bits = (uint32_t)shape * 0x9e3779b1u;
    bits = (bits ^ bits >> 15) * 0x85ebca6bu;
    *x = (float)(bits & 0xffffu);
    *y = (float)(bits >> 16);
}

/* Replaces the zero vector between coinciding centres by one between pseudo-random points, so that
 * many circles in one place come apart to all sides instead of along a line. */
TD_INLINE void part_coincident(const td_block *block, f8 *x, f8 *y) {
    for (unsigned bits = i8_bits((*x == f8_all(0.0f)) & (*y == f8_all(0.0f))); bits;
         bits &= bits - 1) {
        int lane = __builtin_ctz(bits);
        float ax, ay, bx, by;
        scatter(block->shape_a[lane], &ax, &ay);
        scatter(block->shape_b[lane], &bx, &by);
        (*x)[lane] = bx - ax;
        (*y)[lane] = by - ay;
    }
}

/* A td_collide_fn. */
static void circle_circle(td_block *const *blocks, int count, const td_collide_context *c) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_fetch_block(blocks, i, count, 1);
        td_fetch_shapes(blocks, i, count, c);
        td_pairs8 p = td_read_pairs(block, c);
        f8 nx = p.dx, ny = p.dy;
        f8 separation = f8_sqrt(nx * nx + ny * ny) - p.ahx - p.bhx;
        part_coincident(block, &nx, &ny);
        normalise(&nx, &ny);
        i8 valid = td_used_mask(block) & (separation < f8_all(c->margin));
        block->nx = nx;
        block->ny = ny;
        f8 ra = p.ahx + f8_all(0.5f) * separation, rb = -(p.bhx + f8_all(0.5f) * separation);
        td_found found = {valid,          separation,     p.ax + nx * ra,
                          p.ay + ny * ra, p.bx + nx * rb, p.by + ny * rb};
        td_write_points(block, &found, 1, NULL, c);
        td_set_touching(block, i8_bits(valid), c);
    }
}

/* A td_sift_fn. The functions for circles and boxes compute the exact separation, not only a lower
 * bound of it. */
static td_sifted sift_circles(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, 0, c);
    return td_sift(a, b, f8_sqrt(p.dx * p.dx + p.dy * p.dy) - p.ahx - p.bhx, c);
}

/* A circle of radius r at (x, y) in the frame of a box with half extents hx, hy: normal from the
 * box, and separation. */
TD_INLINE f8 circle_in_box_frame(f8 x, f8 y, f8 hx, f8 hy, f8 r, f8 *nx, f8 *ny) {
    f8 dx = x - f8_clamp(x, -hx, hx), dy = y - f8_clamp(y, -hy, hy);
    i8 inside = (dx == f8_all(0.0f)) & (dy == f8_all(0.0f));
    f8 ux = dx, uy = dy;
    f8 distance = normalise(&ux, &uy);
    /* A centre inside the box leaves through the nearest face. */
    f8 depth_x = hx - f8_abs(x), depth_y = hy - f8_abs(y);
    i8 by_x = depth_x < depth_y;
    f8 one = f8_all(1.0f);
    f8 face_x = f8_keep(by_x, f8_flip(one, x < f8_all(0.0f)));
    f8 face_y = f8_keep(~by_x, f8_flip(one, y < f8_all(0.0f)));
    *nx = f8_pick(inside, face_x, ux);
    *ny = f8_pick(inside, face_y, uy);
    return f8_pick(inside, -f8_min(depth_x, depth_y), distance) - r;
}

/* A box and a circle. */
typedef struct box_circle8 {
    f8 dx, dy; /* from the box to the circle */
    f8 nx, ny; /* from the box */
    f8 separation;
    f8 r;
} box_circle8;

/* The contact of a box and a circle; `flip`: the circle is a and the box is b. */
TD_INLINE box_circle8 separate_box_circle(const td_pairs8 *p, bool flip) {
    f8 cosine = flip ? p->bc : p->ac, sine = flip ? p->bs : p->as;
    f8 hx = flip ? p->bhx : p->ahx, hy = flip ? p->bhy : p->ahy;
    box_circle8 m = {.dx = flip ? -p->dx : p->dx,
                     .dy = flip ? -p->dy : p->dy,
                     .r = flip ? p->ahx : p->bhx};
    f8 lx, ly;
    m.separation = circle_in_box_frame(cosine * m.dx + sine * m.dy, cosine * m.dy - sine * m.dx, hx,
                                       hy, m.r, &lx, &ly);
    m.nx = cosine * lx - sine * ly;
    m.ny = sine * lx + cosine * ly;
    return m;
}

/* The manifolds of a block of boxes and circles; `flip`: the circle is a and the box is b. */
TD_INLINE void box_and_circle(td_block *block, const td_collide_context *c, bool flip) {
    td_pairs8 p = td_read_pairs(block, c);
    box_circle8 m = separate_box_circle(&p, flip);
    f8 nx = m.nx, ny = m.ny, dx = m.dx, dy = m.dy, separation = m.separation, r = m.r;
    i8 valid = td_used_mask(block) & (separation < f8_all(c->margin));
    f8 reach = -(r + f8_all(0.5f) * separation); /* along the normal, from the circle's centre */
    f8 cx = nx * reach, cy = ny * reach;
    block->nx = flip ? -nx : nx;
    block->ny = flip ? -ny : ny;
    f8 bx = dx + cx, by = dy + cy; /* the point, from the box */
    td_found found = {valid, separation, p.ax, p.ay, p.bx, p.by};
    found.rax += flip ? cx : bx;
    found.ray += flip ? cy : by;
    found.rbx += flip ? bx : cx;
    found.rby += flip ? by : cy;
    td_write_points(block, &found, 1, NULL, c);
    td_set_touching(block, i8_bits(valid), c);
}

static void box_circle(td_block *const *blocks, int count, const td_collide_context *c) {
    for (int i = 0; i < count; i++) {
        td_fetch_block(blocks, i, count, 1);
        td_fetch_shapes(blocks, i, count, c);
        box_and_circle(blocks[i], c, false);
    }
}

static void circle_box(td_block *const *blocks, int count, const td_collide_context *c) {
    for (int i = 0; i < count; i++) {
        td_fetch_block(blocks, i, count, 1);
        td_fetch_shapes(blocks, i, count, c);
        box_and_circle(blocks[i], c, true);
    }
}

static td_sifted sift_box_circle(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, 0, c);
    return td_sift(a, b, separate_box_circle(&p, false).separation, c);
}

static td_sifted sift_circle_box(const int32_t *a, const int32_t *b, const td_collide_context *c) {
    td_pairs8 p = td_read_shapes(a, b, 0, c);
    return td_sift(a, b, separate_box_circle(&p, true).separation, c);
}

TD_CIRCLE_PAIRS(TD_DEFINE_PAIR)
TD_BOX_CIRCLE_PAIRS(TD_DEFINE_PAIR)
