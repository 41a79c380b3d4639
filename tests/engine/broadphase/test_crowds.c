/* test_crowds.c: many shapes in one place (a crowd): every pair is found, at once where the pairs
 * are few for the world, else within a number of steps that grows with the crowd (thud_detection.h
 * states it). Pairs that cannot act take up no room for contacts. */
#include "engine_support.h"
#include "every_choice.h"
#include "share.h"
#include "snapshot_support.h"

/* Bodies of a crowd at most. */
enum { MOST = 1000 };

/* A crowd; counts of sensor overlaps that are open, and of contacts that began. */
typedef struct crowd {
    thud_world *world;
    thud_body_id bodies[MOST];
    uint64_t seed;
    int sensed, met;
} crowd;

/* Adds circles in one spot with the shape def `def`, whose filter decides whether they collide. */
static void fill(crowd *c, int count, const thud_shape_def *def) {
    for (int i = 0; i < count; i++) {
        thud_body_id id = add_body(c->world, THUD_BODY_DYNAMIC, random_in(&c->seed, -0.05, 0.05),
                                   random_in(&c->seed, -0.05, 0.05), 0);
        add_shape(c->world, id, 0.25f, 0, false, def);
        c->bodies[i] = id;
    }
}

/* Steps the world, and counts sensor overlaps and contacts that began. */
static void step(crowd *c) {
    run(c->world, 1);
    thud_events e = thud_events_of(c->world);
    c->sensed += e.sensor_begin_count - e.sensor_end_count;
    c->met += e.begin_count;
}

/* A prologue that vetoes every contact. */
static bool let_through(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)world;
    (void)contact;
    (void)settings;
    (void)context;
    return false;
}

/* A crowd whose circles do not collide with each other, by their group or by their category and
 * mask. */
static crowd mates(int count, const thud_broadphase *broadphase, bool by_group) {
    thud_world_def def = weightless();
    thud_shape_def shape = thud_default_shape_def();
    def.broadphase = broadphase;
    crowd c = {.world = make_world(def), .seed = 5};
    set_listeners(c.world, let_through, NULL, NULL);
    if (by_group) {
        shape.filter.group = -1;
    } else {
        shape.filter.category = 2;
        shape.filter.mask = ~2u;
    }
    fill(&c, count, &shape);
    return c;
}

static void add_sensor(crowd *c, thud_body_kind kind) {
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    add_shape(c->world, add_body(c->world, kind, 0, 0, 0), 1, 1, true, &sensor);
}

static void sensor_in_a_crowd_of_mates_reports_all(void **state) {
    (void)state;
    for (int k = 0; k < 12; k++) {
        crowd c = mates(120, broadphases[k % 3], k / 3 % 2);
        add_sensor(&c, k / 6 ? THUD_BODY_DYNAMIC : THUD_BODY_KINEMATIC);
        step(&c);
        assert_int_equal(c.sensed, 120);
        thud_world_destroy(c.world);
    }
}

/* The ball is created later, outside of the crowd, and flies through it. */
static void body_flown_through_a_crowd_of_mates_meets_all(void **state) {
    (void)state;
    for (int k = 0; k < 6; k++) {
        crowd c = mates(120, broadphases[k % 3], k / 3);
        step(&c);
        thud_body_id bullet = add_ball(c.world, -3, 0, 0.1f);
        OK(thud_body_set_velocity(c.world, bullet, (thud_vec2){12, 0}, 0));
        for (int i = 0; i < 30; i++) {
            step(&c);
        }
        near_to(state_of(c.world, bullet).position.x, 3, 1e-3);
        assert_int_equal(c.met, 120);
        thud_world_destroy(c.world);
    }
}

/* A thousand shapes have half a million pairs, too many to test in one step. */
static void sensor_in_a_great_crowd_reports_all_within_steps_that_are_stated(void **state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
        crowd c = mates(1000, broadphases[k], true);
        add_sensor(&c, THUD_BODY_KINEMATIC);
        int steps = 0;
        for (; steps < 1000 / 64 + 1 && c.sensed < 1000; steps++) {
            step(&c);
        }
        assert_int_equal(c.sensed, 1000);
        /* A second sensor, created when nothing moves, finds all circles, and the sensors find each
         * other. */
        add_sensor(&c, THUD_BODY_KINEMATIC);
        for (steps = 0; steps < 1000 / 64 + 1 && c.sensed < 2002; steps++) {
            step(&c);
        }
        assert_int_equal(c.sensed, 2002);
        thud_world_destroy(c.world);
    }
}

/* The circles' contacts are vetoed, so the crowd stays. In the fourth case its bodies also sleep in
 * between; a build that runs a share of the cases runs that one. */
static void crowd_that_stays_gets_all_pairs_within_steps_that_are_stated(void **state) {
    (void)state;
    enum { COUNT = 220, ALL = COUNT * (COUNT - 1) / 2 };
    for (int k = 4 - share_of(4); k < 4; k++) {
        thud_world_def def = weightless();
        def.broadphase = broadphases[k % 3];
        def.sleeping = k == 3;
        crowd c = {.world = make_world(def), .seed = 6};
        set_listeners(c.world, let_through, NULL, NULL);
        fill(&c, COUNT, NULL);
        step(&c);
        assert_true(thud_stats_of(c.world).pairs < 64 * COUNT); /* not all pairs in one step */
        int steps = 1;
        for (; steps < 4 * COUNT && thud_stats_of(c.world).pairs < ALL; steps++) {
            step(&c);
            for (int b = 0; b < COUNT && steps % 50 == 49; b++) {
                OK(thud_body_set_awake(c.world, c.bodies[b], true));
            }
        }
        assert_int_equal(thud_stats_of(c.world).pairs, ALL);
        thud_world_destroy(c.world);
    }
}

/* The square is so wide that there are somewhat too many pairs for the number of circles. Two steps
 * later the pairs fit, while more than half of them have no contact yet; making them all at once
 * would be 60 a circle, more than there is room for. A world that is restored continues with the
 * same bits. */
static void crowd_that_comes_apart_gets_no_more_pairs_than_there_are_places(void **state) {
    (void)state;
    /* Circles; room for pairs, for each of them; steps; and steps until the snapshot. */
    enum { COUNT = 2000, PLACES = 32, STEPS = 12, KEPT = 3 };
    for (int k = 0; k < 3; k++) {
        thud_world_def def = weightless();
        def.broadphase = broadphases[k];
        thud_world *world = make_world(def);
        uint64_t seed = 7;
        for (int i = 0; i < COUNT; i++) {
            add_ball(world, random_in(&seed, -1.75, 1.75), random_in(&seed, -1.75, 1.75), 0.25f);
        }
        saved kept = {0};
        for (int i = 0; i < STEPS; i++) {
            run(world, 1);
            int pairs = thud_stats_of(world).pairs;
            assert_in_range(pairs, i < KEPT ? PLACES / 2 * COUNT : 1, PLACES * COUNT);
            if (i == KEPT - 1) {
                kept = save(world);
            }
        }
        thud_world *twin = make_world(def);
        back_to(twin, kept);
        run(twin, STEPS - KEPT);
        assert_true(digest_of(twin) == digest_of(world));
        free(kept.bytes);
        thud_world_destroy(twin);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sensor_in_a_crowd_of_mates_reports_all),
        cmocka_unit_test(body_flown_through_a_crowd_of_mates_meets_all),
        cmocka_unit_test(sensor_in_a_great_crowd_reports_all_within_steps_that_are_stated),
        cmocka_unit_test(crowd_that_stays_gets_all_pairs_within_steps_that_are_stated),
        cmocka_unit_test(crowd_that_comes_apart_gets_no_more_pairs_than_there_are_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
