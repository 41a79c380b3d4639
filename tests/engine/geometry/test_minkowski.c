/* test_minkowski.c: Minkowski sums of every pair of kinds against long double, and casts against a
 * search for the least distance along the path. THUD_CASES of the environment sets the number of
 * cases for each pair. */
#include "geometry_pairs.h"
#include "thud/thud_minkowski.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases for each pair of kinds; golden sections of a search. */
enum { CASES = 20000, SECTIONS = 48 };

/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 12.0

#define OK(call) assert_int_equal(call, THUD_OK)

/* A case: a pair with its Minkowski sum; `slack` is the tolerance of distances. */
typedef struct trial {
    pair p;
    double x, y; /* b's centre, relative to a's */
    thud_minkowski sum;
    double slack;
} trial;

/* Calls `check` for every pair of kinds, every family and that many cases. Shape a is moved to the
 * origin, as the sum does not depend on its place. */
static void each_pair(uint64_t seed, int cases, void (*check)(source *r, const trial *t)) {
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {seed + kinds};
        for (int i = 0; i < cases; i++) {
            trial t = {.p = draw_pair_of(&r, kinds, (pair_family)(i % FAMILIES))};
            OK(thud_minkowski_sum(&t.p.a, &t.p.b, &t.sum));
            t.x = t.p.b.x - t.p.a.x;
            t.y = t.p.b.y - t.p.a.y;
            t.p.a.x = t.p.a.y = 0.0;
            t.p.b.x = t.x;
            t.p.b.y = t.y;
            t.slack = BOUND * pair_rounding(&t.p);
            check(&r, &t);
        }
    }
}

/* The distance, normal and containment of b's centre against long double. */
static void check_distance(source *r, const trial *t) {
    (void)r;
    solid a = solid_of(&t->p.a, 0.0, 0.0), b = solid_of(&t->p.b, 0.0, 0.0);
    real exact = solids_distance(&a, &b);
    double distance, nx, ny;
    bool inside;
    OK(thud_minkowski_distance(&t->sum, t->x, t->y, &distance, &nx, &ny));
    OK(thud_minkowski_contains(&t->sum, t->x, t->y, &inside));
    vec n = {nx, ny};
    CHECK_PAIR(&t->p, fabsl(distance - exact) <= t->slack);
    CHECK_PAIR(&t->p, inside == (exact <= 0.0L) || fabsl(exact) <= t->slack);
    CHECK_PAIR(&t->p, fabsl(length_of(n) - 1.0L) <= BOUND * ROUNDING);
    CHECK_PAIR(&t->p, fabsl(gap_along(&a, &b, unit(n)) - exact) <= t->slack);
}

static void distance_of_every_pair_is_that_of_long_double(void **state) {
    (void)state;
    each_pair(1, case_count(CASES), check_distance);
}

/* How far the shape extends in the direction n (its support function). */
static real support(const thud_geometry *shape, vec n) {
    solid s = solid_of(shape, shape->x, shape->y);
    real most = -1e300L;
    for (int i = 0; i < s.count; i++) {
        most = fmaxl(most, dot(n, s.v[i]));
    }
    return most + s.radius;
}

/* The sum's polygon: each face touches both shapes' support, and corners are in order. */
static void check_polygon(source *r, const trial *t) {
    (void)r;
    const thud_minkowski *m = &t->sum;
    int faces = m->count / 2;
    int circles = (t->p.a.kind == THUD_SHAPE_CIRCLE) + (t->p.b.kind == THUD_SHAPE_CIRCLE);
    assert_true(circles == 2 ? m->count == 1 : circles == 1 ? m->count == 4 : m->count >= 4);
    assert_true(circles > 0 || m->radius == 0.0);
    for (int i = 0; i < m->count && m->count > 1; i++) {
        thud_pos p = m->vertices[i], q = m->vertices[(i + 1) % m->count];
        double sign = i < faces ? 1.0 : -1.0, offset = m->offsets[i % faces];
        vec n = {sign * m->normals[i % faces].x, sign * m->normals[i % faces].y};
        real reach = support(&t->p.a, n) + support(&t->p.b, n);
        CHECK_PAIR(&t->p, fabsl(reach - offset - m->radius) <= t->slack);
        CHECK_PAIR(&t->p, fabsl(dot(n, vec_of(p.x, p.y)) - offset) <= t->slack);
        CHECK_PAIR(&t->p, fabsl(dot(n, vec_of(q.x, q.y)) - offset) <= t->slack);
        /* counter-clockwise */
        CHECK_PAIR(&t->p, cross(n, vec_of(q.x - p.x, q.y - p.y)) >= -t->slack);
        CHECK_PAIR(&t->p, fabsl(length_of(n) - 1.0L) <= BOUND * ROUNDING);
    }
}

static void faces_of_every_sum_support_both_shapes(void **state) {
    (void)state;
    each_pair(11, case_count(CASES), check_polygon);
}

/* The engine's own distance with b at another place. */
static double distance_at(const trial *t, double x, double y) {
    thud_geometry b = t->p.b;
    thud_closest c;
    b.x = x;
    b.y = y;
    assert_int_equal(thud_geometry_closest(&t->p.a, &b, &c), THUD_OK);
    return c.distance;
}

/* The least distance of b from a on its way up to the fraction `end`. The distance from a convex
 * set is convex along a line, so that golden-section search finds it (Kiefer 1953). */
static double least_distance(const trial *t, double dx, double dy, double end) {
    const double golden = 0.6180339887498949;
    double low = 0.0, high = end;
    double p = high - golden * (high - low), q = low + golden * (high - low);
    double at_p = distance_at(t, t->x + p * dx, t->y + p * dy);
    double at_q = distance_at(t, t->x + q * dx, t->y + q * dy);
    double least =
        fmin(distance_at(t, t->x, t->y), distance_at(t, t->x + end * dx, t->y + end * dy));
    for (int i = 0; i < SECTIONS; i++) {
        least = fmin(least, fmin(at_p, at_q));
        if (at_p < at_q) {
            high = q, q = p, at_q = at_p;
            p = high - golden * (high - low);
            at_p = distance_at(t, t->x + p * dx, t->y + p * dy);
        } else {
            low = p, p = q, at_p = at_q;
            q = low + golden * (high - low);
            at_q = distance_at(t, t->x + q * dx, t->y + q * dy);
        }
    }
    return least;
}

/* Counts of casts and hits, asserted at the end. */
static int casts, hits;

/* A random cast against the least distance along its path. */
static void check_cast(source *r, const trial *t) {
    double reach = draw_below(r, 2) ? 8.0 : 2.0, fraction, nx, ny;
    double dx = draw(r, -reach, reach), dy = draw(r, -reach, reach);
    if (draw_below(r, 2)) { /* towards a */
        dx = -draw(r, 0.5, 3.0) * t->x + 0.2 * draw(r, -1.0, 1.0);
        dy = -draw(r, 0.5, 3.0) * t->y + 0.2 * draw(r, -1.0, 1.0);
    }
    if (draw_below(r, 8) == 0) {
        dy = 0.0;
    }
    trial from = *t;
    if (draw_below(r, 2)) { /* from outside, so that more casts hit */
        from.x -= dx;
        from.y -= dy;
        dx *= 2.0;
        dy *= 2.0;
    }
    bool hit, inside;
    OK(thud_minkowski_cast(&t->sum, (thud_segment){from.x, from.y, dx, dy}, &hit, &fraction, &nx,
                           &ny));
    OK(thud_minkowski_contains(&t->sum, from.x, from.y, &inside));
    casts++;
    hits += hit;
    double eps = 2e-12 * (1.0 + hypot(dx, dy));
    if (!hit) {
        assert_true(fraction == 1.0 && nx == 0.0 && ny == 0.0);
        assert_true(least_distance(&from, dx, dy, 1.0) > -eps);
        return;
    }
    assert_true(fraction >= 0.0 && fraction <= 1.0);
    assert_true(fabs(nx * nx + ny * ny - 1.0) < 1e-12);
    if (inside) {
        assert_true(fraction == 0.0);
        return;
    }
    assert_true(fabs(distance_at(t, from.x + fraction * dx, from.y + fraction * dy)) < eps);
    assert_true(least_distance(&from, dx, dy, fraction) > -eps);
    assert_true(nx * dx + ny * dy <= eps);
    /* The normal points outward: no point of the sum is beyond the edge at the point of impact. */
    vec n = {nx, ny}, there = {(real)from.x + fraction * dx, (real)from.y + fraction * dy};
    assert_true(fabsl(dot(n, there) - support(&t->p.a, n) - support(&t->p.b, n)) < eps);
}

static void casts_of_random_motions_agree_with_the_least_distance(void **state) {
    (void)state;
    casts = hits = 0;
    each_pair(21, case_count(CASES / 2), check_cast);
    assert_true(hits > casts / 3 && hits < casts * 9 / 10);
}

/* A negligible rotation makes thud_geometry_time_of_impact use conservative advancement. */
static void check_advancement(source *r, const trial *t) {
    thud_motion m = {draw(r, -4.0, 4.0), draw(r, -4.0, 4.0), 1e-15}, still = {0};
    bool hit, hit_by_steps;
    double fraction, time, nx, ny;
    OK(thud_minkowski_cast(&t->sum, (thud_segment){t->x, t->y, m.dx, m.dy}, &hit, &fraction, &nx,
                           &ny));
    assert_int_equal(thud_geometry_time_of_impact(&t->p.a, still, &t->p.b, m, 0.0, &hit_by_steps,
                                                  &time),
                     THUD_OK);
    if (hit) {
        assert_true(hit_by_steps && time <= fraction + 1e-9);
    }
    if (hit_by_steps) {
        double distance = distance_at(t, t->x + time * m.dx, t->y + time * m.dy);
        assert_true(hit || distance > -1e-11);
    }
}

static void casts_never_come_before_conservative_advancement(void **state) {
    (void)state;
    each_pair(31, case_count(CASES / 4), check_advancement);
}

/* Within a rounding of a vertex the direction from it may be any; the normal must still separate
 * the shapes. */
static void normal_at_a_vertex_within_rounding_is_one_that_parts(void **state) {
    (void)state;
    source r = {6};
    for (int i = 0; i < CASES; i++) {
        thud_geometry a = draw_shape_of(&r, THUD_SHAPE_OBB);
        thud_geometry b = draw_shape_of(&r, i % 2 ? THUD_SHAPE_OBB : THUD_SHAPE_AABB);
        thud_minkowski m;
        OK(thud_minkowski_sum(&a, &b, &m));
        thud_pos v = m.vertices[draw_below(&r, 8)];
        double x = v.x + 2e-16 * draw_below(&r, 4) * v.x, y = v.y + 2e-16 * draw_below(&r, 4) * v.y;
        double distance, nx, ny;
        OK(thud_minkowski_distance(&m, x, y, &distance, &nx, &ny));
        vec n = {nx, ny};
        assert_true(fabs(distance) < 1e-13);
        assert_true(fabsl(dot(n, vec_of(x, y)) - support(&a, n) - support(&b, n)) < 1e-13);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distance_of_every_pair_is_that_of_long_double),
        cmocka_unit_test(faces_of_every_sum_support_both_shapes),
        cmocka_unit_test(casts_of_random_motions_agree_with_the_least_distance),
        cmocka_unit_test(casts_never_come_before_conservative_advancement),
        cmocka_unit_test(normal_at_a_vertex_within_rounding_is_one_that_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
