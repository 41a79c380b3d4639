/* test_event_pairs.c: a pair of shapes begins once and ends once, also while it drifts, rolls along
 * a terrain, or sleeps. */
#include "event_chaos.h"

/* A query applies an edit before the step does; the end event still comes with the next step. */
static void end_of_what_an_edit_took_away_survives_a_query(void **state) {
    (void)state;
    for (int how = 0; how < 4; how++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_shape_def sensor = thud_default_shape_def();
        sensor.sensor = true;
        add_floor(world, NULL);
        thud_body_id zone = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        add_shape(world, zone, 1, 1, true, &sensor);
        thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
        run(world, how & 1 ? 120 : 5);
        assert_int_equal(state_of(world, ball).awake, !(how & 1));
        if (how < 2) {
            OK(thud_body_destroy(world, ball));
        } else {
            OK(thud_body_set_transform(world, ball, (thud_pos){0, 40}, 0));
        }
        bool hit;
        OK(thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 9}, 0, -20, NULL}, &hit, NULL));
        /* still the events of the last step */
        assert_int_equal(thud_events_of(world).end_count, 0);
        run(world, 1);
        assert_int_equal(thud_events_of(world).end_count, 1);
        assert_int_equal(thud_events_of(world).sensor_end_count, 1);
        thud_world_destroy(world);
    }
}

/* A sensor that moves away from a sleeping body reports the end. */
static void sensor_that_moves_away_from_a_sleeper_ends(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    add_floor(world, NULL);
    thud_body_id zone = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    add_shape(world, zone, 1, 1, true, &sensor);
    thud_body_id ball = add_ball(world, 0, 0.5, 0.5f);
    run(world, 120);
    assert_false(state_of(world, ball).awake);
    OK(thud_body_set_transform(world, zone, (thud_pos){40, 0}, 0));
    run(world, 1);
    assert_int_equal(thud_events_of(world).sensor_end_count, 1);
    thud_world_destroy(world);
}

/* Two shapes of any kind and size drift together, closer than the distance at which contacts act,
 * and creep past each other. Their fat bounds separate and overlap again while the shapes touch all
 * the time: the pair begins once. */
static void drift(uint64_t *seed, bool with_skin, bool on_line) {
    chaos *c = calloc(1, sizeof *c);
    thud_world_def def = weightless();
    def.detection = with_skin ? &thud_detection_swept : &thud_detection_continuous;
    c->seed = *seed;
    c->world = make_world(def);
    float size[2][2];
    for (int i = 0; i < 4; i++) {
        size[i / 2][i % 2] = (float)random_in(seed, 0.01, 0.25);
    }
    double gap = random_in(seed, 0.001, 0.02), turn = random_in(seed, -3, 3);
    double x = size[0][0] + size[1][0] + gap;
    thud_vec2 along = {(float)random_in(seed, -0.5, 0.5), (float)random_in(seed, -0.5, 0.5)};
    for (int i = 0; i < 2; i++) {
        if (on_line && i == 0) {
            thud_pos points[] = {{-40, 0}, {-0.1, 0}, {0.1, 0}, {40, 0}};
            thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
            thud_shape_def shape = thud_default_shape_def();
            c->ground = add_body(c->world, THUD_BODY_STATIC, 0, 0, 0);
            OK(thud_shape_create_terrain(c->world, c->ground, &shape, &line, NULL));
            turn = 0.5 * 3.14159265358979323846;
            x = size[1][0] + gap;
            along.y = 0.002f * along.y;
            continue;
        }
        bool box = pick(c, 2);
        double angle = on_line ? 0 : turn;
        c->bodies[i] =
            add_body(c->world, THUD_BODY_DYNAMIC, i * x * cos(turn), i * x * sin(turn), angle);
        add_shape(c->world, c->bodies[i], size[i][0], box ? size[i][box && on_line ? 0 : 1] : 0,
                  false, NULL);
        thud_vec2 v = {along.x + (float)random_in(seed, -0.01, 0.01),
                       along.y + (float)random_in(seed, -0.002, 0.002)};
        OK(thud_body_set_velocity(c->world, c->bodies[i], v, 0));
    }
    for (int i = 0; i < 240; i++) {
        step(c);
        /* one pair for each segment */
        assert_true(thud_stats_of(c->world).pairs <= (on_line ? 3 : 1));
    }
    thud_world_destroy(c->world);
    free(c);
}

static void pair_that_drifts_within_reach_begins_once(void **state) {
    (void)state;
    uint64_t seed = 77;
    for (int i = 0; i < 400; i++) {
        drift(&seed, i % 2, i % 4 == 3);
    }
}

/* A terrain is one shape: a ball that rolls from segment to segment begins to touch it once. */
static void ball_that_rolls_over_many_segments_begins_once(void **state) {
    (void)state;
    for (int sensor = 0; sensor < 2; sensor++) {
        chaos *c = calloc(1, sizeof *c);
        c->world = make_world(thud_default_world_def());
        thud_pos points[41];
        for (int i = 0; i < 41; i++) {
            points[i] = (thud_pos){0.25 * i, -0.01 * i};
        }
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 41};
        thud_shape_def def = thud_default_shape_def();
        c->ground = add_body(c->world, THUD_BODY_STATIC, 0, 0, 0);
        OK(thud_shape_create_terrain(c->world, c->ground, &def, &line, NULL));
        thud_body_id ball = add_body(c->world, THUD_BODY_DYNAMIC, 0.5, 0.45, 0);
        add_shape(c->world, ball, 0.5f, 0, false, NULL);
        def.sensor = true;
        if (sensor) {
            add_shape(c->world, ball, 0.6f, 0, false, &def);
        }
        OK(thud_body_set_velocity(c->world, ball, (thud_vec2){4, 0}, 0));
        for (int i = 0; i < 90; i++) {
            step(c);
        }
        assert_true(state_of(c->world, ball).position.x > 4);
        assert_int_equal(c->touches.begun, 1);
        assert_int_equal(c->touches.count, 1);
        assert_int_equal(c->sensed.begun, sensor);
        thud_world_destroy(c->world);
        free(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(end_of_what_an_edit_took_away_survives_a_query),
        cmocka_unit_test(sensor_that_moves_away_from_a_sleeper_ends),
        cmocka_unit_test(pair_that_drifts_within_reach_begins_once),
        cmocka_unit_test(ball_that_rolls_over_many_segments_begins_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
