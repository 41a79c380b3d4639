/* test_joints_held.c: where a detection stops a body within its step, the bodies that joints tie to
 * it are held with it: joints stay closed and no energy comes in. Motors that press a body against
 * a wall stall. */
#include "joint_support.h"

#include <thud/thud_detection.h>

static const thud_vec2 middle = {0, 0};
static const thud_detection *const detections[] = {&thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};

/* Rows of balls on rods fly at a wall at 150 m/s: in the step in which the first ball of a row
 * stops, 2 m of its motion are left. */
static void joints_stay_closed_where_a_body_is_stopped(void **state) {
    (void)state;
    for (int i = 0; i < 3 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        def.detection = detections[i / QUALITIES];
        def.gravity = middle;
        thud_world *world = make_world(def);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 10, 0, 0);
        add_shape(world, wall, 0.1f, 5, false, NULL);
        thud_body_id last = {0};
        for (int k = 0; k < 3; k++) {
            thud_body_id ball = add_ball(world, 0.1 - 0.3 * k, 0.6 * k, 0.2f);
            OK(thud_body_set_velocity(world, ball, (thud_vec2){150, 0}, 0));
            if (k) {
                thud_joint_def rod = between(THUD_JOINT_DISTANCE, last, ball, middle, middle);
                rod.length = (float)hypot(0.3, 0.6);
                make(world, rod);
            }
            last = ball;
        }
        int held = 0;
        for (int step = 0; step < 6 && !held; step++) {
            run(world, 1);
            held = (int)thud_stats_of(world).held_bodies;
        }
        assert_int_equal(held, 3);
        near_to(thud_step_error_of(world).joint_gap_max, 0, 1e-4);
        /* Collisions of the whirling balls open the rods for some steps; in between they are
         * closed. */
        run(world, 60);
        double least = 1;
        for (int step = 0; step < 10; step++) {
            run(world, 1);
            least = fmin(least, thud_step_error_of(world).joint_gap_max);
        }
        near_to(least, 0, 3e-3);
        thud_world_destroy(world);
    }
}

/* A body that only a spring ties to the held one is not held. */
static void springs_hold_nobody_back(void **state) {
    (void)state;
    thud_world_def def = def_of(&thud_quality_default);
    def.gravity = middle;
    thud_world *world = make_world(def);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 10, 0, 0);
    add_shape(world, wall, 0.1f, 5, false, NULL);
    thud_body_id a = add_ball(world, 0, 0, 0.2f), b = add_ball(world, -0.5, 0.8, 0.2f);
    OK(thud_body_set_velocity(world, a, (thud_vec2){150, 0}, 0));
    OK(thud_body_set_velocity(world, b, (thud_vec2){150, 0}, 0));
    thud_joint_def spring = between(THUD_JOINT_DISTANCE, a, b, middle, middle);
    spring.drive[THUD_DIRECTION_ALONG].frequency = 2;
    spring.drive[THUD_DIRECTION_ALONG].target = 1;
    make(world, spring);
    int held = 0;
    for (int step = 0; step < 6 && !held; step++) {
        run(world, 1);
        held = (int)thud_stats_of(world).held_bodies;
    }
    assert_int_equal(held, 1);
    thud_world_destroy(world);
}

/* Held bodies stop together, and gravity adds no velocity while they are held: boxes on rods around
 * a hub fall onto the floor, and the gains of all steps together are below 2 J, beside 500 J of the
 * fall. */
static void energy_does_not_rise_where_a_linkage_is_stopped(void **state) {
    (void)state;
    for (int i = QUALITIES; i < 3 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        def.detection = detections[i / QUALITIES];
        thud_world *world = make_world(def);
        add_floor(world, NULL);
        thud_body_id hub = add_ball(world, 0, 8, 0.5f);
        for (int k = 0; k < 6; k++) {
            double angle = k * PI / 3;
            thud_body_id box = add_box(world, 2 * cos(angle), 8 + 2 * sin(angle), 0.3f, 0.3f);
            thud_joint_def rod = between(THUD_JOINT_DISTANCE, hub, box, middle, middle);
            rod.length = 2;
            make(world, rod);
        }
        double gained = 0;
        for (int step = 0; step < 300; step++) {
            run(world, 1);
            gained += fmax(thud_step_error_of(world).energy_change, 0);
        }
        /* measured 0.03 to 1.3; 14 to 17 where all bodies continued to fall */
        assert_true(gained < 2);
        thud_world_destroy(world);
    }
}

/* The widest gap of a hinge within 300 steps, where ten boxes of 40 kg fall on a bridge of twenty
 * planks, `shift` to the right of its middle. */
static double widest_gap_of_loaded_bridge(thud_world_def def, double shift) {
    thud_world *world = make_world(def);
    thud_body_id last = add_body(world, THUD_BODY_STATIC, -10, 5, 0);
    for (int k = 0; k < 20; k++) {
        thud_body_id plank = add_box(world, k - 9.5, 5, 0.5f, 0.1f);
        make(world, between(THUD_JOINT_HINGE, last, plank, (thud_vec2){k ? 0.5f : 0, 0},
                            (thud_vec2){-0.5f, 0}));
        last = plank;
    }
    make(world, between(THUD_JOINT_HINGE, last, add_body(world, THUD_BODY_STATIC, 10, 5, 0),
                        (thud_vec2){0.5f, 0}, middle));
    for (int k = 0; k < 10; k++) {
        add_heavy(world, k - 4.5 + shift, 7 + 0.3 * k, 0.3f, 40 / (0.6f * 0.6f));
    }
    double worst = 0;
    for (int step = 0; step < 300; step++) {
        run(world, 1);
        worst = fmax(worst, thud_step_error_of(world).joint_gap_max);
        assert_in_range(thud_stats_of(world).held_bodies, 0, 30);
    }
    thud_world_destroy(world);
    return worst;
}

/* Contacts of jointed bodies are left to the solver: boxes fall on a bridge and stay on it, and its
 * hinges open no further than such impacts open them. Default is left out: there the bridge with
 * such boxes exceeds the direct solver's budget and tears under any detection; its hinges open by 4
 * to 7 m, and no box stays. How far they open depends on the last bits of where the boxes fall, so
 * that sixteen falls that differ by a millimetre each are judged together. */
static void load_tears_no_bridge_under_detection_on_the_way(void **state) {
    (void)state;
    enum { FALLS = 16 };
    for (int i = QUALITIES; i < 3 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        if (def.quality == &thud_quality_draft || def.quality == &thud_quality_default) {
            continue;
        }
        def.detection = detections[i / QUALITIES];
        def.sleeping = false;
        double sum = 0;
        for (int k = 0; k < FALLS; k++) {
            sum += widest_gap_of_loaded_bridge(def, k * 0.001);
        }
        /* measured 0.1 at exact, 0.2 at high, where single falls reach 0.44; 0.5 to 1.0 where
         * detection treated contacts as impacts */
        assert_true(sum / FALLS < 0.25);
    }
}

/* Two balls, tied to each other, reach a wall at 0.8 and at 0.4 of the step. Each is counted as
 * held once, and 0.6 of its step is lost, although `continuous` holds both at the first impact and
 * again at the second. (`bisect` does not see bodies that are beyond the wall at the end of the
 * step.) */
static void body_is_counted_once_however_often_it_is_held(void **state) {
    (void)state;
    for (int i = 0; i < 2 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        def.detection = i < QUALITIES ? &thud_detection_continuous : &thud_detection_swept;
        def.gravity = middle;
        thud_world *world = make_world(def);
        add_shape(world, add_body(world, THUD_BODY_STATIC, 10, 0, 0), 0.1f, 5, true, NULL);
        thud_body_id late = add_ball(world, 8.1, 0, 0.2f), soon = add_ball(world, 8.9, 1, 0.2f);
        make(world, between(THUD_JOINT_HINGE, late, soon, (thud_vec2){0.4f, 0.5f},
                            (thud_vec2){-0.4f, -0.5f}));
        OK(thud_body_set_velocity(world, late, (thud_vec2){120, 0}, 0));
        OK(thud_body_set_velocity(world, soon, (thud_vec2){120, 0}, 0));
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        assert_int_equal(stats.held_bodies, 2);
        near_to(stats.held_seconds, 1.2 * STEP, 0.02 * STEP);
        thud_world_destroy(world);
    }
}

/* Balls in a row. */
enum { LINKS = 120 };

/* Two rows of hinged balls fly at a wall, which the first ball of each row reaches in the step in
 * which a ball at the other end of a row, or a single ball created last, becomes NaN and is
 * quarantined. Its row is held without it, and the body that moved to its awake slot is held with
 * its own row. */
static void body_that_is_no_number_leaves_the_others_that_are_held(void **state) {
    (void)state;
    for (int i = 0; i < 3 * QUALITIES * 3; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        def.detection = detections[i / QUALITIES % 3];
        def.gravity = middle;
        def.log = NULL;
        thud_world *world = make_world(def);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 10, 0, 0), row[2][LINKS];
        add_shape(world, wall, 0.1f, 5, false, NULL);
        bool last_first = i / QUALITIES / 3 == 1;
        for (int n = 0; n < 2 * LINKS; n++) {
            int r = n / LINKS, k = last_first ? LINKS - 1 - n % LINKS : n % LINKS;
            thud_body_id ball = row[r][k] = add_ball(world, 9.65 - 0.5 * k, 3 * r, 0.2f);
            OK(thud_body_set_velocity(world, ball, (thud_vec2){9, 0}, 0));
        }
        thud_body_id loner = add_ball(world, 0, -4, 0.2f);
        OK(thud_body_set_velocity(world, loner, (thud_vec2){1, 0}, 0));
        for (int n = 0; n < 2 * LINKS; n++) {
            int r = n / LINKS, k = n % LINKS;
            if (k > 0) {
                make(world, between(THUD_JOINT_HINGE, row[r][k - 1], row[r][k],
                                    (thud_vec2){-0.25f, 0}, (thud_vec2){0.25f, 0}));
            }
        }
        thud_body_id doomed = i / QUALITIES / 3 == 2 ? loner : row[0][LINKS - 1];
        for (int twice = 0; twice < 2; twice++) { /* twice, so that the sum overflows float */
            OK(thud_body_apply_center_force(world, doomed, (thud_vec2){3e38f, 3e38f}));
        }
        run(world, 1);
        assert_true(state_of(world, doomed).quarantined);
        thud_stats stats = thud_stats_of(world);
        int gone = thud_events_of(world).quarantined_count;
        assert_in_range(stats.held_bodies, LINKS, 2 * LINKS - gone + 1);
        for (int k = 0; k < LINKS; k++) {
            assert_true(state_of(world, row[1][k]).position.x < 9.75 - 0.5 * k);
        }
        near_to(state_of(world, loner).position.x, doomed.index1 == loner.index1 ? 0 : STEP, 1e-6);
        run(world, 30);
        thud_world_destroy(world);
    }
}

enum { BARS = 6 };

/* Five light bars that swing from a hook, and a sixth that hangs from the fifth by a spring. */
static thud_world *swinging(const thud_quality *quality, const thud_detection *detection,
                            thud_body_id bar[BARS]) {
    thud_world_def def = def_of(quality);
    def.detection = detection;
    def.gravity = (thud_vec2){0, -10};
    thud_world *world = make_world(def);
    thud_body_id last = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    for (int i = 0; i < BARS; i++) {
        bool spring = i == BARS - 1;
        bar[i] = add_box(world, i + 0.5, 0, 0.5f, 0.05f);
        thud_joint_def joint =
            between(spring ? THUD_JOINT_DISTANCE : THUD_JOINT_HINGE, last, bar[i],
                    (thud_vec2){i ? 0.5f : 0, 0}, (thud_vec2){spring ? -0.4f : -0.5f, 0});
        if (spring) {
            joint.drive[THUD_DIRECTION_ALONG].frequency = 1;
            joint.drive[THUD_DIRECTION_ALONG].target = 0.1f;
        }
        make(world, joint);
        last = bar[i];
    }
    return world;
}

/* A quality as it is under `bisect` and `swept`: draft has an island solver and four substeps
 * there. */
static thud_quality in_order_of_time(const thud_quality *quality) {
    thud_quality q = *quality;
    if (!q.islands) {
        q.islands = &thud_islands_direct;
        q.substeps = 4;
    }
    return q;
}

/* Where no body is stopped, detections give the same motion as `overlap`. The velocity that joints
 * add in a step may be less than a sixteenth of that of gravity, and must not be neglected. */
static void detections_that_stop_nobody_leave_what_swings_alone(void **state) {
    (void)state;
    for (int i = 0; i < 3 * QUALITIES; i++) {
        thud_body_id bar[BARS], other[BARS];
        const thud_quality *quality = qualities[i % QUALITIES];
        const thud_detection *detection = detections[i / QUALITIES];
        thud_quality alike =
            detection == &thud_detection_continuous ? *quality : in_order_of_time(quality);
        thud_world *world = swinging(&alike, &thud_detection_overlap, bar);
        thud_world *twin = swinging(quality, detection, other);
        for (int step = 0; step < 40; step++) {
            run(world, 1);
            run(twin, 1);
            for (int k = 0; k < BARS; k++) {
                thud_body_state a = state_of(world, bar[k]), b = state_of(twin, other[k]);
                assert_memory_equal(&a.position, &b.position, sizeof a.position);
                assert_memory_equal(&a.velocity, &b.velocity, sizeof a.velocity);
            }
        }
        thud_world_destroy(world);
        thud_world_destroy(twin);
    }
}

/* An arm of length 2 is hinged at its end, and a motor without a maximum force turns it into a
 * block, which it meets at 0.17 rad. The motor stalls: the hinge stays closed and the arm outside
 * of the block. Under `overlap` the tip, which moves 0.3 a step, may be inside for some steps. */
static void motor_stalls_at_a_wall_and_its_hinge_stays_closed(void **state) {
    (void)state;
    for (int i = 0; i < 2 * 4 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        int detection = i / QUALITIES % 4;
        def.detection = detection < 3 ? detections[detection] : &thud_detection_overlap;
        def.sleeping = i / QUALITIES / 4;
        thud_world *world = make_world(def);
        thud_body_id arm = add_box(world, 1, 3, 1, 0.1f);
        add_shape(world, add_body(world, THUD_BODY_STATIC, 1.5, 3.6, 0), 0.2f, 0.2f, true, NULL);
        thud_joint_def hinge = between(THUD_JOINT_HINGE, add_body(world, THUD_BODY_STATIC, 0, 3, 0),
                                       arm, middle, (thud_vec2){-1, 0});
        hinge.drive[THUD_DIRECTION_TURN].motor_speed = 10;
        hinge.drive[THUD_DIRECTION_TURN].motor_force = THUD_JOINT_FORCE_MAX;
        thud_joint_id id = make(world, hinge);
        double widest = 0;
        for (int k = 0; k < 300; k++) {
            run(world, 1);
            widest = fmax(widest, joint_of(world, id).gap);
            assert_true(state_of(world, arm).angle < (detection < 3 ? 0.22 : 0.34));
        }
        /* reached at draft as the motor starts; 0.2 to 2.5 without yielding */
        assert_true(widest < 0.1);
        assert_true(joint_of(world, id).gap < 2e-3);
        assert_true(state_of(world, arm).angle < 0.18);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_stay_closed_where_a_body_is_stopped),
        cmocka_unit_test(springs_hold_nobody_back),
        cmocka_unit_test(energy_does_not_rise_where_a_linkage_is_stopped),
        cmocka_unit_test(load_tears_no_bridge_under_detection_on_the_way),
        cmocka_unit_test(body_is_counted_once_however_often_it_is_held),
        cmocka_unit_test(body_that_is_no_number_leaves_the_others_that_are_held),
        cmocka_unit_test(detections_that_stop_nobody_leave_what_swings_alone),
        cmocka_unit_test(motor_stalls_at_a_wall_and_its_hinge_stays_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
