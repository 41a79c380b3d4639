/* test_rest_against_box2d.c: compares where bodies come to rest in thud and in Box2D. Resting
 * contacts overlap a little in both; in Box2D by about its slop of 5 mm plus the compliance of its
 * soft contacts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "duel.h"

static const double SLOP = 0.005;

/* Each engine must be within the slop of the exact position, so that both differ by at most twice
 * the slop. */
static void rest_ball_on_floor_lies_at_its_radius(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    scene_dynamic_circle(&d.scene, 0, 1.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 180);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][1].y, 0.5, 2 * SLOP);
        assert_near(d.bodies[e][1].vy, 0, 0.01);
    }
    duel_end(&d);
}

/* Each contact below a box may overlap by twice the slop, so box i may be i + 1 times that lower;
 * no force acts sideways. */
static void rest_stack_of_five_boxes_stands_at_equal_heights(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    for (int i = 0; i < 5; i++)
        scene_dynamic_box(&d.scene, 0, i + 0.5, 0.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 300);
    for (int i = 0; i < 5; i++) {
        for (int e = 0; e < ENGINES; e++) {
            assert_near(d.bodies[e][i + 1].y, i + 0.5, 2 * SLOP * (i + 1));
            assert_near(d.bodies[e][i + 1].x, 0, 0.01);
            assert_near(d.bodies[e][i + 1].sine, 0, 0.01);
        }
        assert_near(d.bodies[THUD][i + 1].y, d.bodies[BOX2D][i + 1].y, 2 * SLOP * (i + 1));
    }
    duel_end(&d);
}

/* Box2D's column of 30 boxes sinks by 0.31 m. thud may be stiffer, not softer; the tolerance of 5
 * cm is a third of the slop for each of 30 contacts. */
static void rest_column_of_thirty_sinks_no_more_than_box2d(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    for (int i = 0; i < 30; i++)
        scene_dynamic_box(&d.scene, 0, i + 0.5, 0.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 300);
    assert_true(d.bodies[THUD][30].y > d.bodies[BOX2D][30].y - 0.05);
    assert_true(d.bodies[THUD][30].y < 29.5 + 0.01);
    duel_end(&d);
}

/* In a right-angled valley the centre is one radius from both sides, that is, radius * sqrt(2)
 * above the vertex. The slop acts along both normals, so it is multiplied by sqrt(2) too. */
static void rest_ball_in_valley_of_terrain_touches_both_sides(void **state) {
    (void)state;
    static const scene_point valley[] = {{-5, 5}, {0, 0}, {5, 5}};
    static const double heights[] = {10, 5, 0, 5, 10};
    for (int uniform = 0; uniform < 2; uniform++) {
        duel d;
        duel_init(&d);
        scene_add_body(&d.scene, SCENE_STATIC, 0, 0);
        if (uniform)
            scene_add_uniform(&d.scene, -10, 5, heights, 5);
        else
            scene_add_irregular(&d.scene, valley, 3);
        scene_dynamic_circle(&d.scene, 0.3, 1.5, 0.5);
        duel_begin(&d);
        duel_step(&d, 600);
        for (int e = 0; e < ENGINES; e++) {
            assert_near(d.bodies[e][1].x, 0, 2 * SLOP * sqrt(2));
            assert_near(d.bodies[e][1].y, 0.5 * sqrt(2), 2 * SLOP * sqrt(2));
        }
        duel_end(&d);
    }
}

/* A fifth of the box is supported, and its centre is beyond the edge: only the locked rotation
 * keeps it in place. It must neither turn nor fall; Box2D's creeps by 1.3 cm when it lands. */
static void rest_fixed_rotation_box_on_edge_stays_upright(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 1, 1);
    scene_add_body(&d.scene, SCENE_DYNAMIC, 1.3, 0.6);
    scene_add_aabb(&d.scene, 0.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 180);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][1].y, 0.5, 2 * SLOP);
        assert_near(d.bodies[e][1].x, 1.3, 0.03);
        assert_near(d.bodies[e][1].sine, 0, 1e-6);
    }
    duel_end(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rest_ball_on_floor_lies_at_its_radius),
        cmocka_unit_test(rest_stack_of_five_boxes_stands_at_equal_heights),
        cmocka_unit_test(rest_column_of_thirty_sinks_no_more_than_box2d),
        cmocka_unit_test(rest_ball_in_valley_of_terrain_touches_both_sides),
        cmocka_unit_test(rest_fixed_rotation_box_on_edge_stays_upright),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
