/* test_minkowski.c: Minkowski sums of all pairs of kinds, in the families where such code goes
 * wrong, against the shapes' own distance, against support functions in long double, and casts
 * against a search of the least distance along the path. THUD_CASES sets the cases a pair. */
#include "geometry_random.h"
#include "thud/thud_minkowski.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { CASES = 20000, KINDS = 3, DIRECTIONS = 16, SECTIONS = 48 };

#define OK(call) assert_int_equal(call, THUD_OK)

/* Places are compared about a, where they are exact; only an absolute rounding is left. */
#define EPS 2e-12

typedef struct trial {
    thud_placed a, b; /* a at the origin */
    double x, y;      /* b's centre, seen from a's */
    thud_minkowski sum;
} trial;

/* Calls the check with every kind of pair, every family, and as many cases as are asked for. */
static void for_all_pairs(uint64_t seed, int cases, void (*check)(source *r, const trial *t))
{
    source r = {seed};
    for (int pair = 0; pair < KINDS * KINDS; pair++) {
        for (int i = 0; i < cases; i++) {
            trial t;
            draw_two(&r, (thud_shape_kind)(pair / KINDS), (thud_shape_kind)(pair % KINDS),
                     i % FAMILY_COUNT, &t.a, &t.b);
            OK(thud_minkowski_sum(&t.a, &t.b, &t.sum));
            t.x = t.b.x - t.a.x;
            t.y = t.b.y - t.a.y;
            t.a.x = t.a.y = 0.0;
            t.b.x = t.x;
            t.b.y = t.y;
            check(&r, &t);
        }
    }
}

static long double support(const thud_placed *shape, long double nx, long double ny)
{
    if (shape->kind == THUD_CIRCLE) {
        return shape->hx * sqrtl(nx * nx + ny * ny);
    }
    long double length = hypotl(shape->c, shape->s);
    return (fabsl(shape->c * nx + shape->s * ny) * shape->hx +
            fabsl(shape->c * ny - shape->s * nx) * shape->hy) / length;
}

/* How far the shapes are apart along a direction of length 1: no more than their distance. */
static long double apart(const trial *t, long double nx, long double ny)
{
    return nx * t->x + ny * t->y - support(&t->a, nx, ny) - support(&t->b, nx, ny);
}

static double distance_at(const trial *t, double x, double y)
{
    thud_placed b = t->b;
    thud_closest c;
    b.x = x;
    b.y = y;
    assert_int_equal(thud_shapes_closest(&t->a, &b, &c), THUD_OK);
    return c.distance;
}

static void check_distance(source *r, const trial *t)
{
    (void)r;
    double distance, nx, ny, expected = distance_at(t, t->x, t->y);
    bool inside;
    OK(thud_minkowski_distance(&t->sum, t->x, t->y, &distance, &nx, &ny));
    OK(thud_minkowski_contains(&t->sum, t->x, t->y, &inside));
    assert_true(fabs(distance - expected) < EPS);
    assert_true(inside == (expected <= 0.0) || fabs(expected) < EPS);
    assert_true(fabs(nx * nx + ny * ny - 1.0) < 1e-14);
    /* Along the normal, the distance passes 0 after as much. */
    assert_true(fabs(distance_at(t, t->x - distance * nx, t->y - distance * ny)) < EPS);
}

static void distance_of_random_pairs_agrees_with_closest(void **state)
{
    (void)state;
    for_all_pairs(1, case_count(CASES), check_distance);
}

/* The signed distance is the most that the shapes are apart along any direction. */
static void check_support(source *r, const trial *t)
{
    double distance, nx, ny;
    OK(thud_minkowski_distance(&t->sum, t->x, t->y, &distance, &nx, &ny));
    /* A normal from a corner is as inexact as the corner's place beside its distance. */
    double from_corner = fabs(distance + t->sum.radius) + 1e-15;
    assert_true(fabsl(apart(t, nx, ny) - distance) < EPS + 1e-14 / from_corner);
    for (int i = 0; i < 4; i++) {
        double sign = i < 2 ? 1.0 : -1.0;
        const thud_placed *s = i % 2 ? &t->a : &t->b;
        assert_true(apart(t, sign * s->c, sign * s->s) < distance + EPS ||
                    s->kind == THUD_CIRCLE);
        assert_true(apart(t, -sign * s->s, sign * s->c) < distance + EPS ||
                    s->kind == THUD_CIRCLE);
    }
    double angle = draw(r, 0.0, 7.0);
    for (int i = 0; i < DIRECTIONS; i++) {
        double a = angle + i * (6.283185307179586 / DIRECTIONS);
        assert_true(apart(t, cos(a), sin(a)) < distance + EPS);
    }
}

static void distance_of_random_pairs_is_the_most_along_any_direction(void **state)
{
    (void)state;
    for_all_pairs(2, case_count(CASES / 2), check_support);
}

static void check_polygon(source *r, const trial *t)
{
    (void)r;
    const thud_minkowski *m = &t->sum;
    int faces = m->count / 2, circles = (t->a.kind == THUD_CIRCLE) + (t->b.kind == THUD_CIRCLE);
    assert_true(circles == 2 ? m->count == 1 : circles == 1 ? m->count == 4 : m->count >= 4);
    assert_true(circles > 0 || m->radius == 0.0);
    for (int i = 0; i < m->count && m->count > 1; i++) {
        thud_pos p = m->vertices[i], q = m->vertices[(i + 1) % m->count];
        double sign = i < faces ? 1.0 : -1.0;
        double nx = sign * m->normals[i % faces].x, ny = sign * m->normals[i % faces].y;
        double offset = m->offsets[i % faces];
        long double reach = support(&t->a, nx, ny) + support(&t->b, nx, ny);
        assert_true(fabsl(reach - offset - m->radius) < EPS);
        assert_true(fabs(nx * p.x + ny * p.y - offset) < EPS);
        assert_true(fabs(nx * q.x + ny * q.y - offset) < EPS);
        assert_true(nx * (q.y - p.y) - ny * (q.x - p.x) > -EPS); /* counter-clockwise */
        assert_true(fabs(nx * nx + ny * ny - 1.0) < 1e-14);
    }
}

static void faces_of_random_sums_support_both_shapes(void **state)
{
    (void)state;
    for_all_pairs(3, case_count(CASES), check_polygon);
}

/* The least distance of b from a on its way up to `end`. The distance from a convex set is a convex
 * function along a line, so that golden sections find it (Kiefer 1953). */
static double least_distance(const trial *t, double dx, double dy, double end)
{
    const double golden = 0.6180339887498949;
    double low = 0.0, high = end;
    double p = high - golden * (high - low), q = low + golden * (high - low);
    double at_p = distance_at(t, t->x + p * dx, t->y + p * dy);
    double at_q = distance_at(t, t->x + q * dx, t->y + q * dy);
    double least = fmin(distance_at(t, t->x, t->y),
                        distance_at(t, t->x + end * dx, t->y + end * dy));
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

static int casts, hits;

static void check_cast(source *r, const trial *t)
{
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
    if (draw_below(r, 2)) { /* from outside, so that more is hit on the way */
        from.x -= dx;
        from.y -= dy;
        dx *= 2.0;
        dy *= 2.0;
    }
    bool hit, inside;
    OK(thud_minkowski_cast(&t->sum, from.x, from.y, dx, dy, &hit, &fraction, &nx, &ny));
    OK(thud_minkowski_contains(&t->sum, from.x, from.y, &inside));
    casts++;
    hits += hit;
    double eps = EPS * (1.0 + hypot(dx, dy));
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
    /* Outward: no point of the sum lies beyond the edge at the point of impact. */
    trial there = from;
    there.x += fraction * dx;
    there.y += fraction * dy;
    assert_true(fabsl(apart(&there, nx, ny)) < eps);
}

static void casts_of_random_motions_agree_with_the_least_distance(void **state)
{
    (void)state;
    casts = hits = 0;
    for_all_pairs(4, case_count(CASES / 2), check_cast);
    assert_true(hits > casts / 3 && hits < casts * 9 / 10);
}

/* Turning by next to nothing makes thud_shapes_time_of_impact advance step by step. */
static void check_advancement(source *r, const trial *t)
{
    thud_motion m = {draw(r, -4.0, 4.0), draw(r, -4.0, 4.0), 1e-15}, still = {0};
    bool hit, hit_by_steps;
    double fraction, time, nx, ny;
    OK(thud_minkowski_cast(&t->sum, t->x, t->y, m.dx, m.dy, &hit, &fraction, &nx, &ny));
    assert_int_equal(thud_shapes_time_of_impact(&t->a, still, &t->b, m, 0.0, &hit_by_steps, &time),
                     THUD_OK);
    if (hit) {
        assert_true(hit_by_steps && time <= fraction + 1e-9);
    }
    if (hit_by_steps) {
        double distance = distance_at(t, t->x + time * m.dx, t->y + time * m.dy);
        assert_true(hit || distance > -EPS);
    }
}

static void casts_never_come_before_conservative_advancement(void **state)
{
    (void)state;
    for_all_pairs(5, case_count(CASES / 4), check_advancement);
}

/* A rounding beside a vertex, the direction from it may be any; the normal must still part them. */
static void normal_at_a_corner_within_rounding_is_one_that_parts(void **state)
{
    (void)state;
    source r = {6};
    for (int i = 0; i < 20000; i++) {
        trial t;
        draw_two(&r, THUD_OBB, i % 2 ? THUD_OBB : THUD_AABB, FAMILY_ANY, &t.a, &t.b);
        OK(thud_minkowski_sum(&t.a, &t.b, &t.sum));
        thud_pos v = t.sum.vertices[draw_below(&r, 8)];
        t.x = v.x + 2e-16 * draw_below(&r, 4) * v.x;
        t.y = v.y + 2e-16 * draw_below(&r, 4) * v.y;
        double distance, nx, ny;
        OK(thud_minkowski_distance(&t.sum, t.x, t.y, &distance, &nx, &ny));
        assert_true(fabs(distance) < 1e-13);
        assert_true(fabsl(apart(&t, nx, ny)) < 1e-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distance_of_random_pairs_agrees_with_closest),
        cmocka_unit_test(distance_of_random_pairs_is_the_most_along_any_direction),
        cmocka_unit_test(faces_of_random_sums_support_both_shapes),
        cmocka_unit_test(casts_of_random_motions_agree_with_the_least_distance),
        cmocka_unit_test(casts_never_come_before_conservative_advancement),
        cmocka_unit_test(normal_at_a_corner_within_rounding_is_one_that_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
