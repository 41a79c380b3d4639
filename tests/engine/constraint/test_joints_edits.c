/* test_joints_edits.c: what joints meet: shapes that touch, edits, snapshots, input that is wrong;
 * and random linkages of all kinds. */
#include "joint_support.h"
#include "snapshot_support.h"

#include "state/world.h"

static const thud_vec2 middle = {0, 0};

/* ---- the graph ---- */

static void joined_bodies_do_not_meet_unless_they_shall(void **state) {
    (void)state;
    for (int meets = 0; meets < 2; meets++) {
        thud_world *world = world_at(&thud_quality_default);
        thud_body_id a = add_body(world, THUD_STATIC, 0, 0, 0),
                     b = add_box(world, 0.6, 0, 0.5f, 0.5f);
        add_shape(world, a, 0.5f, 0.5f, false, NULL);
        run(world, 1);
        assert_int_equal(thud_world_stats(world).contacts, 1);
        thud_joint_def def = between(THUD_HINGE, a, b, middle, (thud_vec2){-0.6f, 0});
        def.collide_connected = meets;
        thud_joint_id hinge = make(world, def);
        run(world, 1);
        assert_int_equal(thud_world_stats(world).contacts, meets);
        assert_int_equal(thud_world_events(world).end_count, !meets);
        run(world, 5);
        assert_int_equal(thud_world_stats(world).contacts, meets);
        OK(thud_joint_destroy(world, hinge));
        run(world, 1);
        assert_int_equal(thud_world_stats(world).contacts, 1);
        assert_int_equal(thud_world_events(world).begin_count, !meets);
        assert_false(thud_joint_is_valid(world, hinge));
        assert_int_equal(thud_joint_destroy(world, hinge), THUD_ERROR_STALE);
        thud_world_destroy(world);
    }
}

static void joint_lets_go_while_it_is_disabled(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id hook = add_body(world, THUD_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 0, -1, 0.1f);
    thud_joint_id hinge = make(world, between(THUD_HINGE, hook, ball, middle, (thud_vec2){0, 1}));
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

/* ---- everything at once ---- */

/* Random trees and loops of all kinds, over a floor. */
static thud_world *linkage(thud_world_def def, uint64_t seed) {
    enum { BODIES = 14 };
    thud_world *world = make_world(def);
    thud_body_id body[BODIES];
    add_floor(world, NULL);
    body[0] = add_body(world, THUD_STATIC, 0, 6, 0);
    for (int i = 1; i < BODIES; i++) {
        body[i] = add_box(world, random_in(&seed, -4, 4), random_in(&seed, 1, 8),
                          (float)random_in(&seed, 0.1, 0.5), (float)random_in(&seed, 0.1, 0.5));
        for (int n = 0; n < (i % 4 ? 1 : 2); n++) {
            int other = (int)random_in(&seed, 0, i - 1e-9);
            bool turned = random_in(&seed, 0, 1) < 0.5;
            thud_joint_kind kind =
                (thud_joint_kind)random_in(&seed, 0, THUD_JOINT_KIND_COUNT - 1e-9);
            bool as_b = kind == THUD_WHEEL || kind == THUD_TARGET || !turned;
            thud_vec2 at = {(float)random_in(&seed, -1, 1), (float)random_in(&seed, -1, 1)};
            thud_joint_def j = as_b ? between(kind, body[other], body[i], at, middle)
                                    : between(kind, body[i], body[other], middle, at);
            j.length = (float)random_in(&seed, 0.5, 3);
            for (int k = 0; k < THUD_DIRECTION_COUNT; k++) {
                thud_drive *d = &j.drive[k];
                d->limited = random_in(&seed, 0, 1) < 0.3;
                d->lower = kind == THUD_DISTANCE ? 0.5f : -1.0f;
                d->upper = random_in(&seed, 0, 1) < 0.1 ? d->lower : 1.5f;
                d->frequency = random_in(&seed, 0, 1) < 0.3 ? (float)random_in(&seed, 1, 20) : 0;
                d->target = kind == THUD_DISTANCE ? 1.0f : 0.2f;
                d->motor_speed = 1;
                d->motor_force = random_in(&seed, 0, 1) < 0.2 ? 10.0f : 0.0f;
            }
            j.collide_connected = random_in(&seed, 0, 1) < 0.3;
            make(world, j);
        }
    }
    return world;
}

static void check_finite(const thud_world *world) {
    assert_int_equal(thud_world_events(world).quarantined_count, 0);
    thud_measure m = thud_world_measure(world);
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
        def.baseline_simd = true;
        thud_world *twin = linkage(def, seed);
        for (int k = 0; k < 90; k++) {
            run(world, 1);
            run(twin, 1);
            check_finite(world);
        }
        assert_true(thud_world_hash(world) == thud_world_hash(twin));
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

static void wrong_joints_are_refused(void **state) {
    (void)state;
    thud_world *world = world_at(&thud_quality_default);
    thud_body_id wall = add_body(world, THUD_STATIC, 0, 0, 0), box = add_box(world, 1, 0, 1, 1);
    thud_joint_def good = between(THUD_HINGE, wall, box, middle, middle), wrong[9];
    for (int i = 0; i < 9; i++) {
        wrong[i] = good;
    }
    wrong[0].kind = THUD_JOINT_KIND_COUNT;
    wrong[1].body_a = box;
    wrong[2].frame_a.position.x = NAN;
    wrong[3].frame_b.angle = INFINITY;
    wrong[4].drive[THUD_TURN].frequency = -1;
    wrong[5].drive[THUD_TURN] = (thud_drive){.limited = true, .lower = 1, .upper = -1};
    wrong[6].drive[THUD_TURN].motor_force = NAN;
    wrong[7] = between(THUD_WHEEL, box, wall, middle, middle);
    wrong[8] = between(THUD_DISTANCE, wall, box, middle, middle);
    wrong[8].length = 0;
    for (int i = 0; i < 9; i++) {
        assert_int_equal(thud_joint_create(world, &wrong[i], NULL), THUD_ERROR_INVALID);
    }
    assert_int_equal(world->constraints.live + world->joints.live, 0);
    thud_joint_id hinge = make(world, good);
    assert_int_equal(thud_joint_set_drive(world, hinge, THUD_ALONG, &good.drive[0]),
                     THUD_ERROR_INVALID);
    assert_int_equal(thud_joint_set_drive(world, hinge, THUD_TURN, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_joint_set_length(world, hinge, 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_joint_get(world, hinge, NULL), THUD_ERROR_NULL);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joined_bodies_do_not_meet_unless_they_shall),
        cmocka_unit_test(joint_lets_go_while_it_is_disabled),
        cmocka_unit_test(random_linkages_stay_finite_and_restore_to_the_same_bits),
        cmocka_unit_test(wrong_joints_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
