/* test_motion_against_box2d.c: compares motions in thud and Box2D with formulas and with each
 * other: free flight, friction, rolling, bounces, masses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "duel.h"

static const double G = 10;

/* Semi-implicit Euler at 1/240 s falls g * h * t / 2 = 0.021 m too far in one second, and exact
 * integration does not; the bound of 0.025 m allows both. */
static void motion_projectile_follows_the_parabola(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_body *ball = scene_dynamic_circle(&d.scene, 0, 0, 0.5);
    ball->vx = 3;
    ball->vy = 4;
    duel_begin(&d);
    duel_step(&d, 60);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][0].x, 3, 1e-3);
        assert_near(d.bodies[e][0].y, 4 - G / 2, 0.025);
        assert_near(d.bodies[e][0].vy, 4 - G, 1e-3);
    }
    duel_end(&d);
}

/* Deceleration mu * g with mu = 0.5 from 6 m/s: the distance is 36 / 10 = 3.6 m. The motion in a
 * substep, and the landing, are 2 %. */
static void motion_box_sliding_on_level_ground_stops_after_known_way(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    d.scene.material.friction = 0.5;
    scene_static_box(&d.scene, 0, -1, 20, 1);
    scene_add_body(&d.scene, SCENE_DYNAMIC, 0, 0.5)->vx = 6;
    scene_add_aabb(&d.scene, 0.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 150);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][1].x, 3.6, 0.02 * 3.6);
        assert_near(d.bodies[e][1].vx, 0, 1e-3);
    }
    duel_end(&d);
}

/* A flat line of slope -0.5 with a body that begins in contact. Gravity along it is g *
 * sin(atan(0.5)), across it g * cos(atan(0.5)). */
static void begin_on_slope(duel *d, bool disc, double friction) {
    const double c = 2 / sqrt(5), s = -1 / sqrt(5);
    duel_init(d);
    d->scene.material.friction = friction;
    scene_add_body(&d->scene, SCENE_STATIC, 0, 0);
    scene_add_flat(&d->scene, -0.5);
    double x = -s * 0.5, y = c * 0.5;
    if (disc)
        scene_dynamic_circle(&d->scene, x, y, 0.5);
    else
        scene_dynamic_box(&d->scene, x, y, 1, 0.5)->angle = atan(-0.5);
    duel_begin(d);
}

static double way_along_slope(const duel *d, int engine) {
    return hypot(d->bodies[engine][1].x - d->scene.bodies[1].x,
                 d->bodies[engine][1].y - d->scene.bodies[1].y);
}

/* After two seconds a / 2 * t^2 = 2 a. The bound of 2 % is for integration (0.4 %) and the
 * compliance of contacts at the start. */
static void motion_box_on_steep_slope_slides_with_coulomb_friction(void **state) {
    (void)state;
    duel d;
    begin_on_slope(&d, false, 0.2);
    duel_step(&d, 120);
    double expected = 2 * G * (1 - 0.2 * 2) / sqrt(5);
    for (int e = 0; e < ENGINES; e++)
        assert_near(way_along_slope(&d, e), expected, 0.02 * expected);
    duel_end(&d);
}

/* tan = 0.5 is below 0.7, so the box does not slide; soft contacts may creep by some millimetres.
 */
static void motion_box_below_friction_angle_stays(void **state) {
    (void)state;
    duel d;
    begin_on_slope(&d, false, 0.7);
    duel_step(&d, 120);
    for (int e = 0; e < ENGINES; e++)
        assert_near(way_along_slope(&d, e), 0, 0.03);
    duel_end(&d);
}

/* A disc that rolls without slipping accelerates at 2/3 g sin. */
static void motion_disc_rolls_at_two_thirds(void **state) {
    (void)state;
    duel d;
    begin_on_slope(&d, true, 0.9);
    duel_step(&d, 120);
    double expected = 2 * (2.0 / 3) * G / sqrt(5);
    for (int e = 0; e < ENGINES; e++)
        assert_near(way_along_slope(&d, e), expected, 0.02 * expected);
    duel_end(&d);
}

/* Dropped from 2 m with restitution 0.8 a ball returns to 0.64 * 2 m. The time of impact is known
 * to a substep: at 6.3 m/s this is 2.6 cm of the path, and restitution uses the speed after it. */
static void motion_ball_bounces_to_same_height(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 10, 1);
    scene_dynamic_circle(&d.scene, 0, 2.5, 0.5);
    d.scene.shapes[1].material.restitution = 0.8;
    duel_begin(&d);
    double top[ENGINES] = {0};
    for (int i = 0; i < 90; i++) {
        duel_step(&d, 1);
        for (int e = 0; e < ENGINES; e++)
            if (i > 45)
                top[e] = fmax(top[e], d.bodies[e][1].y);
    }
    for (int e = 0; e < ENGINES; e++)
        assert_near(top[e], 0.5 + 0.64 * 2, 0.1);
    assert_near(top[THUD], top[BOX2D], 0.15);
    duel_end(&d);
}

/* Equal balls at restitution 1 swap velocities. */
static void motion_equal_balls_head_on_swap_velocities(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    d.scene.gravity_y = 0;
    d.scene.material.restitution = 1;
    scene_dynamic_circle(&d.scene, 0, 0, 0.5)->vx = 4;
    scene_dynamic_circle(&d.scene, 3, 0, 0.5)->vx = -2;
    duel_begin(&d);
    duel_step(&d, 60);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][0].vx, -2, 0.05);
        assert_near(d.bodies[e][1].vx, 4, 0.05);
    }
    duel_end(&d);
}

/* A kinematic box at 1 m/s pushes the box in front of it: their faces stay in contact. */
static void motion_kinematic_body_pushes_at_its_own_speed(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    scene_static_box(&d.scene, 0, -1, 20, 1);
    scene_add_body(&d.scene, SCENE_KINEMATIC, 0, 0.6)->vx = 1;
    scene_add_obb(&d.scene, 0.5, 0.5);
    scene_dynamic_box(&d.scene, 1.5, 0.5, 0.5, 0.5);
    duel_begin(&d);
    duel_step(&d, 120);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][1].x, 2, 1e-3);
        assert_near(d.bodies[e][2].x, 3, 0.02);
    }
    duel_end(&d);
}

/* exp(-1) after a second with damping 1; a Pade step of 1/240 s has an error of 1e-5. */
static void motion_damped_bodies_lose_speed_alike(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    d.scene.gravity_y = 0;
    scene_body *box = scene_dynamic_box(&d.scene, 0, 0, 0.5, 0.5);
    box->vx = 5;
    box->angular_velocity = 3;
    box->linear_damping = box->angular_damping = 1;
    duel_begin(&d);
    duel_step(&d, 60);
    for (int e = 0; e < ENGINES; e++) {
        assert_near(d.bodies[e][0].vx, 5 * exp(-1), 0.02);
        assert_near(d.bodies[e][0].angular_velocity, 3 * exp(-1), 0.02);
    }
    duel_end(&d);
}

/* Equal to seven digits, single precision. One body has two shapes, so that its centre of mass is
 * not its origin. */
static void motion_masses_and_inertias_are_equal(void **state) {
    (void)state;
    duel d;
    duel_init(&d);
    d.scene.material.density = 2.5;
    scene_dynamic_circle(&d.scene, 0, 0, 0.7);
    scene_dynamic_box(&d.scene, 5, 0, 0.3, 0.9);
    scene_dynamic_box(&d.scene, 10, 0, 0.5, 0.25);
    scene_add_circle(&d.scene, 0.4)->x = 0.8;
    duel_begin(&d);
    for (int i = 0; i < 3; i++) {
        assert_near(d.bodies[THUD][i].mass, d.bodies[BOX2D][i].mass,
                    1e-6 * d.bodies[BOX2D][i].mass);
        assert_near(d.bodies[THUD][i].inertia, d.bodies[BOX2D][i].inertia,
                    1e-5 * d.bodies[BOX2D][i].inertia);
    }
    duel_end(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(motion_projectile_follows_the_parabola),
        cmocka_unit_test(motion_box_sliding_on_level_ground_stops_after_known_way),
        cmocka_unit_test(motion_box_on_steep_slope_slides_with_coulomb_friction),
        cmocka_unit_test(motion_box_below_friction_angle_stays),
        cmocka_unit_test(motion_disc_rolls_at_two_thirds),
        cmocka_unit_test(motion_ball_bounces_to_same_height),
        cmocka_unit_test(motion_equal_balls_head_on_swap_velocities),
        cmocka_unit_test(motion_kinematic_body_pushes_at_its_own_speed),
        cmocka_unit_test(motion_damped_bodies_lose_speed_alike),
        cmocka_unit_test(motion_masses_and_inertias_are_equal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
