/* test_grip.c: thud_body_apply_grip, the force of a tyre: it brings the velocity of a point of its
 * body along an axis to a target, never beyond it, and adds no energy where the target is 0. */
#include "engine_support.h"

#include <thud/thud_fields.h>
#include <thud/thud_forces.h>
#include <thud/thud_make.h>
#include <thud/thud_reads.h>

static thud_body_id make_car(thud_world *world, double angle, thud_vec2 velocity, float spin) {
    thud_body_options car = {.kind = THUD_BODY_DYNAMIC,
                             .velocity = velocity,
                             .angular_velocity = spin,
                             .density = 3};
    return thud_body_make(world, thud_obb_at(1, 2, 1, 0.5, angle), &car);
}

/* Velocity of a point of the body along an axis, both in the body's frame. */
static double speed_along(thud_world *world, thud_body_id body, thud_vec2 point, thud_vec2 axis) {
    thud_pos at;
    thud_vec2 velocity, along;
    OK(thud_body_get_world_point(world, body, point, &at));
    OK(thud_body_get_world_vector(world, body, axis, &along));
    OK(thud_body_get_velocity_at(world, body, at, &velocity));
    return velocity.x * along.x + velocity.y * along.y;
}

/* The rotation during a step changes the point's place and axis; with a step of 1e-5 s that is
 * negligible. */
static thud_world *short_steps(thud_vec2 gravity) {
    thud_world_def def = weightless();
    def.gravity = gravity;
    def.time_step = 1e-5;
    return make_world(def);
}

/* With a sufficient force, any point of the car has the target velocity along the axis after one
 * step, under gravity and another force; the length of the axis does not matter. */
static void great_force_brings_any_point_to_its_speed_in_a_step(void **state) {
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 200; i++) {
        thud_world *world = short_steps((thud_vec2){0, i % 2 ? -1e4f : 0});
        double angle = random_in(&seed, -3, 3), way = random_in(&seed, -3, 3), sine, cosine;
        thud_vec2 point = {(float)random_in(&seed, -1, 1), (float)random_in(&seed, -1, 1)};
        float speed = i % 3 ? (float)random_in(&seed, -5, 5) : 0;
        OK(thud_sincos(way, &sine, &cosine));
        thud_vec2 axis = {(float)cosine, (float)sine}, longer = {9 * axis.x, 9 * axis.y};
        thud_body_id car = make_car(world, angle, (thud_vec2){3, -4}, (float)way);
        if (i % 4 == 0) {
            OK(thud_body_apply_center_force(world, car, (thud_vec2){4e5f, 1e5f}));
            OK(thud_body_apply_torque(world, car, 3e4f));
        }
        OK(thud_body_apply_grip(world, car, point, longer, speed, 1e9f));
        run(world, 1);
        near_to(speed_along(world, car, point, axis), speed, 2e-3);
        thud_world_destroy(world);
    }
}

/* A force that is too small is used completely: velocity changes by force * time / mass towards the
 * target. */
static void small_force_is_all_used_on_the_way_there(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id car = make_car(world, 0, (thud_vec2){0, 5}, 0); /* mass: 6 kg */
    thud_vec2 middle = {0, 0}, across = {0, 2};
    OK(thud_body_apply_grip(world, car, middle, across, 0, 36));
    run(world, 1);
    near_to(thud_velocity_of(world, car).y, 4.9, 1e-5);
    OK(thud_body_apply_grip(world, car, middle, (thud_vec2){3, 0}, -7, 36));
    run(world, 1);
    near_to(thud_velocity_of(world, car).x, -0.1, 1e-5);
    near_to(thud_velocity_of(world, car).y, 4.9, 1e-5);
    thud_world_destroy(world);
}

static double energy_of(const thud_world *world, thud_body_id body) {
    thud_body_state s = state_of(world, body);
    return 0.5 * s.mass * (s.velocity.x * s.velocity.x + s.velocity.y * s.velocity.y) +
           0.5 * s.inertia * s.angular_velocity * s.angular_velocity;
}

/* Four tyres that each stop their own point do not make the car oscillate. */
static void holding_never_adds_energy(void **state) {
    (void)state;
    const thud_vec2 tyres[] = {{0.9f, 0.4f}, {0.9f, -0.4f}, {-0.9f, 0.4f}, {-0.9f, -0.4f}};
    thud_world *world = make_world(weightless());
    thud_body_id car = make_car(world, 0.5, (thud_vec2){20, 9}, 30);
    double before = energy_of(world, car);
    for (int i = 0; i < 120; i++) {
        for (int t = 0; t < 4; t++) {
            OK(thud_body_apply_grip(world, car, tyres[t], (thud_vec2){0, 1}, 0, 200));
        }
        run(world, 1);
        double now = energy_of(world, car);
        assert_true(now <= before * (1 + 1e-6));
        before = now;
    }
    near_to(state_of(world, car).angular_velocity, 0, 1e-3);
    near_to(speed_along(world, car, tyres[0], (thud_vec2){0, 1}), 0, 1e-3);
    thud_world_destroy(world);
}

static void sleepers_and_who_is_switched_off_are_left_alone(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){0, 0};
    thud_world *world = make_world(def);
    thud_body_id car = make_car(world, 0, (thud_vec2){0, 0}, 0);
    run(world, 120);
    assert_false(state_of(world, car).awake);
    OK(thud_body_apply_grip(world, car, (thud_vec2){0, 0}, (thud_vec2){1, 0}, 5, 100));
    run(world, 1);
    assert_false(state_of(world, car).awake);
    OK(thud_body_set_enabled(world, car, false));
    OK(thud_body_apply_grip(world, car, (thud_vec2){0, 0}, (thud_vec2){1, 0}, 5, 100));
    OK(thud_body_set_enabled(world, car, true));
    run(world, 1);
    assert_true(thud_velocity_of(world, car).x == 0);
    thud_world_destroy(world);
}

/* For a body with fixed rotation the effective mass is its mass at every point. */
static void fixed_rotation_is_heeded(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_options slider = {.kind = THUD_BODY_DYNAMIC,
                                .fixed_rotation = true,
                                .velocity = {0, 3}};
    thud_body_id body = thud_body_make(world, thud_obb_at(0, 0, 1, 0.5, 0), &slider);
    OK(thud_body_apply_grip(world, body, (thud_vec2){1, 0}, (thud_vec2){0, 1}, 0, 1e6f));
    run(world, 1);
    near_to(thud_velocity_of(world, body).y, 0, 1e-6);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(great_force_brings_any_point_to_its_speed_in_a_step),
        cmocka_unit_test(small_force_is_all_used_on_the_way_there),
        cmocka_unit_test(holding_never_adds_energy),
        cmocka_unit_test(sleepers_and_who_is_switched_off_are_left_alone),
        cmocka_unit_test(fixed_rotation_is_heeded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
