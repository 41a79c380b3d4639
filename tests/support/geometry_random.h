/* geometry_random.h: random shapes, points of outlines, and numbers of cases for the property tests
 * of geometry. They come from a generator of the tests' own, so that every run on every machine
 * draws the same. */
#ifndef GEOMETRY_RANDOM_H
#define GEOMETRY_RANDOM_H

#include "share.h"
#include "thud/thud_geometry.h"

#include <math.h>
#include <stdlib.h>

/* State of the generator. */
typedef struct source {
    uint64_t state; /* not 0 */
} source;

/* xorshift64*, Marsaglia 2003 and Vigna 2016. */
static inline uint64_t draw_bits(source *r) {
    r->state ^= r->state >> 12;
    r->state ^= r->state << 25;
    r->state ^= r->state >> 27;
    return r->state * 0x2545f4914f6cdd1dull;
}

static inline double draw(source *r, double low, double high) {
    return low + (high - low) * (double)(draw_bits(r) >> 11) * 0x1p-53;
}

static inline int draw_below(source *r, int count) {
    return (int)(draw_bits(r) >> 33) % count;
}

static inline void set_angle(thud_geometry *shape, double angle) {
    shape->c = shape->kind == THUD_SHAPE_OBB ? cos(angle) : 1.0;
    shape->s = shape->kind == THUD_SHAPE_OBB ? sin(angle) : 0.0;
}

/* A shape of any kind about the origin; a fifth of the boxes are needles with a half width of
 * 1e-5. */
static inline thud_geometry draw_shape(source *r) {
    thud_geometry shape = {.kind = (thud_shape_kind)draw_below(r, 3), .c = 1.0};
    shape.x = draw(r, -1.5, 1.5);
    shape.y = draw(r, -1.5, 1.5);
    shape.hx = exp(draw(r, -2.0, 0.7));
    shape.hy = shape.kind == THUD_SHAPE_CIRCLE ? 0.0 : exp(draw(r, -2.0, 0.7));
    if (shape.kind != THUD_SHAPE_CIRCLE && draw_below(r, 5) == 0) {
        shape.hx = 1e-5;
    }
    set_angle(&shape, draw(r, -4.0, 4.0));
    return shape;
}

/* A point of the outline, relative to the shape's centre; `turn` in [0, 1) goes once around it. */
static inline thud_pos outline(const thud_geometry *shape, double turn) {
    if (shape->kind == THUD_SHAPE_CIRCLE) {
        double angle = turn * 6.283185307179586;
        return (thud_pos){shape->hx * cos(angle), shape->hx * sin(angle)};
    }
    int side = (int)(turn * 4.0);
    double along = 2.0 * (turn * 4.0 - side) - 1.0;
    double u = side == 0 ? along : side == 1 ? 1.0 : side == 2 ? -along : -1.0;
    double v = side == 0 ? -1.0 : side == 1 ? along : side == 2 ? 1.0 : -along;
    u *= shape->hx;
    v *= shape->hy;
    return (thud_pos){shape->c * u - shape->s * v, shape->s * u + shape->c * v};
}

/* Signed distance of a point (given relative to the shape's centre) from the shape. */
static inline double point_distance(const thud_geometry *shape, double x, double y) {
    if (shape->kind == THUD_SHAPE_CIRCLE) {
        return sqrt(x * x + y * y) - shape->hx;
    }
    double u = fabs(shape->c * x + shape->s * y) - shape->hx;
    double v = fabs(shape->c * y - shape->s * x) - shape->hy;
    double over_u = u > 0.0 ? u : 0.0, over_v = v > 0.0 ? v : 0.0;
    return u > 0.0 || v > 0.0 ? sqrt(over_u * over_u + over_v * over_v) : u > v ? u : v;
}

static inline double outline_length(const thud_geometry *shape) {
    return shape->kind == THUD_SHAPE_CIRCLE ? 6.283185307179586 * shape->hx
                                            : 4.0 * (shape->hx + shape->hy);
}

/* How many random cases a pair of kinds gets: THUD_CASES of the environment, or else the share of
 * `usual` that this build runs (share.h). */
static inline int case_count(int usual) {
    const char *text = getenv("THUD_CASES");
    int count = text ? atoi(text) : 0;
    return count > 0 ? count : share_of(usual);
}

/* A shape of one kind about the origin, none of them a needle. */
static inline thud_geometry draw_shape_of(source *r, thud_shape_kind kind) {
    thud_geometry shape = {.kind = kind, .c = 1.0};
    shape.x = draw(r, -1.5, 1.5);
    shape.y = draw(r, -1.5, 1.5);
    shape.hx = exp(draw(r, -2.0, 0.7));
    shape.hy = kind == THUD_SHAPE_CIRCLE ? 0.0 : exp(draw(r, -2.0, 0.7));
    set_angle(&shape, draw(r, -4.0, 4.0));
    return shape;
}

#endif
