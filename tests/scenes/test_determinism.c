/* test_determinism.c: the motion in scenes has the same bits with the baseline and the widest SIMD
 * kernels, with every broadphase, and where the whole scene is shifted by whole metres. */
#include "engine_support.h"

#include "act_thud.h"
#include "build_thud.h"
#include "scenes.h"

#include <thud/thud_lists.h>
#include <thud/thud_testing.h>

static const char *const SCENES[] = {"tall_stack", "circle_pit", "mixed_terrain", "tumbler_half",
                                     "smash",      "platformer", "gas",           "slopes",
                                     "bullets",    "sizes",      "one_spot",      "cradle",
                                     "boats",      "flags",      "explosion",     "planks",
                                     "crates",     "meetings"};

/* Makes shapes that are not used, and destroys them: where the world has had more shapes than
 * TD_FETCH_SHAPES_MIN, it prefetches its records. */
static void make_and_destroy_shapes(thud_world *world, int count) {
    thud_shape_def solid = thud_default_shape_def();
    thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, -5000, 0);
    for (int i = 0; i < count; i++) {
        OK(thud_shape_create_circle(world, body, &solid, (thud_vec2){0, 0}, 0.1f, NULL));
    }
    OK(thud_body_destroy(world, body));
}

/* Hash of the velocities and angles of all bodies after 80 steps, also of bodies created meanwhile.
 * Positions are left out, as a shift changes them. `most` limits the scene's size; `spare`: so many
 * shapes were made and destroyed before the first step. */
static uint64_t motion_of(const char *name, int most, const thud_world_def *def, double shift_x,
                          double shift_y, int spare) {
    const scene_info *info = scenes_find(name);
    scene s;
    assert_non_null(info);
    int size = info->default_size > most ? most : info->default_size;
    assert_true(scenes_fill(info, size, &s));
    scene_shift(&s, shift_x, shift_y);
    thud_world *world;
    thud_body_id *ids = malloc((size_t)s.body_count * sizeof *ids);
    OK(scene_build_thud(&s, def, &world, ids, NULL));
    make_and_destroy_shapes(world, spare);
    for (int i = 0; i < 80; i++)
        OK(scene_step_thud(&s.fields, world));
    uint64_t hash = 0xcbf29ce484222325u;
    int count = 0;
    OK(thud_world_get_bodies(world, NULL, 0, &count));
    thud_body_id *all = malloc((size_t)count * sizeof *all);
    OK(thud_world_get_bodies(world, all, count, &count));
    for (int i = 0; i < count; i++) {
        thud_body_state b = state_of(world, all[i]);
        float values[3] = {b.velocity.x, b.velocity.y, b.angular_velocity};
        uint32_t bits[3];
        memcpy(bits, values, sizeof bits);
        for (int k = 0; k < 3; k++) {
            hash = (hash ^ bits[k]) * 0x100000001b3u;
        }
    }
    thud_world_destroy(world);
    free(all);
    free(ids);
    scene_free(&s);
    return hash;
}

static uint64_t motion_after(const char *name, bool baseline, double shift_x, double shift_y) {
    thud_world_def def = thud_default_world_def();
    thud_world_def_set_baseline_simd(&def, baseline);
    return motion_of(name, 600, &def, shift_x, shift_y, 0);
}

static void baseline_and_widest_kernels_give_the_same_bits(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof SCENES / sizeof *SCENES; i++) {
        if (motion_after(SCENES[i], false, 0, 0) != motion_after(SCENES[i], true, 0, 0)) {
            fail_msg("%s differs", SCENES[i]);
        }
    }
}

static void prefetching_changes_no_bit(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    for (size_t i = 0; i < sizeof SCENES / sizeof *SCENES; i++) {
        if (motion_of(SCENES[i], 600, &def, 0, 0, 0) !=
            motion_of(SCENES[i], 600, &def, 0, 0, 20001)) {
            fail_msg("%s differs", SCENES[i]);
        }
    }
}

static void shift_by_whole_units_changes_no_bit(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof SCENES / sizeof *SCENES; i++) {
        if (strcmp(SCENES[i], "crates") == 0) {
            /* its pieces are created at positions that were read as doubles, and those are coarser
             * far from the origin */
            continue;
        }
        uint64_t here = motion_after(SCENES[i], false, 0, 0);
        if (motion_after(SCENES[i], false, 1e7, -9999999) != here ||
            motion_after(SCENES[i], false, -65536, 12345) != here) {
            fail_msg("%s differs", SCENES[i]);
        }
    }
}

static void every_broadphase_gives_the_same_bits(void **state) {
    (void)state;
    const thud_broadphase *others[] = {&thud_broadphase_sweep, &thud_broadphase_all};
    for (size_t i = 0; i < sizeof SCENES / sizeof *SCENES; i++) {
        uint64_t by_grid = motion_after(SCENES[i], false, 0, 0);
        for (int k = 0; k < 4; k++) {
            thud_world_def def = thud_default_world_def();
            def.broadphase = others[k / 2];
            thud_world_def_set_baseline_simd(&def, k % 2);
            if (motion_of(SCENES[i], 600, &def, 0, 0, 0) != by_grid) {
                fail_msg("%s differs with %s", SCENES[i], thud_broadphase_name(def.broadphase));
            }
        }
    }
}

static void bisected_and_swept_scenes_have_the_same_bits_everywhere(void **state) {
    (void)state;
    static const char *const scenes[] = {"circle_pit", "mixed_terrain", "smash", "gas", "bullets"};
    const thud_detection *const kinds[] = {&thud_detection_bisect, &thud_detection_swept};
    for (size_t i = 0; i < 2 * sizeof scenes / sizeof *scenes; i++) {
        thud_world_def def = thud_default_world_def();
        def.detection = kinds[i % 2];
        uint64_t wanted = motion_of(scenes[i / 2], 150, &def, 0, 0, 0);
        thud_world_def other = def;
        thud_world_def_set_baseline_simd(&other, true);
        other.broadphase = &thud_broadphase_all;
        if (motion_of(scenes[i / 2], 150, &other, 0, 0, 0) != wanted ||
            motion_of(scenes[i / 2], 150, &def, 1e7, -1e7, 0) != wanted) {
            fail_msg("%s differs, %s", scenes[i / 2], thud_detection_name(def.detection));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(baseline_and_widest_kernels_give_the_same_bits),
        cmocka_unit_test(every_broadphase_gives_the_same_bits),
        cmocka_unit_test(bisected_and_swept_scenes_have_the_same_bits_everywhere),
        cmocka_unit_test(prefetching_changes_no_bit),
        cmocka_unit_test(shift_by_whole_units_changes_no_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
