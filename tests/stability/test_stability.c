/* test_stability.c: runs every extreme in its quick form. It asserts that all scenes can be run,
 * that each figure of thud is a number and has the same bits with and without AVX2, and that each
 * bound holds, except those in known_misses.c, which must be missed, but by no more than listed.
 * Where a test run executes a share of its cases, the second run without AVX2 is left out. */
#include "extremes/extreme.h"
#include "share.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

static void check_figure(const extreme *x, const figure *f) {
    for (entrant e = 0; e < ENTRANT_BOX2D; e++) {
        if (!(f->measured & 1u << e))
            continue;
        if (isnan(f->reached[e]))
            fail_msg("%s: %s: not a number (%s)", x->name, f->what, entrant_name(e));
        char why[KNOWN_MISS_TEXT];
        known_miss found = known_misses_judge(x, f, e, true, why, sizeof why);
        if (found == KNOWN_MISS_WRONG)
            fail_msg("%s", why);
        if (found == KNOWN_MISS_AS_KNOWN)
            print_message("%s\n", why);
    }
}

static ledger *run_quickly(const extreme *x, bool baseline_simd) {
    ledger *l = calloc(1, sizeof *l);
    assert_non_null(l);
    *l = (ledger){.quick = true, .baseline_simd = baseline_simd, .entrants = ON_THUD};
    x->run(l);
    assert_false(l->failed);
    assert_true(l->count > 0);
    return l;
}

/* All SIMD widths must compute the same bits, so the figures are compared for equality. */
static void check_equal(const extreme *x, const figure *f, const figure *baseline) {
    assert_string_equal(f->what, baseline->what);
    assert_int_equal(f->measured, baseline->measured);
    for (entrant e = 0; e < ENTRANT_BOX2D; e++)
        if (f->measured & 1u << e && f->reached[e] != baseline->reached[e])
            fail_msg("%s: %s: %.17g, but %.17g without AVX2 (%s)", x->name, f->what, f->reached[e],
                     baseline->reached[e], entrant_name(e));
}

static void check_all_equal(const extreme *x, const ledger *l) {
    ledger *baseline = run_quickly(x, true);
    assert_int_equal(l->count, baseline->count);
    for (int i = 0; i < l->count; i++)
        check_equal(x, &l->figures[i], &baseline->figures[i]);
    free(baseline);
}

static void extreme_keeps_its_bounds_with_every_simd_width(void **state) {
    const extreme *x = *state;
    ledger *l = run_quickly(x, false);
    for (int i = 0; i < l->count; i++) {
        assert_true(l->figures[i].measured != 0);
        check_figure(x, &l->figures[i]);
    }
    if (TEST_SHARE == 1)
        check_all_equal(x, l);
    const char *stray = known_misses_stray(x, l);
    if (stray)
        fail_msg(
            "%s: known_misses.c has a line without a worst value or a reason, or that is no figure: %s",
            x->name, stray);
    free(l);
}

int main(void) {
    struct CMUnitTest *tests = calloc((size_t)EXTREME_COUNT, sizeof *tests);
    if (!tests)
        return 1;
    for (int i = 0; i < EXTREME_COUNT; i++)
        tests[i] = (struct CMUnitTest){.name = EXTREMES[i]->name,
                                       .test_func = extreme_keeps_its_bounds_with_every_simd_width,
                                       .initial_state = (void *)EXTREMES[i]};
    int failed = _cmocka_run_group_tests("stability", tests, (size_t)EXTREME_COUNT, NULL, NULL);
    free(tests);
    return failed;
}
