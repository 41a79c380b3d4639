/* test_sensors.c: sensors report overlaps with every kind of body, awake or asleep, whichever
 * moves; with all bodies that pass within a step; and without waking any body. */
#include "engine_support.h"
#include "every_choice.h"

#include <thud/thud_detection.h>
#include <thud/thud_edits.h>
#include <thud/thud_joint.h>
#include <thud/thud_lists.h>
#include <thud/thud_snapshot.h>

static thud_shape_def sensor_def(void) {
    thud_shape_def def = thud_default_shape_def();
    def.sensor = true;
    return def;
}

/* A box of half extent 1. */
static thud_shape_id add_sensor(thud_world *world, thud_body_id body) {
    thud_shape_def def = sensor_def();
    return add_shape(world, body, 1, 1, true, &def);
}

/* How many events of the list are of sensor a and shape b. */
static int told_of(const thud_contact_event *events, int count, thud_shape_id a, thud_shape_id b) {
    int told = 0;
    for (int i = 0; i < count; i++) {
        told += memcmp(&events[i].shape_a, &a, sizeof a) == 0 &&
                memcmp(&events[i].shape_b, &b, sizeof b) == 0;
    }
    return told;
}

/* Asserts that the last step reported the begin of sensor `a` with shape `b`, and no other sensor
 * event. */
static void only_begins(const thud_world *world, thud_shape_id a, thud_shape_id b) {
    thud_events e = thud_events_of(world);
    assert_int_equal(e.sensor_begin_count, 1);
    assert_int_equal(told_of(e.sensor_begin, 1, a, b), 1);
    assert_int_equal(e.sensor_end_count, 0);
}

/* The same of the end. */
static void only_ends(const thud_world *world, thud_shape_id a, thud_shape_id b) {
    thud_events e = thud_events_of(world);
    assert_int_equal(e.sensor_end_count, 1);
    assert_int_equal(told_of(e.sensor_end, 1, a, b), 1);
    assert_int_equal(e.sensor_begin_count, 0);
}

static void no_sensor_event(const thud_world *world) {
    thud_events e = thud_events_of(world);
    assert_int_equal(e.sensor_begin_count + e.sensor_end_count, 0);
}

/* ---- which bodies a sensor sees ---- */

/* A sensor on any kind of body sees any kind of body, except a static one by a static sensor. */
static void sensor_of_each_kind_sees_each_kind_but_static_static(void **state) {
    (void)state;
    for (int i = 0; i < THUD_BODY_KIND_COUNT * THUD_BODY_KIND_COUNT; i++) {
        thud_body_kind own = (thud_body_kind)(i / THUD_BODY_KIND_COUNT);
        thud_body_kind other = (thud_body_kind)(i % THUD_BODY_KIND_COUNT);
        thud_world *world = make_world(weightless());
        thud_shape_id zone = add_sensor(world, add_body(world, own, 0, 0, 0));
        thud_body_id body = add_body(world, other, 0.5, 0, 0);
        thud_shape_id shape = add_shape(world, body, 0.5f, 0, false, NULL);
        run(world, 1);
        if (own == THUD_BODY_STATIC && other == THUD_BODY_STATIC) {
            no_sensor_event(world);
        } else {
            only_begins(world, zone, shape);
            OK(thud_body_set_transform(world, body, (thud_pos){9, 0}, 0));
            run(world, 1);
            only_ends(world, zone, shape);
        }
        thud_world_destroy(world);
    }
}

static void kinematic_body_that_passes_a_sensor_begins_and_ends(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_id coin = add_sensor(world, add_body(world, THUD_BODY_STATIC, 3, 0, 0));
    thud_body_id hero = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    thud_shape_id shape = add_shape(world, hero, 0.5f, 0.5f, true, NULL);
    int begun = 0, ended = 0;
    OK(thud_body_set_velocity(world, hero, (thud_vec2){3, 0}, 0));
    for (int i = 0; i < 120; i++) {
        run(world, 1);
        thud_events e = thud_events_of(world);
        begun += told_of(e.sensor_begin, e.sensor_begin_count, coin, shape);
        ended += told_of(e.sensor_end, e.sensor_end_count, coin, shape);
        assert_int_equal(e.begin_count, 0);
    }
    assert_int_equal(begun, 1);
    assert_int_equal(ended, 1);
    near_to(state_of(world, hero).position.x, 6, 1e-3);
    thud_world_destroy(world);
}

/* Two sensors see each other, in both orders, where their filters let them collide. */
static void two_sensors_report_each_other_where_their_filters_meet(void **state) {
    (void)state;
    for (int meet = 0; meet < 2; meet++) {
        thud_world *world = make_world(weightless());
        thud_shape_def def = sensor_def();
        def.filter = (thud_filter){2, meet ? 4 : 1, 0};
        thud_shape_id a =
            add_shape(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), 1, 0, false, &def);
        def.filter = (thud_filter){4, 2, 0};
        thud_body_id body = add_body(world, THUD_BODY_KINEMATIC, 1, 0, 0);
        thud_shape_id b = add_shape(world, body, 1, 0, false, &def);
        run(world, 1);
        thud_events e = thud_events_of(world);
        assert_int_equal(e.sensor_begin_count, meet ? 2 : 0);
        assert_int_equal(told_of(e.sensor_begin, e.sensor_begin_count, a, b), meet);
        assert_int_equal(told_of(e.sensor_begin, e.sensor_begin_count, b, a), meet);
        OK(thud_body_destroy(world, body));
        run(world, 1);
        e = thud_events_of(world);
        assert_int_equal(e.sensor_end_count, meet ? 2 : 0);
        assert_int_equal(told_of(e.sensor_end, e.sensor_end_count, a, b), meet);
        assert_int_equal(told_of(e.sensor_end, e.sensor_end_count, b, a), meet);
        thud_world_destroy(world);
    }
}

/* Sensor events do not depend on contact_events. */
static void sensors_report_without_contact_events(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.contact_events = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    thud_shape_id zone = add_sensor(world, add_body(world, THUD_BODY_STATIC, 0, 0.5, 0));
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5, 0);
    thud_shape_id shape = add_shape(world, ball, 0.5f, 0, false, NULL);
    run(world, 1);
    only_begins(world, zone, shape);
    assert_int_equal(thud_events_of(world).begin_count, 0);
    OK(thud_body_destroy(world, ball));
    run(world, 1);
    only_ends(world, zone, shape);
    assert_int_equal(thud_events_of(world).end_count, 0);
    thud_world_destroy(world);
}

/* A terrain may be a sensor, and moving sensors see a terrain. */
static void line_and_sensor_meet_on_kinematic_bodies(void **state) {
    (void)state;
    for (int how = 0; how < 2; how++) {
        thud_world *world = make_world(weightless());
        thud_shape_def def = sensor_def(), plain = thud_default_shape_def();
        const thud_pos points[] = {{-4, 0}, {-1, 0.5}, {2, 0}, {4, 0.2}};
        thud_terrain hills = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 4};
        thud_shape_id line, shape;
        OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                                     how ? &def : &plain, &hills, &line));
        thud_body_id body = add_body(world, THUD_BODY_KINEMATIC, 0, 1.5, 0);
        shape = add_shape(world, body, 1, 0, false, how ? &plain : &def);
        run(world, 1);
        no_sensor_event(world);
        OK(thud_shape_raise(world, line, 0, 1, 1)); /* raised to the body */
        run(world, 1);
        only_begins(world, how ? line : shape, how ? shape : line);
        OK(thud_body_set_velocity(world, body, (thud_vec2){0, 2}, 0));
        run(world, 29);
        no_sensor_event(world);
        run(world, 31);
        OK(thud_body_set_transform(world, body, (thud_pos){0, 0}, 0));
        run(world, 1);
        only_begins(world, how ? line : shape, how ? shape : line);
        thud_world_destroy(world);
    }
}

/* ---- sleeping bodies ---- */

/* A world with a sleeping ball. */
typedef struct bedroom {
    thud_world *world;
    thud_body_id ball;
    thud_shape_id shape;
} bedroom;

/* A ball that sleeps at the origin; it is a sensor or a solid shape. */
static bedroom make_bedroom(bool sensor) {
    thud_world_def def = thud_default_world_def();
    thud_shape_def sensing = sensor_def();
    def.gravity = (thud_vec2){0, 0};
    bedroom room = {.world = make_world(def)};
    room.ball = add_body(room.world, THUD_BODY_DYNAMIC, 0, 0, 0);
    room.shape = add_shape(room.world, room.ball, 0.5f, 0, false, sensor ? &sensing : NULL);
    run(room.world, 60);
    assert_false(state_of(room.world, room.ball).awake);
    return room;
}

/* Adds a static body with the other shape of the pair, 9 to the right of the sleeping ball or over
 * it. */
static thud_body_id add_other(const bedroom *room, bool sensor, bool over, thud_shape_id *shape) {
    thud_shape_def sensing = sensor_def();
    thud_body_id body = add_body(room->world, THUD_BODY_STATIC, over ? 0 : 9, 0, 0);
    *shape = add_shape(room->world, body, 1, 1, true, sensor ? &sensing : NULL);
    return body;
}

/* A pair of a sensor and a sleeping body begins and ends, and the body sleeps on, whichever of the
 * two is the sensor. */
static void pair_begins_and_ends_while_the_body_sleeps(void **state) {
    (void)state;
    for (int sleeper_senses = 0; sleeper_senses < 2; sleeper_senses++) {
        for (int how = 0; how < 4; how++) {
            bedroom room = make_bedroom(sleeper_senses);
            thud_world *world = room.world;
            thud_shape_id other;
            thud_body_id body = add_other(&room, !sleeper_senses, how == 0 || how == 2, &other);
            if (how == 1) { /* moved to the ball */
                run(world, 1);
                no_sensor_event(world);
                OK(thud_body_set_transform(world, body, (thud_pos){1, 0}, 0));
            } else if (how == 2) { /* enabled over the ball */
                OK(thud_body_set_enabled(world, body, false));
                run(world, 1);
                no_sensor_event(world);
                OK(thud_body_set_enabled(world, body, true));
            } else if (how == 3) { /* a further shape of an existing body */
                thud_shape_def def = thud_default_shape_def();
                def.sensor = !sleeper_senses;
                run(world, 1);
                OK(thud_shape_create_circle(world, body, &def, (thud_vec2){-9, 0}, 1, &other));
            }
            run(world, 1);
            only_begins(world, sleeper_senses ? room.shape : other,
                        sleeper_senses ? other : room.shape);
            assert_false(state_of(world, room.ball).awake);
            run(world, 10);
            no_sensor_event(world);
            if (how == 0) {
                OK(thud_body_destroy(world, body));
            } else if (how == 1) {
                OK(thud_body_set_transform(world, body, (thud_pos){9, 0}, 0));
            } else if (how == 2) {
                OK(thud_body_set_enabled(world, body, false));
            } else {
                OK(thud_shape_destroy(world, other));
            }
            run(world, 1);
            only_ends(world, sleeper_senses ? room.shape : other,
                      sleeper_senses ? other : room.shape);
            assert_false(state_of(world, room.ball).awake);
            thud_world_destroy(world);
        }
    }
}

/* The sensor moves so little that its bounds overlap the ball's all the time. */
static void sensor_that_moves_a_little_ends_and_begins_over_a_sleeper(void **state) {
    (void)state;
    bedroom room = make_bedroom(false);
    thud_shape_id zone;
    thud_body_id body = add_other(&room, true, true, &zone);
    run(room.world, 1);
    only_begins(room.world, zone, room.shape);
    OK(thud_body_set_transform(room.world, body, (thud_pos){1.502, 0}, 0));
    run(room.world, 1);
    only_ends(room.world, zone, room.shape);
    OK(thud_body_set_transform(room.world, body, (thud_pos){1.498, 0}, 0));
    run(room.world, 1);
    only_begins(room.world, zone, room.shape);
    assert_false(state_of(room.world, room.ball).awake);
    thud_world_destroy(room.world);
}

/* A terrain that is created over a sleeping body, and then moved away, makes a begin and an end;
 * one of the two is the sensor. */
static void line_that_comes_to_a_sleeping_sensor_is_seen(void **state) {
    (void)state;
    for (int how = 0; how < 2; how++) {
        bedroom room = make_bedroom(how == 0);
        const thud_pos points[] = {{-4, 0}, {4, 0}};
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 2};
        thud_shape_def def = how ? sensor_def() : thud_default_shape_def();
        thud_shape_id ground;
        thud_body_id body = add_body(room.world, THUD_BODY_STATIC, 0, 0, 0);
        OK(thud_shape_create_terrain(room.world, body, &def, &line, &ground));
        run(room.world, 1);
        only_begins(room.world, how ? ground : room.shape, how ? room.shape : ground);
        assert_false(state_of(room.world, room.ball).awake);
        OK(thud_body_set_transform(room.world, body, (thud_pos){0, -9}, 0));
        run(room.world, 1);
        only_ends(room.world, how ? ground : room.shape, how ? room.shape : ground);
        thud_world_destroy(room.world);
    }
}

/* A sensor that sees a sleeping body does not begin again when that wakes. */
static void sleeper_that_is_seen_and_wakes_begins_once(void **state) {
    (void)state;
    bedroom room = make_bedroom(false);
    thud_shape_id zone;
    add_other(&room, true, true, &zone);
    run(room.world, 5);
    OK(thud_body_set_awake(room.world, room.ball, true));
    run(room.world, 1);
    no_sensor_event(room.world);
    OK(thud_body_set_velocity(room.world, room.ball, (thud_vec2){0, 60}, 0));
    run(room.world, 2);
    only_ends(room.world, zone, room.shape);
    thud_world_destroy(room.world);
}

/* A kinematic sensor that moves over a heap, or stays over it, lets it sleep. */
static void sensor_wakes_nobody(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    add_floor(world, NULL);
    for (int i = 0; i < 5; i++) {
        add_box(world, 0, 0.5 + i, 0.5f, 0.5f);
    }
    run(world, 240);
    assert_int_equal(thud_stats_of(world).awake_bodies, 0);
    thud_body_id light = add_body(world, THUD_BODY_KINEMATIC, -3, 2, 0);
    add_sensor(world, light);
    int begun = 0, ended = 0;
    for (int i = 0; i < 180; i++) {
        OK(thud_body_set_velocity(world, light, (thud_vec2){2, 0}, 0));
        run(world, 1);
        begun += thud_events_of(world).sensor_begin_count;
        ended += thud_events_of(world).sensor_end_count;
        assert_int_equal(thud_stats_of(world).awake_bodies, 1);
    }
    assert_int_equal(begun, 3);
    assert_int_equal(ended, 3);
    thud_world_destroy(world);
}

/* ---- within a step ---- */

/* The begin is reported in the step at whose end the two overlap, and the end in the one at whose
 * end they do not. */
static void what_moves_in_or_out_is_told_by_the_same_step(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        thud_world_def def = weightless();
        def.detection = detections[d];
        thud_world *world = make_world(def);
        thud_shape_id zone = add_sensor(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0));
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, -2, 0, 0);
        thud_shape_id shape = add_shape(world, ball, 0.5f, 0, false, NULL);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){60, 0}, 0));
        run(world, 1); /* the ball is at -1 */
        only_begins(world, zone, shape);
        near_to(thud_events_of(world).sensor_begin_time[0], d ? 0.5 : 1, 1e-3);
        run(world, 2); /* at 1 */
        no_sensor_event(world);
        run(world, 1); /* at 2 */
        only_ends(world, zone, shape);
        near_to(thud_events_of(world).sensor_end_time[0], d ? 0.5 : 1, 1e-3);
        thud_world_destroy(world);
    }
}

/* A circle passes gates of width 0.1 at 300 m/s, a static one and one that moves towards it; it
 * bounces off a wall, and passes both again on its way back. */
static void gates_are_passed_on_the_way_and_back(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        thud_world_def def = weightless();
        def.detection = detections[d];
        def.maximum_speed = 1000;
        thud_world *world = make_world(def);
        thud_shape_def gate = sensor_def(), elastic = thud_default_shape_def();
        elastic.restitution = 1;
        thud_body_id comes = add_body(world, THUD_BODY_DYNAMIC, 2, 0, 0);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 4.5, 0, 0);
        add_shape(world, add_body(world, THUD_BODY_STATIC, 1, 0, 0), 0.05f, 1, true, &gate);
        add_shape(world, comes, 0.05f, 1, true, &gate);
        add_shape(world, wall, 0.5f, 3, true, &elastic);
        add_shape(world, ball, 0.1f, 0, false, &elastic);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){300, 0}, 0));
        OK(thud_body_set_velocity(world, comes, (thud_vec2){-6, 0}, 0));
        int begun = 0, ended = 0;
        for (int step = 0; step < 6; step++) {
            run(world, 1);
            thud_events e = thud_events_of(world);
            for (int i = 0; i < e.sensor_begin_count; i++) {
                assert_true(d || e.sensor_begin_time[i] == 1);
            }
            begun += e.sensor_begin_count;
            ended += e.sensor_end_count;
        }
        assert_int_equal(begun, ended);
        /* `continuous` sees the static gate alone */
        assert_int_equal(begun, d == 0 ? 0 : d == 1 ? 2 : 4);
        thud_world_destroy(world);
    }
}

/* Two circles of radius 0.1, joined by a rod, fly side by side, 10 in a step. Walls stop the first
 * after a part of its way, and the second after another; each stop holds both, so that the rest of
 * either way is cut twice. Each passes gates of half width 0.05 before both stop at x = 1, and none
 * of those behind. */
static void body_that_is_held_twice_in_a_step_passes_what_it_did_when_it_did(void **state) {
    (void)state;
    const double stops[][2] = {{5, 2}, {3, 2.2}, {2, 5}, {9, 2}, {5, 4.9}};
    for (int i = 0; i < 5 * 3 * 2 * 2; i++) {
        thud_world_def def = weightless();
        def.maximum_speed = 1000;
        def.broadphase = broadphases[i % 3];
        bool swept = i >= 5 * 3 * 2;
        thud_world *world = make_world(def);
        thud_shape_def gate = sensor_def(), plain = thud_default_shape_def();
        thud_body_id ball[2];
        const double *stop = stops[i / 6 % 5];
        for (int k = 0; k < 2; k++) {
            int side = i / 3 % 2 ? !k : k; /* the order of creation decides which is tested first */
            double y = 3 * side;
            thud_body_def body = thud_default_body_def();
            body.kind = THUD_BODY_DYNAMIC;
            body.position = (thud_pos){0, y};
            body.velocity = (thud_vec2){600, 0};
            body.detection = swept && side ? &thud_detection_swept : NULL;
            OK(thud_body_create(world, &body, &ball[side]));
            add_shape(world, ball[side], 0.1f, 0, false, &plain);
            add_shape(world, add_body(world, THUD_BODY_STATIC, stop[side] + 0.6, y, 0), 0.5f, 1,
                      true, &plain);
            for (int x = 1; x < 9; x++) {
                thud_body_id at = add_body(world, THUD_BODY_STATIC, x == 1 ? 1 : x + 0.5, y, 0);
                add_shape(world, at, 0.05f, 1, true, &gate);
            }
        }
        thud_joint_def rod = thud_default_joint_def(THUD_JOINT_DISTANCE);
        rod.body_a = ball[0];
        rod.body_b = ball[1];
        rod.length = 3;
        OK(thud_joint_create(world, &rod, NULL));
        run(world, 1);
        double end = fmin(stop[0], stop[1]);
        int gates = 2 * (1 + (int)fmax(0, floor(end - 0.65 - 1)));
        thud_events e = thud_events_of(world);
        for (int k = 0; k < 2; k++) {
            near_to(state_of(world, ball[k]).position.x, end, 0.03);
        }
        assert_int_equal(e.sensor_begin_count, gates);
        assert_int_equal(e.sensor_end_count, gates);
        for (int k = 0; k < gates; k++) {
            double at = k % (gates / 2) ? 1.5 + k % (gates / 2) : 1;
            if (!swept) {
                near_to(e.sensor_begin_time[k], (at - 0.15) / 10, 2e-3);
                near_to(e.sensor_end_time[k], (at + 0.15) / 10, 2e-3);
            }
            assert_true(e.sensor_begin_time[k] < e.sensor_end_time[k]);
        }
        thud_world_destroy(world);
    }
}

/* A sleeping box is woken by another one that touches it in the step in which a fast sensor passes
 * it: the passage is reported once. */
static void what_wakes_as_a_sensor_passes_it_is_told_of_once(void **state) {
    (void)state;
    for (int d = 2; d < 4; d++) {
        for (int b = 0; b < 3; b++) {
            thud_world_def def = weightless();
            def.sleeping = true;
            def.detection = detections[d];
            def.broadphase = broadphases[b];
            def.maximum_speed = 1000;
            thud_world *world = make_world(def);
            thud_shape_def zone = sensor_def();
            thud_body_id sleeper = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
            add_shape(world, sleeper, 0.5f, 0.5f, true, NULL);
            run(world, 60);
            assert_false(state_of(world, sleeper).awake);
            thud_body_id other = add_body(world, THUD_BODY_DYNAMIC, 0, 0.99, 0);
            add_shape(world, other, 0.2f, 0.5f, true, NULL);
            thud_body_id quick = add_body(world, THUD_BODY_DYNAMIC, -3, -0.3, 0);
            add_shape(world, quick, 0.1f, 0, false, &zone);
            OK(thud_body_set_velocity(world, quick, (thud_vec2){360, 0}, 0));
            run(world, 1);
            assert_true(state_of(world, sleeper).awake);
            thud_events e = thud_events_of(world);
            assert_int_equal(e.sensor_begin_count, 1);
            assert_int_equal(e.sensor_end_count, 1);
            thud_world_destroy(world);
        }
    }
}

/* A ball in a sensor is taken out of it by an edit, and passes it again in the next step: that pair
 * has ended, and does not begin. A second end in one step could not be told from a pair that ended
 * and began again. */
static void what_an_edit_ended_is_not_told_of_passing_in_the_same_step(void **state) {
    (void)state;
    for (int i = 0; i < 4 * 3 * 3; i++) {
        thud_world_def def = weightless();
        def.detection = detections[i % 4];
        def.broadphase = broadphases[i / 4 % 3];
        def.maximum_speed = 1000;
        thud_world *world = make_world(def);
        thud_body_id place = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_shape_id zone = add_sensor(world, place);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        thud_shape_id shape = add_shape(world, ball, 0.5f, 0, false, NULL);
        run(world, 1);
        only_begins(world, zone, shape);
        if (i / 12 == 0) { /* refused for a moment */
            OK(thud_shape_set_filter(world, zone, (thud_filter){1, 0, 0}));
            OK(thud_shape_set_filter(world, zone, thud_default_shape_def().filter));
        } else { /* one of the two is set elsewhere */
            OK(thud_body_set_transform(world, i / 12 == 1 ? ball : place,
                                       (thud_pos){i / 12 == 1 ? -5 : 5, 0}, 0));
        }
        OK(thud_body_set_velocity(world, ball, (thud_vec2){600, 0}, 0)); /* by 10 */
        run(world, 1);
        only_ends(world, zone, shape);
        run(world, 1);
        no_sensor_event(world);
        OK(thud_body_set_transform(world, ball, (thud_pos){-5, 0}, 0));
        OK(thud_body_set_transform(world, place, (thud_pos){0, 0}, 0));
        run(world, 1);
        assert_int_equal(thud_events_of(world).sensor_begin_count, i % 4 != 0);
        assert_int_equal(thud_events_of(world).sensor_end_count, i % 4 != 0);
        thud_world_destroy(world);
    }
}

/* ---- worlds that get sensors by a call ---- */

/* Whether a circle is made as a sensor; refused, nothing is made. */
static bool makes_sensor(thud_world *world, thud_body_id body) {
    thud_shape_def def = sensor_def();
    thud_shape_id made = {0, 0};
    int shapes = thud_stats_of(world).shapes;
    thud_result result = thud_shape_create_circle(world, body, &def, (thud_vec2){0, 9}, 1, &made);
    assert_true(result == THUD_OK || (result == THUD_ERROR_INVALID && made.index1 == 0));
    assert_int_equal(thud_stats_of(world).shapes, shapes + (result == THUD_OK));
    return result == THUD_OK;
}

static thud_body_id first_body(const thud_world *world) {
    thud_body_id body = {0, 0};
    int count = 0;
    thud_world_get_bodies(world, &body, 1, &count);
    return body;
}

static thud_world_def small_def(void) {
    thud_world_def def = thud_default_small_world_def(&thud_quality_draft);
    def.log = NULL;
    return def;
}

static void small_world_has_sensors_from_the_first_that_is_set(void **state) {
    (void)state;
    thud_world_def whole = thud_default_world_def_of(&thud_quality_draft);
    thud_world *worlds[2] = {make_world(small_def()), make_world(whole)};
    for (int i = 0; i < 2; i++) {
        thud_shape_def plain = thud_default_shape_def();
        thud_body_id gate = add_body(worlds[i], THUD_BODY_STATIC, 0, 0, 0);
        thud_shape_id shape = add_shape(worlds[i], gate, 1, 0, false, &plain);
        if (i == 0) {
            assert_false(makes_sensor(worlds[i], gate));
        }
        OK(thud_shape_set_sensor(worlds[i], shape, true));
        assert_true(makes_sensor(worlds[i], gate));
        OK(thud_body_set_velocity(worlds[i], add_ball(worlds[i], 0, 5, 0.1f), (thud_vec2){0, -700},
                                  0));
    }
    int told = 0;
    for (int step = 0; step < 30; step++) {
        run(worlds[0], 1);
        run(worlds[1], 1);
        told += thud_events_of(worlds[0]).sensor_begin_count;
        assert_int_equal(thud_events_of(worlds[0]).sensor_begin_count,
                         thud_events_of(worlds[1]).sensor_begin_count);
        assert_true(thud_hash_of(worlds[0]) == thud_hash_of(worlds[1]));
    }
    assert_int_equal(told, 1);
    thud_world_destroy(worlds[0]);
    thud_world_destroy(worlds[1]);
}

/* A snapshot says whether shapes can be sensors; a world of thud_default_world_def keeps them. */
static void snapshot_brings_sensors_into_a_small_world(void **state) {
    (void)state;
    static char bytes[2][1 << 16];
    size_t sizes[2];
    thud_body_id body = {0, 0};
    thud_world *from = make_world(small_def());
    thud_shape_def plain = thud_default_shape_def();
    body = add_body(from, THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_id shape = add_shape(from, body, 1, 0, false, &plain);
    add_ball(from, 0, 0.5, 0.1f);
    OK(thud_world_snapshot(from, bytes[0], sizeof bytes[0], &sizes[0]));
    OK(thud_shape_set_sensor(from, shape, true));
    OK(thud_world_snapshot(from, bytes[1], sizeof bytes[1], &sizes[1]));
    thud_world *to = make_world(small_def());
    thud_world_def with_all = thud_default_world_def_of(&thud_quality_draft);
    with_all.broadphase = small_def().broadphase;
    thud_world *whole = make_world(with_all);
    for (int i = 0; i < 2; i++) {
        OK(thud_world_restore(to, bytes[i], sizes[i]));
        OK(thud_world_restore(whole, bytes[i], sizes[i]));
        thud_body_id there = first_body(to);
        assert_int_equal(makes_sensor(to, there), i);
        assert_true(makes_sensor(whole, first_body(whole)));
    }
    OK(thud_world_restore(to, bytes[1], sizes[1]));
    run(to, 1);
    assert_int_equal(thud_events_of(to).sensor_begin_count, 1);
    OK(thud_world_restore(to, bytes[0], sizes[0]));
    assert_false(makes_sensor(to, first_body(to)));
    thud_world_destroy(from);
    thud_world_destroy(to);
    thud_world_destroy(whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sensor_of_each_kind_sees_each_kind_but_static_static),
        cmocka_unit_test(kinematic_body_that_passes_a_sensor_begins_and_ends),
        cmocka_unit_test(two_sensors_report_each_other_where_their_filters_meet),
        cmocka_unit_test(sensors_report_without_contact_events),
        cmocka_unit_test(line_and_sensor_meet_on_kinematic_bodies),
        cmocka_unit_test(pair_begins_and_ends_while_the_body_sleeps),
        cmocka_unit_test(sensor_that_moves_a_little_ends_and_begins_over_a_sleeper),
        cmocka_unit_test(line_that_comes_to_a_sleeping_sensor_is_seen),
        cmocka_unit_test(sleeper_that_is_seen_and_wakes_begins_once),
        cmocka_unit_test(sensor_wakes_nobody),
        cmocka_unit_test(what_moves_in_or_out_is_told_by_the_same_step),
        cmocka_unit_test(gates_are_passed_on_the_way_and_back),
        cmocka_unit_test(body_that_is_held_twice_in_a_step_passes_what_it_did_when_it_did),
        cmocka_unit_test(what_wakes_as_a_sensor_passes_it_is_told_of_once),
        cmocka_unit_test(what_an_edit_ended_is_not_told_of_passing_in_the_same_step),
        cmocka_unit_test(small_world_has_sensors_from_the_first_that_is_set),
        cmocka_unit_test(snapshot_brings_sensors_into_a_small_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
