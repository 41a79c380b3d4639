/* test_prediction.c: poses some time ahead (thud_prediction.h): free flight beside steps and beside
 * its closed form, and flight up to the first shape that is met, in scenes known by hand. */
#include "engine_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_lists.h>
#include <thud/thud_prediction.h>
#include <thud/thud_snapshot.h>

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = 4, STEPS = 90 };

static thud_prediction extrapolated(const thud_world *world, thud_body_id body, double seconds) {
    thud_prediction out;
    OK(thud_world_extrapolate(world, &body, 1, seconds, &out));
    assert_int_equal(out.body.index1, body.index1);
    assert_int_equal(out.met.index1, 0);
    near_to(out.seconds, seconds, 0);
    return out;
}

static thud_prediction predicted(thud_world *world, thud_body_id body, double seconds) {
    thud_prediction out;
    OK(thud_world_predict(world, &body, 1, seconds, &out));
    return out;
}

/* Asserts that the body is where it was predicted to be. */
static void is_there(const thud_world *world, const thud_prediction *p, double tolerance) {
    thud_body_state s = state_of(world, p->body);
    near_to(s.position.x, p->position.x, tolerance);
    near_to(s.position.y, p->position.y, tolerance);
    near_to(cos(s.angle - p->angle), 1, 1e-9);
    near_to((double)s.velocity.x, (double)p->velocity.x, 3 * tolerance);
    near_to((double)s.velocity.y, (double)p->velocity.y, 3 * tolerance);
    near_to((double)s.angular_velocity, (double)p->angular_velocity, 3 * tolerance);
}

/* A body with its centre of mass beside its origin, thrown and spinning. */
static thud_body_id throw_body(thud_world *world, float damping, float gravity_scale) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){3, 4};
    def.angle = 2.5;
    def.velocity = (thud_vec2){6, 8};
    def.angular_velocity = -5;
    def.linear_damping = damping;
    def.angular_damping = 2 * damping;
    def.gravity_scale = gravity_scale;
    thud_body_id body;
    thud_shape_def shape = thud_default_shape_def();
    thud_shape_id id;
    OK(thud_body_create(world, &def, &body));
    OK(thud_shape_create_obb(world, body, &shape, (thud_vec2){0.4f, 0.1f}, (thud_vec2){0.5f, 0.3f},
                             0.3, &id));
    return body;
}

/* Before the first step and in the middle of the flight, every quality and detection. Each step
 * rounds velocities of up to 16 length scales a second by half a unit, 5e-7; over 1.5 s. */
static void steps_lead_where_extrapolation_does(void **state) {
    (void)state;
    static const float dampings[] = {0, 0.3f, 4, 30};
    static const float scales[] = {1, 0, -0.5f};
    for (int i = 0; i < QUALITIES * DETECTIONS * 4 * 3; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i % QUALITIES]);
        def.detection = detections[i / QUALITIES % DETECTIONS];
        def.sleeping = false;
        thud_world *world = make_world(def);
        int setting = i / QUALITIES / DETECTIONS;
        thud_body_id body = throw_body(world, dampings[setting % 4], scales[setting / 4]);
        double dt = def.time_step;
        thud_prediction whole = extrapolated(world, body, STEPS * dt);
        run(world, STEPS / 3);
        thud_prediction rest = extrapolated(world, body, (STEPS - STEPS / 3) * dt);
        run(world, STEPS - STEPS / 3);
        is_there(world, &whole, 3e-5);
        is_there(world, &rest, 3e-5);
        thud_prediction now = extrapolated(world, body, 0);
        is_there(world, &now, 0);
        thud_world_destroy(world);
    }
}

/* The engine's steps clamp each coordinate; the closed form has to go on straight from there. */
static void maximum_speed_holds(void **state) {
    (void)state;
    static const float dampings[] = {0, 0.5f};
    for (int i = 0; i < 2; i++) {
        thud_world_def def = thud_default_world_def();
        def.maximum_speed = 9;
        thud_world *world = make_world(def);
        thud_body_id body = throw_body(world, dampings[i], 2);
        thud_prediction ahead = extrapolated(world, body, 2);
        run(world, 120);
        /* A step in which the speed reaches the maximum goes off by less than its way in half of
         * the time: 20 dt^2 / 2. */
        is_there(world, &ahead, 3e-3);
        near_to((double)ahead.velocity.y, -9, 1e-6);
        thud_world_destroy(world);
    }
}

/* dv/dt = g - c v in closed form by the C library's exponential, also for strong damping and long
 * times, where c t is large. */
static void damping_is_in_closed_form(void **state) {
    (void)state;
    static const double times[] = {0.01, 0.4, 2, 11, 60};
    static const double dampings[] = {1e-3, 0.2, 1, 7, 50, 1e6, 1e30};
    for (int i = 0; i < 5 * 7; i++) {
        double t = times[i % 5], c = (double)(float)dampings[i / 5], k = -expm1(-c * t) / c;
        thud_world *world = make_world(thud_default_world_def());
        thud_body_id body = add_ball(world, 0, 0, 0.5f);
        OK(thud_body_set_damping(world, body, (float)c, (float)c));
        OK(thud_body_set_velocity(world, body, (thud_vec2){3, 8}, 2));
        OK(thud_world_set_gravity(world, (thud_vec2){0, -1}));
        thud_prediction p = extrapolated(world, body, t);
        near_to(p.position.x, 3 * k, 1e-9);
        near_to(p.position.y, c < 0.01 ? p.position.y : 8 * k - (t - k) / c, 1e-8);
        near_to((double)p.velocity.y, 8 * exp(-c * t) - k, 5e-6);
        near_to(cos(p.angle - 2 * k), 1, 1e-9);
        thud_world_destroy(world);
    }
}

/* What does not move stays, and only awake bodies are listed. */
static void the_rest_stays(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_body_id floor = add_floor(world, NULL), resting = add_box(world, 5, 0.5, 0.5f, 0.5f);
    run(world, 200);
    assert_false(state_of(world, resting).awake);
    thud_body_id off = add_ball(world, 0, 9, 0.5f), flying = add_ball(world, 3, 9, 0.5f);
    thud_body_id lift = add_body(world, THUD_BODY_KINEMATIC, -5, 5, 0);
    OK(thud_body_set_velocity(world, lift, (thud_vec2){0, 2}, 1));
    OK(thud_body_set_enabled(world, off, false));
    thud_body_id asked[] = {floor, resting, off};
    thud_prediction out[3];
    OK(thud_world_extrapolate(world, asked, 3, 1, out));
    for (int i = 0; i < 3; i++) {
        is_there(world, &out[i], 0);
    }
    int count = 0;
    OK(thud_world_extrapolate_awake(world, 1, NULL, 0, &count));
    assert_int_equal(count, 2);
    memset(out, 0, sizeof out);
    OK(thud_world_extrapolate_awake(world, 0.5, out, 1, &count));
    assert_int_equal(count, 2);
    assert_int_equal(out[0].body.index1, flying.index1);
    assert_int_equal(out[1].body.index1, 0);
    OK(thud_world_extrapolate_awake(world, 0.5, out, 3, &count));
    near_to(out[0].position.y, 9 - 0.125 * 10, 1e-6);
    assert_int_equal(out[1].body.index1, lift.index1);
    near_to(out[1].position.y, 6, 1e-6);
    near_to(out[1].angle, 0.5, 1e-9);
    thud_world_destroy(world);
}

/* A ball at 6 to the right meets a wall, passes where filters say so and a sensor, and stops. */
static void prediction_stops_at_the_first_shape(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
    thud_shape_def round = thud_default_shape_def();
    round.filter.mask = ~4u;
    add_shape(world, ball, 0.5f, 0, false, &round);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){6, 0}, 0));
    thud_prediction p = predicted(world, ball, 1);
    assert_int_equal(p.met.index1, 0);
    near_to(p.position.x, 6, 1e-6);
    thud_body_id far = add_body(world, THUD_BODY_STATIC, 5, 0, 0);
    thud_shape_id wall = add_shape(world, far, 0.25f, 2, true, NULL);
    thud_shape_def other = thud_default_shape_def();
    other.sensor = true;
    add_shape(world, add_body(world, THUD_BODY_STATIC, 2, 0, 0), 0.25f, 2, true, &other);
    other.sensor = false;
    other.filter.mask = 0;
    add_shape(world, add_body(world, THUD_BODY_STATIC, 3, 0, 0), 0.25f, 2, true, &other);
    other.filter = (thud_filter){.category = 4, .mask = UINT32_MAX};
    add_shape(world, add_body(world, THUD_BODY_STATIC, 3.5, 0, 0), 0.25f, 2, true, &other);
    p = predicted(world, ball, 1);
    assert_int_equal(p.met.index1, wall.index1);
    near_to(p.position.x, 4.25, 1e-6);
    near_to(p.seconds, 4.25 / 6, 1e-6);
    near_to((double)p.velocity.x, 6, 0);
    assert_int_equal(predicted(world, ball, 0.7).met.index1, 0);
    /* From the place where it touches: on towards the wall, along it, and away. */
    OK(thud_body_set_transform(world, ball, (thud_pos){4.25, 0}, 0));
    near_to(predicted(world, ball, 1).position.x, 4.25, 1e-6);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 3}, 0));
    near_to(predicted(world, ball, 0.5).position.y, 1.5, 1e-6);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){-3, 0}, 0));
    near_to(predicted(world, ball, 0.5).position.x, 2.75, 1e-6);
    thud_world_destroy(world);
}

/* The parabola of a throw ends on the ground where steps have it land. The chord of a step is off
 * by g dt^2 / 8, here 4e-4. */
static void prediction_lands_where_steps_do(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_swept;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    thud_body_id box = throw_body(world, 0, 1);
    OK(thud_body_set_velocity(world, box, (thud_vec2){2, 3}, 0));
    thud_prediction p = predicted(world, box, 3);
    assert_int_equal(p.met.index1, 1);
    while (thud_events_of(world).hit_count + thud_events_of(world).begin_count == 0) {
        run(world, 1);
        assert_true(state_of(world, box).position.y > 0);
    }
    near_to(state_of(world, box).position.x, p.position.x, 2 * def.time_step);
    thud_body_state s = state_of(world, box);
    near_to(s.angle, p.angle, 0.3);
    near_to(s.position.y, p.position.y, 0.12);
    thud_world_destroy(world);
}

/* Refused calls write nothing. */
static void bad_input_is_refused(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id good = add_ball(world, 0, 0, 0.5f), bodies[] = {good, {7, 7}};
    thud_prediction out[2], before[2];
    memset(out, 0x55, sizeof out);
    memcpy(before, out, sizeof out);
    int count = -7;
    static const double times[] = {-1e-9, 60.001, NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 5; i++) {
        double x = times[i];
        assert_int_equal(thud_world_extrapolate(world, &good, 1, x, out), THUD_ERROR_INVALID);
        assert_int_equal(thud_world_predict(world, &good, 1, x, out), THUD_ERROR_INVALID);
        assert_int_equal(thud_world_extrapolate_awake(world, x, out, 2, &count),
                         THUD_ERROR_INVALID);
    }
    assert_int_equal(thud_world_extrapolate(world, bodies, 2, 1, out), THUD_ERROR_STALE);
    assert_int_equal(thud_world_predict(world, bodies, 2, 1, out), THUD_ERROR_STALE);
    assert_int_equal(thud_world_extrapolate(world, bodies, -1, 1, out), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_predict(world, bodies, -1, 1, out), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_extrapolate_awake(world, 1, out, -1, &count), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_extrapolate(NULL, bodies, 1, 1, out), THUD_ERROR_NULL);
    assert_int_equal(thud_world_predict(NULL, bodies, 1, 1, out), THUD_ERROR_NULL);
    assert_int_equal(thud_world_extrapolate_awake(NULL, 1, out, 2, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_extrapolate(world, NULL, 1, 1, out), THUD_ERROR_NULL);
    assert_int_equal(thud_world_predict(world, bodies, 1, 1, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_world_extrapolate_awake(world, 1, NULL, 1, &count), THUD_ERROR_NULL);
    assert_int_equal(thud_world_extrapolate_awake(world, 1, out, 1, NULL), THUD_ERROR_NULL);
    assert_int_equal(count, -7);
    assert_memory_equal(out, before, sizeof out);
    OK(thud_world_extrapolate(world, NULL, 0, 1, NULL));
    OK(thud_world_predict(world, NULL, 0, 1, NULL));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_lead_where_extrapolation_does),
        cmocka_unit_test(maximum_speed_holds),
        cmocka_unit_test(damping_is_in_closed_form),
        cmocka_unit_test(the_rest_stays),
        cmocka_unit_test(prediction_stops_at_the_first_shape),
        cmocka_unit_test(prediction_lands_where_steps_do),
        cmocka_unit_test(bad_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
