/* test_events.c: begin, end, hit and sensor events of small scenes, filters, and what callbacks may
 * do. */
#include "engine_support.h"

#include <float.h>

/* Counts of events over a run. */
typedef struct tally {
    int begun, ended, sensed, left, hits;
} tally;

static void count(thud_world *world, tally *t) {
    thud_events e = thud_events_of(world);
    t->begun += e.begin_count;
    t->ended += e.end_count;
    t->sensed += e.sensor_begin_count;
    t->left += e.sensor_end_count;
    t->hits += e.hit_count;
}

static tally run_counting(thud_world *world, int steps) {
    tally t = {0, 0, 0, 0, 0};
    for (int i = 0; i < steps; i++) {
        run(world, 1);
        count(world, &t);
    }
    return t;
}

static void bouncing_ball_begins_and_ends_and_hits(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def bouncy = thud_default_shape_def();
    bouncy.restitution = 0.5f;
    add_floor(world, NULL);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 3, 0);
    add_shape(world, ball, 0.5f, 0, false, &bouncy);
    tally t = {0, 0, 0, 0, 0};
    double speed = 0;
    for (int i = 0; i < 300; i++) {
        run(world, 1);
        thud_events e = thud_events_of(world);
        if (e.hit_count && speed == 0) {
            speed = (double)e.hit[0].speed;
            near_to(fabs((double)e.hit[0].normal.y), 1, 1e-5);
            near_to(e.hit[0].point.y, 0, 0.1);
        }
        count(world, &t);
    }
    near_to(speed, sqrt(2 * 10 * 2.5), 0.2);
    assert_true(t.begun > 2);
    assert_int_equal(t.begun, t.ended + 1); /* it lies on the floor at the end */
    thud_world_destroy(world);
}

/* Two balls meet at 3e38 m/s each: the approach speed, whose sum overflows a float, is reported as
 * a finite one. */
static void hit_of_bodies_faster_than_floats_add_up_tells_a_finite_speed(void **state) {
    (void)state;
    for (int swept = 0; swept < 2; swept++) {
        thud_world_def def = weightless();
        def.detection = swept ? &thud_detection_swept : &thud_detection_overlap;
        thud_world *world = make_world(def);
        for (int side = -1; side <= 1; side += 2) {
            thud_body_id ball =
                add_body(world, THUD_BODY_DYNAMIC, side * (swept ? 0.6 : 0.49), 0, 0);
            add_shape(world, ball, 0.5f, 0, false, NULL);
            OK(thud_body_set_velocity(world, ball, (thud_vec2){-3e38f * (float)side, 0}, 0));
        }
        run(world, 1);
        thud_events e = thud_events_of(world);
        assert_int_equal(e.hit_count, 1);
        assert_true(e.hit[0].speed > 1e5f && e.hit[0].speed <= FLT_MAX);
        thud_world_destroy(world);
    }
}

/* Under `swept` a ball that bounces within a step is reported as a hit; it begins no contact, since
 * it does not touch at the end of the step. */
static void bounce_within_a_swept_step_is_a_hit_without_a_begin(void **state) {
    (void)state;
    thud_world_def def = weightless();
    def.detection = &thud_detection_swept;
    thud_world *world = make_world(def);
    thud_shape_def bouncy = thud_default_shape_def();
    bouncy.restitution = 1;
    add_shape(world, add_body(world, THUD_BODY_STATIC, 0, -1, 0), 5, 1, true, &bouncy);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 3, 0);
    add_shape(world, ball, 0.5f, 0, false, &bouncy);
    OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -92}, 0));
    tally t = run_counting(world, 4);
    assert_true(state_of(world, ball).velocity.y > 90);
    assert_int_equal(t.hits, 1);
    assert_int_equal(t.begun + t.ended, 0);
    thud_world_destroy(world);
}

/* A contact ends with one event where its body or shape is destroyed, the body is moved away, or
 * the ground under a sleeping body is destroyed. */
static void contact_ends_when_a_body_a_shape_or_the_ground_goes(void **state) {
    (void)state;
    for (int how = 0; how < 4; how++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_body_id floor = add_floor(world, NULL);
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
        thud_shape_id shape = add_shape(world, box, 0.5f, 0.5f, false, NULL);
        tally t = run_counting(world, how == 3 ? 120 : 10); /* the last case sleeps */
        assert_int_equal(t.begun, 1);
        assert_int_equal(t.ended, 0);
        if (how == 0) {
            OK(thud_body_destroy(world, box));
        } else if (how == 1) {
            OK(thud_shape_destroy(world, shape));
        } else if (how == 2) {
            OK(thud_body_set_transform(world, box, (thud_pos){50, 50}, 0));
        } else {
            assert_false(state_of(world, box).awake);
            OK(thud_body_destroy(world, floor));
        }
        t = run_counting(world, 2);
        assert_int_equal(t.begun, 0);
        assert_int_equal(t.ended, 1);
        if (how == 3) {
            assert_true(state_of(world, box).awake);
            run(world, 30);
            assert_true(state_of(world, box).position.y < 0);
        }
        thud_world_destroy(world);
    }
}

static void sensor_reports_and_does_not_collide(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    thud_body_id gate = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    add_shape(world, gate, 1, 1, true, &sensor);
    thud_body_id ball = add_ball(world, 0, 3, 0.25f);
    tally t = run_counting(world, 120);
    assert_int_equal(t.sensed, 1);
    assert_int_equal(t.left, 1);
    assert_int_equal(t.begun, 0);
    near_to(state_of(world, ball).position.y, 3 - 5 * 4, 0.1);
    thud_world_destroy(world);
}

static void filters_decide_who_meets(void **state) {
    (void)state;
    const struct {
        thud_filter a, b;
        bool meet;
    } cases[] = {
        {{1, 1, 0}, {1, 1, 0}, true}, {{1, 2, 0}, {1, 1, 0}, false},
        {{1, 2, 0}, {2, 1, 0}, true}, {{1, 1, -3}, {1, 1, -3}, false},
        {{1, 0, 3}, {1, 0, 3}, true}, {{1, 1, 3}, {1, 1, 4}, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        thud_world *world = make_world(weightless());
        thud_shape_def def = thud_default_shape_def();
        thud_body_id a = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        thud_body_id b = add_body(world, THUD_BODY_DYNAMIC, 0.5, 0, 0);
        def.filter = cases[i].a;
        add_shape(world, a, 0.5f, 0, false, &def);
        def.filter = cases[i].b;
        add_shape(world, b, 0.5f, 0, false, &def);
        run(world, 1);
        assert_int_equal(thud_events_of(world).begin_count, cases[i].meet);
        thud_world_destroy(world);
    }
}

static bool veto(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                 void *context) {
    (void)settings;
    (void)world;
    (void)contact;
    ++*(int *)context;
    return false;
}

static void prologue_that_says_no_lets_bodies_through(void **state) {
    (void)state;
    int asked = 0;
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_overlap;
    thud_world *world = make_world(def);
    set_listeners(world, veto, NULL, &asked);
    add_floor(world, NULL);
    thud_body_id ball = add_ball(world, 0, 1, 0.5f);
    run(world, 90);
    assert_true(asked > 5);
    near_to(state_of(world, ball).position.y, 1 - 5 * 1.5 * 1.5, 0.1);
    thud_world_destroy(world);
}

/* Sum of the normal impulses that the epilogue was given. */
static double impulse_sum;

/* An epilogue that sums normal impulses. */
static void weigh(thud_world *world, const thud_contact *contact, void *context) {
    (void)context;
    impulse_sum += (double)contact->normal_impulse;
    /* Inside a callback a step is refused, and an edit is deferred to the next step. */
    assert_int_equal(thud_world_step(world), THUD_ERROR_LOCKED);
    OK(thud_body_set_velocity(world, contact->body_b, (thud_vec2){1, 0}, 0));
    assert_true((double)fabsf(state_of(world, contact->body_b).velocity.x) < 2.0);
}

/* The impulses given to the epilogue in a second sum to weight times time; and its deferred edits
 * act. */
static void epilogue_hears_the_impulse_that_carries_the_weight(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    thud_world *world = make_world(def);
    set_listeners(world, NULL, weigh, NULL);
    thud_shape_def smooth = thud_default_shape_def();
    smooth.friction = 0;
    add_floor(world, &smooth);
    thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    add_shape(world, box, 0.5f, 0.5f, false, &smooth);
    run(world, 60);
    impulse_sum = 0;
    run(world, 60);
    near_to(impulse_sum, (double)state_of(world, box).mass * 10, 0.02);
    near_to((double)state_of(world, box).velocity.x, 1, 1e-3);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bouncing_ball_begins_and_ends_and_hits),
        cmocka_unit_test(hit_of_bodies_faster_than_floats_add_up_tells_a_finite_speed),
        cmocka_unit_test(bounce_within_a_swept_step_is_a_hit_without_a_begin),
        cmocka_unit_test(contact_ends_when_a_body_a_shape_or_the_ground_goes),
        cmocka_unit_test(sensor_reports_and_does_not_collide),
        cmocka_unit_test(filters_decide_who_meets),
        cmocka_unit_test(prologue_that_says_no_lets_bodies_through),
        cmocka_unit_test(epilogue_hears_the_impulse_that_carries_the_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
