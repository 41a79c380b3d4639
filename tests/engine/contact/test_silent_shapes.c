/* test_silent_shapes.c: shapes whose pairs make no events (silent shapes): none of their events is
 * reported, and an end is reported exactly where its begin was, also where events are switched in
 * between. */
#include "event_chaos.h"
#include "every_choice.h"
#include "snapshot_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_lists.h>

/* The events of one step. */
static thud_events told(thud_world *world) {
    run(world, 1);
    return thud_events_of(world);
}

/* Asserts that there are no events for that many steps. */
static void nothing_told(thud_world *world, int steps) {
    for (int i = 0; i < steps; i++) {
        thud_events e = told(world);
        assert_int_equal(e.begin_count + e.end_count + e.hit_count, 0);
        assert_int_equal(e.sensor_begin_count + e.sensor_end_count, 0);
    }
}

static thud_shape_id add_silent(thud_world *world, thud_body_id body, float hx, float hy) {
    thud_shape_def def = thud_default_shape_def();
    def.events = false;
    return add_shape(world, body, hx, hy, false, &def);
}

/* Sets whether a shape's pairs make events, and asserts that it is read back. */
static void set_events(thud_world *world, thud_shape_id shape, bool events) {
    thud_shape_state state;
    OK(thud_shape_set_events(world, shape, events));
    OK(thud_shape_get_state(world, shape, &state));
    assert_int_equal(state.events, events);
}

/* ---- what is not reported ---- */

/* A silent ball lands, hits and is destroyed without events, while another ball beside it has its
 * events. */
static void silent_shape_touches_hits_and_parts_unheard_and_others_do_not(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[d];
        thud_world *world = make_world(def);
        add_floor(world, NULL);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 3, 0);
        add_silent(world, ball, 0.5f, 0);
        thud_body_id loud = add_ball(world, 10, 3, 0.5f);
        int begun = 0, hits = 0;
        for (int i = 0; i < 90; i++) {
            thud_events e = told(world);
            begun += e.begin_count;
            hits += e.hit_count;
        }
        assert_int_equal(begun, 1);
        assert_int_equal(hits, 1);
        near_to(state_of(world, ball).position.y, state_of(world, loud).position.y, 1e-3);
        OK(thud_body_set_transform(world, ball, (thud_pos){0, 9}, 0));
        nothing_told(world, 5);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, -200}, 0));
        nothing_told(world, 60);
        OK(thud_body_destroy(world, ball));
        nothing_told(world, 2);
        thud_world_destroy(world);
    }
}

/* A pair makes no sensor events where either the sensor or the other shape is silent. */
static void silence_of_either_side_is_enough_for_sensors_too(void **state) {
    (void)state;
    for (int silent = 0; silent < 2; silent++) {
        thud_world *world = make_world(weightless());
        thud_shape_def zone = thud_default_shape_def(), plain = thud_default_shape_def();
        zone.sensor = true;
        zone.events = silent != 0;
        plain.events = silent != 1;
        add_shape(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), 1, 1, true, &zone);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0.5, 0, 0);
        add_shape(world, ball, 0.5f, 0, false, &plain);
        nothing_told(world, 2);
        OK(thud_body_set_transform(world, ball, (thud_pos){5, 0}, 0));
        nothing_told(world, 2);
        thud_world_destroy(world);
    }
}

/* ---- switched while shapes touch ---- */

/* Events are switched while the two shapes touch or overlap: the end is reported exactly where the
 * begin was. */
static void end_is_told_where_its_begin_was(void **state) {
    (void)state;
    for (int silent = 0; silent < 2; silent++) {
        for (int sensor = 0; sensor < 2; sensor++) {
            thud_world *world = make_world(weightless());
            thud_shape_def def = thud_default_shape_def();
            def.sensor = sensor;
            def.events = !silent;
            thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
            thud_shape_id shape = add_shape(world, body, 1, 1, true, &def);
            thud_body_id ball = add_ball(world, 1.4, 0, 0.5f);
            thud_events e = told(world);
            assert_int_equal(e.begin_count + e.sensor_begin_count, !silent);
            set_events(world, shape, silent);
            nothing_told(world, 3);
            OK(thud_body_set_transform(world, ball, (thud_pos){5, 0}, 0));
            e = told(world);
            assert_int_equal(e.end_count + e.sensor_end_count, !silent);
            OK(thud_body_set_transform(world, body, (thud_pos){0, 0}, 0));
            OK(thud_body_set_transform(world, ball, (thud_pos){1.4, 0}, 0));
            e = told(world);
            assert_int_equal(e.begin_count + e.sensor_begin_count, silent);
            thud_world_destroy(world);
        }
    }
}

/* A terrain and a shape are one pair, over whichever segments. */
static void line_is_told_of_as_it_began(void **state) {
    (void)state;
    for (int silent = 0; silent < 2; silent++) {
        thud_world *world = make_world(thud_default_world_def());
        thud_pos points[41];
        for (int i = 0; i < 41; i++) {
            points[i] = (thud_pos){0.5 * i - 10.0, 0};
        }
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 41};
        thud_shape_def def = thud_default_shape_def();
        def.friction = 0;
        thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        OK(thud_shape_create_terrain(world, ground, &def, &line, NULL));
        thud_body_id box = add_body(world, THUD_BODY_DYNAMIC, -6, 0.5, 0);
        def.events = !silent;
        thud_shape_id shape = add_shape(world, box, 1, 0.5f, false, &def);
        int begun = 0;
        for (int i = 0; i < 10; i++) {
            begun += told(world).begin_count;
        }
        assert_int_equal(begun, !silent);
        set_events(world, shape, silent);
        OK(thud_body_set_velocity(world, box, (thud_vec2){4, 0}, 0));
        nothing_told(world, 120);
        assert_true(state_of(world, box).position.x > 1);
        OK(thud_body_set_transform(world, box, (thud_pos){0, 5}, 0));
        assert_int_equal(told(world).end_count, !silent);
        thud_world_destroy(world);
    }
}

/* ---- at random ---- */

/* Switches events of random shapes on or off. */
static void toggle_some(chaos *c) {
    thud_shape_id shapes[256];
    int count;
    OK(thud_world_get_shapes(c->world, shapes, 256, &count));
    for (int i = 0; i < count && i < 256; i++) {
        if (pick(c, 12) == 0) {
            OK(thud_shape_set_events(c->world, shapes[i], pick(c, 3) != 0));
        }
    }
}

static chaos *make_chaos(const thud_detection *detection, uint64_t seed) {
    chaos *c = calloc(1, sizeof *c);
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    c->seed = seed;
    c->world = make_world(def);
    add_pit(c);
    add_ground(c);
    for (int i = 0; i < BODIES; i++) {
        add_random_body(c, i);
    }
    return c;
}

/* In random worlds whose shapes are switched at random, each reported begin has exactly one end. */
static void every_told_begin_has_its_end_whatever_is_switched(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        chaos *c = make_chaos(detections[d], 7919);
        for (int i = 0; i < 2 * STEPS; i++) {
            c->quiet = i % 120 > 40;
            toggle_some(c);
            for (int edits = c->quiet ? 0 : pick(c, 3); edits > 0; edits--) {
                edit(c);
            }
            if (!c->quiet && pick(c, 8) == 0) {
                edit_ground(c);
            }
            step(c);
        }
        assert_true(c->touches.begun > 100);
        assert_true(c->sensed.begun > 20);
        OK(thud_body_destroy(c->world, c->ground));
        for (int i = 0; i < BODIES; i++) {
            fine_or_gone(thud_body_destroy(c->world, c->bodies[i]));
        }
        step(c);
        assert_int_equal(c->touches.count, 0);
        assert_int_equal(c->sensed.count, 0);
        thud_world_destroy(c->world);
        free(c);
    }
}

/* Silent shapes change nothing but which events are reported. */
static void silent_world_moves_as_a_loud_one(void **state) {
    (void)state;
    chaos *loud = make_chaos(&thud_detection_swept, 104729);
    chaos *silent = make_chaos(&thud_detection_swept, 104729);
    thud_shape_id shapes[256];
    int count;
    OK(thud_world_get_shapes(silent->world, shapes, 256, &count));
    assert_true(count > BODIES && count <= 256);
    for (int i = 0; i < count; i++) {
        OK(thud_shape_set_events(silent->world, shapes[i], false));
    }
    for (int i = 0; i < 600; i++) {
        run(loud->world, 1);
        nothing_told(silent->world, 1);
        for (int k = 0; k < BODIES; k++) {
            thud_body_state a = state_of(loud->world, loud->bodies[k]);
            thud_body_state b = state_of(silent->world, silent->bodies[k]);
            assert_memory_equal(&a.position, &b.position, sizeof a.position);
            assert_int_equal(a.awake, b.awake);
        }
    }
    thud_world_destroy(loud->world);
    thud_world_destroy(silent->world);
    free(loud);
    free(silent);
}

/* ---- snapshots ---- */

/* A restored world continues with the same events. */
static void snapshot_knows_who_is_silent_and_what_was_told(void **state) {
    (void)state;
    chaos *c = make_chaos(NULL, 65537);
    for (int i = 0; i < 60; i++) {
        toggle_some(c);
        run(c->world, 1);
    }
    saved here = save(c->world);
    uint64_t digests[90];
    for (int i = 0; i < 90; i++) {
        run(c->world, 1);
        digests[i] = digest_of(c->world);
    }
    chaos *other = make_chaos(NULL, 31);
    back_to(other->world, here);
    for (int i = 0; i < 90; i++) {
        run(other->world, 1);
        assert_int_equal(digest_of(other->world), digests[i]);
    }
    thud_world_destroy(other->world);
    free(other);
    thud_world_destroy(c->world);
    free(here.bytes);
    free(c);
}

/* ---- refused ---- */

static void wrong_input_is_refused(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_shape_id shape = add_shape(world, add_ball(world, 0, 0, 1), 1, 0, false, NULL);
    assert_int_equal(thud_shape_set_events(NULL, shape, false), THUD_ERROR_NULL);
    shape.generation++;
    assert_int_equal(thud_shape_set_events(world, shape, false), THUD_ERROR_STALE);
    assert_int_equal(thud_shape_set_events(world, (thud_shape_id){0, 0}, false), THUD_ERROR_STALE);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silent_shape_touches_hits_and_parts_unheard_and_others_do_not),
        cmocka_unit_test(silence_of_either_side_is_enough_for_sensors_too),
        cmocka_unit_test(end_is_told_where_its_begin_was),
        cmocka_unit_test(line_is_told_of_as_it_began),
        cmocka_unit_test(every_told_begin_has_its_end_whatever_is_switched),
        cmocka_unit_test(silent_world_moves_as_a_loud_one),
        cmocka_unit_test(snapshot_knows_who_is_silent_and_what_was_told),
        cmocka_unit_test(wrong_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
