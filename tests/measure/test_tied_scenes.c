/* test_tied_scenes.c: tests that scenes with joints begin with closed joints, and that bridges
 * begin in their exact equilibrium. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "joint_gaps.h"
#include "tied_scenes.h"

#include <math.h>
#include <stdlib.h>

static void assert_near(double actual, double expected, double tolerance) {
    if (!(fabs(actual - expected) <= tolerance))
        fail_msg("%.12g is not within %g of %.12g", actual, tolerance, expected);
}

static void assert_closed(scene *s) {
    assert_false(s->failed);
    assert_true(s->joint_count > 0);
    engine_body *bodies = calloc((size_t)s->body_count, sizeof *bodies);
    assert_non_null(bodies);
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        bodies[i] =
            (engine_body){.x = b->x, .y = b->y, .cosine = cos(b->angle), .sine = sin(b->angle)};
    }
    joint_gaps gaps = {0};
    joint_gaps_sample(s, bodies, &gaps);
    assert_near(gaps.worst.length, 0, 1e-12);
    assert_near(gaps.worst.angle, 0, 1e-12);
    assert_near(gaps.worst.beyond_angle, 0, 1e-12);
    free(bodies);
    scene_free(s);
}

static void all_start_with_closed_joints(void **state) {
    (void)state;
    static void (*const BY_SIZE[])(scene *, int) = {fill_pendulum,     fill_ragdolls,
                                                    fill_joint_grid,   fill_chains,
                                                    fill_bridges,      fill_cars,
                                                    fill_ragdoll_heap, fill_boxed_bridge};
    static void (*const ALONE[])(scene *) = {fill_door, fill_four_bar};
    scene s;
    for (size_t i = 0; i < sizeof BY_SIZE / sizeof BY_SIZE[0]; i++) {
        scene_init(&s);
        BY_SIZE[i](&s, 10);
        assert_closed(&s);
    }
    for (size_t i = 0; i < sizeof ALONE / sizeof ALONE[0]; i++) {
        scene_init(&s);
        ALONE[i](&s);
        assert_closed(&s);
    }
    for (int i = 0; i < 2; i++) {
        scene_init(&s);
        fill_chain(&s, &(chain_scene){10, 100, i == 1});
        assert_closed(&s);
        scene_init(&s);
        fill_slider(&s, i == 1);
        assert_closed(&s);
    }
    scene_init(&s);
    fill_scissor(&s, 5, 1);
    assert_closed(&s);
    scene_init(&s);
    fill_cantilever(&s, 5, 10);
    assert_closed(&s);
}

/* A bridge of a thousand planks is nearly a catenary of length 2 a sinh(w / 2 a) and depth a
 * (cosh(w / 2 a) - 1), where w is the span. */
static void bridge_of_many_planks_is_a_catenary(void **state) {
    (void)state;
    const double span = 960, length = 1000;
    double low = 100, high = 10000;
    for (int i = 0; i < 200; i++) {
        double a = 0.5 * (low + high);
        *(2 * a * sinh(span / (2 * a)) > length ? &low : &high) = a;
    }
    bridge_scene b = {.planks = 1000, .span = span};
    double sag = low * (cosh(span / (2 * low)) - 1);
    assert_near(bridge_sag(&b) / sag, 1, 1e-5);
}

/* Two planks with equal weights form a triangle that does not depend on the weight. */
static void bridge_of_two_planks_is_a_triangle(void **state) {
    (void)state;
    bridge_scene b = {.planks = 2, .span = 1.6, .weights = 2, .kg = 30};
    assert_near(bridge_sag(&b), 0.6, 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_start_with_closed_joints),
        cmocka_unit_test(bridge_of_many_planks_is_a_catenary),
        cmocka_unit_test(bridge_of_two_planks_is_a_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
