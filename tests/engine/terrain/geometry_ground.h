/* geometry_ground.h: random terrains with a shape near them, in the families in which geometry code
 * fails, and reference answers in long double. Places in the answers are relative to the shape's
 * centre. */
#ifndef GEOMETRY_GROUND_H
#define GEOMETRY_GROUND_H

#include "geometry_exact.h"
#include "geometry_random.h"

#include <stdio.h>

enum { MAX_VERTICES = 24 };

typedef enum ground_family {
    ROUGH,
    GENTLE,
    STRAIGHT,   /* all vertices on one line, but for rounding */
    CLIFFS,     /* some segments are 10^-4 times as wide as the others */
    SPIKES,     /* needles up and down, 10^-6 times as wide as high */
    TWO_POINTS, /* the minimum of a terrain */
    GROUND_FAMILIES
} ground_family;

/* A terrain with its points, and a shape near it. */
typedef struct ground {
    thud_terrain terrain;
    thud_pos points[MAX_VERTICES];
    thud_geometry shape;
} ground;

static inline double vertex_x(const thud_terrain *t, int i) {
    return t->kind == THUD_TERRAIN_UNIFORM ? t->x0 + i * t->spacing : t->points[i].x;
}

/* Draws the vertices of a line of a family. */
static inline void draw_line(source *r, ground *g, ground_family family) {
    int count = family == TWO_POINTS ? 2 : 3 + draw_below(r, MAX_VERTICES - 2);
    double spacing = exp(draw(r, -2.5, 0.5)), rough = family == GENTLE ? 0.1 : 1.0;
    double x = -spacing * draw(r, 0.0, 1.0) * count, y = 0.0, slope = draw(r, -1.0, 1.0);
    for (int i = 0; i < count; i++) {
        bool narrow = family == CLIFFS && draw_below(r, 3) == 0;
        double spike = family == SPIKES && draw_below(r, 3) == 0 ? draw(r, -2.0, 2.0) : 0.0;
        double step = spacing * draw(r, 0.3, 2.0);
        g->points[i] = (thud_pos){x, y + spike};
        step = narrow ? 1e-4 * spacing : family == SPIKES && draw_below(r, 2) ? 1e-6 : step;
        x += step;
        y += family == STRAIGHT ? slope * (g->terrain.kind == THUD_TERRAIN_UNIFORM ? spacing : step)
                                : rough * draw(r, -1.0, 1.0) * spacing;
    }
    g->terrain.spacing = family == SPIKES ? 1e-3 * spacing : spacing;
    g->terrain.x0 = g->points[0].x;
    g->terrain.slope = slope;
    g->terrain.points = g->points;
    g->terrain.count = count;
}

/* A vertex relative to the shape's centre: exact, also far from the origin. */
static inline vec vertex_from(const thud_terrain *t, const thud_geometry *s, int i) {
    return (vec){(real)vertex_x(t, i) - s->x, (real)t->points[i].y - s->y};
}

/* Height of the line above the shape's centre at distance x from it, by a scan of all segments;
 * -infinity where there is no ground. */
static inline real line_height(const thud_terrain *t, const thud_geometry *s, real x) {
    if (t->kind == THUD_TERRAIN_FLAT) {
        return t->slope * (s->x + x) - s->y;
    }
    for (int i = 0; i + 1 < t->count; i++) {
        vec a = vertex_from(t, s, i), b = vertex_from(t, s, i + 1);
        if (x >= a.x && x <= b.x) {
            real w = (x - a.x) / (b.x - a.x);
            return (1.0L - w) * a.y + w * b.y;
        }
    }
    return -HUGE_VALL;
}

/* Half of the shape's horizontal extent. */
static inline real half_width(const thud_geometry *s) {
    return s->kind == THUD_SHAPE_CIRCLE ? (real)s->hx
                                        : fabsl((real)s->c * s->hx) + fabsl((real)s->s * s->hy);
}

/* The height of the shape's underside relative to its centre, at distance dx from it. */
static inline real underside(const thud_geometry *s, real dx) {
    real low = HUGE_VALL;
    if (s->kind == THUD_SHAPE_CIRCLE) {
        return -sqrtl(fmaxl(0.0L, ((real)s->hx - dx) * ((real)s->hx + dx)));
    }
    solid box = solid_of(s, s->x, s->y);
    for (int k = 0; k < 4; k++) {
        vec a = box.v[k], b = box.v[(k + 1) % 4];
        if (fminl(a.x, b.x) <= dx && dx <= fmaxl(a.x, b.x)) {
            real part = b.x != a.x ? (dx - a.x) / (b.x - a.x) : a.y < b.y ? 0.0L : 1.0L;
            low = fminl(low, a.y + part * (b.y - a.y));
        }
    }
    return low < HUGE_VALL ? low : dx < 0.0L ? box.v[0].y : box.v[1].y;
}

/* By how much the shape, moved sideways by x, must be lifted to be just out of the ground; negative
 * where it may sink, -infinity where there is no ground below. The greatest lift is at a vertex, at
 * a corner of a box, or where a circle is parallel to a segment. */
static inline real lift_at(const ground *g, const thud_geometry *s, real x) {
    const thud_terrain *t = &g->terrain;
    real half = half_width(s), lift = -HUGE_VALL;
    bool flat = t->kind == THUD_TERRAIN_FLAT, round = s->kind == THUD_SHAPE_CIRCLE;
    solid box = solid_of(s, s->x, s->y);
    for (int k = 0; k < 4 && !round; k++) {
        lift = fmaxl(lift, line_height(t, s, x + box.v[k].x) - box.v[k].y);
    }
    if (flat && round) {
        return line_height(t, s, x) + s->hx * sqrtl(1.0L + (real)t->slope * t->slope);
    }
    for (int i = 0; i < t->count && !flat; i++) {
        vec p = vertex_from(t, s, i), q = vertex_from(t, s, i + 1 < t->count ? i + 1 : i);
        if (fabsl(p.x - x) <= half) {
            lift = fmaxl(lift, p.y - underside(s, p.x - x));
        }
        vec along = unit(minus(q, p));
        real foot = x + along.y * s->hx;
        if (round && foot >= p.x && foot <= q.x && q.x > p.x) {
            lift = fmaxl(lift, p.y + (foot - p.x) * along.y / along.x + along.x * s->hx);
        }
    }
    return lift;
}

/* Distance of a solid from the line and from the vertical sides below its ends. It does not tell
 * inside from outside, except for a flat terrain. */
static inline real outline_distance(const ground *g, const solid *s) {
    const thud_terrain *t = &g->terrain;
    const real deep = 128.0L; /* longer than any shape reaches into or above the ground */
    real least = HUGE_VALL;
    if (t->kind == THUD_TERRAIN_FLAT) {
        for (int i = 0; i < s->count; i++) {
            real above = s->v[i].y - line_height(t, &g->shape, s->v[i].x);
            least = fminl(least, above / sqrtl(1.0L + (real)t->slope * t->slope));
        }
        return least - s->radius;
    }
    for (int i = 0; i <= t->count; i++) {
        int a = i < t->count ? i : 0, b = i < t->count - 1 ? i + 1 : a;
        solid piece = {.count = 2,
                       .v = {vertex_from(t, &g->shape, a), vertex_from(t, &g->shape, b)}};
        piece.v[1].y -= a == b ? deep : 0.0L;
        least = fminl(least, solids_distance(&piece, s));
    }
    return least;
}

/* Places the shape on the ground, in it, above it, beyond its ends, or on a vertex. */
static inline void place_shape(source *r, ground *g) {
    thud_geometry *s = &g->shape;
    const thud_terrain *t = &g->terrain;
    bool flat = t->kind == THUD_TERRAIN_FLAT;
    double from = flat ? -3.0 : vertex_x(t, 0), to = flat ? 3.0 : vertex_x(t, t->count - 1);
    double size = s->hx + s->hy;
    int where = draw_below(r, 8);
    s->x = draw(r, from, to);
    if (where == 0) { /* beyond an end */
        s->x = draw_below(r, 2) ? from - draw(r, 0.0, 1.5) * size : to + draw(r, 0.0, 1.5) * size;
    }
    real lift = lift_at(g, s, 0.0L);
    s->y = lift > -1e9L ? (double)lift : 0.0;
    if (where <= 2) {
        s->y += draw(r, -2.0, 3.0) * size;
    } else if (where <= 5) {
        s->y += draw(r, -0.1, 0.05) * size; /* a little inside, or a little above */
    } else if (where == 6 && !flat) {       /* centre or corner on a vertex */
        int i = draw_below(r, t->count);
        thud_pos corner = outline(s, 0.25 * draw_below(r, 4));
        s->x = vertex_x(t, i) - (draw_below(r, 2) ? corner.x : 0.0);
        s->y = t->points[i].y - (draw_below(r, 2) ? corner.y : 0.0);
    } /* else just touching */
}

/* Draws a terrain with a shape near it; `i` selects the family. */
static inline ground *draw_ground_of(source *r, ground *g, thud_terrain_kind kind,
                                     thud_shape_kind shape, int i) {
    *g = (ground){.terrain = {.kind = kind}, .shape = {.kind = shape, .c = 1.0}};
    draw_line(r, g, (ground_family)(i % GROUND_FAMILIES));
    thud_geometry *s = &g->shape;
    s->hx = exp(draw(r, -2.0, 0.7));
    s->hy = shape == THUD_SHAPE_CIRCLE ? 0.0 : exp(draw(r, -2.0, 0.7));
    if (draw_below(r, 8) == 0) {
        *(draw_below(r, 2) && shape != THUD_SHAPE_CIRCLE ? &s->hy : &s->hx) = 1e-6;
    }
    const double slope =
        kind == THUD_TERRAIN_FLAT || i % GROUND_FAMILIES == STRAIGHT ? atan(g->terrain.slope) : 0.0;
    set_angle(s, draw_below(r, 3) ? draw(r, -4.0, 4.0) : slope);
    place_shape(r, g);
    if (draw_below(r, 8) == 0) { /* up to ten million units away, where doubles are coarse */
        double x = draw(r, -1e7, 1e7), y = draw(r, -1e7, 1e7);
        y = kind == THUD_TERRAIN_FLAT ? g->terrain.slope * x : y;
        for (int k = 0; k < g->terrain.count; k++) {
            g->points[k].x += x;
            g->points[k].y += y;
        }
        g->terrain.x0 += x;
        s->x += x;
        s->y += y;
    }
    return g;
}

/* A unit of rounding of the engine's answers: ROUNDING times the lengths that it adds; on a flat
 * terrain heights are as coarse as the place. */
static inline double ground_rounding(const ground *g) {
    const thud_terrain *t = &g->terrain;
    double far = 0.0;
    for (int i = 0; i < t->count; i++) {
        far = fmax(far, fabs(vertex_x(t, i) - g->shape.x) + fabs(t->points[i].y - g->shape.y));
    }
    if (t->kind == THUD_TERRAIN_FLAT) {
        far = fabs(t->slope * g->shape.x) + fabs(g->shape.y);
    }
    return ROUNDING * (far + g->shape.hx + g->shape.hy);
}

/* The same for places, which are as coarse as their coordinates. */
static inline double spot_rounding(const ground *g) {
    return ground_rounding(g) + ROUNDING * (fabs(g->shape.x) + fabs(g->shape.y));
}

/* By how much the height at a place may change for a change of one sideways: the steepest slope, at
 * least 1. */
static inline double steepest(const thud_terrain *t) {
    double most = 1.0;
    for (int i = 0; i + 1 < t->count && t->kind != THUD_TERRAIN_FLAT; i++) {
        double rise = fabs(t->points[i + 1].y - t->points[i].y);
        most = fmax(most, rise / (vertex_x(t, i + 1) - vertex_x(t, i)));
    }
    return most;
}

static inline void print_ground(const ground *g) {
    const thud_terrain *t = &g->terrain;
    const thud_geometry *s = &g->shape;
    printf("shape = {.kind = %d, .x = %a, .y = %a, .c = %a, .s = %a, .hx = %a, .hy = %a}\n",
           (int)s->kind, s->x, s->y, s->c, s->s, s->hx, s->hy);
    printf("terrain = {.kind = %d, .slope = %a, .x0 = %a, .spacing = %a, .count = %d}\n",
           (int)t->kind, t->slope, t->x0, t->spacing, t->count);
    for (int i = 0; i < t->count; i++) {
        printf("{%a, %a},\n", g->points[i].x, g->points[i].y);
    }
}

/* As assert_true, but first prints the ground, so that a failure can be repeated. */
#define CHECK_GROUND(g, condition) \
    do {                           \
        if (!(condition)) {        \
            print_ground(g);       \
        }                          \
        assert_true(condition);    \
    } while (0)

#endif
