/* test_pairs_impact.c: time of impact of every pair of kinds in random motion.
 *
 * Without rotation, the exact time is that at which a point enters the pair's rounded Minkowski
 * difference, in long double. Whether grazing shapes meet depends on rounding, so the time is
 * bounded by those of shapes that are a few roundings thicker and thinner. With rotation there is
 * no closed form: at the time that is found the shapes must be at the target distance, and sampled
 * at steps no longer than the distance allows, they must be farther apart before. */
#include "geometry_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* Cases for each pair of kinds in a quick run, without and with rotation; the shortest step of a
 * search is 1/STEPS of the motion. */
enum { QUICK = 12000, QUICK_TURNING = 600, STEPS = 1000 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 16.0

/* ---- without rotation ---- */

static int hits;

/* Asserts that the time is between those of the thicker and the thinner pair. */
static void check_translating(const moving *m) {
    double slack = BOUND * moving_rounding(m), time;
    bool hit;
    solid a = solid_of(&m->p.a, m->p.a.x, m->p.a.y), b = solid_of(&m->p.b, m->p.a.x, m->p.a.y);
    sum h = sum_of(&a, &b);
    /* b approaches a as the origin moves towards the Minkowski difference. */
    vec way = {(real)m->a.dx - m->b.dx, (real)m->a.dy - m->b.dy};
    real early = enters(&h, h.radius + m->target + slack, way);
    real late = enters(&h, h.radius + m->target - slack, way);
    assert_int_equal(thud_geometry_time_of_impact(&m->p.a, m->a, &m->p.b, m->b, m->target, &hit,
                                                  &time),
                     THUD_OK);
    CHECK_PAIR(&m->p, hit || time == 1.0);
    real found = hit ? (real)time : NEVER;
    CHECK_PAIR(&m->p, found >= early - BOUND * ROUNDING && found <= late + BOUND * ROUNDING);
    hits += hit;
}

static void impact_without_turning_is_that_of_long_double(void **state) {
    (void)state;
    int count = case_count(QUICK);
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {101 + kinds};
        hits = 0;
        for (int i = 0; i < count; i++) {
            moving m = draw_moving(&r, kinds, i, false);
            check_translating(&m);
        }
        assert_true(hits > count / 5 && hits < count);
    }
}

/* Faces that are parallel but for rounding. b falls from 1 above a, at any place along it, to
 * within the target. */
static void impact_of_flush_boxes_with_a_target_is_never_missed(void **state) {
    (void)state;
    for (int i = 1; i < 400; i++) {
        double c = cos(i * 0.01), s = sin(i * 0.01), length = sqrt(9.0 * c * c + 9.0 * s * s);
        thud_geometry a = {THUD_SHAPE_OBB, 0.0, 0.0, c, s, 0.3, 1.0};
        thud_geometry b = {THUD_SHAPE_OBB, 0.0, 0.0, 3.0 * c / length, 3.0 * s / length, 2.0, 0.5};
        for (int k = -20; k <= 20; k++) {
            thud_motion up = {-s, c, 0.0}, down = {s, -c, 0.0};
            bool hit;
            double time;
            b.x = 0.1 * k * c - 1.54 * s;
            b.y = 0.1 * k * s + 1.54 * c;
            assert_int_equal(thud_geometry_time_of_impact(&a, (thud_motion){0}, &b, up, 0.05, &hit,
                                                          &time),
                             THUD_OK);
            assert_true(hit && time == 0.0);
            b.x = 0.1 * k * c - 2.0 * s;
            b.y = 0.1 * k * s + 2.0 * c;
            assert_int_equal(thud_geometry_time_of_impact(&a, (thud_motion){0}, &b, down, 0.05,
                                                          &hit, &time),
                             THUD_OK);
            assert_true(hit && fabs(time - 0.45) < 1e-14);
        }
    }
}

/* ---- with rotation ---- */

/* An upper bound of the rate at which the shapes' distance changes. */
static real fastest(const moving *m) {
    real reach_a = m->p.a.kind == THUD_SHAPE_OBB ? hypotl(m->p.a.hx, m->p.a.hy) : 0.0L;
    real reach_b = m->p.b.kind == THUD_SHAPE_OBB ? hypotl(m->p.b.hx, m->p.b.hy) : 0.0L;
    return hypotl(m->a.dx - m->b.dx, m->a.dy - m->b.dy) + fabsl(m->a.turn) * reach_a +
           fabsl(m->b.turn) * reach_b;
}

/* Whether the shapes stay at least `least` apart until `end`, by steps that the distance allows,
 * but at least 1/STEPS: grazing that lasts less is not seen. */
static bool apart_until(const moving *m, real least, real end) {
    real speed = fastest(m);
    for (real t = 0.0L; t < end;) {
        real distance = moving_distance(m, t);
        if (distance < least) {
            return false;
        }
        t += fmaxl(speed > 0.0L ? (distance - least) / speed : 1.0L, 1.0L / STEPS);
    }
    return true;
}

/* Impacts at which the search ended farther away than the target. */
static int stopped_early;

/* Asserts that the shapes are at the target distance at the time, and farther apart before. */
static void check_turning(const moving *m) {
    double size = m->p.a.hx + m->p.a.hy + m->p.b.hx + m->p.b.hy;
    double slack = 1.1e-10 * size + BOUND * moving_rounding(m), time;
    bool hit;
    assert_int_equal(thud_geometry_time_of_impact(&m->p.a, m->a, &m->p.b, m->b, m->target, &hit,
                                                  &time),
                     THUD_OK);
    CHECK_PAIR(&m->p, time >= 0.0 && time <= 1.0 && (hit || time == 1.0));
    CHECK_PAIR(&m->p, apart_until(m, m->target - slack, time));
    if (hit) {
        real distance = moving_distance(m, time);
        CHECK_PAIR(&m->p, time == 0.0 || distance >= m->target - slack);
        stopped_early += distance > m->target + slack;
        hits++;
    }
}

static void impact_with_turning_comes_no_later_and_no_earlier(void **state) {
    (void)state;
    int count = case_count(QUICK_TURNING);
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {111 + kinds};
        hits = stopped_early = 0;
        for (int i = 0; i < count; i++) {
            moving m = draw_moving(&r, kinds, i, true);
            check_turning(&m);
        }
        assert_true(hits > count / 5 && hits < count);
        /* Shapes that rotate close to each other for long may use up the search's iterations. */
        assert_true(stopped_early * 5000 <= hits);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impact_without_turning_is_that_of_long_double),
        cmocka_unit_test(impact_of_flush_boxes_with_a_target_is_never_missed),
        cmocka_unit_test(impact_with_turning_comes_no_later_and_no_earlier),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
