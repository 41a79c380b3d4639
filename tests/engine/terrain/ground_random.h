/* ground_random.h: random terrains, and how deep a shape is in one, by sampling. */
#ifndef GROUND_RANDOM_H
#define GROUND_RANDOM_H

#include "geometry_random.h"
#include "terrain/terrain_manifold.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Random terrains and cases on each; vertices at most; samples of a width; samples of a motion. */
enum { LINES = 300, PER_LINE = 20, VERTICES = 40, SAMPLES = 800, TIMES = 200 };
/* Distance up to which a contact is made, in metres. */
#define MARGIN 0.02

typedef struct ground {
    thud_terrain terrain;
    thud_pos points[VERTICES];
} ground;

/* A terrain about x = 0, with heights within a few units of 0. */
static inline void draw_ground(source *r, ground *g) {
    int kind = draw_below(r, 8), count = 2 + draw_below(r, VERTICES - 1);
    double spacing = exp(draw(r, -2.5, 0.5)), rough = draw_below(r, 2) ? 1.0 : 0.1;
    double x = -spacing * draw(r, 0.0, 1.0) * count, y = 0.0, slope = draw(r, -1.0, 1.0);
    for (int i = 0; i < count; i++) {
        g->points[i] = (thud_pos){x, y};
        x += draw_below(r, 6) ? spacing * draw(r, 0.3, 2.0) : 1e-4 * spacing;
        y += (kind == 1 ? slope : rough * draw(r, -1.0, 1.0)) * spacing;
    }
    g->terrain = (thud_terrain){.kind = kind == 0   ? THUD_TERRAIN_FLAT
                                        : kind <= 3 ? THUD_TERRAIN_UNIFORM
                                                    : THUD_TERRAIN_IRREGULAR,
                                .slope = slope,
                                .x0 = g->points[0].x,
                                .spacing = spacing,
                                .points = g->points,
                                .count = count};
    assert_int_equal(thud_terrain_check(&g->terrain), THUD_OK);
}

static inline double vertex_x(const thud_terrain *t, int i) {
    return t->kind == THUD_TERRAIN_UNIFORM ? t->x0 + i * t->spacing : t->points[i].x;
}

static inline double first_x(const thud_terrain *t) {
    return t->kind == THUD_TERRAIN_FLAT ? -1e9 : vertex_x(t, 0);
}

static inline double last_x(const thud_terrain *t) {
    return t->kind == THUD_TERRAIN_FLAT ? 1e9 : vertex_x(t, t->count - 1);
}

/* Height by a scan of all segments; -infinity where there is no ground. */
static inline double height(const thud_terrain *t, double x) {
    if (t->kind == THUD_TERRAIN_FLAT) {
        return t->slope * x;
    }
    for (int i = 0; i + 1 < t->count; i++) {
        double a = vertex_x(t, i), b = vertex_x(t, i + 1);
        if (x >= a && x <= b) {
            double w = (x - a) / (b - a);
            return (1.0 - w) * t->points[i].y + w * t->points[i + 1].y;
        }
    }
    return -INFINITY;
}

/* Half of the shape's horizontal extent. */
static inline double half_width(const thud_geometry *s) {
    return s->kind == THUD_SHAPE_CIRCLE ? s->hx : fabs(s->c) * s->hx + fabs(s->s) * s->hy;
}

/* Height of the shape's lowest point at x. */
static inline double underside(const thud_geometry *s, double x) {
    double dx = x - s->x, low = INFINITY;
    if (s->kind == THUD_SHAPE_CIRCLE) {
        return s->y - sqrt(fmax(0.0, s->hx * s->hx - dx * dx));
    }
    for (int k = 0; k < 4; k++) {
        thud_pos a = outline(s, 0.25 * k), b = outline(s, 0.25 * ((k + 1) % 4));
        if (fabs(b.x - a.x) > 1e-12 && (dx - a.x) * (dx - b.x) <= 1e-15) {
            low = fmin(low, a.y + (b.y - a.y) * (dx - a.x) / (b.x - a.x));
        }
    }
    return s->y + low;
}

/* How deep the shape is in the ground, vertically; negative above it. */
static inline double sampled_depth(const thud_terrain *t, const thud_geometry *s) {
    double half = half_width(s), depth = -INFINITY;
    double from = fmax(s->x - half, first_x(t)), to = fmin(s->x + half, last_x(t));
    for (int i = 0; i <= SAMPLES && from <= to; i++) {
        double x = from + (to - from) * i / SAMPLES;
        depth = fmax(depth, height(t, x) - underside(s, x));
    }
    for (int i = 0; t->kind != THUD_TERRAIN_FLAT && i < t->count; i++) {
        double x = vertex_x(t, i);
        if (x >= from && x <= to) {
            depth = fmax(depth, t->points[i].y - underside(s, x));
        }
    }
    return depth;
}

/* A random shape near the ground. */
static inline thud_geometry draw_over(source *r, const thud_terrain *t) {
    thud_geometry s = draw_shape(r);
    s.hx = fmax(s.hx, 0.05);
    double from = fmax(first_x(t), -3.0), to = fmin(last_x(t), 3.0);
    s.x = from < to ? draw(r, from - 0.5, to + 0.5) : draw(r, -1.0, 1.0);
    double top = height(t, s.x);
    s.y = (top > -1e9 ? top : 0.0) + draw(r, -1.0, 3.0) * (s.hx + s.hy);
    return s;
}

#endif
