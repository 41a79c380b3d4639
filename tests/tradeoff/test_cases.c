/* test_cases.c: tests the error functions of the cases on states made by hand: exact ones, which
 * have no error, and ones that are wrong by a known amount. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "yardstick.h"

#include <math.h>
#include <stdlib.h>

typedef struct made {
    scene scene;
    engine_body *bodies; /* bodies as in the scene, until a test moves them */
    yardstick *yardstick;
} made;

/* Fills *m in place, because the yardstick keeps the scene's address. */
static void make(made *m, const tradeoff_case *c) {
    assert_true(case_fill(c, true, &m->scene));
    m->bodies = calloc((size_t)m->scene.body_count, sizeof *m->bodies);
    m->yardstick = yardstick_create(c, &m->scene);
    assert_non_null(m->bodies);
    assert_non_null(m->yardstick);
    for (int i = 0; i < m->scene.body_count; i++) {
        const scene_body *b = &m->scene.bodies[i];
        m->bodies[i] = (engine_body){.x = b->x,
                                     .y = b->y,
                                     .cosine = cos(b->angle),
                                     .sine = sin(b->angle),
                                     .vx = b->vx,
                                     .vy = b->vy,
                                     .angular_velocity = b->angular_velocity};
    }
    assert_true(yardstick_begin(m->yardstick, m->bodies));
}

static void look(made *m, double time) {
    assert_true(yardstick_look(m->yardstick, m->bodies, time));
}

static errors finish(made *m) {
    errors found = yardstick_conclude(m->yardstick);
    yardstick_destroy(m->yardstick);
    free(m->bodies);
    scene_free(&m->scene);
    return found;
}

static void assert_near(double actual, double expected) {
    if (!(fabs(actual - expected) <= 1e-9 * fmax(1, fabs(expected))))
        fail_msg("%.12g is not %.12g", actual, expected);
}

static void all_cases_fill_at_both_sizes_and_have_names_of_their_own(void **state) {
    (void)state;
    assert_true(cases_count() >= 11);
    assert_null(cases_at(cases_count()));
    for (int i = 0; i < cases_count(); i++) {
        const tradeoff_case *c = cases_at(i);
        assert_ptr_equal(cases_find(c->name), c);
        for (int quick = 0; quick < 2; quick++) {
            scene s;
            assert_true(case_fill(c, quick, &s));
            assert_true(s.body_count > 2);
            scene_free(&s);
        }
        assert_true(c->floor > 0 && c->chance >= 1 && c->steps >= c->quick_steps);
    }
    assert_null(cases_find("no such case"));
}

static void stacks_that_stay_have_no_error(void **state) {
    (void)state;
    const tradeoff_case *const cases[] = {&case_column_30, &case_pyramid, &case_heavy_on_light};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        made m;
        make(&m, cases[i]);
        look(&m, 1);
        errors found = finish(&m);
        assert_near(found.error, 0);
        assert_near(found.energy_gained, 0);
        assert_int_equal(found.lost, 0);
    }
}

static void column_keeps_the_worst_height_it_lost(void **state) {
    (void)state;
    made m;
    make(&m, &case_column_30);
    engine_body *top = &m.bodies[m.scene.body_count - 1];
    top->y -= 0.125;
    look(&m, 1);
    top->y += 0.0625;
    look(&m, 2);
    errors found = finish(&m);
    assert_near(found.error, 0.125);
    assert_near(found.penetration_worst, 0.125);
}

static void sliding_box_on_its_analytic_path_has_no_error_and_off_it_that_distance(void **state) {
    (void)state;
    const double time = 2;
    made m;
    make(&m, &case_slope);
    /* At 30 and 40 degrees the boxes slide: s = g (sin a - 0.5 cos a) t^2 / 2; the others stay. */
    for (int i = 2; i < 4; i++) {
        double a = (i + 1) * 3.14159265358979323846 / 18;
        double way = 0.5 * 10 * (sin(a) - 0.5 * cos(a)) * time * time;
        m.bodies[2 * i + 1].x += way * cos(a);
        m.bodies[2 * i + 1].y -= way * sin(a);
    }
    look(&m, time);
    assert_near(yardstick_conclude(m.yardstick).error, 0);
    m.bodies[1].x += 0.25;
    look(&m, time);
    assert_near(finish(&m).error, 0.25);
}

static void disc_that_stays_on_a_slope_is_off_by_the_way_it_should_have_rolled(void **state) {
    (void)state;
    made m;
    make(&m, &case_rolling);
    look(&m, 1);
    double a = 4 * 3.14159265358979323846 / 18;
    assert_near(finish(&m).error, 0.5 * 10 * sin(a) * 2 / 3);
}

static void cradle_that_handed_all_on_has_no_error_and_one_that_did_not_has_one(void **state) {
    (void)state;
    made m;
    make(&m, &case_cradle);
    look(&m, 1);
    assert_near(yardstick_conclude(m.yardstick).error, 1);
    for (int row = 0; row < 3; row++)
        for (int i = 0; i < 5; i++)
            m.bodies[2 + 5 * row + i].vx = i >= 4 - row ? 5 : 0;
    look(&m, 2);
    errors found = finish(&m);
    assert_near(found.error, 0);
    assert_near(found.energy_gained, 0);
}

static void gas_that_is_twice_as_fast_has_four_times_its_energy(void **state) {
    (void)state;
    made m;
    make(&m, &case_gas);
    for (int i = 0; i < m.scene.body_count; i++) {
        m.bodies[i].vx *= 2;
        m.bodies[i].vy *= 2;
    }
    look(&m, 1);
    errors found = finish(&m);
    assert_near(found.error, 3);
    assert_near(found.energy_gained, 0.75);
}

static void bullets_behind_their_walls_are_counted(void **state) {
    (void)state;
    made m;
    make(&m, &case_bullets);
    look(&m, 0);
    assert_near(yardstick_conclude(m.yardstick).error, 0);
    for (int i = 0; i < 3; i++)
        m.bodies[2 * i + 1].x = 1;
    look(&m, 1);
    assert_near(finish(&m).error, 3.0 / (m.scene.body_count / 2));
}

static void a_lost_body_makes_the_error_infinite(void **state) {
    (void)state;
    made m;
    make(&m, &case_pit);
    look(&m, 1);
    m.bodies[5].vx = NAN;
    look(&m, 2);
    errors found = finish(&m);
    assert_true(isinf(found.error));
    assert_int_equal(found.lost, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_cases_fill_at_both_sizes_and_have_names_of_their_own),
        cmocka_unit_test(stacks_that_stay_have_no_error),
        cmocka_unit_test(column_keeps_the_worst_height_it_lost),
        cmocka_unit_test(sliding_box_on_its_analytic_path_has_no_error_and_off_it_that_distance),
        cmocka_unit_test(disc_that_stays_on_a_slope_is_off_by_the_way_it_should_have_rolled),
        cmocka_unit_test(cradle_that_handed_all_on_has_no_error_and_one_that_did_not_has_one),
        cmocka_unit_test(gas_that_is_twice_as_fast_has_four_times_its_energy),
        cmocka_unit_test(bullets_behind_their_walls_are_counted),
        cmocka_unit_test(a_lost_body_makes_the_error_infinite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
