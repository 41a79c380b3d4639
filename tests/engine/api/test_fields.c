/* test_fields.c: wind and the rolling resistance of balls (thud_fields.h) against formulas and
 * sums. */
#include "engine_support.h"

#include <thud/thud_fields.h>

static double energy(thud_world *world) {
    return thud_measure_of(world).kinetic_energy;
}

/* ---- wind ---- */

/* The drag of still air on a box and a ball follows the formula: it depends on the length across
 * the motion, and does not turn the box. */
static void still_air_brakes_by_what_goes_across(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id box = add_box(world, 0, 0, 0.25f, 1), ball = add_ball(world, 9, 0, 0.5f);
    OK(thud_body_set_velocity(world, box, (thud_vec2){4, 0}, 0));
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -3}, 0));
    thud_vec2 still = {0, 0};
    OK(thud_body_apply_wind(world, box, still, 0.1f, 1.5f, 0));
    OK(thud_body_apply_wind(world, ball, still, 0.1f, 0.5f, 0));
    run(world, 1);
    /* change of speed: density / 2 * drag * speed^2 * length * time / mass */
    thud_body_state s = state_of(world, box);
    near_to((double)s.velocity.x, 4 - 0.05 * 1.5 * 16 * 2 / 60 / (double)s.mass, 1e-5);
    near_to((double)s.velocity.y, 0, 1e-6);
    near_to((double)s.angular_velocity, 0, 1e-6);
    s = state_of(world, ball);
    near_to((double)s.velocity.y, -3 + 0.05 * 0.5 * 9 * 1 / 60 / (double)s.mass, 1e-5);
    thud_world_destroy(world);
}

/* Reference: force and torque of the drag on a box that moves and turns, by sums over its edges. */
static void drag_over_edges_is_the_integral(void **state) {
    (void)state;
    const double h[2] = {1, 0.4}, v[3] = {1.5, -0.5, 3}, wind[2] = {0.25, 0.5};
    thud_world *world = make_world(weightless());
    double angle = 0.4, sum[3] = {0}, c = cos(angle), s = sin(angle);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 5, 5, angle);
    add_shape(world, box, (float)h[0], (float)h[1], false, NULL);
    OK(thud_body_set_velocity(world, box, (thud_vec2){(float)v[0], (float)v[1]}, (float)v[2]));
    enum { PIECES = 100000 };
    for (int edge = 0; edge < 4; edge++) {
        int axis = edge % 2;
        double side = edge < 2 ? 1 : -1, length = 2 * h[!axis] / PIECES;
        double nx = axis ? -s * side : c * side, ny = axis ? c * side : s * side;
        for (int i = 0; i < PIECES; i++) {
            double t = -h[!axis] + (i + 0.5) * length;
            double x = h[axis] * nx - t * ny, y = h[axis] * ny + t * nx;
            double ux = v[0] - wind[0] - v[2] * y, uy = v[1] - wind[1] + v[2] * x;
            double across = fmax(nx * ux + ny * uy, 0) * length;
            sum[0] -= across * ux;
            sum[1] -= across * uy;
            sum[2] -= across * (x * uy - y * ux);
        }
    }
    OK(thud_body_apply_wind(world, box, (thud_vec2){(float)wind[0], (float)wind[1]}, 0.2f, 1, 0));
    run(world, 1);
    thud_body_state b = state_of(world, box);
    near_to((double)b.velocity.x - v[0], 0.1 * sum[0] / 60 / (double)b.mass, 2e-6);
    near_to((double)b.velocity.y - v[1], 0.1 * sum[1] / 60 / (double)b.mass, 2e-6);
    near_to((double)b.angular_velocity - v[2], 0.1 * sum[2] / 60 / (double)b.inertia, 2e-6);
    thud_world_destroy(world);
}

/* A lift coefficient raises a wing without changing its drag; a rotating ball has the lift of its
 * spin. */
static void wings_and_spin_lift(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    /* A wing flies to +x with its nose up, and a ball with backspin. */
    thud_body_id wing = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0.2),
                 ball = add_ball(world, 9, 0, 0.5f);
    add_shape(world, wing, 1, 0.01f, false, NULL);
    float drag[2], up[2];
    for (int lift = 0; lift < 2; lift++) {
        OK(thud_body_set_velocity(world, wing, (thud_vec2){5, 0}, 0));
        OK(thud_body_apply_wind(world, wing, (thud_vec2){0, 0}, 0.01f, 1, (float)lift));
        run(world, 1);
        drag[lift] = 5 - state_of(world, wing).velocity.x;
        up[lift] = state_of(world, wing).velocity.y;
        OK(thud_body_set_transform(world, wing, (thud_pos){0, 0}, 0.2));
    }
    assert_true(drag[0] > 0 && up[1] > up[0] + 1e-3f);
    near_to((double)drag[0], (double)drag[1], 1e-6);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){5, 0}, 10));
    OK(thud_body_apply_wind(world, ball, (thud_vec2){0, 0}, 0.01f, 0.5f, 0.5f));
    run(world, 1);
    thud_body_state s = state_of(world, ball);
    near_to((double)s.velocity.y, 0.005 * 0.5 * (0.5 * 10) * 5 * 1 / 60 / (double)s.mass, 1e-6);
    thud_world_destroy(world);
}

static void still_air_never_gives_energy(void **state) {
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 500; i++) {
        thud_world_def def = weightless();
        def.time_step = i % 2 ? 1 : 1.0 / 60;
        thud_world *world = make_world(def);
        thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0, random_in(&seed, -3, 3));
        thud_shape_def shape = thud_default_shape_def();
        thud_shape_id id;
        thud_vec2 offset = {(float)random_in(&seed, -1, 1), (float)random_in(&seed, -1, 1)};
        add_shape(world, body, 1, i % 3 ? 0.1f : 0, false, NULL);
        OK(thud_shape_create_circle(world, body, &shape, offset, 0.3f, &id));
        thud_vec2 v = {(float)random_in(&seed, -9, 9), (float)random_in(&seed, -9, 9)};
        OK(thud_body_set_velocity(world, body, v, (float)random_in(&seed, -9, 9)));
        float density = (float)pow(10, random_in(&seed, -2, 6));
        float drag = (float)random_in(&seed, 0, 2),
              lift = i % 4 ? (float)random_in(&seed, 0, 5) : 0;
        double before = energy(world);
        for (int k = 0; k < 10; k++) {
            OK(thud_body_apply_wind(world, body, (thud_vec2){0, 0}, density, drag, lift));
            run(world, 1);
            assert_true(energy(world) <= before * (1 + 1e-5));
            before = energy(world);
        }
        thud_world_destroy(world);
    }
}

/* A ball is taken along up to the speed of the wind, and no step exceeds it, however dense the air
 * is. */
static void wind_takes_along_and_wakes_nobody(void **state) {
    (void)state;
    const float density[] = {0.3f, 1, 1e9f};
    for (int i = 0; i < 3; i++) {
        thud_world_def def = weightless();
        def.time_step = 0.25;
        def.sleeping = true;
        thud_world *world = make_world(def);
        thud_body_id ball = add_ball(world, 0, 0, 0.5f);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){-2, 0.1f}, 0));
        float last = -2;
        for (int k = 0; k < 400; k++) {
            OK(thud_body_apply_wind(world, ball, (thud_vec2){7, 0}, density[i], 1, 0));
            run(world, 1);
            float now = state_of(world, ball).velocity.x;
            assert_true(now >= last - 1e-5f && now <= 7.00001f);
            last = now;
        }
        near_to((double)last, 7, 0.1);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 0}, 0));
        run(world, 10);
        assert_false(state_of(world, ball).awake);
        OK(thud_body_apply_wind(world, ball, (thud_vec2){7, 0}, 1, 1, 0));
        run(world, 1);
        assert_false(state_of(world, ball).awake);
        OK(thud_body_set_awake(world, ball, true));
        OK(thud_body_apply_wind(world, ball, (thud_vec2){7, 0}, 1, 1, 0));
        run(world, 1);
        assert_true(state_of(world, ball).velocity.x > 0.1f);
        thud_world_destroy(world);
    }
}

/* ---- rolling resistance ---- */

/* Rolling resistance slows a ball by 2/3 of coefficient * g until it stops and sleeps; its velocity
 * does not change sign. */
static void balls_roll_to_a_stop(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = make_world(thud_default_world_def_of(qualities[q]));
        add_floor(world, NULL);
        thud_body_id ball = add_ball(world, -20, 0.5, 0.5f);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){3, 0}, -6));
        run(world, 10);
        double start = (double)state_of(world, ball).velocity.x, last = start;
        for (int i = 0; i < 900; i++) {
            OK(thud_body_apply_rolling_resistance(world, ball, 0.06f));
            run(world, 1);
            double now = (double)state_of(world, ball).velocity.x;
            assert_true(now >= -1e-3 && now <= last + 2e-3);
            if (i == 59) {
                near_to(now, start - 0.06 * 10 * 2 / 3, 0.02);
            }
            last = now;
        }
        near_to(last, 0, 1e-3);
        assert_false(state_of(world, ball).awake);
        thud_world_destroy(world);
    }
}

/* The greatest rolling resistance stops a rotating ball without reversing it, and has no effect on
 * a ball in the air or on a box. */
static void resistance_never_turns_back_nor_slows_what_flies(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def ice = thud_default_shape_def();
    ice.friction = 0;
    add_floor(world, &ice);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f), flying = add_ball(world, 5, 50, 0.5f);
    thud_body_id box = add_box(world, 9, 0.5, 0.5f, 0.5f);
    run(world, 5);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 0}, 9));
    OK(thud_body_set_velocity(world, flying, (thud_vec2){0, 0}, 9));
    OK(thud_body_set_velocity(world, box, (thud_vec2){3, 0}, 0));
    for (int i = 0; i < 30; i++) {
        OK(thud_body_apply_rolling_resistance(world, ball, THUD_DRAG_MAX));
        OK(thud_body_apply_rolling_resistance(world, flying, THUD_DRAG_MAX));
        OK(thud_body_apply_rolling_resistance(world, box, THUD_DRAG_MAX));
        run(world, 1);
        assert_true(state_of(world, ball).angular_velocity >= -1e-4f);
    }
    near_to((double)state_of(world, ball).angular_velocity, 0, 1e-4);
    near_to((double)state_of(world, flying).angular_velocity, 9, 1e-6);
    near_to((double)state_of(world, box).velocity.x, 3, 1e-4);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(still_air_brakes_by_what_goes_across),
        cmocka_unit_test(drag_over_edges_is_the_integral),
        cmocka_unit_test(wings_and_spin_lift),
        cmocka_unit_test(still_air_never_gives_energy),
        cmocka_unit_test(wind_takes_along_and_wakes_nobody),
        cmocka_unit_test(balls_roll_to_a_stop),
        cmocka_unit_test(resistance_never_turns_back_nor_slows_what_flies),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
