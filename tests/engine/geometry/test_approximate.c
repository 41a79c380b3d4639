/* test_approximate.c: polygons approximated by circles and boxes: by figures worked out by hand,
 * and random polygons against dense samples. THUD_CASES of the environment sets the number of
 * random polygons. */
#include "geometry_random.h"
#include "hostile_memory.h"
#include "thud/thud_all.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 30, MOST = THUD_APPROXIMATE_SHAPES_MAX, SAMPLES = 250, POINTS = 40 };

static const double PI = 3.141592653589793;

/* A polygon. */
typedef struct outline_points {
    int count;
    thud_pos at[THUD_POLYGON_POINTS_MAX];
} outline_points;

/* What was found for one. */
typedef struct answer {
    thud_geometry shapes[MOST];
    thud_approximation found;
} answer;

static answer approximate(const outline_points *p, int most, thud_approximate_kind kinds) {
    answer a;
    thud_approximate_options options = {.shapes_max = most, .kinds = kinds};
    memset(&a, 0, sizeof a);
    assert_int_equal(thud_approximate(p->at, p->count, &options, a.shapes, &a.found), THUD_OK);
    assert_in_range(a.found.count, 1, most);
    for (int i = 0; i < a.found.count; i++) {
        assert_int_equal(thud_geometry_check(&a.shapes[i]), THUD_OK);
        assert_true(kinds != THUD_APPROXIMATE_CIRCLES || a.shapes[i].kind == THUD_SHAPE_CIRCLE);
        assert_true(kinds != THUD_APPROXIMATE_BOXES || a.shapes[i].kind == THUD_SHAPE_OBB);
    }
    return a;
}

static void near(double value, double expected, double tolerance) {
    if (!(fabs(value - expected) <= tolerance)) {
        fail_msg("%.12g is not %.12g within %g", value, expected, tolerance);
    }
}

/* Nothing is missed, within rounding. */
static void exact(const answer *a, int count) {
    assert_int_equal(a->found.count, count);
    near(a->found.missed, 0.0, 1e-9);
    near(a->found.extra, 0.0, 1e-9);
    near(a->found.distance, 0.0, 1e-9);
}

static outline_points turned_by(outline_points p, double angle, double x, double y) {
    for (int i = 0; i < p.count; i++) {
        thud_pos q = p.at[i];
        p.at[i].x = x + cos(angle) * q.x - sin(angle) * q.y;
        p.at[i].y = y + sin(angle) * q.x + cos(angle) * q.y;
    }
    return p;
}

static const outline_points RECTANGLE = {4, {{0, 0}, {3, 0}, {3, 1}, {0, 1}}};
static const outline_points AN_L = {6, {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
static const outline_points A_PLUS = {12,
                                      {{1, 0},
                                       {2, 0},
                                       {2, 1},
                                       {3, 1},
                                       {3, 2},
                                       {2, 2},
                                       {2, 3},
                                       {1, 3},
                                       {1, 2},
                                       {0, 2},
                                       {0, 1},
                                       {1, 1}}};

static outline_points regular(int count) {
    outline_points p = {.count = count};
    for (int i = 0; i < count; i++) {
        p.at[i] = (thud_pos){cos(2.0 * PI * i / count), sin(2.0 * PI * i / count)};
    }
    return p;
}

/* ---- by hand ---- */

static void a_rectangle_is_one_box_at_any_angle(void **state) {
    (void)state;
    answer a = approximate(&RECTANGLE, 5, THUD_APPROXIMATE_BOTH);
    exact(&a, 1);
    near(a.shapes[0].x, 1.5, 1e-12);
    near(a.shapes[0].y, 0.5, 1e-12);
    near(a.shapes[0].hx, 1.5, 1e-12);
    near(a.shapes[0].hy, 0.5, 1e-12);
    assert_true(a.shapes[0].c == 1.0 && a.shapes[0].s == 0.0);
    for (int i = 0; i < 40; i++) {
        outline_points p = turned_by(RECTANGLE, 0.17 * i, 5.0, -700.0);
        a = approximate(&p, 5, THUD_APPROXIMATE_BOTH);
        exact(&a, 1);
        double angle;
        assert_int_equal(thud_angle_of(a.shapes[0].s, a.shapes[0].c, &angle), THUD_OK);
        assert_true(fabs(angle) < 0.7854);
        near(fmod(0.17 * i - angle + 100.0 * PI + 1e-6, 0.5 * PI), 1e-6, 1e-9);
    }
}

static void right_angled_polygons_are_their_boxes(void **state) {
    (void)state;
    answer one = approximate(&AN_L, 1, THUD_APPROXIMATE_BOTH);
    /* The larger leg, 3 of 5 units of area; the other one's end is 2 away. */
    near(one.found.missed, 0.4, 1e-9);
    near(one.found.extra, 0.0, 1e-9);
    assert_true(one.found.distance >= 2.0 && one.found.distance <= 2.0 * 17.0 / 16.0);
    answer two = approximate(&AN_L, 8, THUD_APPROXIMATE_BOTH);
    exact(&two, 2);
    near(two.found.overlap, 0.0, 1e-9);
    answer plus = approximate(&A_PLUS, 8, THUD_APPROXIMATE_BOTH);
    exact(&plus, 2);
    near(plus.found.overlap, 0.2, 1e-9); /* the middle, 1 of 5 */
    for (int i = 0; i < 10; i++) {
        outline_points p = turned_by(A_PLUS, 0.31 * i, 0.0, 0.0);
        plus = approximate(&p, 8, THUD_APPROXIMATE_BOXES);
        exact(&plus, 2);
    }
}

/* One circle about the centre of a regular polygon is best where half of it is inside: r = a /
 * cos(pi / 2n), for the distance a of the sides. Each of the n segments beyond a side then has the
 * area r^2 (f - sin f cos f), f = pi / 2n. */
static void a_regular_polygon_is_a_circle(void **state) {
    (void)state;
    for (int n = 4; n <= 12; n++) {
        outline_points p = regular(n);
        answer a = approximate(&p, 1, THUD_APPROXIMATE_CIRCLES);
        double side = cos(PI / n), f = 0.5 * PI / n, r = side / cos(f);
        double area = 0.5 * n * sin(2.0 * PI / n);
        double extra = n * r * r * (f - sin(f) * cos(f));
        near(a.shapes[0].hx, r, 1e-2);
        near(a.shapes[0].x, 0.0, 1e-2);
        near(a.shapes[0].y, 0.0, 1e-2);
        near(a.found.missed + a.found.extra, (area - PI * r * r + 2.0 * extra) / area, 2e-3);
        assert_true(a.found.distance >= 1.0 - r - 1e-2);
        assert_true(a.found.distance <= (1.0 - r) * 17.0 / 16.0 + 2.0 / 256.0);
    }
}

static void the_distance_that_is_good_enough_ends_the_search(void **state) {
    (void)state;
    outline_points p = regular(3);
    answer all = approximate(&p, 12, THUD_APPROXIMATE_BOTH);
    for (int k = 1; k < all.found.count; k++) {
        answer some = approximate(&p, k, THUD_APPROXIMATE_BOTH), same;
        thud_approximate_options options = {.shapes_max = 12, .distance = some.found.distance};
        assert_int_equal(thud_approximate(p.at, p.count, &options, same.shapes, &same.found),
                         THUD_OK);
        assert_true(same.found.count <= some.found.count);
        assert_true(same.found.distance <= some.found.distance);
    }
}

/* ---- random polygons ---- */

/* A polygon around the origin whose points are at random distances; a quarter of them is
 * right-angled, as a skyline. */
static outline_points draw_polygon(source *r) {
    outline_points p = {.count = 3 + draw_below(r, POINTS - 3)};
    if (draw_below(r, 4) == 0) {
        int towers = 2 + draw_below(r, 8);
        p.count = 0;
        p.at[p.count++] = (thud_pos){0.0, 0.0};
        p.at[p.count++] = (thud_pos){towers, 0.0};
        for (int i = towers; i > 0; i--) {
            double height = 0.5 + i % 2 + draw(r, 0.0, 1.0);
            p.at[p.count++] = (thud_pos){i, height};
            p.at[p.count++] = (thud_pos){i - 1.0, height};
        }
        return p;
    }
    double least = draw(r, 0.2, 0.9), angle = draw(r, 0.0, 6.0), wide = draw(r, 0.3, 1.0);
    for (int i = 0; i < p.count; i++) {
        double distance = draw(r, least, 1.0), at = 2.0 * PI * i / p.count;
        p.at[i] = (thud_pos){distance * cos(at), wide * distance * sin(at)};
    }
    return turned_by(p, angle, draw(r, -3.0, 3.0), draw(r, -3.0, 3.0));
}

/* Whether a point is in the polygon: the number of edges to its right is odd. */
static bool inside(const outline_points *p, double x, double y) {
    bool in = false;
    for (int i = 0, j = p->count - 1; i < p->count; j = i++) {
        thud_pos a = p->at[i], b = p->at[j];
        if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) {
            in = !in;
        }
    }
    return in;
}

static double from_polygon(const outline_points *p, double x, double y) {
    double least = 1e300;
    for (int i = 0; i < p->count && !inside(p, x, y); i++) {
        thud_pos a = p->at[i], b = p->at[(i + 1) % p->count];
        double dx = b.x - a.x, dy = b.y - a.y;
        double t = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy);
        t = fmin(fmax(t, 0.0), 1.0);
        least = fmin(least, hypot(x - a.x - t * dx, y - a.y - t * dy));
    }
    return least < 1e300 ? least : 0.0;
}

static double from_shapes(const answer *a, double x, double y) {
    double least = 1e300;
    for (int i = 0; i < a->found.count; i++) {
        double distance = point_distance(&a->shapes[i], x - a->shapes[i].x, y - a->shapes[i].y);
        least = fmin(least, fmax(distance, 0.0));
    }
    return least;
}

/* What samples on a grid and on all outlines say. */
typedef struct sampled {
    double missed, extra, distance, cell, extent;
} sampled;

static sampled sample(const outline_points *p, const answer *a) {
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    for (int i = 0; i < p->count; i++) {
        x0 = fmin(x0, p->at[i].x), x1 = fmax(x1, p->at[i].x);
        y0 = fmin(y0, p->at[i].y), y1 = fmax(y1, p->at[i].y);
    }
    sampled s = {.extent = fmax(x1 - x0, y1 - y0)};
    double margin = a->found.distance + 1e-9, width = x1 - x0 + 2.0 * margin,
           height = y1 - y0 + 2.0 * margin;
    int of_polygon = 0, missed = 0, extra = 0;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        double x = x0 - margin + width * (i % SAMPLES + 0.5) / SAMPLES;
        double y = y0 - margin + height * (i / SAMPLES + 0.5) / SAMPLES;
        bool in = inside(p, x, y);
        double shapes = from_shapes(a, x, y);
        of_polygon += in;
        missed += in && shapes > 0.0;
        extra += !in && shapes == 0.0;
        s.distance = fmax(s.distance, in ? shapes : 0.0);
        if (!in && shapes == 0.0) {
            s.distance = fmax(s.distance, from_polygon(p, x, y));
        }
    }
    for (int i = 0; i < p->count; i++) {
        thud_pos from = p->at[i], to = p->at[(i + 1) % p->count];
        for (int k = 0; k < 50; k++) {
            double t = k / 50.0;
            s.distance = fmax(s.distance, from_shapes(a, from.x + t * (to.x - from.x),
                                                      from.y + t * (to.y - from.y)));
        }
    }
    for (int i = 0; i < a->found.count; i++) {
        for (int k = 0; k < 400; k++) {
            thud_pos at = outline(&a->shapes[i], k / 400.0);
            s.distance =
                fmax(s.distance, from_polygon(p, a->shapes[i].x + at.x, a->shapes[i].y + at.y));
        }
    }
    s.missed = (double)missed / of_polygon;
    s.extra = (double)extra / of_polygon;
    s.cell = hypot(width, height) / SAMPLES;
    return s;
}

/* No sample is further away than the bound, which is not much larger than the furthest, and the
 * areas are those of the samples. */
static void errors_of_random_polygons_hold_for_dense_samples(void **state) {
    (void)state;
    source r = {77};
    for (int i = 0; i < case_count(CASES); i++) {
        outline_points p = draw_polygon(&r);
        answer a = approximate(&p, 1 + draw_below(&r, 20), (thud_approximate_kind)(i % 3));
        sampled s = sample(&p, &a);
        assert_true(s.distance <= a.found.distance);
        assert_true(a.found.distance <= fmax((s.distance + s.cell) * 17.0 / 16.0,
                                             s.distance + s.cell + s.extent / 500));
        near(a.found.missed, s.missed, 0.015);
        near(a.found.extra, s.extra, 0.015);
    }
}

/* The mass of a body of the shapes, by the density that the header gives, is the polygon's. */
static void overlap_tells_the_mass(void **state) {
    (void)state;
    source r = {5};
    for (int i = 0; i < 12; i++) {
        outline_points p = draw_polygon(&r);
        answer a = approximate(&p, 6, THUD_APPROXIMATE_BOTH);
        double sum = 0.0, area = 0.0;
        for (int k = 0; k < a.found.count; k++) {
            const thud_geometry *s = &a.shapes[k];
            sum += s->kind == THUD_SHAPE_CIRCLE ? PI * s->hx * s->hx : 4.0 * s->hx * s->hy;
        }
        for (int k = 0; k < p.count; k++) {
            thud_pos u = p.at[k], v = p.at[(k + 1) % p.count];
            area += 0.5 * (u.x * v.y - u.y * v.x);
        }
        near(sum / (1.0 + a.found.overlap + a.found.extra - a.found.missed), area, 1e-3 * area);
    }
}

static void more_shapes_are_never_worse(void **state) {
    (void)state;
    source r = {3};
    for (int i = 0; i < 5; i++) {
        outline_points p = draw_polygon(&r);
        double area = 1e300, distance = 1e300, first = 0.0;
        for (int most = 1; most <= 10; most++) {
            answer a = approximate(&p, most, (thud_approximate_kind)(i % 3));
            double wrong = a.found.missed + a.found.extra;
            assert_true(wrong <= area && a.found.distance <= distance);
            area = wrong;
            distance = a.found.distance;
            first = most == 1 ? wrong : first;
        }
        assert_true(area < 0.8 * first + 1e-9);
    }
}

/* Neither the winding nor a power of two in size changes a bit of the result. */
static void winding_and_size_change_no_bit(void **state) {
    (void)state;
    source r = {9};
    for (int i = 0; i < 6; i++) {
        outline_points p = draw_polygon(&r), back = p, large = p;
        for (int k = 0; k < p.count; k++) {
            back.at[k] = p.at[p.count - 1 - k];
            large.at[k] = (thud_pos){p.at[k].x * 0x1p30, p.at[k].y * 0x1p30};
        }
        answer a = approximate(&p, 9, THUD_APPROXIMATE_BOTH);
        answer b = approximate(&back, 9, THUD_APPROXIMATE_BOTH);
        answer c = approximate(&large, 9, THUD_APPROXIMATE_BOTH);
        assert_memory_equal(&a, &b, sizeof a);
        assert_int_equal(a.found.count, c.found.count);
        assert_true(a.found.missed == c.found.missed && a.found.extra == c.found.extra);
        for (int k = 0; k < a.found.count; k++) {
            assert_true(a.shapes[k].x * 0x1p30 == c.shapes[k].x);
            assert_true(a.shapes[k].hx * 0x1p30 == c.shapes[k].hx);
        }
    }
}

/* Polygons at the ends of the ranges: many points, thin, jagged, small and large. */
static void polygons_at_the_limits_are_approximated(void **state) {
    (void)state;
    outline_points p = {.count = THUD_POLYGON_POINTS_MAX};
    for (int i = 0; i < p.count; i++) {
        double at = 2.0 * PI * i / p.count, distance = i % 2 ? 1.0 : 0.02;
        p.at[i] = (thud_pos){distance * cos(at), distance * sin(at)};
    }
    answer a = approximate(&p, 4, THUD_APPROXIMATE_BOTH);
    assert_true(a.found.distance <= 2.0);
    outline_points thin = {4, {{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}};
    a = approximate(&thin, 1, THUD_APPROXIMATE_BOTH);
    assert_int_equal(a.found.count, 1);
    near(a.found.distance, 0.0, 1e-9);
    a = approximate(&thin, 64, THUD_APPROXIMATE_CIRCLES);
    assert_true(a.found.missed < 1.0);
    const outline_points ends[] = {{3, {{-1e12, -1e12}, {1e12, -1e12}, {0, 1e12}}},
                                   {3, {{1e-150, 0}, {2e-150, 0}, {1e-150, 1e-150}}}};
    for (int i = 0; i < 2; i++) {
        a = approximate(&ends[i], 10, THUD_APPROXIMATE_BOTH);
        assert_true(a.found.missed + a.found.extra < 0.1);
    }
}

/* ---- refused ---- */

static void no_polygons_are_refused_with_the_reason(void **state) {
    (void)state;
    static const struct {
        outline_points points;
        const char *reason;
    } bad[] = {
        {{2, {{0, 0}, {1, 0}}}, "too few"},
        {{THUD_POLYGON_POINTS_MAX + 1, {{0, 0}}}, "too many"},
        {{3, {{0, 0}, {1, 0}, {NAN, 1}}}, "not finite"},
        {{3, {{0, 0}, {2e12, 0}, {0, 1}}}, "out of range"},
        {{4, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, "cross"},
        {{5, {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, "touch"}, /* a corner on an edge */
        {{4, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}}, "touch"},         /* a point twice */
        {{5, {{0, 0}, {2, 0}, {2, 2}, {2, 1}, {0, 1}}}, "touch"}, /* an edge that turns back */
        {{6, {{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}}, "touch"}, /* two triangles */
        {{3, {{0, 0}, {1, 0}, {2, 0}}}, "touch"},
        {{3, {{0, 0}, {1, 0}, {2, 1e-9}}}, "no area"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        thud_geometry shape = {0};
        thud_approximation found = {.count = 77};
        thud_approximate_options options = {.shapes_max = 1};
        const char *reason = NULL;
        assert_int_equal(thud_polygon_check(bad[i].points.at, bad[i].points.count, &reason),
                         THUD_ERROR_INVALID);
        assert_non_null(strstr(reason, bad[i].reason));
        assert_int_equal(thud_approximate(bad[i].points.at, bad[i].points.count, &options, &shape,
                                          &found),
                         THUD_ERROR_INVALID);
        assert_int_equal(found.count, 77);
        assert_true(shape.hx == 0.0);
    }
    const char *reason = "none";
    assert_int_equal(thud_polygon_check(AN_L.at, AN_L.count, &reason), THUD_OK);
    assert_null(reason);
    assert_int_equal(thud_polygon_check(AN_L.at, AN_L.count, NULL), THUD_OK);
    assert_int_equal(thud_polygon_check(NULL, 3, &reason), THUD_ERROR_NULL);
}

static void options_out_of_range_are_refused(void **state) {
    (void)state;
    const thud_approximate_options bad[] = {
        {.shapes_max = 0},
        {.shapes_max = MOST + 1},
        {.shapes_max = 1, .kinds = (thud_approximate_kind)3},
        {.shapes_max = 1, .kinds = (thud_approximate_kind)-1},
        {.shapes_max = 1, .distance = -1e-9},
        {.shapes_max = 1, .distance = NAN},
    };
    thud_geometry shape;
    thud_approximation found;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(thud_approximate(AN_L.at, 6, &bad[i], &shape, &found), THUD_ERROR_INVALID);
    }
    const thud_approximate_options good = {.shapes_max = 1};
    assert_int_equal(thud_approximate(NULL, 6, &good, &shape, &found), THUD_ERROR_NULL);
    assert_int_equal(thud_approximate(AN_L.at, 6, NULL, &shape, &found), THUD_ERROR_NULL);
    assert_int_equal(thud_approximate(AN_L.at, 6, &good, NULL, &found), THUD_ERROR_NULL);
    assert_int_equal(thud_approximate(AN_L.at, 6, &good, &shape, NULL), THUD_ERROR_NULL);
}

static void short_memory_is_told_and_nothing_is_kept(void **state) {
    (void)state;
    thud_approximate_options options = {.shapes_max = 4, .allocator = hostile_memory()};
    thud_geometry shapes[4];
    thud_approximation found = {.count = 77};
    int failed = 0;
    for (memory_allowed = 0;; memory_allowed = ++failed) {
        thud_result result = thud_approximate(AN_L.at, 6, &options, shapes, &found);
        assert_int_equal(memory_held, 0);
        if (result == THUD_OK) {
            break;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
        assert_int_equal(found.count, 77);
    }
    assert_int_equal(found.count, 2);
    assert_true(failed > 0);
    memory_allowed = -1;
}

static void an_angle_is_that_of_its_sine_and_cosine(void **state) {
    (void)state;
    for (int i = -1000; i <= 1000; i++) {
        double angle = PI * i / 1000.0, s, c, back;
        assert_int_equal(thud_sincos(angle, &s, &c), THUD_OK);
        assert_int_equal(thud_angle_of(s, c, &back), THUD_OK);
        near(remainder(back - angle, 2.0 * PI), 0.0, 2e-15);
    }
    double kept = 7.0;
    assert_int_equal(thud_angle_of(1.0, 1.0, &kept), THUD_ERROR_INVALID);
    assert_int_equal(thud_angle_of(NAN, 1.0, &kept), THUD_ERROR_INVALID);
    assert_int_equal(thud_angle_of(0.0, 1.0, NULL), THUD_ERROR_NULL);
    assert_true(kept == 7.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rectangle_is_one_box_at_any_angle),
        cmocka_unit_test(right_angled_polygons_are_their_boxes),
        cmocka_unit_test(a_regular_polygon_is_a_circle),
        cmocka_unit_test(the_distance_that_is_good_enough_ends_the_search),
        cmocka_unit_test(errors_of_random_polygons_hold_for_dense_samples),
        cmocka_unit_test(overlap_tells_the_mass),
        cmocka_unit_test(more_shapes_are_never_worse),
        cmocka_unit_test(winding_and_size_change_no_bit),
        cmocka_unit_test(polygons_at_the_limits_are_approximated),
        cmocka_unit_test(no_polygons_are_refused_with_the_reason),
        cmocka_unit_test(options_out_of_range_are_refused),
        cmocka_unit_test(short_memory_is_told_and_nothing_is_kept),
        cmocka_unit_test(an_angle_is_that_of_its_sine_and_cosine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
