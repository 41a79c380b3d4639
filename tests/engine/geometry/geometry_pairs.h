/* geometry_pairs.h: random pairs of shapes of given kinds, in the families in which geometry code
 * fails: touching, one inside the other, concentric, parallel, corner to corner, needles, far from
 * the origin; and pairs in motion. Where shapes must touch, their places come from geometry_exact.h
 * and not from the engine. */
#ifndef GEOMETRY_PAIRS_H
#define GEOMETRY_PAIRS_H

#include "geometry_exact.h"
#include "geometry_random.h"

#include <stdio.h>

enum { PAIR_KINDS = 6 };

static const thud_shape_kind pair_kinds[PAIR_KINDS][2] = {{THUD_SHAPE_CIRCLE, THUD_SHAPE_CIRCLE},
                                                          {THUD_SHAPE_CIRCLE, THUD_SHAPE_AABB},
                                                          {THUD_SHAPE_CIRCLE, THUD_SHAPE_OBB},
                                                          {THUD_SHAPE_AABB, THUD_SHAPE_AABB},
                                                          {THUD_SHAPE_AABB, THUD_SHAPE_OBB},
                                                          {THUD_SHAPE_OBB, THUD_SHAPE_OBB}};

typedef enum pair_family {
    ANYHOW,
    TOUCHING,
    CONTAINING,
    CONCENTRIC,
    PARALLEL,
    CORNERS,
    NEEDLES,
    FAR_AWAY, /* any of the above, ten million units from the origin */
    FAMILIES
} pair_family;

typedef struct pair {
    thud_geometry a, b;
} pair;

/* Moves b until it touches a, along the shortest way; a circle whose centre is inside of the other
 * shape may take a longer one. */
static inline void bring_to_touch(pair *p) {
    solid a = solid_of(&p->a, p->a.x, p->a.y), b = solid_of(&p->b, p->a.x, p->a.y);
    sum h = sum_of(&a, &b);
    /* the point of the Minkowski difference's outline that is nearest to the origin */
    vec best = {0.0L, 0.0L};
    real least = 1e300L;
    for (int i = 0; i < h.count; i++) {
        vec p0 = h.v[i], d = minus(h.v[(i + 1) % h.count], p0);
        real square = dot(d, d), t = square > 0.0L ? -dot(d, p0) / square : 0.0L;
        t = fminl(fmaxl(t, 0.0L), 1.0L);
        vec z = {p0.x + t * d.x, p0.y + t * d.y};
        if (length_of(z) < least) {
            least = length_of(z);
            best = z;
        }
    }
    real part = least > 0.0L && h.radius > 0.0L ? 1.0L - h.radius / least : 1.0L;
    p->b.x -= (double)(best.x * part);
    p->b.y -= (double)(best.y * part);
}

/* Places b above a, parallel or rotated by a tiny angle, with or without a gap. */
static inline void place_parallel(source *r, pair *p) {
    const double gaps[] = {0.0, 0.01, -0.01, draw(r, -1.0, 1.0)};
    const double turns[] = {0.0, 0.0, 1e-12, 1e-9, 1e-6, 1e-3};
    double angle =
        p->a.kind == THUD_SHAPE_OBB && p->b.kind == THUD_SHAPE_OBB ? draw(r, -4.0, 4.0) : 0.0;
    double turned = angle + turns[draw_below(r, 6)], gap = gaps[draw_below(r, 4)];
    set_angle(&p->a, angle);
    set_angle(&p->b, turned);
    double height_a = p->a.kind == THUD_SHAPE_CIRCLE ? p->a.hx : p->a.hy;
    double height_b = p->b.kind == THUD_SHAPE_CIRCLE ? p->b.hx : p->b.hy;
    double u = draw_below(r, 3) ? draw(r, -1.2, 1.2) * (p->a.hx + p->b.hx) : 0.0;
    double v = height_a + height_b + gap;
    p->b.x = p->a.x + cos(angle) * u - sin(angle) * v;
    p->b.y = p->a.y + sin(angle) * u + cos(angle) * v;
}

/* Places a corner of one shape on a corner of the other or on a circle's outline, or up to 1e-3
 * beside it. */
static inline void place_corners(source *r, pair *p) {
    thud_pos i = outline(&p->a, 0.25 * draw_below(r, 4)),
             j = outline(&p->b, 0.25 * draw_below(r, 4));
    double off = draw_below(r, 2) ? 0.0 : draw(r, -1e-3, 1e-3);
    p->b.x = p->a.x + i.x - j.x + off;
    p->b.y = p->a.y + i.y - j.y - off * draw(r, -1.0, 1.0);
}

/* Makes one shape or both a needle (a circle a point), and places them across or end to end. */
static inline void make_needles(source *r, pair *p) {
    thud_geometry *thin = draw_below(r, 2) ? &p->a : &p->b;
    for (int i = 0; i < 2; i++, thin = thin == &p->a ? &p->b : &p->a) {
        if (thin->kind == THUD_SHAPE_CIRCLE) {
            thin->hx = 1e-6;
        } else {
            thin->hx = draw(r, 1.0, 2.0);
            thin->hy = 1e-6 * thin->hx;
        }
        if (draw_below(r, 2)) {
            break; /* one of the two is a needle */
        }
    }
    if (draw_below(r, 2)) { /* across each other, or end to end */
        p->b.x = p->a.x + draw(r, -1.0, 1.0);
        p->b.y = p->a.y + draw(r, -1.0, 1.0) * 1e-3;
    }
}

/* A random pair of kinds (an index of pair_kinds), in a family. */
static inline pair draw_pair_of(source *r, int kinds, pair_family family) {
    pair p = {draw_shape_of(r, pair_kinds[kinds][0]), draw_shape_of(r, pair_kinds[kinds][1])};
    bool far = family == FAR_AWAY;
    switch (far ? draw_below(r, FAR_AWAY) : (int)family) {
    case TOUCHING:
        bring_to_touch(&p);
        break;
    case CONTAINING:
        p.b.hx *= 0.05;
        p.b.hy *= 0.05;
        p.b.x = p.a.x + draw(r, -0.1, 0.1);
        p.b.y = p.a.y + draw(r, -0.1, 0.1);
        break;
    case CONCENTRIC:
        p.b.x = p.a.x;
        p.b.y = p.a.y;
        if (p.b.kind != THUD_SHAPE_CIRCLE && draw_below(r, 2)) { /* or on a corner */
            thud_pos corner = outline(&p.b, 0.25 * draw_below(r, 4));
            p.b.x -= corner.x;
            p.b.y -= corner.y;
        }
        break;
    case PARALLEL:
        place_parallel(r, &p);
        break;
    case CORNERS:
        place_corners(r, &p);
        break;
    case NEEDLES:
        make_needles(r, &p);
        break;
    default:
        break;
    }
    if (far) {
        double x = draw(r, -1e7, 1e7), y = draw(r, -1e7, 1e7);
        p.a.x += x, p.b.x += x;
        p.a.y += y, p.b.y += y;
    }
    if (draw_below(r, 2)) {
        p = (pair){p.b, p.a};
    }
    return p;
}

/* A unit of rounding of the engine's answers about the pair: ROUNDING times the lengths that it
 * adds. */
static inline double pair_rounding(const pair *p) {
    double size = p->a.hx + p->a.hy + p->b.hx + p->b.hy;
    return ROUNDING * (fabs(p->b.x - p->a.x) + fabs(p->b.y - p->a.y) + size);
}

/* The same for places, which are as coarse as their coordinates. */
static inline double place_rounding(const pair *p) {
    return pair_rounding(p) + ROUNDING * (fabs(p->a.x) + fabs(p->a.y));
}

/* A pair in motion over one unit of time; `target` is the distance at which an impact is due. */
typedef struct moving {
    pair p;
    thud_motion a, b;
    double target;
} moving;

/* A random pair in motion; `i` selects the family. */
static inline moving draw_moving(source *r, int kinds, int i, bool turning) {
    moving m = {.p = draw_pair_of(r, kinds, (pair_family)(i % FAMILIES))};
    double speed = exp(draw(r, -3.0, 5.0)), away = draw_below(r, 3) ? 3.0 : 0.0;
    m.p.b.x += draw(r, -away, away);
    m.p.b.y += draw(r, -away, away);
    m.a = (thud_motion){draw(r, -1.0, 1.0), draw(r, -1.0, 1.0), 0.0};
    m.b = (thud_motion){draw(r, -speed, speed), draw(r, -speed, speed), 0.0};
    if (draw_below(r, 2)) { /* b moves towards a */
        m.a = (thud_motion){0};
        m.b.dx = (m.p.a.x - m.p.b.x) * draw(r, 0.5, 3.0) + draw(r, -1.0, 1.0);
        m.b.dy = (m.p.a.y - m.p.b.y) * draw(r, 0.5, 3.0) + draw(r, -1.0, 1.0);
    }
    if (draw_below(r, 4) == 0) { /* along an axis */
        *(draw_below(r, 2) ? &m.b.dx : &m.b.dy) = 0.0;
        m.a = (thud_motion){0};
    }
    if (turning) {
        m.a.turn = draw_below(r, 2) ? draw(r, -6.0, 6.0) : 0.0;
        m.b.turn = draw(r, -6.0, 6.0);
    }
    m.target = draw_below(r, 3) ? 0.0 : draw(r, 0.0, 0.1);
    return m;
}

/* A unit of rounding of answers about the moving pair. */
static inline double moving_rounding(const moving *m) {
    double way = fabs(m->a.dx) + fabs(m->a.dy) + fabs(m->b.dx) + fabs(m->b.dy);
    return pair_rounding(&m->p) + ROUNDING * (way + m->target);
}

/* Distance of the pair after the share t of the motion, in long double. */
static inline real moving_distance(const moving *m, real t) {
    solid a = solid_after(&m->p.a, m->a, t, m->p.a.x, m->p.a.y);
    solid b = solid_after(&m->p.b, m->b, t, m->p.a.x, m->p.a.y);
    return solids_distance(&a, &b);
}

static inline void print_shape(const char *name, const thud_geometry *s) {
    printf("%s = {.kind = %d, .x = %a, .y = %a, .c = %a, .s = %a, .hx = %a, .hy = %a}\n", name,
           (int)s->kind, s->x, s->y, s->c, s->s, s->hx, s->hy);
}

/* As assert_true, but first prints the pair, so that a failure can be repeated. */
#define CHECK_PAIR(pair, condition)       \
    do {                                  \
        if (!(condition)) {               \
            print_shape("a", &(pair)->a); \
            print_shape("b", &(pair)->b); \
        }                                 \
        assert_true(condition);           \
    } while (0)

#endif
