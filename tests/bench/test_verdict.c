/* test_verdict.c: tests that a verdict holds only if time, overlap, joint gaps and limits all hold,
 * with results made by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "verdict.h"

/* A result at the bounds: four times as fast as Box2D, the target, with equal overlap. */
static race_result even(void) {
    return (race_result){
        .scene = "any",
        .target = 4,
        .entry_count = 3,
        .entries = {{.engine = "thud",
                     .time = {1, 2, 3},
                     .overlap = {.worst = 0.02, .sum = 0.1, .pairs = 10}},
                    {.engine = "rapier", .time = {1, 1, 1}},
                    {.engine = "box2d",
                     .time = {4, 8, 12},
                     .overlap = {.worst = 0.02, .sum = 0.1, .pairs = 10}}},
    };
}

static void assert_verdict(const race_result *r, const char *expected) {
    char text[64];
    verdict_text(r, text, sizeof text);
    assert_string_equal(text, expected);
}

static void verdict_at_the_target_holds(void **state) {
    (void)state;
    race_result r = even();
    assert_verdict(&r, "holds");
    assert_true(verdict_holds(verdict_of(&r)));
}

static void verdict_below_the_target_names_each_part_that_misses(void **state) {
    (void)state;
    race_result r = even();
    r.entries[0].time.median = 1.01;
    assert_verdict(&r, "misses: median");
    r.entries[0].time.max = 3.01;
    assert_verdict(&r, "misses: median, worst");
    r = even();
    r.entries[2].time.p99 = 7.9;
    assert_verdict(&r, "misses: p99");
}

static void verdict_with_wider_joints_misses_however_fast(void **state) {
    (void)state;
    race_result r = even();
    r.entries[0].gaps = r.entries[2].gaps = (joint_gaps){{.length = 0.01}, .sum = 1, .joints = 200};
    assert_verdict(&r, "holds");
    r.entries[0].gaps.worst.length = 0.0101;
    assert_verdict(&r, "misses: gap");
    r.entries[0].gaps = (joint_gaps){{.length = 0.005}, .sum = 1.1, .joints = 200};
    assert_verdict(&r, "misses: gap");
}

static void verdict_with_deeper_overlap_misses_however_fast(void **state) {
    (void)state;
    race_result r = even();
    r.entries[0].overlap.worst = 0.0201;
    assert_verdict(&r, "misses: overlap");
    r = even();
    r.entries[0].overlap.sum = 0.11;
    assert_verdict(&r, "misses: overlap");
    r = even();
    r.entries[0].overlap.lost = 1;
    assert_verdict(&r, "misses: overlap");
}

static void verdict_on_a_limit_needs_no_rival(void **state) {
    (void)state;
    race_result r = even();
    r.target = 0;
    r.entry_count = 1;
    assert_verdict(&r, "");
    r.limit_ms = 3;
    assert_verdict(&r, "holds");
    r.limit_ms = 2.9;
    assert_verdict(&r, "misses: limit");
}

static void verdict_without_the_rival_of_the_target_is_silent(void **state) {
    (void)state;
    race_result r = even();
    r.entry_count = 2;
    assert_null(verdict_rival(&r));
    assert_verdict(&r, "");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdict_at_the_target_holds),
        cmocka_unit_test(verdict_below_the_target_names_each_part_that_misses),
        cmocka_unit_test(verdict_with_wider_joints_misses_however_fast),
        cmocka_unit_test(verdict_with_deeper_overlap_misses_however_fast),
        cmocka_unit_test(verdict_on_a_limit_needs_no_rival),
        cmocka_unit_test(verdict_without_the_rival_of_the_target_is_silent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
