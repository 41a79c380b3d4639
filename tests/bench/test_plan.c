/* test_plan.c: tests the table of plans (scenes exist, sizes are valid, other sizes have no target)
 * and the reading of thud-bench's options. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "options.h"
#include "plan.h"

static void every_plan_names_a_scene_that_fills_at_its_size(void **state) {
    (void)state;
    for (int i = 0; i < bench_plan_count(); i++) {
        bench_plan plan = bench_plan_at(i);
        const scene_info *info = bench_scene(plan.scene);
        assert_non_null(info);
        scene s;
        assert_true(scenes_fill(info, plan.size, &s));
        assert_true(s.body_count >= (plan.size ? plan.size : info->default_size));
        scene_free(&s);
        assert_true(plan.target > 0 || plan.limit_ms > 0);
    }
}

static void plan_of_another_size_keeps_the_steps_and_loses_the_promise(void **state) {
    (void)state;
    bench_plan own = bench_plan_for("gas", 4000), other = bench_plan_for("gas", 5000);
    assert_true(own.target > 0 && own.size == 4000);
    assert_true(other.target == 0 && other.size == 5000);
    assert_int_equal(other.warm_up, own.warm_up);
    assert_true(bench_plan_for("overlapping", 100).limit_ms == 0);
    assert_false(bench_plan_for("cradle", 0).by_default);
}

static void rubble_is_ten_deep_at_every_size(void **state) {
    (void)state;
    for (int size = 1000; size <= 64000; size *= 4) {
        scene s;
        assert_true(scenes_fill(&bench_rubble, size, &s));
        double top = 0, right = 0;
        for (int i = 0; i < s.body_count; i++) {
            if (s.bodies[i].kind != SCENE_DYNAMIC)
                continue;
            top = s.bodies[i].y > top ? s.bodies[i].y : top;
            right = s.bodies[i].x > right ? s.bodies[i].x : right;
        }
        assert_true(top > 9 && top < 12);
        assert_true(right > size / 10 * 0.5 && right < size / 10 * 0.6);
        scene_free(&s);
    }
}

static options_outcome read(options *o, int count, const char *const *words) {
    char *argv[16] = {"thud-bench"};
    for (int i = 0; i < count; i++)
        argv[i + 1] = (char *)words[i];
    return options_read(o, count + 1, argv);
}

static void options_without_any_are_all_scenes_in_all_engines(void **state) {
    (void)state;
    static options o;
    assert_int_equal(read(&o, 0, NULL), OPTIONS_RUN);
    assert_int_equal(o.parts, BENCH_SCENES);
    assert_int_equal(o.scene_count, bench_plan_count());
    assert_int_equal(o.repetitions, 3);
    assert_ptr_equal(o.engines[0], &engine_thud);
    assert_ptr_equal(o.engines[1], &engine_box2d);
    assert_true(o.engine_count >= 2);
}

static void options_given_are_taken(void **state) {
    (void)state;
    const char *const words[] = {"--scene",   "gas:500", "--against", "box2d",
                                 "--profile", "--quick", "--growth",  "--against",
                                 "box2d",     "--steps", "7"};
    static options o;
    assert_int_equal(read(&o, 11, words), OPTIONS_RUN);
    assert_int_equal(o.parts, BENCH_PROFILE | BENCH_GROWTH);
    assert_int_equal(o.scene_count, 1);
    assert_int_equal(o.scenes[0].size, 500);
    assert_int_equal(o.engine_count, 2);
    assert_int_equal(o.repetitions, 1);
    assert_int_equal(o.steps, 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_plan_names_a_scene_that_fills_at_its_size),
        cmocka_unit_test(plan_of_another_size_keeps_the_steps_and_loses_the_promise),
        cmocka_unit_test(rubble_is_ten_deep_at_every_size),
        cmocka_unit_test(options_without_any_are_all_scenes_in_all_engines),
        cmocka_unit_test(options_given_are_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
