/* test_pairs_impact.c: time of impact and time of collision of every pair of kinds in random
 * motion.
 *
 * Without turning, the exact time is that at which a point enters the pair's rounded sum, in long
 * double. Whether shapes that graze each other meet is a rounding's choice, so the time is held
 * between those of shapes a few roundings thicker and thinner. With turning there is no closed
 * form: at the time that is found the shapes must be as near as they should be, and steps through
 * the time before, none longer than the distance allows, must find them further apart. */
#include "geometry_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { QUICK = 12000, QUICK_TURNING = 600, STEPS = 1000 };
#define BOUND 16.0
#define NEVER 2.0L

/* ---- without turning ---- */

/* Narrows [first, last] to where p + t d is within `inset` of the inner side of the edge. */
static void clip(vec a, vec b, real inset, vec p, vec d, real *first, real *last)
{
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

static real enters_circle(vec center, real radius, vec p, vec d)
{
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

/* When a point that starts at the origin and moves by d first is within `radius` of the polygon; a
 * negative radius is a smaller polygon. */
static real enters(const sum *h, real radius, vec d)
{
    vec origin = {0.0L, 0.0L};
    real time = NEVER, first = 0.0L, last = 1.0L;
    for (int i = 0; i < h->count && h->count > 1; i++) {
        vec a = h->v[i], b = h->v[(i + 1) % h->count], along = unit(minus(b, a));
        clip(a, b, -fminl(radius, 0.0L), origin, d, &first, &last);
        if (radius > 0.0L) { /* the strip along the edge */
            vec out = {along.y * radius, -along.x * radius};
            vec c = {a.x + out.x, a.y + out.y}, e = {b.x + out.x, b.y + out.y};
            real from = 0.0L, to = 1.0L;
            clip(c, e, 0.0L, origin, d, &from, &to);
            clip(b, a, 0.0L, origin, d, &from, &to);
            clip(a, c, 0.0L, origin, d, &from, &to);
            clip(e, b, 0.0L, origin, d, &from, &to);
            time = from <= to ? fminl(time, from) : time;
        }
    }
    if (h->count > 1 && first <= last) {
        time = fminl(time, first);
    }
    for (int i = 0; i < h->count && radius >= 0.0L; i++) {
        time = fminl(time, enters_circle(h->v[i], radius, origin, d));
    }
    return time <= 1.0L ? time : NEVER;
}

static int hits;

static void check_translating(const moving *m)
{
    double slack = BOUND * moving_rounding(m), time;
    bool hit;
    solid a = solid_of(&m->p.a, m->p.a.x, m->p.a.y), b = solid_of(&m->p.b, m->p.a.x, m->p.a.y);
    sum h = sum_of(&a, &b);
    /* b comes nearer by what the origin moves towards the sum. */
    vec way = {(real)m->a.dx - m->b.dx, (real)m->a.dy - m->b.dy};
    real early = enters(&h, h.radius + m->target + slack, way);
    real late = enters(&h, h.radius + m->target - slack, way);
    assert_int_equal(
        thud_shapes_time_of_impact(&m->p.a, m->a, &m->p.b, m->b, m->target, &hit, &time), THUD_OK);
    CHECK_PAIR(&m->p, hit || time == 1.0);
    real found = hit ? (real)time : NEVER;
    CHECK_PAIR(&m->p, found >= early - BOUND * ROUNDING && found <= late + BOUND * ROUNDING);
    hits += hit;
}

static void impact_without_turning_is_that_of_long_double(void **state)
{
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

/* ---- with turning ---- */

/* The fastest that the shapes' distance may change. */
static real fastest(const moving *m)
{
    real reach_a = m->p.a.kind == THUD_OBB ? hypotl(m->p.a.hx, m->p.a.hy) : 0.0L;
    real reach_b = m->p.b.kind == THUD_OBB ? hypotl(m->p.b.hx, m->p.b.hy) : 0.0L;
    return hypotl(m->a.dx - m->b.dx, m->a.dy - m->b.dy) + fabsl(m->a.turn) * reach_a +
           fabsl(m->b.turn) * reach_b;
}

/* Are the shapes no nearer than `least` until `end`? Steps that the distance allows, but no shorter
 * than a thousandth: where they graze each other, what is nearer for less time is not seen. */
static bool apart_until(const moving *m, real least, real end)
{
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

static int stopped_early;

static void check_turning(const moving *m)
{
    double size = m->p.a.hx + m->p.a.hy + m->p.b.hx + m->p.b.hy;
    double slack = 1.1e-10 * size + BOUND * (moving_rounding(m) + place_rounding(&m->p)), time;
    bool hit;
    assert_int_equal(
        thud_shapes_time_of_impact(&m->p.a, m->a, &m->p.b, m->b, m->target, &hit, &time), THUD_OK);
    CHECK_PAIR(&m->p, time >= 0.0 && time <= 1.0 && (hit || time == 1.0));
    CHECK_PAIR(&m->p, apart_until(m, m->target - slack, time));
    if (hit) {
        real distance = moving_distance(m, time);
        CHECK_PAIR(&m->p, time == 0.0 || distance >= m->target - slack);
        stopped_early += distance > m->target + slack;
        hits++;
    }
}

static void impact_with_turning_comes_no_later_and_no_earlier(void **state)
{
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
        /* Shapes that turn close by each other for long may use up the search's jumps. */
        assert_true(stopped_early * 50 <= hits);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impact_without_turning_is_that_of_long_double),
        cmocka_unit_test(impact_with_turning_comes_no_later_and_no_earlier),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
