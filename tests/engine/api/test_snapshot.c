/* test_snapshot.c: worlds that are restored from a snapshot repeat the same steps exactly, in every
 * scene and with every setting. */
#include "share.h"
#include "snapshot_support.h"

#include "build_thud.h"
#include "scenes.h"

#include <thud/thud_joint.h>
#include <thud/thud_rules.h>
#include <thud/thud_testing.h>
#include <thud/thud_textured.h>

/* Steps before and after a snapshot; greatest size of a scene. */
enum { BEFORE = 60, AFTER = 70, SIZE_MOST = 200 };

/* A world of a scene, at most of size SIZE_MOST. *scale is the scene's length scale. */
static thud_world *scene_world(const scene_info *info, const thud_world_def *def, float *scale) {
    scene s;
    thud_world *world;
    int size = info->default_size > SIZE_MOST ? SIZE_MOST : info->default_size;
    assert_true(scenes_fill(info, size < info->min_size ? info->min_size : size, &s));
    OK(scene_build_thud(&s, def, &world, NULL, NULL));
    *scale = (float)s.length_scale;
    scene_free(&s);
    return world;
}

/* A scene's snapshot is restored into the same world, into an empty one, and into one that has run
 * on; each repeats the steps. */
static void restored_anywhere(const scene_info *info, const thud_world_def *settings,
                              const thud_listeners *listeners, int before, int after,
                              const char *what) {
    thud_world_def def = settings ? *settings : thud_default_world_def();
    float scale;
    thud_world *world = scene_world(info, &def, &scale), *other = scene_world(info, &def, &scale);
    OK(thud_world_set_listeners(world, listeners));
    OK(thud_world_set_listeners(other, listeners));
    run(world, before);
    saved snapshot = save(world);
    trail first = walk(world, after);
    back_to(world, snapshot);
    walks_again(world, &first, what);
    run(other, before / 3);
    back_to(other, snapshot);
    walks_again(other, &first, what);
    thud_world_destroy(other);
    def.length_scale = scale;
    other = make_world(def);
    OK(thud_world_use_joints(other));
    OK(thud_world_set_listeners(other, listeners));
    OK(thud_world_use_rules(other));
    OK(thud_world_use_textures(other));
    back_to(other, snapshot);
    walks_again(other, &first, what);
    thud_world_destroy(other);
    thud_world_destroy(world);
    free(snapshot.bytes);
}

static void every_scene_restored_goes_the_same_way(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i += TEST_SHARE) {
        restored_anywhere(scenes_at(i), NULL, NULL, BEFORE, AFTER, scenes_at(i)->name);
    }
}

/* A world so large that its contacts have blocks by place (TD_PLACE_SLOTS), restored into itself
 * and into a small one. */
static void contacts_of_several_places_are_restored(void **state) {
    (void)state;
    scene s;
    thud_world *world;
    float scale;
    assert_true(scenes_fill(scenes_find("circle_pit"), 3000, &s));
    OK(scene_build_thud(&s, NULL, &world, NULL, NULL));
    scene_free(&s);
    run(world, 80);
    saved snapshot = save(world);
    trail first = walk(world, 40);
    back_to(world, snapshot);
    walks_again(world, &first, "the same world");
    thud_world *other = scene_world(scenes_find("circle_pit"), NULL, &scale);
    run(other, 30);
    back_to(other, snapshot);
    walks_again(other, &first, "a small world");
    thud_world_destroy(other);
    thud_world_destroy(world);
    free(snapshot.bytes);
}

/* A world that differs from the scenes as much as possible: large; thin, damped and belted bodies,
 * kinematic ones and sleeping ones; and a setting that may be pending for the next step. */
static thud_world *wild_world(thud_world_def def, int steps) {
    def.sleeping = steps % 2 == 0;
    def.gravity = (thud_vec2){1, -3};
    thud_world *world = make_world(def);
    OK(thud_world_use_joints(world));
    OK(thud_world_use_rules(world));
    OK(thud_world_use_textures(world));
    thud_shape_def belt = thud_default_shape_def();
    belt.surface_speed = 2 * def.length_scale;
    belt.restitution = 0.8f;
    add_floor(world, &belt);
    for (int side = -1; side <= 1; side += 2) {
        double far_out = side * 9e8 * (double)def.length_scale;
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, far_out, far_out, 0),
                  0.001f * def.length_scale, 5 * def.length_scale, false, NULL);
    }
    for (int i = 0; i < 300; i++) {
        thud_body_def body = thud_default_body_def();
        thud_body_id id;
        body.kind = i % 7 == 0 ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
        body.position = (thud_pos){i % 20 - 10, 1 + i / 20};
        body.linear_damping = i % 3 ? 0.5f : 0;
        body.velocity = (thud_vec2){(float)(i % 5), (float)(i % 3)};
        OK(thud_body_create(world, &body, &id));
        add_shape(world, id, 0.3f, i % 2 ? 0.2f : 0, i % 4 == 1, &belt);
    }
    run(world, steps);
    OK(thud_world_set_time_step(world, 1.0 / 90.0));
    run(world, steps % 3);
    return world;
}

/* Two very different worlds are restored from each other's snapshots; nothing of the former
 * contents remains. */
static void unlike_worlds_restored_from_each_other_go_the_same_ways(void **state) {
    (void)state;
    const thud_broadphase *const broadphases[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                  &thud_broadphase_sweep_both,
                                                  &thud_broadphase_sweep_widest};
    for (int i = 0; i < 2 * scenes_count(); i += TEST_SHARE) {
        const char *name = scenes_at(i / 2)->name;
        thud_world_def def = thud_default_world_def();
        def.broadphase = broadphases[i % 4];
        thud_world *world = scene_world(scenes_at(i / 2), &def, &def.length_scale);
        thud_world *wild = wild_world(def, 20 + i);
        run(world, 16 + i % 9);
        saved of_scene = save(world), of_wild = save(wild);
        trail scene_way = walk(world, 40), wild_way = walk(wild, 40);
        back_to(world, of_wild);
        walks_again(world, &wild_way, name);
        back_to(wild, of_scene);
        walks_again(wild, &scene_way, name);
        thud_world_destroy(world);
        thud_world_destroy(wild);
        free(of_scene.bytes);
        free(of_wild.bytes);
    }
}

static bool veto(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                 void *context) {
    (void)world;
    (void)context;
    settings->friction *= 0.5f;
    return contact->shape_b.index1 % 7 != 0;
}

/* An epilogue whose edits are deferred to the next step, also across a snapshot. */
static void push(thud_world *world, const thud_contact *contact, void *context) {
    (void)context;
    if (contact->shape_b.index1 % 5 == 0) {
        thud_body_apply_impulse(world, contact->body_b, (thud_vec2){0.1f, 0.5f}, contact->point);
    }
}

static void every_setting_restored_goes_the_same_way(void **state) {
    (void)state;
    static const char *const names[] = {"circle_pit", "mixed_terrain", "bullets"};
    const thud_detection *const detections[] = {&thud_detection_overlap, &thud_detection_bisect,
                                                &thud_detection_swept, NULL};
    const thud_broadphase *const broadphases[] = {&thud_broadphase_sweep, &thud_broadphase_all,
                                                  &thud_broadphase_grid, &thud_broadphase_grid};
    for (int n = 0; n < 3; n++) {
        for (int i = 0; i < 4; i++) {
            thud_world_def def = thud_default_world_def_of(qualities[i]);
            def.detection = detections[(i + n) % 4];
            def.broadphase = broadphases[i];
            thud_world_def_set_baseline_simd(&def, i == 1);
            thud_listeners listeners = {.prologue = i == 2 ? veto : NULL,
                                        .epilogue = i == 3 || n == 2 ? push : NULL};
            restored_anywhere(scenes_find(names[n]), &def, &listeners, 40, 30, names[n]);
        }
    }
}

static void sleeping_island_restored_sleeps_and_wakes_as_before(void **state) {
    (void)state;
    float scale;
    thud_world *world = scene_world(scenes_find("tall_stack"), NULL, &scale);
    for (int i = 0; i < 1000 && thud_stats_of(world).awake_bodies; i++) {
        run(world, 1);
    }
    assert_int_equal(thud_stats_of(world).awake_bodies, 0);
    saved snapshot = save(world);
    trail first = {0};
    for (int round = 0; round < 2; round++) {
        add_ball(world, -3, 1, 0.5f);
        OK(thud_world_set_gravity(world, (thud_vec2){6, -10}));
        if (round == 0) {
            first = walk(world, 100);
        } else {
            walks_again(world, &first, "woken");
        }
        assert_true(thud_stats_of(world).awake_bodies > 1);
        back_to(world, snapshot);
        assert_int_equal(thud_stats_of(world).awake_bodies, 0);
    }
    thud_world_destroy(world);
    free(snapshot.bytes);
}

/* Snapshots of each step until sleep are restored into worlds with other contents, and three steps
 * each are repeated. */
static void every_step_on_the_way_to_sleep_is_restored(void **state) {
    (void)state;
    enum { STEPS = 500, MORE = 3 };
    yard y = make_yard(NULL);
    thud_world *others[] = {wild_world(thud_default_world_def(), 30),
                            make_world(thud_default_world_def())};
    saved kept[STEPS];
    uint64_t digests[STEPS + MORE];
    for (int i = 0; i < STEPS + MORE; i++) {
        if (i < STEPS) {
            kept[i] = save(y.world);
        }
        run(y.world, 1);
        digests[i] = digest_of(y.world);
    }
    assert_true(thud_stats_of(y.world).awake_bodies < 7); /* of 14 */
    for (int i = 0; i < 2 * STEPS; i += TEST_SHARE) {
        int from = i * 37 % STEPS;
        back_to(others[i % 2], kept[from]);
        for (int k = 0; k < MORE; k++) {
            run(others[i % 2], 1);
            assert_int_equal(digest_of(others[i % 2]), digests[from + k]);
        }
    }
    for (int i = 0; i < STEPS; i++) {
        free(kept[i].bytes);
    }
    thud_world_destroy(others[0]);
    thud_world_destroy(others[1]);
    thud_world_destroy(y.world);
}

/* Makes one edit of each kind. */
static void edit(const yard *y) {
    OK(thud_shape_dig(y->world, y->ground, (thud_pos){5, 0.5}, 1.5));
    OK(thud_body_destroy(y->world, y->heap[3]));
    OK(thud_body_set_transform(y->world, y->heap[4], (thud_pos){-5, 4}, 0.3));
    OK(thud_body_set_enabled(y->world, y->heap[5], false));
    OK(thud_shape_destroy(y->world, y->ball_shape));
    add_shape(y->world, y->ball, 0.3f, 0.2f, false, NULL);
    OK(thud_body_apply_center_force(y->world, y->box, (thud_vec2){40, 10}));
    OK(thud_body_apply_torque(y->world, y->box, 3));
    OK(thud_body_set_awake(y->world, y->heap[6], false));
    add_ball(y->world, 1, 14, 0.4f);
}

/* Snapshots with edits that are not applied yet are restored with them. */
static void edits_that_wait_for_the_step_are_restored(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    saved fresh = save(y.world); /* a snapshot before any edit is applied */
    trail all = walk(y.world, 100);
    edit(&y);
    saved edited = save(y.world);
    trail first = walk(y.world, 100);
    back_to(y.world, edited);
    walks_again(y.world, &first, "edited");
    back_to(y.world, fresh);
    walks_again(y.world, &all, "fresh");
    edit(&y);
    walks_again(y.world, &first, "edited again");
    thud_world_destroy(y.world);
    free(fresh.bytes);
    free(edited.bytes);
}

/* A velocity set just before a snapshot is not part of the energy change that the next step
 * reports, in the restored world as in the first. */
static void velocity_set_just_before_is_no_gain_of_energy(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    run(y.world, 30);
    OK(thud_body_set_velocity(y.world, y.heap[11], (thud_vec2){50, 0}, 0));
    saved snapshot = save(y.world);
    trail first = walk(y.world, 20);
    back_to(y.world, snapshot);
    walks_again(y.world, &first, "hurried");
    thud_world_destroy(y.world);
    free(snapshot.bytes);
}

/* Every setting with a setter is restored; worlds of all qualities. */
static void settings_with_a_setter_are_restored(void **state) {
    (void)state;
    thud_quality odd = {.name = "odd",
                        .substeps = 7,
                        .contact_stiffness = 0.3f,
                        .contact_damping = 2,
                        .detection = &thud_detection_bisect,
                        .islands = &thud_islands_direct,
                        .overlap_limit = 0.5f,
                        .island_limit = 1,
                        .island_work = 1,
                        .island_slow_steps = 1000};
    for (int i = 0; i < QUALITIES; i++) {
        thud_world_def def = thud_default_world_def_of(qualities[i]);
        def.sleeping = i != 2;
        yard y = make_yard(&def);
        run(y.world, 50);
        saved snapshot = save(y.world);
        trail first = walk(y.world, 200);
        OK(thud_world_set_gravity(y.world, (thud_vec2){3, 0}));
        OK(thud_world_set_time_step(y.world, 1.0 / 30.0));
        OK(thud_world_set_quality(y.world, &odd));
        OK(thud_world_set_sleeping(y.world, i == 2));
        OK(thud_world_set_max_error(y.world, 0.001));
        run(y.world, 10);
        back_to(y.world, snapshot);
        walks_again(y.world, &first, qualities[i]->name);
        OK(thud_world_set_quality(y.world, &thud_quality_draft)); /* has no island solver */
        run(y.world, 10);
        back_to(y.world, snapshot);
        walks_again(y.world, &first, qualities[i]->name);
        thud_world_destroy(y.world);
        free(snapshot.bytes);
    }
}

/* After a restore, handles of the snapshot are valid, later ones are not, and new bodies get the
 * handles that they had the first time. */
static void handles_are_those_of_the_snapshot(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    run(y.world, 5);
    saved snapshot = save(y.world);
    OK(thud_body_destroy(y.world, y.ball));
    run(y.world, 1);
    thud_body_id later[100];
    for (int i = 0; i < 100; i++) {
        later[i] = add_ball(y.world, i, 30, 0.3f);
    }
    assert_false(thud_body_is_valid(y.world, y.ball));
    OK(thud_body_destroy(y.world, later[99]));
    run(y.world, 1);
    back_to(y.world, snapshot);
    assert_true(thud_body_is_valid(y.world, y.ball));
    assert_true(thud_shape_is_valid(y.world, y.ball_shape));
    for (int i = 0; i < 100; i++) {
        assert_false(thud_body_is_valid(y.world, later[i]));
    }
    OK(thud_body_destroy(y.world, y.ball));
    run(y.world, 1);
    for (int i = 0; i < 100; i++) {
        thud_body_id again = add_ball(y.world, i, 30, 0.3f);
        assert_memory_equal(&again, &later[i], sizeof again);
    }
    thud_world *other = make_world(thud_default_world_def());
    thud_body_id own = add_ball(other, 0, 0, 1);
    assert_false(thud_body_is_valid(other, y.box));
    back_to(other, snapshot);
    assert_true(thud_body_is_valid(other, y.box));
    assert_false(thud_body_is_valid(other, own));
    thud_world_destroy(other);
    thud_world_destroy(y.world);
    free(snapshot.bytes);
}

/* A snapshot is restored where terrains were destroyed, created or dug since. */
static void lines_that_came_went_or_grew_are_restored(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    run(y.world, 20);
    saved snapshot = save(y.world);
    trail first = walk(y.world, 40);
    thud_shape_state ground;
    OK(thud_shape_get_state(y.world, y.ground, &ground));
    OK(thud_body_destroy(y.world, ground.body));
    run(y.world, 2);
    thud_pos points[] = {{-50, -1}, {0, -2}, {50, -1}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    thud_shape_def plain = thud_default_shape_def();
    for (int i = 0; i < 3; i++) {
        OK(thud_shape_create_terrain(y.world, add_body(y.world, THUD_BODY_STATIC, 0, -i, 0), &plain,
                                     &line, NULL));
    }
    run(y.world, 5);
    back_to(y.world, snapshot);
    walks_again(y.world, &first, "lines");
    for (int i = 0; i < 20; i++) {
        OK(thud_shape_dig(y.world, y.ground, (thud_pos){i - 10, 0}, 0.7));
    }
    run(y.world, 5);
    back_to(y.world, snapshot);
    walks_again(y.world, &first, "holes");
    thud_world_destroy(y.world);
    free(snapshot.bytes);
}

/* The time that thud_world_advance has left over is restored. */
static void poses_and_time_left_over_are_restored(void **state) {
    (void)state;
    yard y = make_yard(NULL);
    double alpha[2];
    run(y.world, 20);
    OK(thud_world_advance(y.world, 0.01, 4, NULL, NULL));
    saved snapshot = save(y.world);
    for (int i = 0; i < 2; i++) {
        int steps;
        OK(thud_world_advance(y.world, 0.01, 4, &steps, &alpha[i]));
        assert_int_equal(steps, 1);
        back_to(y.world, snapshot);
    }
    assert_true(alpha[0] == alpha[1]);
    thud_world_destroy(y.world);
    free(snapshot.bytes);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_restored_goes_the_same_way),
        cmocka_unit_test(contacts_of_several_places_are_restored),
        cmocka_unit_test(unlike_worlds_restored_from_each_other_go_the_same_ways),
        cmocka_unit_test(every_setting_restored_goes_the_same_way),
        cmocka_unit_test(sleeping_island_restored_sleeps_and_wakes_as_before),
        cmocka_unit_test(every_step_on_the_way_to_sleep_is_restored),
        cmocka_unit_test(edits_that_wait_for_the_step_are_restored),
        cmocka_unit_test(velocity_set_just_before_is_no_gain_of_energy),
        cmocka_unit_test(settings_with_a_setter_are_restored),
        cmocka_unit_test(handles_are_those_of_the_snapshot),
        cmocka_unit_test(lines_that_came_went_or_grew_are_restored),
        cmocka_unit_test(poses_and_time_left_over_are_restored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
