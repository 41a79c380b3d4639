/* test_circles_approach.c: time of impact and nearest approach of moving circles, against formulas
 * in long double. */
#include "geometry_exact.h"
#include "geometry_random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases of a quick run. */
enum { QUICK = 200000 };
/* Tolerance of distances, in units of their rounding. Chosen. */
#define BOUND 8.0

/* A case: two circles in motion; `slack` is the tolerance of distances. */
typedef struct passing {
    thud_geometry a, b;
    thud_motion motion_a, motion_b;
    vec start, way; /* of b's centre, relative to a's */
    double slack;
} passing;

/* A random case: slow and fast, head-on, grazing, in parallel, at relative rest, tiny, or far from
 * the origin. */
static passing draw_passing(source *r, int i) {
    passing p = {draw_shape_of(r, THUD_SHAPE_CIRCLE), draw_shape_of(r, THUD_SHAPE_CIRCLE),
                 .slack = 0.0};
    double speed = exp(draw(r, -3.0, 8.0));
    p.b.x += draw(r, -4.0, 4.0);
    p.motion_a = (thud_motion){draw(r, -1.0, 1.0), draw(r, -1.0, 1.0), draw(r, -9.0, 9.0)};
    p.motion_b = (thud_motion){draw(r, -speed, speed), draw(r, -speed, speed), 0.0};
    double dx = p.a.x - p.b.x, dy = p.a.y - p.b.y, distance = sqrt(dx * dx + dy * dy);
    switch (i % 8) {
    case 0: /* through the centre */
        p.motion_a = (thud_motion){0};
        p.motion_b = (thud_motion){1.5 * dx, 1.5 * dy, 0.0};
        break;
    case 1: { /* grazes: the path is a tangent of the circle with the sum of both radii */
        double sine = (p.a.hx + p.b.hx) / distance, cosine = sqrt(fmax(0.0, 1.0 - sine * sine));
        p.motion_a = (thud_motion){0};
        p.motion_b =
            (thud_motion){2.0 * (cosine * dx - sine * dy), 2.0 * (sine * dx + cosine * dy), 0};
        break;
    }
    case 2: /* the distance does not change */
        p.motion_b = p.motion_a;
        break;
    case 3: /* a bullet */
        p.a.hx = p.b.hx = 1e-6;
        break;
    case 4: { /* far from the origin */
        double x = draw(r, -1e7, 1e7), y = draw(r, -1e7, 1e7);
        p.a.x += x, p.b.x += x;
        p.a.y += y, p.b.y += y;
        break;
    }
    default:
        break;
    }
    p.start = vec_of((real)p.b.x - p.a.x, (real)p.b.y - p.a.y);
    p.way = vec_of((real)p.motion_b.dx - p.motion_a.dx, (real)p.motion_b.dy - p.motion_a.dy);
    p.slack = BOUND * ROUNDING * (double)(length_of(p.start) + length_of(p.way) + p.a.hx + p.b.hx);
    return p;
}

static real distance_at(const passing *p, real t) {
    return length_of(vec_of(p->start.x + t * p->way.x, p->start.y + t * p->way.y));
}

/* The first time at which the centres are within r, or 2. */
static real first_within(const passing *p, real r) {
    real a = dot(p->way, p->way), b = dot(p->start, p->way), side = cross(p->way, p->start);
    if (length_of(p->start) <= r) {
        return 0.0L;
    }
    if (b >= 0.0L || side * side > r * r * a) {
        return 2.0L;
    }
    real t = (-b - sqrtl(r * r * a - side * side)) / a;
    return t <= 1.0L ? t : 2.0L;
}

static void least_distance_of_circles_is_that_of_long_double(void **state) {
    (void)state;
    source r = {91};
    int count = case_count(QUICK);
    for (int i = 0; i < count; i++) {
        passing p = draw_passing(&r, i);
        thud_approach out;
        assert_int_equal(thud_geometry_approach(&p.a, p.motion_a, &p.b, p.motion_b, &out), THUD_OK);
        real square = dot(p.way, p.way);
        real t = square > 0.0L ? -dot(p.start, p.way) / square : 0.0L;
        real exact = distance_at(&p, fminl(fmaxl(t, 0.0L), 1.0L));
        assert_true(fabsl(out.min_distance - exact) <= p.slack);
        assert_true(out.min_distance_time >= 0.0 && out.min_distance_time <= 1.0);
        assert_true(distance_at(&p, out.min_distance_time) <= exact + p.slack);
        assert_true(square > 0.0L || out.min_distance_time == 0.0);
    }
}

static void impact_of_circles_is_when_the_sum_of_radii_is_reached(void **state) {
    (void)state;
    source r = {92};
    int count = case_count(QUICK), hits = 0;
    for (int i = 0; i < count; i++) {
        passing p = draw_passing(&r, i);
        thud_approach out;
        assert_int_equal(thud_geometry_approach(&p.a, p.motion_a, &p.b, p.motion_b, &out), THUD_OK);
        /* With radii that differ by a few roundings the impact is a little earlier or later, or
         * there is none. */
        real touch = (real)p.a.hx + p.b.hx;
        real early = first_within(&p, touch + p.slack), late = first_within(&p, touch - p.slack);
        real time = out.hit ? out.time : 2.0L;
        assert_true(out.hit || out.time == 1.0);
        assert_true(time >= early - BOUND * ROUNDING && time <= late + BOUND * ROUNDING);
        hits += out.hit;
    }
    assert_true(hits > count / 5 && hits < count);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(least_distance_of_circles_is_that_of_long_double),
        cmocka_unit_test(impact_of_circles_is_when_the_sum_of_radii_is_reached),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
