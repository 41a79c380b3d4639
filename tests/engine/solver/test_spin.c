/* test_spin.c: bodies keep their angular velocity at every quality and detection, up to the maximum
 * that a body may have. */
#include "engine_support.h"
#include "every_choice.h"

enum { DETECTIONS = 4, STEPS = 10 };

static thud_body_id add_spinning(thud_world *world, thud_body_kind kind, bool box, double x,
                                 float spin) {
    thud_body_def def = thud_default_body_def();
    thud_body_id id;
    def.kind = kind;
    def.position = (thud_pos){x, 0};
    def.angular_velocity = spin;
    OK(thud_body_create(world, &def, &id));
    add_shape(world, id, 0.4f, box ? 0.3f : 0.0f, false, NULL);
    return id;
}

/* Angle in radians between two angles, at most half a turn. */
static double apart(double a, double b) {
    return fabs(remainder(a - b, 6.283185307179586));
}

/* Asserts that bodies with this angular velocity keep it and rotate by it. */
static void spins_as_it_was_told(const thud_quality *quality, const thud_detection *detection,
                                 float spin) {
    thud_world_def def = thud_default_world_def_of(quality);
    def.gravity = (thud_vec2){0, 0};
    def.detection = detection;
    thud_world *world = make_world(def);
    thud_body_id bodies[4];
    for (int i = 0; i < 4; i++) {
        bodies[i] = add_spinning(world, i < 2 ? THUD_BODY_DYNAMIC : THUD_BODY_KINEMATIC, i & 1,
                                 2 * i, spin);
    }
    double before = 0;
    for (int step = 1; step <= STEPS; step++) {
        run(world, 1);
        for (int i = 0; i < 4; i++) {
            thud_body_state s = state_of(world, bodies[i]);
            assert_true(s.angular_velocity == spin);
            /* The rotation of a step is summed in single precision. */
            double turned = (double)spin / 60;
            assert_true(apart(s.angle - before, turned) < 1e-6 + 1e-6 * fabs(turned));
        }
        before = state_of(world, bodies[0]).angle;
    }
    thud_world_destroy(world);
}

static void free_body_keeps_any_spin_at_every_quality_and_detection(void **state) {
    (void)state;
    const float spins[] = {1, 94, -95, 188, 200, 300, -377, 3000, 1e5f};
    for (int q = 0; q < QUALITIES; q++) {
        for (int d = 0; d < DETECTIONS; d++) {
            for (size_t i = 0; i < sizeof spins / sizeof *spins; i++) {
                spins_as_it_was_told(qualities[q], detections[d], spins[i]);
            }
        }
    }
}

/* A greater angular velocity is limited to 1e8 rad/s with its sign. */
static void spin_beyond_the_highest_is_held_there_with_its_sign(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id left = add_spinning(world, THUD_BODY_DYNAMIC, true, 0, 3e30f);
    thud_body_id right = add_spinning(world, THUD_BODY_KINEMATIC, false, 2, -3e30f);
    run(world, STEPS);
    assert_true(state_of(world, left).angular_velocity == 1e8f);
    assert_true(state_of(world, right).angular_velocity == -1e8f);
    thud_world_destroy(world);
}

/* A ball of radius 5 cm at 12 m/s rotates at 240 rad/s. The tolerance is 1 %: at exact it lands on
 * a skin of a millimetre. */
static void small_ball_rolls_on_forwards_at_every_quality_and_size(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        for (float scale = 1e-3f; scale < 1e4f; scale *= 1e3f) {
            thud_world_def def = thud_default_world_def_of(qualities[q]);
            def.length_scale = scale;
            def.gravity.y *= scale;
            thud_world *world = make_world(def);
            thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
            thud_shape_def plain = thud_default_shape_def();
            thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            OK(thud_shape_create_terrain(world, ground, &plain, &flat, NULL));
            float radius = 0.05f * scale, speed = 12 * scale;
            thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, (double)radius, 0);
            add_shape(world, ball, radius, 0, false, NULL);
            OK(thud_body_set_velocity(world, ball, (thud_vec2){speed, 0}, -speed / radius));
            for (int step = 0; step < 120; step++) {
                run(world, 1);
                thud_body_state s = state_of(world, ball);
                near_to((double)(s.velocity.x / speed), 1, 0.01);
                near_to((double)s.angular_velocity, -240, 2.4);
            }
            near_to(state_of(world, ball).position.x / (double)scale, 24, 0.24);
            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_body_keeps_any_spin_at_every_quality_and_detection),
        cmocka_unit_test(spin_beyond_the_highest_is_held_there_with_its_sign),
        cmocka_unit_test(small_ball_rolls_on_forwards_at_every_quality_and_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
