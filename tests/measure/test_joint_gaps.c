/* test_joint_gaps.c: tests the measured gaps of joints whose bodies are displaced by known amounts.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "joint_gaps.h"

#include <math.h>

static const double PI_2 = 1.5707963267948966;

static void assert_near(double actual, double expected) {
    if (!(fabs(actual - expected) <= 1e-12))
        fail_msg("%.12g is not %.12g", actual, expected);
}

/* A static box, and a dynamic one beside it, both at angle 0, with a joint at a point between them.
 */
typedef struct pair {
    scene scene;
    engine_body bodies[2];
    scene_joint *joint;
} pair;

static void tie(pair *p, scene_joint_kind kind, double angle) {
    scene_init(&p->scene);
    scene_static_box(&p->scene, 0, 0, 0.5, 0.5);
    scene_dynamic_box(&p->scene, 2, 0, 0.5, 0.5);
    p->joint = scene_tie(&p->scene, kind, 0, 1, 1, 0, angle);
    p->bodies[0] = (engine_body){.cosine = 1};
    p->bodies[1] = (engine_body){.x = 2, .cosine = 1};
}

static joint_gap gap(pair *p) {
    return joint_gap_of(&p->scene, 0, p->bodies);
}

/* Sets the body's angle about its own position. */
static void turn(engine_body *b, double angle) {
    b->cosine = cos(angle), b->sine = sin(angle);
}

static void hinge_is_open_by_the_distance_of_its_points(void **state) {
    (void)state;
    pair p;
    tie(&p, SCENE_HINGE, 0.4);
    assert_near(gap(&p).length, 0);
    p.bodies[1].x += 0.03;
    p.bodies[1].y -= 0.04;
    assert_near(gap(&p).length, 0.05);
    p.bodies[1].x = 1, p.bodies[1].y = 1;
    turn(&p.bodies[1], PI_2);
    assert_near(gap(&p).length, 0);
    assert_near(gap(&p).angle, 0);
    p.joint->drive[SCENE_TURN] = (scene_drive){.limited = true, .lower = -1, .upper = 1};
    assert_near(gap(&p).beyond_angle, PI_2 - 1);
    scene_free(&p.scene);
}

static void slider_is_open_across_its_axis_and_by_its_turn(void **state) {
    (void)state;
    pair p;
    tie(&p, SCENE_SLIDER, PI_2); /* pointing up */
    p.joint->drive[SCENE_ALONG] = (scene_drive){.limited = true, .lower = 0, .upper = 0.5};
    p.bodies[1].y += 0.75;
    assert_near(gap(&p).length, 0);
    assert_near(gap(&p).beyond, 0.25);
    p.bodies[1].x += 0.125;
    assert_near(gap(&p).length, 0.125);
    scene_free(&p.scene);
    tie(&p, SCENE_SLIDER, 0);
    turn(&p.bodies[1], -0.25);
    assert_near(gap(&p).angle, 0.25);
    assert_near(gap(&p).length, sin(0.25));
    scene_free(&p.scene);
}

static void weld_is_open_where_it_has_no_spring(void **state) {
    (void)state;
    pair p;
    tie(&p, SCENE_WELD, 0);
    p.bodies[1].x = 2.3, p.bodies[1].y = 0.4;
    assert_near(gap(&p).length, 0.5);
    turn(&p.bodies[0], 3);
    turn(&p.bodies[1], -3);
    assert_near(gap(&p).angle, 4 * PI_2 - 6);
    p.joint->drive[SCENE_ALONG].frequency = p.joint->drive[SCENE_ACROSS].frequency = 2;
    p.joint->drive[SCENE_TURN].frequency = 2;
    assert_near(gap(&p).length, 0);
    assert_near(gap(&p).angle, 0);
    scene_free(&p.scene);
}

static void rod_is_off_its_length_and_rope_only_beyond_it(void **state) {
    (void)state;
    pair p;
    tie(&p, SCENE_WHEEL, 0);
    p.joint = scene_tie_distance(&p.scene, 0, 1, 0, 0, 2, 0);
    p.bodies[1].x = 2.5;
    assert_near(joint_gap_of(&p.scene, 1, p.bodies).length, 0.5);
    p.joint->drive[SCENE_ALONG] = (scene_drive){.limited = true, .lower = 0, .upper = 2.25};
    assert_near(joint_gap_of(&p.scene, 1, p.bodies).length, 0);
    assert_near(joint_gap_of(&p.scene, 1, p.bodies).beyond, 0.25);
    p.bodies[1].x = 1;
    assert_near(joint_gap_of(&p.scene, 1, p.bodies).beyond, 0);
    scene_free(&p.scene);
}

static void samples_keep_the_worst_and_the_sum_and_count_what_is_lost(void **state) {
    (void)state;
    pair p;
    tie(&p, SCENE_HINGE, 0);
    joint_gaps seen = {0};
    p.bodies[1].y = 0.25;
    joint_gaps_sample(&p.scene, p.bodies, &seen);
    p.bodies[1].y = 0.125;
    joint_gaps_sample(&p.scene, p.bodies, &seen);
    assert_near(seen.worst.length, 0.25);
    assert_near(seen.sum, 0.375);
    assert_int_equal(seen.joints, 2);
    p.bodies[1].y = NAN;
    joint_gaps_sample(&p.scene, p.bodies, &seen);
    assert_int_equal(seen.lost, 1);
    assert_true(isinf(joint_gaps_sum(&p.scene, p.bodies)));
    scene_free(&p.scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hinge_is_open_by_the_distance_of_its_points),
        cmocka_unit_test(slider_is_open_across_its_axis_and_by_its_turn),
        cmocka_unit_test(weld_is_open_where_it_has_no_spring),
        cmocka_unit_test(rod_is_off_its_length_and_rope_only_beyond_it),
        cmocka_unit_test(samples_keep_the_worst_and_the_sum_and_count_what_is_lost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
