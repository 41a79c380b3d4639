/* test_sensors_memory.c: however many shapes enter sensors in a step, the step makes no allocation
 * once bodies have moved, so that it cannot fail from then on. */
#include "engine_support.h"
#include "every_choice.h"
#include "share.h"

#include <thud/thud_detection.h>

/* ---- when a step allocates ---- */

/* calls of the world's clock in this step; after MARKS of them the narrowphase is complete */
static int marks;
static int late; /* allocations since then */
enum { MARKS = 4 };

/* The world's clock, which counts its calls. */
static double mark(void *context) {
    (void)context;
    return ++marks;
}

static void *get(size_t bytes, void *context) {
    (void)context;
    late += marks >= MARKS;
    return aligned_alloc(64, bytes);
}

static void put(void *block, size_t bytes, void *context) {
    (void)bytes, (void)context;
    free(block);
}

/* Steps the world, and asserts that it does not allocate late. */
static void step(thud_world *world) {
    marks = late = 0;
    OK(thud_world_step(world));
    assert_true(marks > MARKS);
    marks = 0;
    assert_int_equal(late, 0);
}

/* ---- crowds of sensors and balls ---- */

/* A case: how many sensors (zones) and balls, which group moves, and indices of detection and
 * broadphase. */
typedef struct crowd {
    int zones, balls;
    bool zones_move; /* the sensors move to the balls; else the balls to the sensors */
    int detection, broadphase;
} crowd;

static thud_shape_def shape_of(bool zone) {
    thud_shape_def def = thud_default_shape_def();
    def.sensor = zone;
    def.filter = zone ? (thud_filter){2, 4, 0} : (thud_filter){4, 2, 0};
    return def;
}

enum { BODIES = 4000 };

/* A world with sensors around x = 0 and balls around x = 100. */
typedef struct scene {
    thud_world *world;
    thud_body_id body[BODIES];
    int count;
} scene;

/* Creates the case's world; `half` is the half width of the sensors. */
static scene make_crowd(const crowd *c, float half) {
    thud_world_def def = weightless();
    def.detection = detections[c->detection];
    def.broadphase = broadphases[c->broadphase];
    def.maximum_speed = 50000;
    def.allocator = (thud_allocator){get, put, NULL};
    def.clock = mark;
    scene s = {.world = make_world(def), .count = c->zones + c->balls};
    thud_shape_def zone = shape_of(true), ball = shape_of(false);
    for (int i = 0; i < s.count; i++) {
        bool is_zone = i < c->zones;
        int n = i - c->zones;
        thud_body_kind kind = is_zone == c->zones_move ? THUD_BODY_DYNAMIC : THUD_BODY_STATIC;
        if (is_zone) {
            s.body[i] = add_body(s.world, kind, 0, 0, 0);
            add_shape(s.world, s.body[i], half, 5, true, &zone);
        } else {
            s.body[i] = add_body(s.world, kind, 100 + n % 40 * 0.05, n / 40 * 0.05, 0);
            add_shape(s.world, s.body[i], 0.02f, 0, false, &ball);
        }
    }
    return s;
}

/* Gives the moving group a velocity of `way` metres in a step, towards the other group. */
static void set_off(const scene *s, const crowd *c, double way) {
    for (int i = 0; i < s->count; i++) {
        if ((i < c->zones) == c->zones_move) {
            thud_vec2 velocity = {(float)((c->zones_move ? 60 : -60) * way), 0};
            OK(thud_body_set_velocity(s->world, s->body[i], velocity, 0));
        }
    }
}

/* Calls `check` for so many sensors and balls, with every detection and broadphase, and either
 * group moving. */
static void for_crowds(void (*check)(const crowd *), int zones, int balls) {
    for (int i = 0; i < 4 * 3 * 2; i += TEST_SHARE) {
        crowd c = {zones, balls, i % 2, i / 2 % 4, i / 8};
        check(&c);
    }
}

/* ---- shapes that enter ---- */

/* All pairs begin to overlap in one step, which reports them. */
static void come_in(const crowd *c) {
    scene s = make_crowd(c, 4);
    step(s.world);
    set_off(&s, c, 101);
    step(s.world);
    thud_events e = thud_events_of(s.world);
    assert_int_equal(e.sensor_begin_count, c->zones * c->balls);
    assert_int_equal(e.sensor_end_count, 0);
    set_off(&s, c, 0);
    step(s.world);
    e = thud_events_of(s.world);
    assert_int_equal(e.sensor_begin_count + e.sensor_end_count, 0);
    set_off(&s, c, 101);
    step(s.world);
    assert_int_equal(thud_events_of(s.world).sensor_end_count, c->zones * c->balls);
    thud_world_destroy(s.world);
}

static void crowd_that_comes_into_sensors_asks_for_no_memory_late(void **state) {
    (void)state;
    for (int i = 0; i < 4 * 3; i += TEST_SHARE) {
        come_in(&(crowd){1, 3000, false, i % 4, i / 4});
        come_in(&(crowd){3000, 1, true, i % 4, i / 4});
    }
    for_crowds(come_in, 1, 500);
    for_crowds(come_in, 500, 1);
    for_crowds(come_in, 22, 22);
}

/* More pairs than there is room for: 15 times as many as shapes. The next step reports the rest. */
static void come_in_late(const crowd *c) {
    scene s = make_crowd(c, 4);
    step(s.world);
    set_off(&s, c, 101);
    step(s.world);
    int told = thud_events_of(s.world).sensor_begin_count;
    set_off(&s, c, 0);
    step(s.world);
    told += thud_events_of(s.world).sensor_begin_count;
    assert_int_equal(told, c->zones * c->balls);
    assert_int_equal(thud_events_of(s.world).sensor_end_count, 0);
    step(s.world);
    assert_int_equal(thud_events_of(s.world).sensor_begin_count, 0);
    thud_world_destroy(s.world);
}

static void what_there_is_no_room_for_is_told_by_the_next_step(void **state) {
    (void)state;
    for_crowds(come_in_late, 30, 30);
}

/* ---- shapes that pass ---- */

/* The moving group passes the other completely within one step. `bisect` and `swept` see that, and
 * `continuous` does where the sensors are static. */
static void pass(const crowd *c) {
    scene s = make_crowd(c, 0.05f);
    bool looks = c->detection > 1 || (c->detection == 1 && !c->zones_move);
    step(s.world);
    set_off(&s, c, 200);
    step(s.world);
    thud_events e = thud_events_of(s.world);
    assert_int_equal(e.sensor_begin_count, looks ? c->zones * c->balls : 0);
    assert_int_equal(e.sensor_end_count, e.sensor_begin_count);
    thud_world_destroy(s.world);
}

static void crowd_that_passes_sensors_asks_for_no_memory_late(void **state) {
    (void)state;
    for (int i = 0; i < 4 * 3; i += TEST_SHARE) {
        pass(&(crowd){1, 3000, false, i % 4, i / 4});
        pass(&(crowd){3000, 1, true, i % 4, i / 4});
    }
    for_crowds(pass, 1, 500);
    for_crowds(pass, 500, 1);
    for_crowds(pass, 22, 22);
}

/* ---- the first sensor ---- */

/* A prologue that adds the first sensor. */
static bool make_sensor(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)settings;
    bool *made = context;
    if (!*made) {
        thud_shape_def zone = thud_default_shape_def();
        zone.sensor = true;
        int before = late;
        add_shape(world, contact->body_b, 1, 0, false, &zone);
        late = before; /* allocations of the call itself are allowed */
        *made = true;
    }
    return true;
}

/* A sensor created inside a callback takes part from the next step on. */
static void first_sensor_made_by_a_callback_asks_for_no_memory_late(void **state) {
    (void)state;
    for (int i = 0; i < 12; i++) {
        crowd c = {0, 2, false, i % 4, i / 4};
        scene s = make_crowd(&c, 1);
        bool made = false;
        add_box(s.world, -50, 0, 0.5f, 0.5f);
        add_box(s.world, -50, 0.99, 0.5f, 0.5f);
        set_listeners(s.world, make_sensor, NULL, &made);
        step(s.world);
        assert_true(made);
        assert_int_equal(thud_events_of(s.world).sensor_begin_count, 0);
        step(s.world);
        assert_int_equal(thud_events_of(s.world).sensor_begin_count, 1);
        thud_world_destroy(s.world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crowd_that_comes_into_sensors_asks_for_no_memory_late),
        cmocka_unit_test(what_there_is_no_room_for_is_told_by_the_next_step),
        cmocka_unit_test(crowd_that_passes_sensors_asks_for_no_memory_late),
        cmocka_unit_test(first_sensor_made_by_a_callback_asks_for_no_memory_late),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
