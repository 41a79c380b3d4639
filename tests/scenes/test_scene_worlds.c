/* test_scene_worlds.c: every built-in scene and every level of assets/ builds a world that runs
 * without losing bodies, and to the same bits each time. */
#include "act_thud.h"
#include "build_thud.h"
#include "level.h"
#include "scenes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

static const char *const LEVELS[] = {"assets/levels/platform.tmj",  "assets/levels/quarry.tmj",
                                     "assets/levels/towers.tmj",    "assets/levels/mountain.tmj",
                                     "assets/levels/adventure.tmj", "assets/levels/playground.tmj"};
enum { LEVEL_COUNT = sizeof LEVELS / sizeof LEVELS[0] };

/* Builds the scene's world and runs it; asserts that every body stays finite. Returns the hash. */
static uint64_t run(const scene *s, int steps) {
    thud_world *world;
    int failed_body;
    thud_body_id *ids = malloc((size_t)s->body_count * sizeof *ids);
    thud_result result = scene_build_thud(s, NULL, &world, ids, &failed_body);
    if (result != THUD_OK)
        fail_msg("%s: body %d: %s", s->name, failed_body, thud_result_text(result));
    assert_int_equal(thud_stats_of(world).bodies, s->body_count);
    for (int i = 0; i < steps; i++) {
        assert_int_equal(scene_step_thud(&s->fields, world), THUD_OK);
        assert_int_equal(thud_events_of(world).quarantined_count, 0);
    }
    for (int i = 0; i < s->body_count; i++) {
        thud_body_state state;
        if (s->fields.breaks != 0 && !thud_body_is_valid(world, ids[i]))
            continue;
        assert_int_equal(thud_body_get_state(world, ids[i], &state), THUD_OK);
        if (!isfinite(state.position.x) || !isfinite(state.position.y))
            fail_msg("%s: body %d is lost", s->name, i);
    }
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    free(ids);
    return hash;
}

/* The size at which to run a scene, small enough that a sanitizer build runs all scenes in a second
 * or two; 0: the default size. */
static int small_size(const scene_info *info) {
    return info->default_size > 1000 ? 500 : info->default_size > 50 ? 20 : 0;
}

static void every_scene_runs_and_repeats_to_the_bit(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i++) {
        scene s;
        assert_true(scenes_fill(scenes_at(i), small_size(scenes_at(i)), &s));
        uint64_t first = run(&s, 60);
        assert_true(first == run(&s, 60));
        scene_free(&s);
    }
}

static void every_scene_builds_at_its_default_size(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i++) {
        scene s;
        assert_true(scenes_fill(scenes_at(i), 0, &s));
        run(&s, 0);
        scene_free(&s);
    }
}

static void every_level_runs_and_moves(void **state) {
    (void)state;
    for (int i = 0; i < LEVEL_COUNT; i++) {
        scene s;
        level_report report;
        assert_true(level_read_file(LEVELS[i], false, &s, &report));
        assert_true(run(&s, 30) != run(&s, 31));
        scene_free(&s);
    }
}

/* The scene `detection` has four lanes from left to right between pillars, one for each detection.
 * Bullets start below the first thin wall: under `overlap` and `bisect` (lanes 0 and 2) some pass
 * it, under the others none does. */
static void detection_lanes_keep_bullets_that_continuous_and_swept_look_after(void **state) {
    (void)state;
    enum { LANES = 4, STEPS = 600 };
    const double bullet = 0.12;
    scene s;
    thud_world *world;
    assert_true(scenes_fill(scenes_find("detection"), 0, &s));
    thud_body_id *ids = malloc((size_t)s.body_count * sizeof *ids);
    assert_int_equal(scene_build_thud(&s, NULL, &world, ids, NULL), THUD_OK);
    double first_wall = 0;
    for (int i = 0; i < s.body_count && first_wall == 0; i++)
        if (s.bodies[i].kind == SCENE_STATIC && s.shapes[s.bodies[i].first_shape].hy < 0.1)
            first_wall = s.bodies[i].y;
    double width = 2 * s.shapes[s.bodies[0].first_shape].hx; /* the width of the lowest slab */
    bool passed[LANES] = {false};
    int bullets = 0;
    for (int step = 0; step < STEPS; step++) {
        assert_int_equal(thud_world_step(world), THUD_OK);
        for (int i = 0; i < s.body_count; i++) {
            thud_body_state body;
            if (s.bodies[i].kind != SCENE_DYNAMIC || s.shapes[s.bodies[i].first_shape].hx != bullet)
                continue;
            bullets += step == 0;
            assert_int_equal(thud_body_get_state(world, ids[i], &body), THUD_OK);
            int lane = (int)((s.bodies[i].x / width + 0.5) * LANES);
            passed[lane] |= body.position.y > first_wall;
        }
    }
    assert_int_equal(bullets, 3 * LANES);
    assert_true(passed[0] && passed[2]);
    assert_false(passed[1] || passed[3]);
    thud_world_destroy(world);
    free(ids);
    scene_free(&s);
}

static void body_that_the_engine_refuses_is_named_and_leaves_no_world(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    scene_dynamic_circle(&s, 0, 0, 1);
    scene_dynamic_circle(&s, 0, 0, -1);
    thud_world *world;
    int failed_body;
    assert_int_equal(scene_build_thud(&s, NULL, &world, NULL, &failed_body), THUD_ERROR_INVALID);
    assert_int_equal(failed_body, 1);
    assert_null(world);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_runs_and_repeats_to_the_bit),
        cmocka_unit_test(every_scene_builds_at_its_default_size),
        cmocka_unit_test(every_level_runs_and_moves),
        cmocka_unit_test(detection_lanes_keep_bullets_that_continuous_and_swept_look_after),
        cmocka_unit_test(body_that_the_engine_refuses_is_named_and_leaves_no_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
