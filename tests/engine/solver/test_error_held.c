/* test_error_held.c: the errors of a step in which detection stops bodies before its end, against
 * the bodies' positions. */
#include "error_support.h"

static const thud_detection *const detections[] = {&thud_detection_continuous,
                                                   &thud_detection_swept};

static void move(thud_world *world, thud_body_id id, float x, float y) {
    OK(thud_body_set_velocity(world, id, (thud_vec2){x, y}, 0));
}

/* One ball follows another, which the wall stops: the penetration of the two after the step is
 * reported as their positions give it. */
static void ball_that_runs_into_a_held_one_is_as_deep_as_they_stand(void **state) {
    (void)state;
    bool ran_into = false;
    for (int i = 0; i < 60; i++) {
        double gap = 0.01 * i;
        thud_world *world = make_world(weightless());
        add_shape(world, add_body(world, THUD_BODY_STATIC, 10, 0, 0), 0.5f, 5, true, NULL);
        thud_body_id first = add_ball(world, 9 - gap, 0, 0.5f);
        thud_body_id second = add_ball(world, 8 - gap, 0, 0.5f);
        move(world, first, 60, 0);
        move(world, second, 60, 0);
        thud_step_error e = error_of_step(world);
        double a = state_of(world, first).position.x, b = state_of(world, second).position.x;
        double deepest = fmax(fmax(1 - (a - b), a - 9), 0);
        near_to(e.penetration_max, deepest, 1e-6);
        near_to(thud_measure_of(world).penetration_max, deepest, 1e-6);
        assert_int_equal(e.overlaps, deepest > 0.005);
        ran_into |= deepest > 0.4;
        thud_world_destroy(world);
    }
    assert_true(ran_into);
}

/* shortfall is the greatest distance by which a held body is behind its free motion. */
static void shortfall_is_the_way_that_the_held_ball_lacks(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    add_shape(world, add_body(world, THUD_BODY_STATIC, 10, 0, 0), 0.01f, 5, true, NULL);
    thud_body_id fast = add_ball(world, 0, 0, 0.1f), slow = add_ball(world, 0, 1, 0.1f);
    move(world, fast, 120, 0);
    move(world, slow, 60, 0);
    int held = 0;
    for (int i = 0; i < 30; i++) {
        double x[2] = {state_of(world, fast).position.x, state_of(world, slow).position.x};
        double v[2] = {(double)state_of(world, fast).velocity.x,
                       (double)state_of(world, slow).velocity.x};
        thud_step_error e = error_of_step(world);
        double h = thud_default_world_def().time_step, lacks = 0;
        int now = thud_stats_of(world).held_bodies;
        if (now) {
            lacks = fmax(x[0] + v[0] * h - state_of(world, fast).position.x,
                         x[1] + v[1] * h - state_of(world, slow).position.x);
            assert_true(lacks > 0.1);
        }
        near_to(e.shortfall, lacks, 1e-5);
        held += now;
    }
    assert_int_equal(held, 2);
    thud_world_destroy(world);
}

static void energy_change_is_the_world_s_where_balls_are_held(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        thud_world_def def = thud_default_world_def();
        def.sleeping = false;
        def.detection = detections[k];
        thud_world *world = make_world(def);
        uint64_t seed = 3;
        add_floor(world, NULL);
        for (int i = 0; i < 20; i++) {
            thud_body_id ball = add_ball(world, 2 * i, random_in(&seed, 2, 9), 0.3f);
            move(world, ball, (float)random_in(&seed, -20, 20), (float)random_in(&seed, -90, -40));
        }
        int held = 0, met = 0;
        for (int i = 0; i < 40; i++) {
            double before = energy_of(world), kinetic = thud_measure_of(world).kinetic_energy;
            thud_step_error e = error_of_step(world);
            near_to(e.energy_change, energy_of(world) - before, 2e-6 * kinetic + 1e-5);
            held += thud_stats_of(world).held_bodies;
            met += thud_stats_of(world).impacts;
        }
        assert_true(k ? met >= 20 : held >= 15);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ball_that_runs_into_a_held_one_is_as_deep_as_they_stand),
        cmocka_unit_test(shortfall_is_the_way_that_the_held_ball_lacks),
        cmocka_unit_test(energy_change_is_the_world_s_where_balls_are_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
