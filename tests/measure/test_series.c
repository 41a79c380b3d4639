/* test_series.c: compares median, percentile and summary with values computed by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "series.h"

static void assert_equal(double actual, double expected) {
    if (actual != expected)
        fail_msg("%.17g is not %.17g", actual, expected);
}

static void median_is_the_middle_or_the_mean_of_the_two_in_the_middle(void **state) {
    (void)state;
    double odd[] = {9, 1, 4}, even[] = {8, 1, 2, 100}, one[] = {7};
    assert_equal(series_median(odd, 3), 4);
    assert_equal(series_median(even, 4), 5);
    assert_equal(series_median(one, 1), 7);
}

static void quantile_is_the_smallest_value_that_the_part_does_not_exceed(void **state) {
    (void)state;
    double values[200];
    for (int i = 0; i < 200; i++)
        values[i] = i + 1;
    assert_equal(series_quantile(values, 200, 0.99), 198);
    assert_equal(series_quantile(values, 200, 1), 200);
    assert_equal(series_quantile(values, 200, 0), 1);
    assert_equal(series_quantile(values, 10, 0.99), 10);
    assert_equal(series_quantile(values, 1, 0.99), 1);
}

static void span_is_the_largest_over_the_smallest_in_any_order(void **state) {
    (void)state;
    const double values[] = {3, 2, 5, 4};
    assert_equal(series_span(values, 4), 2.5);
    assert_equal(series_span(values, 1), 1);
}

/* A disturbance of a different step in each repetition does not change the summary. */
static void summary_takes_each_step_from_its_quietest_repetition(void **state) {
    (void)state;
    enum { STEPS = 101, REPETITIONS = 3 };
    series s;
    assert_true(series_init(&s, STEPS, REPETITIONS));
    for (int r = 0; r < REPETITIONS; r++)
        for (int i = 0; i < STEPS; i++)
            s.ms[r * STEPS + i] = i + 1 + (i % REPETITIONS == r ? 1000 : 0);
    series_summary summary = series_summarize(&s);
    assert_equal(summary.median, 51);
    assert_equal(summary.p99, 100);
    assert_equal(summary.max, 101);
    series_free(&s);
}

static void median_of_a_repetition_leaves_the_others_alone(void **state) {
    (void)state;
    series s;
    assert_true(series_init(&s, 3, 2));
    const double ms[] = {3, 1, 2, 30, 10, 20};
    for (int i = 0; i < 6; i++)
        s.ms[i] = ms[i];
    assert_equal(series_median_of(&s, 0), 2);
    assert_equal(series_median_of(&s, 1), 20);
    for (int i = 0; i < 6; i++)
        assert_equal(s.ms[i], ms[i]);
    series_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(median_is_the_middle_or_the_mean_of_the_two_in_the_middle),
        cmocka_unit_test(quantile_is_the_smallest_value_that_the_part_does_not_exceed),
        cmocka_unit_test(span_is_the_largest_over_the_smallest_in_any_order),
        cmocka_unit_test(summary_takes_each_step_from_its_quietest_repetition),
        cmocka_unit_test(median_of_a_repetition_leaves_the_others_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
