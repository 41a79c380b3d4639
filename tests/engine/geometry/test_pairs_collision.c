/* test_pairs_collision.c: time of collision by bisection of every pair of kinds in random motion,
 * against distances in long double: at the time the shapes are apart, and within the tolerance
 * after it they overlap. */
#include "geometry_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { QUICK = 12000 };
/* Tolerance, in roundings of the lengths that an answer is computed from. Chosen. */
#define BOUND 16.0

static int collisions;

/* Where the shapes may or may not touch at the start or the end, within rounding, either answer is
 * accepted. */
static void check_collision(const moving *m, double tolerance) {
    double slack = BOUND * (moving_rounding(m) + place_rounding(&m->p)), time;
    bool collided;
    assert_int_equal(thud_geometry_time_of_collision(&m->p.a, m->a, &m->p.b, m->b, tolerance,
                                                     &collided, &time),
                     THUD_OK);
    real before = moving_distance(m, 0.0L), after = moving_distance(m, 1.0L);
    if (fabsl(before) > slack && fabsl(after) > slack) {
        CHECK_PAIR(&m->p, collided == (before > 0.0L && after < 0.0L));
    }
    if (!collided) {
        CHECK_PAIR(&m->p, time == 1.0);
        return;
    }
    CHECK_PAIR(&m->p, time >= 0.0 && time < 1.0);
    CHECK_PAIR(&m->p, moving_distance(m, time) >= -slack);
    /* Halving the motion leaves an interval that is a power of two. */
    double left = exp2(floor(log2(tolerance)));
    CHECK_PAIR(&m->p, moving_distance(m, (real)time + left) <= slack);
    collisions++;
}

static void collision_of_every_pair_is_between_apart_and_together(void **state) {
    (void)state;
    int count = case_count(QUICK);
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {121 + kinds};
        collisions = 0;
        for (int i = 0; i < count; i++) {
            moving m = draw_moving(&r, kinds, i, i % 2);
            check_collision(&m, i % 3 ? 1e-6 : i % 5 ? 0.1 : 1e-15);
        }
        assert_true(collisions > count / 50);
    }
}

/* Motions in which both centres are in one place at some time. */
static void bisectable_motion_through_the_middle_is_never_missed(void **state) {
    (void)state;
    int count = case_count(QUICK), bisectable = 0;
    for (int kinds = 0; kinds < PAIR_KINDS; kinds++) {
        source r = {131 + kinds};
        for (int i = 0; i < count; i++) {
            moving m = draw_moving(&r, kinds, i, false);
            thud_geometry *a = &m.p.a, *b = &m.p.b;
            double part = draw(&r, 0.0, 1.0), speed = draw(&r, 0.0, 3.0),
                   angle = draw(&r, -4.0, 4.0);
            double thin_a = a->kind == THUD_SHAPE_CIRCLE ? a->hx : fmin(a->hx, a->hy);
            double thin_b = b->kind == THUD_SHAPE_CIRCLE ? b->hx : fmin(b->hx, b->hy);
            double way = speed * fmin(thin_a, thin_b);
            m.a = (thud_motion){0};
            m.b = (thud_motion){way * cos(angle), way * sin(angle), 0.0};
            b->x = a->x - part * m.b.dx;
            b->y = a->y - part * m.b.dy;
            if (thud_geometry_is_bisectable(a, m.a, b, m.b)) {
                bisectable++;
                CHECK_PAIR(&m.p,
                           moving_distance(&m, 0.0L) <= 0.0L || moving_distance(&m, 1.0L) <= 0.0L);
            }
            /* The thickness is twice the half extent: the motion is bisectable below that, but for
             * rounding. */
            CHECK_PAIR(&m.p, fabs(speed - 2.0) < 1e-9 ||
                                 thud_geometry_is_bisectable(a, m.a, b, m.b) == (speed < 2.0));
        }
    }
    assert_true(bisectable > count);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(collision_of_every_pair_is_between_apart_and_together),
        cmocka_unit_test(bisectable_motion_through_the_middle_is_never_missed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
