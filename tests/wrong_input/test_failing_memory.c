/* test_failing_memory.c: makes every call of a world with its first allocation failing, then with
 * its second, and so on until it succeeds. Each failure must return a result code and log a
 * message, and must change nothing but the memory that is held; the successful call must have the
 * same effect as in a world whose memory never fails. */
#include "village.h"

#include "hostile_memory.h"

#include <thud/thud_casts.h>
#include <thud/thud_prediction.h>
#include <thud/thud_draw.h>
#include <thud/thud_fields.h>
#include <thud/thud_make.h>
#include <thud/thud_rollback.h>
#include <thud/thud_snapshot.h>

#include <stdio.h>

typedef struct call {
    const char *name;
    thud_result (*make)(village *v);
    int times; /* number of calls in a row, so that arrays grow */
} call;

/* ---- calls that create something ---- */

static thud_result create_body(village *v) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){60 + 2.0 * thud_stats_of(v->world).bodies, 3};
    return thud_body_create(v->world, &def, &v->bare);
}

static thud_result create_circle(village *v) {
    thud_shape_def def = thud_default_shape_def();
    return thud_shape_create_circle(v->world, v->bare, &def, (thud_vec2){0, 0}, 1, NULL);
}

static thud_result create_aabb(village *v) {
    thud_shape_def def = thud_default_shape_def();
    return thud_shape_create_aabb(v->world, v->plank, &def, (thud_vec2){0, 1}, (thud_vec2){1, 1},
                                  NULL);
}

static thud_result create_obb(village *v) {
    thud_shape_def def = thud_default_shape_def();
    return thud_shape_create_obb(v->world, v->bare, &def, (thud_vec2){0, 1}, (thud_vec2){1, 1}, 1,
                                 NULL);
}

static thud_result create_terrain(village *v) {
    enum { COUNT = 50 };
    thud_pos points[COUNT];
    for (int i = 0; i < COUNT; i++) {
        points[i] = (thud_pos){i, -900 - i % 3};
    }
    thud_shape_def def = thud_default_shape_def();
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = COUNT};
    return thud_shape_create_terrain(v->world, v->floor, &def, &line, NULL);
}

/* ---- calls that change something ---- */

static thud_result teleport(village *v) {
    return thud_body_set_transform(v->world, v->ball, (thud_pos){3, 7}, 0);
}

static thud_result destroy(village *v) {
    return thud_shape_destroy(v->world, v->box_shape);
}

static thud_result enable(village *v) {
    return thud_body_set_enabled(v->world, v->switched_off, true);
}

/* Changes the quality to exact. */
static thud_result sharpen(village *v) {
    return thud_world_set_quality(v->world, &thud_quality_exact);
}

static thud_result set_heights(village *v) {
    const double heights[] = {1, 2, 1};
    return thud_shape_set_heights(v->world, v->dunes, 1, heights, 3);
}

static thud_result dig(village *v) {
    return thud_shape_dig(v->world, v->hill, (thud_pos){203, 2}, 2);
}

static thud_result raise_mound(village *v) {
    return thud_shape_raise(v->world, v->hill, 195, 4, 1);
}

static thud_result replace_range(village *v) {
    thud_pos points[40];
    for (int i = 0; i < 40; i++) {
        points[i] = (thud_pos){-15 + 0.1 * i, 0.5};
    }
    return thud_shape_replace_range(v->world, v->hill, -15, -11, points, 40);
}

static thud_result step(village *v) {
    return thud_world_step(v->world);
}

static thud_result advance(village *v) {
    return thud_world_advance(v->world, 1.0 / 60, 1, NULL, NULL);
}

static thud_result walk(village *v) {
    return thud_mover_move(v->world, &v->mover, (thud_vec2){1, -1}, 1.0 / 60, NULL);
}

/* ---- calls that read only ---- */

static bool go_on(thud_shape_id shape, void *context) {
    (void)shape;
    (void)context;
    return true;
}

static thud_result cast_ray(village *v) {
    return thud_world_cast_ray(v->world, &(thud_ray){(thud_pos){-20, 0.5}, 60, 0, NULL}, NULL,
                               NULL);
}

static thud_result cast_ray_all(village *v) {
    return thud_world_cast_ray_all(v->world, &(thud_ray){(thud_pos){-20, 0.5}, 60, 0, NULL}, NULL,
                                   0, NULL);
}

static thud_result cast_circle_all(village *v) {
    thud_ray_hit hits[8];
    return thud_world_cast_shape_all(v->world,
                                     &(thud_shape_cast){(thud_pos){-20, 3}, thud_circle_at(0, 0, 2),
                                                        60, 0, NULL},
                                     hits, 8, NULL);
}

static thud_result cast_box(village *v) {
    return thud_world_cast_shape(v->world,
                                 &(thud_shape_cast){(thud_pos){-20, 3}, thud_obb_at(0, 0, 2, 1, 1),
                                                    60, 0, NULL},
                                 NULL, NULL);
}

static thud_result overlap(village *v) {
    return thud_world_overlap_shape(v->world, (thud_pos){3, 1}, thud_circle_at(0, 0, 50), NULL,
                                    go_on, NULL);
}

static thud_result closest(village *v) {
    return thud_world_closest(v->world, (thud_pos){30, 1}, 400, NULL, NULL, NULL);
}

static thud_result volume(village *v) {
    thud_volume around;
    return thud_body_get_volume(v->world, v->box, THUD_SHAPE_OBB, (thud_pos){0, 0}, &around);
}

/* A cast inside a cast, at each hit. */
static double look_again(const thud_ray_hit *hit, void *context) {
    village *v = context;
    bool any = false;
    thud_result result =
        thud_world_cast_ray(v->world, &(thud_ray){hit->point, 0, -9, NULL}, &any, NULL);
    if (result != THUD_OK) {
        v->told = 0; /* the call is repeated with memory, or not at all */
    }
    return THUD_CAST_ON;
}

static thud_result cast_each(village *v) {
    return thud_world_cast_ray_each(v->world, &(thud_ray){(thud_pos){-60, 20}, 120, 1, NULL},
                                    look_again, v);
}

static thud_result predict(village *v) {
    thud_prediction out;
    return thud_world_predict(v->world, &v->ball, 1, 1, &out);
}

static thud_result cast_rays(village *v) {
    const thud_ray rays[2] = {{{-20, 0.5}, 60, 0, NULL}, {{-60, 20}, 60, 0, NULL}};
    thud_ray_hit hits[2] = {{.fraction = 9}};
    thud_result result = thud_world_cast_rays(v->world, rays, 2, hits);
    assert_true(result == THUD_OK || hits[0].fraction == 9);
    return result;
}

static thud_result bounds(village *v) {
    thud_pos lower, upper;
    return thud_shape_get_bounds(v->world, v->box_shape, &lower, &upper);
}

static thud_result explode(village *v) {
    thud_explosion blast = thud_default_explosion();
    int pushed = -7;
    blast.center.y = 6;
    blast.radius = 40;
    thud_result result = thud_world_explode(v->world, &blast, &pushed);
    assert_true(result == THUD_OK ? pushed > 0 : pushed == -7);
    return result;
}

static thud_result roll(village *v) {
    return thud_body_apply_rolling_resistance(v->world, v->ball, 0.5f);
}

static thud_result poses(village *v) {
    int count;
    return thud_poses_of(v->world, (thud_pos){0, 0}, 1, &count) ? THUD_OK : THUD_ERROR_MEMORY;
}

static thud_result draw(village *v) {
    const thud_debug_draw all = {.flags = 0xff, .lower = {-50, -50}, .upper = {350, 50}};
    return thud_world_draw(v->world, &all);
}

static thud_result make_body(village *v) {
    thud_geometry at = thud_circle_at(60 + 2.0 * thud_stats_of(v->world).bodies, 3, 0.5);
    return thud_body_make(v->world, at, NULL).index1 ? THUD_OK : THUD_ERROR_MEMORY;
}

static thud_result step_of(thud_world *world, const uint64_t *inputs, void *state) {
    (void)inputs, (void)state;
    return thud_world_step(world);
}

static thud_result roll_back(village *v) {
    thud_rollback_options options = {.step = step_of, .depth = 3};
    thud_rollback *made = NULL;
    thud_result result = thud_rollback_create(v->world, &options, &made);
    thud_rollback_destroy(made);
    return result;
}

static thud_result save_and_load(village *v) {
    char own[8] = "village";
    thud_result result = thud_world_save(v->world, "failing_memory_save", own, sizeof own);
    if (result == THUD_OK) {
        result = thud_world_load(v->world, "failing_memory_save", own, sizeof own);
        remove("failing_memory_save");
    }
    return result;
}

static const call calls[] = {
    {"create body", create_body, 200},
    {"create circle", create_circle, 100},
    {"create OBB", create_obb, 100},
    {"create AABB", create_aabb, 100},
    {"create terrain", create_terrain, 20},
    {"teleport", teleport, 1},
    {"destroy", destroy, 1},
    {"enable", enable, 1},
    {"quality", sharpen, 1},
    {"set heights", set_heights, 1},
    {"dig", dig, 3},
    {"raise", raise_mound, 1},
    {"replace range", replace_range, 1},
    {"cast ray", cast_ray, 1},
    {"cast ray, all", cast_ray_all, 1},
    {"cast circle, all", cast_circle_all, 1},
    {"cast box", cast_box, 1},
    {"overlap", overlap, 1},
    {"closest", closest, 1},
    {"volume", volume, 1},
    {"cast ray, each", cast_each, 1},
    {"cast rays", cast_rays, 1},
    {"predict", predict, 1},
    {"bounds", bounds, 1},
    {"explode", explode, 2},
    {"roll", roll, 1},
    {"make body", make_body, 100},
    {"rollback", roll_back, 1},
    {"save and load", save_and_load, 1},
    {"poses", poses, 1},
    {"draw", draw, 1},
    {"walk", walk, 3},
    {"step", step, 10},
    {"advance", advance, 10},
};
enum { CALLS = sizeof calls / sizeof *calls };

/* Makes the call with failing allocations. Returns the number of failures before it succeeded. */
static long make_with_failures(village *here, village *twin, const call *c) {
    for (long failures = 0;; failures++) {
        uint64_t hash = thud_hash_of(here->world);
        thud_stats before = thud_stats_of(here->world);
        here->told = 0;
        memory_allowed = failures;
        thud_result result = c->make(here);
        memory_allowed = -1;
        if (result == THUD_OK) {
            assert_int_equal(here->told, 0);
            OK(c->make(twin));
            return failures;
        }
        if (result != THUD_ERROR_MEMORY || here->told != 1) {
            fail_msg("%s: '%s', %d messages", c->name, thud_result_text(result), here->told);
        }
        thud_stats after = thud_stats_of(here->world);
        if (thud_hash_of(here->world) != hash || after.bodies != before.bodies ||
            after.shapes != before.shapes || after.steps != before.steps) {
            fail_msg("%s: the world has changed after %ld failures", c->name, failures);
        }
        assert_true(failures < 1000);
    }
}

/* Edits that no step has processed yet: a call that applies them allocates memory. */
static void add_crowd(village *v) {
    for (int i = 0; i < 200; i++) {
        add_ball(v->world, -40 + i % 20 * 0.9, 20 + i / 20 * 0.9, 0.5f);
    }
}

static long check_call(const call *c) {
    thud_world_def def = thud_default_world_def();
    village here, twin;
    long failures = 0;
    def.allocator = hostile_memory();
    village_make(&here, def);
    village_make(&twin, def);
    add_crowd(&here);
    add_crowd(&twin);
    for (int i = 0; i < c->times; i++) {
        failures += make_with_failures(&here, &twin, c);
    }
    for (int i = 0; i < 90; i++) {
        village_step(&here);
        village_step(&twin);
        if (thud_hash_of(here.world) != thud_hash_of(twin.world)) {
            fail_msg("%s: differs at step %d from a call that never failed", c->name, i);
        }
    }
    village_free(&here);
    village_free(&twin);
    assert_int_equal(memory_held, 0);
    return failures;
}

static void every_call_without_memory_changes_nothing_and_works_once_there_is_some(void **state) {
    (void)state;
    long failures = 0;
    for (int i = 0; i < CALLS; i++) {
        failures += check_call(&calls[i]);
    }
    print_message("%ld allocations failed\n", failures);
    assert_true(failures >= 80);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_call_without_memory_changes_nothing_and_works_once_there_is_some),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
