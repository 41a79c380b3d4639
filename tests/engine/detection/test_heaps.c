/* test_heaps.c: swept bodies under load: detection in a collapsing heap costs a bounded amount of
 * work, and holds few bodies. */
#include "engine_support.h"

#include <thud/thud_make.h>

#include "build_thud.h"
#include "geometry_random.h"
#include "scenes.h"

/* What detection did in a scene. */
typedef struct load {
    double held;  /* held bodies, as a share of all bodies in all steps */
    double exact; /* times of impact computed, for each body and step */
    double deepest, speed;
} load;

/* Runs a scene under `swept` and measures it. */
static load run_scene(const char *name, int size, int steps) {
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    load l = {0};
    long bodies = 0;
    def.sleeping = false;
    def.detection = &thud_detection_swept;
    assert_true(scenes_fill(scenes_find(name), size, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    for (int i = 0; i < steps; i++) {
        run(world, 1);
        thud_stats stats = thud_stats_of(world);
        bodies += stats.awake_bodies;
        l.held += stats.held_bodies;
        l.exact += stats.motion_exact;
        l.deepest = fmax(l.deepest, thud_step_error_of(world).penetration_max);
    }
    l.held /= (double)bodies;
    l.exact /= (double)bodies;
    l.speed = sqrt(thud_measure_of(world).kinetic_energy);
    thud_world_destroy(world);
    scene_free(&s);
    return l;
}

/* Before loads were projected out of motions, 14 % were held, with 5 times of impact for each body,
 * and a depth of 21 mm. */
static void pit_holds_hardly_anybody(void **state) {
    (void)state;
    load l = run_scene("circle_pit", 500, 240);
    assert_true(l.held < 0.01);
    assert_true(l.exact < 0.5);
    assert_true(l.deepest < 0.03);
}

/* Before that, 7 % were held, with 8 times of impact for each body. Where the pairs that rest on
 * each other were told by their velocities alone, whatever they had yet to move in the step, some
 * came to overlap by 20 cm, half of their size. */
static void block_that_is_smashed_holds_hardly_anybody(void **state) {
    (void)state;
    for (int size = 480; size <= 520; size += 20) {
        load l = run_scene("smash", size, 120);
        assert_true(l.held < 0.03);
        assert_true(l.exact < 2);
        assert_true(l.deepest < 0.01);
    }
}

/* A resting contact is no impact; before that, 4 times of impact for each body were computed. */
static void pyramid_stands_without_a_test_of_motion(void **state) {
    (void)state;
    load l = run_scene("pyramid", 20, 120);
    assert_true(l.held < 0.001);
    assert_true(l.exact < 0.01);
    assert_true(l.deepest < 0.001 && l.speed < 0.02);
}

/* Bodies that lie on terrain and hardly move have no time of impact computed; before that, it was
 * one for each body and step. */
static void bodies_that_lie_on_terrain_need_no_time_of_impact(void **state) {
    (void)state;
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    long exact = 0;
    def.sleeping = false;
    def.detection = &thud_detection_swept;
    assert_true(scenes_fill(scenes_find("mixed_terrain"), 300, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    run(world, 600);
    int bodies = thud_stats_of(world).awake_bodies;
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        exact += thud_stats_of(world).motion_exact;
    }
    print_message("%ld times of impact, %d bodies\n", exact, bodies);
    assert_true(exact < 60 * bodies / 10);
    thud_world_destroy(world);
    scene_free(&s);
}

/* The projection has no friction: where it held bodies at rest, too, the heap crept without end. */
static void heap_falls_asleep_under_swept(void **state) {
    (void)state;
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    def.detection = &thud_detection_swept;
    assert_true(scenes_fill(scenes_find("circle_pit"), 500, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    run(world, 480);
    assert_int_equal(thud_stats_of(world).awake_bodies, 0);
    thud_world_destroy(world);
    scene_free(&s);
}

/* ---- a crowd whose bounds all overlap ---- */

enum { CROWD = 100 };

/* Rotating boxes with sides of 1/100 to 100, many of them needles, in a room of 60 by 60: the
 * bounds of most pairs overlap, so that each impact makes two bodies test nearly all others. */
static thud_world *make_crowd(const thud_quality *quality, const thud_detection *detection) {
    thud_world_def def = thud_default_world_def_of(quality);
    def.detection = detection;
    thud_world *world = make_world(def);
    source r = {.state = 77};
    const double room = 30;
    for (int side = -1; side <= 1; side += 2) {
        thud_body_make(world, thud_aabb_at(side * (room + 50), room, 50, 3 * room), NULL);
        thud_body_make(world, thud_aabb_at(0, room + side * (room + 50), 3 * room, 50), NULL);
    }
    for (int i = 0; i < CROWD; i++) {
        double hx = pow(100, draw(&r, -1, 1));
        double hy = pow(100, draw(&r, -1, 1));
        thud_body_options options = {.kind = THUD_BODY_DYNAMIC};
        options.restitution = (float)draw(&r, 0, 1);
        options.velocity.x = (float)draw(&r, -300, 300);
        options.velocity.y = (float)draw(&r, -300, 300);
        options.angular_velocity = (float)draw(&r, -3000, 3000);
        double x = draw(&r, -room, room);
        double y = draw(&r, 0, 2 * room);
        thud_body_make(world, thud_obb_at(x, y, hx, hy, draw(&r, -3, 3)), &options);
    }
    return world;
}

/* The budget of a step (TOI_BUDGET, impacts.c) is 8192 times of collision and 48 more for each
 * body. Beyond it each body is held at its next impact, at the cost of one more for each pair. */
static void crowd_of_extreme_sizes_costs_a_bounded_number_of_collision_times(void **state) {
    (void)state;
    const thud_detection *const detections[] = {&thud_detection_bisect, &thud_detection_swept};
    const thud_quality *const levels[] = {&thud_quality_draft, &thud_quality_default,
                                          &thud_quality_high, &thud_quality_exact};
    const int most = 8192 + 48 * CROWD + CROWD * CROWD / 2;
    int busiest = 0;
    for (int i = 0; i < 8; i++) {
        thud_world *world = make_crowd(levels[i / 2], detections[i % 2]);
        for (int k = 0; k < 4; k++) {
            OK(thud_world_step(world));
            thud_stats stats = thud_stats_of(world);
            busiest = stats.motion_exact > busiest ? stats.motion_exact : busiest;
            if (stats.motion_exact > most) {
                fail_msg("%s, %s: step %d worked out %d times of collision", levels[i / 2]->name,
                         i % 2 ? "swept" : "bisect", k, stats.motion_exact);
            }
        }
        thud_world_destroy(world);
    }
    print_message("at most %d times of collision in a step\n", busiest);
    assert_true(busiest > 8192 + 48 * CROWD); /* else no step has spent its budget */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pit_holds_hardly_anybody),
        cmocka_unit_test(block_that_is_smashed_holds_hardly_anybody),
        cmocka_unit_test(pyramid_stands_without_a_test_of_motion),
        cmocka_unit_test(heap_falls_asleep_under_swept),
        cmocka_unit_test(bodies_that_lie_on_terrain_need_no_time_of_impact),
        cmocka_unit_test(crowd_of_extreme_sizes_costs_a_bounded_number_of_collision_times),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
