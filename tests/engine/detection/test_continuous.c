/* test_continuous.c: under `continuous` nothing fast passes through static geometry, and fast
 * sliding is not stopped. */
#include "engine_support.h"

/* Shoots a small body of a kind at a wall 0.02 thick or at a terrain; asserts that it stays on its
 * side. */
static void shoot(int kind, double speed, double jitter, bool terrain) {
    thud_world *world = make_world(weightless());
    thud_body_id target = add_body(world, THUD_BODY_STATIC, terrain ? 0 : 10, 0, 0);
    thud_shape_def plain = thud_default_shape_def();
    if (terrain) {
        thud_pos points[4] = {{-1e6, 0}, {-3, 0.5}, {4, -0.5}, {1e6, 0}};
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
        OK(thud_shape_create_terrain(world, target, &plain, &line, NULL));
    } else {
        add_shape(world, target, 0.01f, 1e4f, true, NULL);
    }
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, jitter, terrain ? 10 : jitter, 0);
    add_shape(world, body, 0.1f, kind ? 0.1f : 0, kind == 1, NULL);
    thud_vec2 v = {(float)(speed * (terrain ? jitter : 1)),
                   (float)(speed * (terrain ? -1 : jitter))};
    OK(thud_body_set_velocity(world, body, v, kind == 2 ? 7 : 0));
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        thud_pos p = state_of(world, body).position;
        if (terrain ? p.y < -1.5 : p.x > 10.01) {
            fail_msg("kind %d at %g passed, to (%g, %g)", kind, speed, p.x, p.y);
        }
    }
    thud_world_destroy(world);
}

static void nothing_passes_a_thin_wall_or_the_ground(void **state) {
    (void)state;
    uint64_t seed = 5;
    for (int kind = 0; kind < 3; kind++) {
        for (double speed = 10; speed < 2e5; speed *= 10) {
            for (int i = 0; i < 12; i++) {
                shoot(kind, speed, random_in(&seed, -0.3, 0.3), i % 2);
            }
        }
    }
}

/* Under `overlap`, for comparison, a bullet passes the wall. */
static void without_it_a_bullet_passes(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.detection = &thud_detection_overlap;
    thud_world *world = make_world(def);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 10, 0, 0);
    add_shape(world, wall, 0.01f, 10, true, NULL);
    thud_body_id body = add_ball(world, 0.5, 0, 0.1f);
    OK(thud_body_set_velocity(world, body, (thud_vec2){1000, 0}, 0));
    run(world, 10);
    assert_true(state_of(world, body).position.x > 100);
    thud_world_destroy(world);
}

/* A row of pegs and a sensor, all circles, and fast balls among them; with a box far away the world
 * has the geometry of all kinds in place of that of circles. */
static thud_world *make_pegs(bool box, thud_body_id balls[24]) {
    uint64_t seed = 11;
    thud_world *world = make_world(thud_default_world_def_of(&thud_quality_draft));
    thud_shape_def zone = thud_default_shape_def();
    zone.sensor = true;
    for (int i = 0; i < 12; i++) {
        thud_body_id peg = add_body(world, THUD_BODY_STATIC, 2 * i, i % 3, 0);
        add_shape(world, peg, 0.7f, 0, false, i % 4 == 3 ? &zone : NULL);
    }
    if (box) {
        thud_body_id far = add_body(world, THUD_BODY_STATIC, 1e4, 1e4, 0);
        add_shape(world, far, 1, 1, true, NULL);
    }
    for (int i = 0; i < 24; i++) {
        balls[i] = add_ball(world, i, 5, 0.1f);
        thud_vec2 v = {(float)random_in(&seed, -60, 60), (float)random_in(&seed, -300, -50)};
        OK(thud_body_set_velocity(world, balls[i], v, 0));
    }
    return world;
}

static void circles_alone_meet_to_the_same_bits_as_beside_a_box(void **state) {
    (void)state;
    thud_body_id balls[2][24];
    thud_world *worlds[2] = {make_pegs(false, balls[0]), make_pegs(true, balls[1])};
    int held = 0, sensed = 0;
    for (int step = 0; step < 40; step++) {
        thud_events events[2];
        for (int i = 0; i < 2; i++) {
            run(worlds[i], 1);
            OK(thud_world_get_events(worlds[i], &events[i]));
        }
        held += thud_stats_of(worlds[0]).held_bodies;
        sensed += events[0].sensor_begin_count;
        assert_int_equal(events[0].sensor_begin_count, events[1].sensor_begin_count);
        for (int k = 0; k < events[0].sensor_begin_count; k++) {
            assert_true(events[0].sensor_begin_time[k] == events[1].sensor_begin_time[k]);
        }
        for (int k = 0; k < 24; k++) {
            thud_body_state a = state_of(worlds[0], balls[0][k]);
            thud_body_state b = state_of(worlds[1], balls[1][k]);
            assert_true(a.position.x == b.position.x && a.position.y == b.position.y);
            assert_true(a.velocity.x == b.velocity.x && a.velocity.y == b.velocity.y);
        }
    }
    assert_true(held > 5 && sensed > 0);
    thud_world_destroy(worlds[0]);
    thud_world_destroy(worlds[1]);
}

static void fast_sliding_along_a_floor_is_not_stopped(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def smooth = thud_default_shape_def();
    smooth.friction = 0;
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    add_shape(world, floor, 10000, 1, true, &smooth);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    add_shape(world, box, 0.5f, 0.5f, false, &smooth);
    run(world, 10);
    OK(thud_body_set_velocity(world, box, (thud_vec2){300, 0}, 0));
    double from = state_of(world, box).position.x;
    run(world, 60);
    near_to(state_of(world, box).position.x - from, 300, 0.5);
    thud_world_destroy(world);
}

/* A restitution of 1 throws a ball off at 180 length/s, which the step clamps to its maximum speed
 * of 100; a force has acted against it. The ball meets a wall in that step and is held there,
 * without what the force gave it for the rest of the step: that must not take it beyond the
 * maximum. */
static void held_body_stays_within_maximum_speed(void **state) {
    (void)state;
    thud_world_def def = weightless();
    thud_shape_def elastic = thud_default_shape_def();
    elastic.restitution = 1;
    def.maximum_speed = 100;
    thud_world *world = make_world(def);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, -0.5, 0, 0);
    add_shape(world, wall, 0.01f, 10, true, NULL);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    add_shape(world, ball, 0.1f, 0, false, &elastic);
    thud_body_id heavy = add_body(world, THUD_BODY_DYNAMIC, 0.6, 0, 0);
    add_shape(world, heavy, 0.5f, 0, false, &elastic);
    OK(thud_body_set_velocity(world, heavy, (thud_vec2){-90, 0}, 0));
    float force = 50 * state_of(world, ball).mass / (float)def.time_step;
    OK(thud_body_apply_center_force(world, ball, (thud_vec2){force, 0}));
    run(world, 1);
    assert_int_equal(thud_stats_of(world).held_bodies, 2); /* the heavy one meets the wall too */
    near_to((double)state_of(world, ball).velocity.x, -100, 1e-3);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_passes_a_thin_wall_or_the_ground),
        cmocka_unit_test(without_it_a_bullet_passes),
        cmocka_unit_test(circles_alone_meet_to_the_same_bits_as_beside_a_box),
        cmocka_unit_test(fast_sliding_along_a_floor_is_not_stopped),
        cmocka_unit_test(held_body_stays_within_maximum_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
