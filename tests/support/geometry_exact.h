/* geometry_exact.h: reference answers for the tests of geometry, in long double and by other
 * methods than the engine's: distances, overlaps and times of impact of two shapes come from their
 * Minkowski difference, the convex hull of all differences of their corners. Places are relative to
 * an origin that the caller chooses. */
#ifndef GEOMETRY_EXACT_H
#define GEOMETRY_EXACT_H

#include "thud/thud_geometry.h"

#include <float.h>
#include <math.h>

typedef long double real;
_Static_assert(LDBL_MANT_DIG >= 64, "no answers more exact than the engine's");

typedef struct vec {
    real x, y;
} vec;

/* Half a unit in the last place of 1.0: the relative rounding error of one operation in double. */
#define ROUNDING 0x1p-53

static inline vec vec_of(real x, real y) {
    return (vec){x, y};
}

static inline vec minus(vec a, vec b) {
    return (vec){a.x - b.x, a.y - b.y};
}

static inline real dot(vec a, vec b) {
    return a.x * b.x + a.y * b.y;
}

static inline real cross(vec a, vec b) {
    return a.x * b.y - a.y * b.x;
}

static inline real length_of(vec a) {
    return sqrtl(dot(a, a));
}

static inline vec unit(vec a) {
    real length = length_of(a);
    return (vec){a.x / length, a.y / length};
}

/* A convex polygon, counter-clockwise, with a rounding radius; a circle has one corner. */
typedef struct solid {
    vec v[4];
    int count;
    real radius;
} solid;

/* The shape's polygon with this centre and rotation (c, si). */
static inline solid solid_at(const thud_geometry *s, vec center, real c, real si) {
    solid out = {.count = 1,
                 .v = {center},
                 .radius = s->kind == THUD_SHAPE_CIRCLE ? (real)s->hx : 0.0L};
    if (s->kind != THUD_SHAPE_CIRCLE) {
        out.count = 4;
        for (int i = 0; i < 4; i++) {
            real u = i == 1 || i == 2 ? (real)s->hx : -(real)s->hx;
            real v = i >= 2 ? (real)s->hy : -(real)s->hy;
            out.v[i] = vec_of(center.x + c * u - si * v, center.y + si * u + c * v);
        }
    }
    return out;
}

/* The shape's polygon, relative to (x, y). */
static inline solid solid_of(const thud_geometry *s, double x, double y) {
    return solid_at(s, vec_of((real)s->x - x, (real)s->y - y), s->c, s->s);
}

/* The shape's polygon after the share t of its motion m, relative to (x, y). */
static inline solid solid_after(const thud_geometry *s, thud_motion m, real t, double x, double y) {
    bool turns = s->kind == THUD_SHAPE_OBB && m.turn != 0.0;
    real c = turns ? cosl(m.turn * t) : 1.0L, si = turns ? sinl(m.turn * t) : 0.0L;
    return solid_at(s, vec_of((real)s->x - x + m.dx * t, (real)s->y - y + m.dy * t),
                    s->c * c - s->s * si, s->s * c + s->c * si);
}

/* The Minkowski difference: the convex hull of all b - a, with a rounding radius. The shapes
 * overlap if the origin is within `radius` of it. */
typedef struct sum {
    vec v[32];
    int count;
    real radius;
} sum;

/* Adds a corner to the chain of a hull, and first removes corners that are no longer convex; the
 * first `keep` corners stay. */
static inline void hull_add(sum *h, int keep, vec p) {
    while (h->count > keep && cross(minus(h->v[h->count - 1], h->v[h->count - 2]),
                                    minus(p, h->v[h->count - 1])) <= 0) {
        h->count--;
    }
    h->v[h->count++] = p;
}

/* The Minkowski difference of two solids, by Andrew's monotone chain (1979). */
static inline sum sum_of(const solid *a, const solid *b) {
    sum h = {.radius = a->radius + b->radius};
    vec p[16];
    int n = 0;
    for (int i = 0; i < a->count; i++) {
        for (int j = 0; j < b->count; j++) {
            vec d = minus(b->v[j], a->v[i]);
            int k = n++;
            for (; k > 0 && (p[k - 1].x > d.x || (p[k - 1].x == d.x && p[k - 1].y > d.y)); k--) {
                p[k] = p[k - 1];
            }
            p[k] = d;
        }
    }
    if (n == 1) {
        h.v[h.count++] = p[0];
        return h;
    }
    for (int i = 0; i < n; i++) {
        hull_add(&h, 1, p[i]);
    }
    int keep = h.count;
    for (int i = n - 2; i >= 0; i--) {
        hull_add(&h, keep, p[i]);
    }
    h.count--; /* the first corner, which the lower chain added again */
    return h;
}

/* Distance of p from the segment from a to b. */
static inline real segment_distance(vec a, vec b, vec p) {
    vec d = minus(b, a), q = minus(p, a);
    real square = dot(d, d), t = square > 0.0L ? dot(d, q) / square : 0.0L;
    if (t > 0.0L && t < 1.0L) {
        return fabsl(cross(d, q)) / sqrtl(square);
    }
    return length_of(t < 0.5L ? q : minus(p, b));
}

/* Signed distance of p from the sum; negative inside, the penetration depth. */
static inline real sum_distance(const sum *h, vec p) {
    real nearest = 1e300L, deepest = -1e300L;
    if (h->count == 1) {
        return length_of(minus(p, h->v[0])) - h->radius;
    }
    for (int i = 0; i < h->count; i++) {
        vec a = h->v[i], b = h->v[(i + 1) % h->count], d = minus(b, a);
        deepest = fmaxl(deepest, cross(minus(p, a), d) / length_of(d));
        nearest = fminl(nearest, segment_distance(a, b, p));
    }
    return (deepest > 0.0L || h->count == 2 ? nearest : deepest) - h->radius;
}

/* Signed distance of two solids; negative: the penetration depth. */
static inline real solids_distance(const solid *a, const solid *b) {
    sum h = sum_of(a, b);
    return sum_distance(&h, vec_of(0.0L, 0.0L));
}

/* Signed distance of a point from a solid. */
static inline real solid_distance(const solid *s, vec p) {
    solid point = {.count = 1, .v = {p}};
    return solids_distance(&point, s);
}

/* Time that means "no impact": later than 1, the end of every motion. */
#define NEVER 2.0L

/* Narrows the interval [first, last] of times t to those at which p + t d is at least `inset`
 * inside of the edge from a to b. *last is negative where there are none. */
static inline void clip_path(vec a, vec b, real inset, vec p, vec d, real *first, real *last) {
    vec along = unit(minus(b, a)), out = {along.y, -along.x};
    real start = dot(out, minus(p, a)) + inset, speed = dot(out, d);
    if (speed == 0.0L) {
        *last = start <= 0.0L ? *last : -1.0L;
    } else if (speed < 0.0L) {
        *first = fmaxl(*first, -start / speed);
    } else {
        *last = fminl(*last, -start / speed);
    }
}

/* The first time t >= 0 at which p + t d is within the circle, or NEVER. */
static inline real enters_circle(vec center, real radius, vec p, vec d) {
    vec o = minus(p, center);
    real a = dot(d, d), b = dot(o, d), side = cross(d, o);
    if (length_of(o) <= radius) {
        return 0.0L;
    }
    if (b >= 0.0L || side * side > radius * radius * a) {
        return NEVER;
    }
    return (-b - sqrtl(radius * radius * a - side * side)) / a;
}

/* The first time in [0, 1] at which a point that starts at the origin and moves by d is within
 * `radius` of the polygon, or NEVER. With a negative radius the polygon is shrunk by it. */
static inline real enters(const sum *h, real radius, vec d) {
    vec origin = {0.0L, 0.0L};
    real time = NEVER, first = 0.0L, last = 1.0L;
    for (int i = 0; i < h->count && h->count > 1; i++) {
        vec a = h->v[i], b = h->v[(i + 1) % h->count], along = unit(minus(b, a));
        clip_path(a, b, -fminl(radius, 0.0L), origin, d, &first, &last);
        if (radius > 0.0L) { /* the strip of width `radius` along the edge, outside of it */
            vec out = {along.y * radius, -along.x * radius};
            vec c = {a.x + out.x, a.y + out.y}, e = {b.x + out.x, b.y + out.y};
            real from = 0.0L, to = 1.0L;
            clip_path(c, e, 0.0L, origin, d, &from, &to);
            clip_path(b, a, 0.0L, origin, d, &from, &to);
            clip_path(a, c, 0.0L, origin, d, &from, &to);
            clip_path(e, b, 0.0L, origin, d, &from, &to);
            time = from <= to ? fminl(time, from) : time;
        }
    }
    if (h->count > 2 && first <= last) {
        time = fminl(time, first);
    }
    for (int i = 0; i < h->count && radius >= 0.0L; i++) {
        time = fminl(time, enters_circle(h->v[i], radius, origin, d));
    }
    return time <= 1.0L ? time : NEVER;
}

/* The gap between a and b along the unit vector n: by how far b is beyond a. The distance of two
 * separate shapes is the greatest gap over all directions, so a direction with that gap is a
 * correct normal. */
static inline real gap_along(const solid *a, const solid *b, vec n) {
    real top = -1e300L, low = 1e300L;
    for (int i = 0; i < a->count; i++) {
        top = fmaxl(top, dot(n, a->v[i]));
    }
    for (int i = 0; i < b->count; i++) {
        low = fminl(low, dot(n, b->v[i]));
    }
    return low - top - a->radius - b->radius;
}

#endif
