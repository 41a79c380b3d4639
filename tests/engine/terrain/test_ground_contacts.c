/* test_ground_contacts.c: contact points of shapes and ground. The first must be at the closest
 * features. The candidates for the second are found again in long double, and each is either
 * certain or depends on rounding. */
#include "geometry_ground.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { QUICK = 4000 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 32.0

/* The greatest distance of candidates from the first point: of all that may count, and of those
 * that must. */
typedef struct reach {
    const ground *g;
    vec from;
    real margin, slack, may, must;
} reach;

/* Adds a candidate at `place`, with that separation. */
static void offer(reach *k, real distance, vec place, bool certain) {
    real apart = length_of(minus(place, k->from));
    if (distance <= k->margin + k->slack) {
        k->may = fmaxl(k->may, apart);
    }
    if (certain && distance <= k->margin - k->slack) {
        k->must = fmaxl(k->must, apart);
    }
}

/* The point of the segment from a to b that is nearest to p. */
static vec nearest_on(vec a, vec b, vec p) {
    vec d = minus(b, a);
    real t = dot(minus(p, a), d) / dot(d, d);
    t = fminl(fmaxl(t, 0.0L), 1.0L);
    return vec_of(a.x + t * d.x, a.y + t * d.y);
}

/* A corner, with the nearest places on the outline; where a second place is as near, the candidate
 * is uncertain. */
static void offer_corner(reach *k, vec corner) {
    const thud_terrain *t = &k->g->terrain;
    const thud_geometry *s = &k->g->shape;
    vec place[MAX_VERTICES + 2];
    int count = 0;
    if (t->kind == THUD_TERRAIN_FLAT) {
        real height = line_height(t, s, 0.0L);
        place[count++] = nearest_on(vec_of(-99.0L, height - 99.0L * t->slope),
                                    vec_of(99.0L, height + 99.0L * t->slope), corner);
    } else {
        vec left = vertex_from(t, s, 0), right = vertex_from(t, s, t->count - 1);
        place[count++] = vec_of(left.x, fminl(left.y, corner.y));
        place[count++] = vec_of(right.x, fminl(right.y, corner.y));
        for (int i = 0; i + 1 < t->count; i++) {
            place[count++] = nearest_on(vertex_from(t, s, i), vertex_from(t, s, i + 1), corner);
        }
    }
    real least = HUGE_VALL, furthest = 0.0L;
    for (int i = 0; i < count; i++) {
        least = fminl(least, length_of(minus(place[i], corner)));
    }
    bool inside = corner.y < line_height(t, s, corner.x);
    for (int i = 0; i < count; i++) {
        bool nearest = length_of(minus(place[i], corner)) <= least + k->slack;
        for (int j = 0; j < i && nearest; j++) {
            bool also = length_of(minus(place[j], corner)) <= least + k->slack;
            furthest = also ? fmaxl(furthest, length_of(minus(place[i], place[j]))) : furthest;
        }
    }
    for (int i = 0; i < count; i++) {
        if (length_of(minus(place[i], corner)) <= least + k->slack) {
            offer(k, inside ? -least : least, place[i], furthest <= 1e-9L);
        }
    }
}

/* The direction in which the shape would be moved away from the place p. */
static vec way_off(const thud_geometry *s, vec p, real *distance) {
    solid shape = solid_of(s, s->x, s->y);
    *distance = solid_distance(&shape, p);
    if (s->kind == THUD_SHAPE_CIRCLE) {
        return unit(vec_of(-p.x, -p.y));
    }
    real u = s->c * p.x + s->s * p.y, v = s->c * p.y - s->s * p.x;
    real over_u = fabsl(u) - s->hx, over_v = fabsl(v) - s->hy;
    real nu = 0.0L, nv = 0.0L;
    if (over_u > 0.0L || over_v > 0.0L) {
        nu = copysignl(fmaxl(over_u, 0.0L), -u);
        nv = copysignl(fmaxl(over_v, 0.0L), -v);
    } else if (over_u > over_v) {
        nu = copysignl(1.0L, -u);
    } else {
        nv = copysignl(1.0L, -v);
    }
    return unit(vec_of(s->c * nu - s->s * nv, s->s * nu + s->c * nv));
}

/* Whether a ridge counts depends on its sharpness, on the direction away from it, and on whether
 * that is between the normals of its sides. The direction depends on rounding on the shape's
 * outline, at its centre (where it may be NaN), and where two faces are equally near. */
static void offer_ridge(reach *k, int i) {
    const thud_terrain *t = &k->g->terrain;
    const thud_geometry *s = &k->g->shape;
    vec v = vertex_from(t, s, i), before = {0.0L, 1.0L}, after = {0.0L, -1.0L};
    if (i > 0) {
        before = unit(minus(v, vertex_from(t, s, i - 1)));
    }
    if (i < t->count - 1) {
        after = unit(minus(vertex_from(t, s, i + 1), v));
    }
    real distance, ridge = -cross(before, after);
    vec n = way_off(s, v, &distance);
    real u = fabsl(s->c * v.x + s->s * v.y) - s->hx, w = fabsl(s->c * v.y - s->s * v.x) - s->hy;
    bool chosen = fabsl(distance) <= 1e-6L || !(fabsl(dot(n, v)) > k->slack) ||
                  (s->kind != THUD_SHAPE_CIRCLE && fabsl(u - w) <= k->slack);
    bool within = dot(n, before) >= -1e-8L && dot(n, after) <= 1e-8L;
    bool clearly = ridge > 1e-8L && dot(n, before) > 1e-8L && dot(n, after) < -1e-8L;
    if (ridge > 0.0L && (within || chosen)) {
        offer(k, distance, v, clearly && !chosen);
    }
}

/* A segment below a circle whose centre is `out` outside of the ground. */
static void offer_segment(reach *k, int i, real out) {
    vec p = vertex_from(&k->g->terrain, &k->g->shape, i);
    vec q = vertex_from(&k->g->terrain, &k->g->shape, i + 1), d = unit(minus(q, p));
    real along = -dot(d, p), above = -cross(d, p), length = length_of(minus(q, p));
    real least = fminl(fminl(along, length - along), fminl(above, out));
    if (least >= -k->slack) {
        bool clear = least >= k->slack;
        offer(k, above - k->g->shape.hx, vec_of(d.y * above, -d.x * above), clear);
    }
}

/* Offers all candidates for the second point. */
static reach search(const ground *g, const thud_closest *from, double depth, double margin,
                    double slack) {
    reach k = {.g = g,
               .from = {(real)from->ax - g->shape.x, (real)from->ay - g->shape.y},
               .margin = margin,
               .slack = slack};
    const thud_terrain *t = &g->terrain;
    solid shape = solid_of(&g->shape, g->shape.x, g->shape.y);
    bool round = g->shape.kind == THUD_SHAPE_CIRCLE, flat = t->kind == THUD_TERRAIN_FLAT;
    for (int i = 0; i < 4 && !round; i++) {
        offer_corner(&k, shape.v[i]);
    }
    for (int i = 0; i < t->count && !flat; i++) {
        offer_ridge(&k, i);
        if (round && i + 1 < t->count) {
            offer_segment(&k, i, (real)depth + g->shape.hx);
        }
    }
    return k;
}

/* Asserts that a contact's points are on the shape and on the ground, and the distance apart along
 * the normal. */
static void check_point(const ground *g, const thud_closest *c, double coarse) {
    const thud_geometry *s = &g->shape;
    solid shape = solid_of(s, s->x, s->y);
    vec on_shape = {(real)c->bx - s->x, (real)c->by - s->y};
    solid on_ground = {.count = 1, .v = {{(real)c->ax - s->x, (real)c->ay - s->y}}};
    CHECK_GROUND(g, fabs(c->nx * c->nx + c->ny * c->ny - 1.0) <= BOUND * ROUNDING);
    CHECK_GROUND(g, fabs(c->bx - c->ax - c->nx * c->distance) <= coarse);
    CHECK_GROUND(g, fabs(c->by - c->ay - c->ny * c->distance) <= coarse);
    CHECK_GROUND(g, fabsl(solid_distance(&shape, on_shape)) <= coarse);
    CHECK_GROUND(g, fabsl(outline_distance(g, &on_ground)) <= coarse);
}

static real apart(const thud_closest *one, const thud_closest *two) {
    return length_of(vec_of((real)two->ax - one->ax, (real)two->ay - one->ay));
}

/* The second point is the candidate farthest from the closest features. The first is at the closest
 * features, or at another place as deep and farther from the second. */
static void check_second(const ground *g, const thud_contacts *c, const thud_closest *closest,
                         double margin, double slack) {
    const thud_closest *one = &c->point[0], *two = &c->point[1];
    double coarse = BOUND * spot_rounding(g), size = g->shape.hx + g->shape.hy;
    real placed = 8.0L * coarse * steepest(&g->terrain);
    reach k = search(g, closest, closest->distance, margin, slack);
    if (c->count < 2) {
        CHECK_GROUND(g, k.must <= 2e-9L * size + placed);
        return;
    }
    check_point(g, two, coarse);
    CHECK_GROUND(g, two->distance <= margin && two->distance >= closest->distance - slack);
    CHECK_GROUND(g,
                 apart(closest, two) >= k.must - placed && apart(closest, two) <= k.may + placed);
    CHECK_GROUND(g, one->distance <= closest->distance + 1.01e-9 * size + slack);
    CHECK_GROUND(g, apart(one, two) >= apart(closest, two) - placed);
    reach back = search(g, two, closest->distance, closest->distance + 1e-9 * size, slack);
    CHECK_GROUND(g, apart(one, two) >= back.must - placed);
    CHECK_GROUND(g, apart(one, two) <= fmaxl(back.may, apart(closest, two)) + placed);
}

/* How many cases had a second point. */
static int seconds;

static void check_contacts(const ground *g, double margin) {
    double slack = BOUND * ground_rounding(g), coarse = BOUND * spot_rounding(g);
    thud_closest closest;
    thud_contacts c;
    assert_int_equal(thud_terrain_closest(&g->terrain, &g->shape, &closest), THUD_OK);
    assert_int_equal(thud_terrain_contacts(&g->terrain, &g->shape, margin, &c), THUD_OK);
    CHECK_GROUND(g, (c.count > 0) == (closest.distance <= margin));
    if (c.count > 0) {
        check_point(g, &c.point[0], coarse);
        check_second(g, &c, &closest, margin, slack);
        seconds += c.count > 1;
    }
}

static void each_ground(thud_terrain_kind kind) {
    int count = case_count(QUICK);
    for (int shape = 0; shape < 3; shape++) {
        source r = {71 + 3 * kind + shape};
        seconds = 0;
        for (int i = 0; i < count; i++) {
            ground g;
            check_contacts(draw_ground_of(&r, &g, kind, (thud_shape_kind)shape, i), i % 5   ? 0.02
                                                                                    : i % 2 ? 0.0
                                                                                            : 10.0);
        }
        bool never = kind == THUD_TERRAIN_FLAT && shape == THUD_SHAPE_CIRCLE;
        assert_true(never ? seconds == 0 : seconds > count / 50);
    }
}

static void contacts_of_flat_ground_are_those_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_FLAT);
}

static void contacts_of_uniform_ground_are_those_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_UNIFORM);
}

static void contacts_of_irregular_ground_are_those_of_long_double(void **state) {
    (void)state;
    each_ground(THUD_TERRAIN_IRREGULAR);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_of_flat_ground_are_those_of_long_double),
        cmocka_unit_test(contacts_of_uniform_ground_are_those_of_long_double),
        cmocka_unit_test(contacts_of_irregular_ground_are_those_of_long_double),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
