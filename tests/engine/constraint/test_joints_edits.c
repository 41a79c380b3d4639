/* test_joints_edits.c: joints together with the rest of a world: collisions of joined bodies, edits
 * of joints and bodies, snapshots, wrong input, redundant locks, drawing; and random linkages of
 * all kinds of joints. */
#include "driven.h"
#include "joint_support.h"
#include "snapshot_support.h"

#include "state/world.h"

#include <thud/thud_testing.h>

static const thud_vec2 middle = {0, 0};

/* ---- collisions and edits ---- */

/* A joint switches the collision of its bodies off, with an end event, and destroying it switches
 * it on again, unless collide_connected is set. */
static void joined_bodies_do_not_meet_unless_they_shall(void **state) {
    (void)state;
    for (int meets = 0; meets < 2; meets++) {
        thud_world *world = world_at(&thud_quality_default);
        thud_body_id a = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                     b = add_box(world, 0.6, 0, 0.5f, 0.5f);
        add_shape(world, a, 0.5f, 0.5f, false, NULL);
        run(world, 1);
        assert_int_equal(thud_stats_of(world).contacts, 1);
        thud_joint_def def = between(THUD_JOINT_HINGE, a, b, middle, (thud_vec2){-0.6f, 0});
        def.collide_connected = meets;
        thud_joint_id hinge = make(world, def);
        run(world, 1);
        assert_int_equal(thud_stats_of(world).contacts, meets);
        assert_int_equal(thud_events_of(world).end_count, !meets);
        run(world, 5);
        assert_int_equal(thud_stats_of(world).contacts, meets);
        OK(thud_joint_destroy(world, hinge));
        run(world, 1);
        assert_int_equal(thud_stats_of(world).contacts, 1);
        assert_int_equal(thud_events_of(world).begin_count, !meets);
        assert_false(thud_joint_is_valid(world, hinge));
        assert_int_equal(thud_joint_destroy(world, hinge), THUD_ERROR_STALE);
        thud_world_destroy(world);
    }
}

/* A disabled joint does not act, and closes again when it is enabled. */
static void joint_lets_go_while_it_is_disabled(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 0, -1, 0.1f);
    thud_joint_id hinge =
        make(world, between(THUD_JOINT_HINGE, hook, ball, middle, (thud_vec2){0, 1}));
    run(world, 30);
    near_to(state_of(world, ball).position.y, -1, 1e-3);
    OK(thud_joint_set_enabled(world, hinge, false));
    run(world, 6);
    assert_true(state_of(world, ball).position.y < -1.03);
    assert_false(joint_of(world, hinge).enabled);
    OK(thud_joint_set_enabled(world, hinge, true));
    run(world, 120);
    near_to(joint_of(world, hinge).gap, 0, 2e-2);
    thud_world_destroy(world);
}

/* Makes edit number `which` of those that a joint has to follow: its length, either frame, its
 * drive, or its body's centre of mass. */
static void edit(thud_world *world, thud_body_id body, thud_joint_id joint, int which) {
    thud_drive spring = {.frequency = 5, .damping = 1, .target = 1, .spring_force = 1e6f};
    thud_shape_def shape = thud_default_shape_def();
    switch (which) {
    case 0:
        OK(thud_joint_set_length(world, joint, 2));
        break;
    case 1:
    case 2:
        OK(thud_joint_set_frame(world, joint, which - 1, (thud_joint_frame){{0.3f, 0.8f}, 0}));
        break;
    case 3:
        OK(thud_joint_set_drive(world, joint, THUD_DIRECTION_ALONG, &spring));
        break;
    default:
        OK(thud_shape_create_circle(world, body, &shape, (thud_vec2){1, 0}, 0.3f, NULL));
    }
}

/* The joint stays closed after each edit, with its body awake or asleep. */
static void joints_follow_every_edit_awake_and_asleep(void **state) {
    (void)state;
    for (int i = 0; i < 10; i++) {
        int which = i / 2;
        bool asleep = i % 2;
        thud_joint_kind kind = which == 0   ? THUD_JOINT_DISTANCE
                               : which == 3 ? THUD_JOINT_SLIDER
                                            : THUD_JOINT_HINGE;
        thud_world_def def = def_of(&thud_quality_default);
        def.sleeping = asleep;
        thud_world *world = make_world(def);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id ball = add_ball(world, 0, which == 3 ? 0 : -1, 0.1f);
        thud_joint_def joint =
            between(kind, hook, ball, middle, (thud_vec2){0, kind == THUD_JOINT_HINGE ? 1 : 0});
        joint.drive[THUD_DIRECTION_ALONG].motor_force = which == 3 ? 10 : 0;
        thud_joint_id id = make(world, joint);
        run(world, asleep ? 200 : 10);
        assert_int_equal(thud_stats_of(world).awake_bodies, !asleep);
        edit(world, ball, id, which);
        run(world, 240);
        near_to(joint_of(world, id).gap, 0, 1e-2);
        if (which == 3) {
            near_to(joint_of(world, id).value[THUD_DIRECTION_ALONG], 1, 1e-2);
        }
        thud_world_destroy(world);
    }
}

/* ---- everything at once ---- */

/* Random trees and loops of all kinds of joints above a floor. */
static thud_world *linkage(thud_world_def def, uint64_t seed) {
    enum { BODIES = 14 };
    thud_world *world = make_world(def);
    thud_body_id body[BODIES];
    add_floor(world, NULL);
    body[0] = add_body(world, THUD_BODY_STATIC, 0, 6, 0);
    for (int i = 1; i < BODIES; i++) {
        body[i] = add_box(world, random_in(&seed, -4, 4), random_in(&seed, 1, 8),
                          (float)random_in(&seed, 0.1, 0.5), (float)random_in(&seed, 0.1, 0.5));
        for (int n = 0; n < (i % 4 ? 1 : 2); n++) {
            int other = (int)random_in(&seed, 0, i - 1e-9);
            bool turned = random_in(&seed, 0, 1) < 0.5;
            thud_joint_kind kind = (thud_joint_kind)random_in(&seed, 0, THUD_JOINT_GEAR - 1e-9);
            bool as_b = kind == THUD_JOINT_WHEEL || kind == THUD_JOINT_TARGET || !turned;
            thud_vec2 at = {(float)random_in(&seed, -1, 1), (float)random_in(&seed, -1, 1)};
            thud_joint_def j = as_b ? between(kind, body[other], body[i], at, middle)
                                    : between(kind, body[i], body[other], middle, at);
            j.length = (float)random_in(&seed, 0.5, 3);
            for (int k = 0; k < THUD_DIRECTION_COUNT; k++) {
                thud_drive *d = &j.drive[k];
                d->limited = random_in(&seed, 0, 1) < 0.3;
                d->lower = kind == THUD_JOINT_DISTANCE ? 0.5f : -1.0f;
                d->upper = random_in(&seed, 0, 1) < 0.1 ? d->lower : 1.5f;
                d->frequency = random_in(&seed, 0, 1) < 0.3 ? (float)random_in(&seed, 1, 20) : 0;
                d->target = kind == THUD_JOINT_DISTANCE ? 1.0f : 0.2f;
                d->motor_speed = 1;
                d->motor_force = random_in(&seed, 0, 1) < 0.2 ? 10.0f : 0.0f;
                if (!is_driven(kind, k)) {
                    *d = (thud_drive){0};
                }
            }
            j.collide_connected = random_in(&seed, 0, 1) < 0.3;
            make(world, j);
        }
    }
    return world;
}

/* Asserts that no body is quarantined and the kinetic energy is bounded. */
static void check_finite(const thud_world *world) {
    assert_int_equal(thud_events_of(world).quarantined_count, 0);
    thud_measure m = thud_measure_of(world);
    assert_true(isfinite(m.kinetic_energy) && m.kinetic_energy < 1e6);
}

static void random_linkages_stay_finite_and_restore_to_the_same_bits(void **state) {
    (void)state;
    const thud_detection *const detections[] = {NULL, &thud_detection_overlap,
                                                &thud_detection_swept, &thud_detection_bisect};
    for (int i = 0; i < 4 * QUALITIES; i++) {
        thud_world_def def = def_of(qualities[i % QUALITIES]);
        def.detection = detections[i / QUALITIES];
        uint64_t seed = 0x9e3779b97f4a7c15u + (uint64_t)i;
        thud_world *world = linkage(def, seed);
        thud_world_def_set_baseline_simd(&def, true);
        thud_world *twin = linkage(def, seed);
        for (int k = 0; k < 90; k++) {
            run(world, 1);
            run(twin, 1);
            check_finite(world);
        }
        assert_true(thud_hash_of(world) == thud_hash_of(twin));
        saved then = save(world);
        run(world, 60);
        back_to(twin, then);
        run(twin, 60);
        assert_true(digest_of(world) == digest_of(twin));
        free(then.bytes);
        thud_world_destroy(twin);
        thud_world_destroy(world);
    }
}

/* With either body as body a: where body b is static, the engine keeps the two swapped. */
static void def_of_a_joint_is_read_as_it_was_set(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 box = add_box(world, 1, 0, 1, 1);
    for (int i = 0; i < 2; i++) {
        thud_joint_def def =
            between(THUD_JOINT_SLIDER, i ? box : wall, i ? wall : box, middle, middle);
        def.frame_a = (thud_joint_frame){{0.25f, 0.5f}, 0.75};
        def.frame_b.position = (thud_vec2){-0.5f, 1};
        def.drive[THUD_DIRECTION_ALONG] = (thud_drive){true, -1, 2, 3, 0.5f, 0.25f, 4, 5, 6};
        def.collide_connected = def.only_reports = true;
        def.enabled = false;
        def.break_force = 7;
        def.break_torque = 8;
        def.user_data = 9;
        thud_joint_id joint = make(world, def);
        thud_joint_def read;
        memset(&read, -1, sizeof read);
        OK(thud_joint_get_def(world, joint, &read));
        assert_int_equal(read.kind, THUD_JOINT_SLIDER);
        assert_int_equal(read.body_a.index1, def.body_a.index1);
        assert_int_equal(read.body_b.index1, def.body_b.index1);
        near_to(read.frame_a.angle, 0.75, 1e-8);
        assert_memory_equal(&read.frame_a.position, &def.frame_a.position, sizeof(thud_vec2));
        assert_memory_equal(&read.frame_b, &def.frame_b, sizeof def.frame_b);
        assert_memory_equal(&read.drive[0].lower, &def.drive[0].lower, 8 * sizeof(float));
        assert_true(read.drive[0].limited && !read.drive[THUD_DIRECTION_TURN].limited);
        assert_true(read.collide_connected && read.only_reports && !read.enabled);
        assert_true(read.break_force == 7 && read.break_torque == 8 && read.user_data == 9);
        OK(thud_joint_destroy(world, joint));
        assert_int_equal(thud_joint_get_def(world, joint, &read), THUD_ERROR_STALE);
    }
    thud_joint_id rod = make(world, between(THUD_JOINT_DISTANCE, wall, box, middle, middle));
    OK(thud_joint_set_length(world, rod, 3));
    thud_joint_def read;
    OK(thud_joint_get_def(world, rod, &read));
    assert_true(read.length == 3);
    assert_int_equal(thud_joint_get_def(world, rod, NULL), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

/* A load is an impulse divided by the time step, which would overflow here. */
static void load_is_finite_after_a_time_step_next_to_nothing(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 0, -1, 0.1f);
    thud_joint_id hinge =
        make(world, between(THUD_JOINT_HINGE, hook, ball, middle, (thud_vec2){0, 1}));
    run(world, 10);
    OK(thud_world_set_time_step(world, 5e-324));
    run(world, 1);
    thud_joint_state joint = joint_of(world, hinge);
    assert_true(isfinite(joint.force.x) && isfinite(joint.force.y) && isfinite(joint.torque));
    thud_world_destroy(world);
}

/* Handles after a restore do not depend on what was made and destroyed in between. */
static void joints_made_after_going_back_have_the_handles_of_the_first_time(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 box = add_box(world, 1, 0, 1, 1);
    OK(thud_world_use_joints(world));
    saved then = save(world);
    thud_joint_def def = between(THUD_JOINT_HINGE, wall, box, middle, middle);
    thud_joint_id first = make(world, def);
    OK(thud_joint_destroy(world, first));
    make(world, def);
    back_to(world, then);
    thud_joint_id again = make(world, def);
    assert_memory_equal(&again, &first, sizeof first);
    free(then.bytes);
    thud_world_destroy(world);
}

static void wrong_joints_are_refused(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0),
                 box = add_box(world, 1, 0, 1, 1);
    thud_joint_def good = between(THUD_JOINT_HINGE, wall, box, middle, middle), wrong[9];
    for (int i = 0; i < 9; i++) {
        wrong[i] = good;
    }
    wrong[0].kind = THUD_JOINT_KIND_COUNT;
    wrong[1].body_a = box;
    wrong[2].frame_a.position.x = NAN;
    wrong[3].frame_b.angle = INFINITY;
    wrong[4].drive[THUD_DIRECTION_TURN].frequency = -1;
    wrong[5].drive[THUD_DIRECTION_TURN] = (thud_drive){.limited = true, .lower = 1, .upper = -1};
    wrong[6].drive[THUD_DIRECTION_TURN].motor_force = NAN;
    wrong[7] = between(THUD_JOINT_WHEEL, box, wall, middle, middle);
    wrong[8] = between(THUD_JOINT_DISTANCE, wall, box, middle, middle);
    wrong[8].length = 0;
    for (int i = 0; i < 9; i++) {
        assert_int_equal(thud_joint_create(world, &wrong[i], NULL), THUD_ERROR_INVALID);
    }
    assert_int_equal(world->constraints.live + world->joints.live, 0);
    thud_joint_id hinge = make(world, good);
    assert_int_equal(thud_joint_set_drive(world, hinge, THUD_DIRECTION_ALONG, &good.drive[0]),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_joint_set_drive(world, hinge, THUD_DIRECTION_TURN, NULL),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_joint_set_length(world, hinge, 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_joint_get_state(world, hinge, NULL), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

/* ---- loops ---- */

/* A node is joined by four bars to walls. More directions are locked than it has, and lengths in
 * single precision fit only to rounding: no joint may report a force from that. */
static void loop_with_more_locks_than_it_needs_is_not_strained(void **state) {
    (void)state;
    static const double ends[][2] = {{-2, 0}, {2, 0}, {-2, -2.1}, {2.3, -1.7}};
    for (int q = 0; q < QUALITIES; q++) {
        thud_world *world = world_at(qualities[q]);
        thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id node = add_ball(world, 0, 0, 0.16f);
        thud_joint_id pins[8];
        double mass = state_of(world, node).mass;
        for (int i = 0; i < 4; i++) {
            double x = ends[i][0], y = ends[i][1], length = hypot(x, y);
            thud_body_id bar = add_body(world, THUD_BODY_DYNAMIC, x / 2, y / 2, atan2(y, x));
            thud_shape_def light = thud_default_shape_def();
            light.density = 0.2f;
            light.filter.mask = 0;
            add_shape(world, bar, (float)(length / 2), 0.11f, false, &light);
            mass += state_of(world, bar).mass;
            thud_vec2 half = {(float)(length / 2), 0};
            pins[2 * i] =
                make(world, between(THUD_JOINT_HINGE, node, bar, middle, (thud_vec2){-half.x, 0}));
            pins[2 * i + 1] = make(world, between(THUD_JOINT_HINGE, wall, bar,
                                                  (thud_vec2){(float)x, (float)y}, half));
        }
        for (int step = 0; step < 60; step++) {
            run(world, 1);
            for (int i = 0; i < 8; i++) {
                thud_vec2 force = joint_of(world, pins[i]).force;
                assert_true(hypot((double)force.x, (double)force.y) < 2 * 10 * mass);
            }
        }
        thud_world_destroy(world);
    }
}

/* ---- drawing ---- */

typedef struct drawn {
    int lines[THUD_STYLE_COUNT], points[THUD_STYLE_COUNT];
    double length[THUD_STYLE_COUNT];
} drawn;

static void count_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    drawn *d = context;
    d->lines[style]++;
    d->length[style] += hypot((double)(b.x - a.x), (double)(b.y - a.y));
}

static void count_point(thud_vec2 p, thud_style style, void *context) {
    (void)p;
    ((drawn *)context)->points[style]++;
}

static void joints_are_drawn_with_their_places_limits_and_forces(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_exact);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 0, -2, 0.5f);
    thud_joint_def def = between(THUD_JOINT_HINGE, hook, ball, middle, (thud_vec2){0, 2});
    def.drive[THUD_DIRECTION_TURN].limited = true;
    def.drive[THUD_DIRECTION_TURN].lower = -1;
    def.drive[THUD_DIRECTION_TURN].upper = 1;
    make(world, def);
    run(world, 60);
    drawn d = {0};
    thud_debug_draw draw = {.flags = THUD_DRAW_JOINTS | THUD_DRAW_JOINT_FORCES,
                            .lower = {-5, -5},
                            .upper = {5, 5},
                            .context = &d,
                            .line = count_line,
                            .point = count_point};
    OK(thud_world_draw(world, &draw));
    assert_int_equal(d.points[THUD_STYLE_JOINT], 2);
    assert_int_equal(d.lines[THUD_STYLE_JOINT_AXIS], 1);
    assert_int_equal(d.lines[THUD_STYLE_JOINT_LIMIT], 2);
    assert_int_equal(d.lines[THUD_STYLE_JOINT_FORCE], 1);
    near_to(d.length[THUD_STYLE_JOINT], 2, 1e-3);
    /* the length drawn for its weight: the impulse of one second */
    near_to(d.length[THUD_STYLE_JOINT_FORCE], 0.5 * 10, 1e-2);
    assert_int_equal(d.lines[THUD_STYLE_STATIC], 0);
    draw.flags = THUD_DRAW_SHAPES;
    drawn without = d;
    OK(thud_world_draw(world, &draw));
    assert_memory_equal(&d, &without, sizeof d);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joined_bodies_do_not_meet_unless_they_shall),
        cmocka_unit_test(joint_lets_go_while_it_is_disabled),
        cmocka_unit_test(joints_follow_every_edit_awake_and_asleep),
        cmocka_unit_test(random_linkages_stay_finite_and_restore_to_the_same_bits),
        cmocka_unit_test(def_of_a_joint_is_read_as_it_was_set),
        cmocka_unit_test(load_is_finite_after_a_time_step_next_to_nothing),
        cmocka_unit_test(joints_made_after_going_back_have_the_handles_of_the_first_time),
        cmocka_unit_test(loop_with_more_locks_than_it_needs_is_not_strained),
        cmocka_unit_test(wrong_joints_are_refused),
        cmocka_unit_test(joints_are_drawn_with_their_places_limits_and_forces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
