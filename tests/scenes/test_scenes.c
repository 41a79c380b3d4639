/* test_scenes.c: the built-in scenes as descriptions, before a world is built of them: sizes,
 * texts, positions on the grid, no overlaps. */
#include "scenes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* Distance of the body's farthest point from its centre, for bodies with one shape about their
 * origin. */
static double reach_of(const scene *s, const scene_body *body) {
    const scene_shape *shape = &s->shapes[body->first_shape];
    return shape->kind == SCENE_CIRCLE ? shape->hx
                                       : sqrt(shape->hx * shape->hx + shape->hy * shape->hy);
}

/* Asserts that a body has shapes of sane sizes, is on the position grid, and an AABB does not
 * rotate. */
static void check_body(const scene *s, const scene_body *body, const char *name) {
    if (!(isfinite(body->x) && isfinite(body->y) && fabs(body->angle) <= 7))
        fail_msg("%s: a body has no finite position or angle", name);
    if (body->x != scene_grid(body->x) || body->y != scene_grid(body->y))
        fail_msg("%s: a body is off the position grid", name);
    if (body->shape_count < 1)
        fail_msg("%s: a body without a shape", name);
    for (int i = 0; i < body->shape_count; i++) {
        const scene_shape *shape = &s->shapes[body->first_shape + i];
        if (shape->kind <= SCENE_OBB && !(shape->hx >= 1e-4 && shape->hx <= 16384))
            fail_msg("%s: a shape of size %g", name, shape->hx);
        if (shape->kind == SCENE_AABB && (!body->fixed_rotation || body->angle != 0))
            fail_msg("%s: an AABB that may rotate", name);
    }
}

static void check_texts(const scene_info *info) {
    if (!(info->title && info->about && info->size_means && info->min_size > 0 &&
          info->min_size <= info->default_size && info->default_size <= info->max_size))
        fail_msg("%s lacks its title, its sentence or its sizes", info->name);
}

static void every_scene_fills_at_least_and_default_size(void **state) {
    (void)state;
    assert_true(scenes_count() >= 12);
    for (int i = 0; i < scenes_count(); i++) {
        const scene_info *info = scenes_at(i);
        assert_ptr_equal(scenes_find(info->name), info);
        check_texts(info);
        assert_true(i == 0 || scenes_at(i - 1)->place < info->place);
        const int sizes[] = {0, info->min_size, info->default_size / 2};
        for (int k = 0; k < 3; k++) {
            scene s;
            if (k == 2 && sizes[k] < info->min_size)
                continue;
            if (!scenes_fill(info, sizes[k], &s))
                fail_msg("%s does not fill at size %d", info->name, sizes[k]);
            for (int b = 0; b < s.body_count; b++)
                check_body(&s, &s.bodies[b], info->name);
            assert_string_equal(s.name, info->name);
            assert_true(s.camera_height > 0);
            scene_free(&s);
        }
    }
}

static void default_sizes_are_those_of_the_benchmark(void **state) {
    (void)state;
    static const struct {
        const char *name;
        int dynamic, still;
    } expected[] = {
        {"pyramid", 5050, 1},        {"circle_pit", 10000, 3},  {"mixed_terrain", 4000, 3},
        {"tumbler", 2000, 1},        {"tumbler_half", 2000, 1}, {"smash", 9601, 0},
        {"platformer", 2000, 10000}, {"gas", 16000, 4},         {"tall_stack", 30, 1},
        {"sizes", 4000, 3},          {"asleep", 20100, 38},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        scene s;
        assert_true(scenes_fill(scenes_find(expected[i].name), 0, &s));
        int dynamic = 0;
        for (int b = 0; b < s.body_count; b++)
            dynamic += s.bodies[b].kind == SCENE_DYNAMIC;
        if (dynamic != expected[i].dynamic || s.body_count - dynamic != expected[i].still)
            fail_msg("%s has %d dynamic bodies and %d others", expected[i].name, dynamic,
                     s.body_count - dynamic);
        scene_free(&s);
    }
}

static void size_out_of_range_is_refused(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i++) {
        scene s;
        assert_false(scenes_fill(scenes_at(i), scenes_at(i)->max_size + 1, &s));
        assert_false(scenes_fill(scenes_at(i), -1, &s));
        assert_int_equal(s.body_count, 0);
    }
    assert_null(scenes_find("nothing"));
    assert_null(scenes_find(NULL));
    assert_null(scenes_at(-1));
    assert_null(scenes_at(scenes_count()));
}

static void scene_fills_the_same_twice(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i++) {
        scene a, b;
        assert_true(scenes_fill(scenes_at(i), 0, &a) && scenes_fill(scenes_at(i), 0, &b));
        assert_int_equal(a.body_count, b.body_count);
        for (int k = 0; k < a.body_count; k++)
            assert_true(a.bodies[k].x == b.bodies[k].x && a.bodies[k].vx == b.bodies[k].vx);
        scene_free(&a);
        scene_free(&b);
    }
}

/* Random bodies are laid out so that none starts inside another. */
static void random_scenes_start_without_overlap(void **state) {
    (void)state;
    static const char *const names[] = {"circle_pit", "mixed_terrain", "gas",
                                        "sizes",      "platformer",    "digging"};
    for (size_t n = 0; n < sizeof names / sizeof names[0]; n++) {
        scene s;
        assert_true(scenes_fill(scenes_find(names[n]), 1000, &s));
        for (int i = 0; i < s.body_count; i++) {
            for (int k = 0; k < i; k++) {
                const scene_body *a = &s.bodies[i], *b = &s.bodies[k];
                if (a->kind != SCENE_DYNAMIC || b->kind != SCENE_DYNAMIC)
                    continue;
                double dx = a->x - b->x, dy = a->y - b->y;
                double reach = reach_of(&s, a) + reach_of(&s, b);
                if (dx * dx + dy * dy < reach * reach)
                    fail_msg("%s: bodies %d and %d overlap", names[n], i, k);
            }
        }
        scene_free(&s);
    }
}

static void shift_by_whole_numbers_is_exact(void **state) {
    (void)state;
    for (int i = 0; i < scenes_count(); i++) {
        scene a, b;
        assert_true(scenes_fill(scenes_at(i), 0, &a) && scenes_fill(scenes_at(i), 0, &b));
        scene_shift(&b, 10000000, -9999999);
        for (int k = 0; k < a.body_count; k++) {
            assert_true(b.bodies[k].x - 10000000 == a.bodies[k].x);
            assert_true(b.bodies[k].y + 9999999 == a.bodies[k].y);
        }
        scene_free(&a);
        scene_free(&b);
    }
}

static void cradle_row_touches_exactly_and_first_balls_fly(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(scenes_find("cradle"), 0, &s));
    for (int row = 0; row < 3; row++) {
        const scene_body *balls = &s.bodies[2 + 5 * row];
        for (int i = 0; i < 5; i++)
            assert_true(balls[i].vx == (i <= row ? 5 : 0));
        for (int i = row + 1; i < 4; i++)
            assert_true(balls[i + 1].x - balls[i].x == 1);
    }
    scene_free(&s);
}

/* The table of heights in digging.c against the file that it was taken from. */
static void digging_ground_is_the_profile_of_the_asset(void **state) {
    (void)state;
    scene s;
    assert_true(scenes_fill(scenes_find("digging"), 0, &s));
    FILE *file = fopen("assets/terrain/jacksboro_200.csv", "r");
    assert_non_null(file);
    double elevation[403];
    int count = 0;
    char line[64];
    assert_non_null(fgets(line, sizeof line, file)); /* the line of column names */
    while (count < 403 && fscanf(file, "%*f,%lf", &elevation[count]) == 1)
        count++;
    fclose(file);
    assert_int_equal(count, 403);
    const scene_shape *ground = &s.shapes[0];
    assert_int_equal(ground->kind, SCENE_TERRAIN_UNIFORM);
    assert_int_equal(ground->point_count, 481);
    for (int i = 60; i <= 180; i++) {
        double height = (elevation[i] - 386) * 1.5 / 74.4;
        assert_true(fabs(s.points[ground->first_point + 4 * (i - 60)].y - height) < 1e-12);
    }
    scene_free(&s);
}

static void shape_without_a_body_marks_the_scene_as_failed(void **state) {
    (void)state;
    scene s;
    scene_init(&s);
    assert_non_null(scene_add_circle(&s, 1));
    assert_true(s.failed);
    assert_int_equal(s.shape_count, 0);
    assert_non_null(scene_add_body(&s, SCENE_DYNAMIC, 0, 0));
    assert_int_equal(s.body_count, 0);
    scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_fills_at_least_and_default_size),
        cmocka_unit_test(default_sizes_are_those_of_the_benchmark),
        cmocka_unit_test(size_out_of_range_is_refused),
        cmocka_unit_test(scene_fills_the_same_twice),
        cmocka_unit_test(random_scenes_start_without_overlap),
        cmocka_unit_test(shift_by_whole_numbers_is_exact),
        cmocka_unit_test(cradle_row_touches_exactly_and_first_balls_fly),
        cmocka_unit_test(digging_ground_is_the_profile_of_the_asset),
        cmocka_unit_test(shape_without_a_body_marks_the_scene_as_failed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
