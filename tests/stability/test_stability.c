/* test_stability.c: every extreme in its quick form. What is asserted: that all of it can be run,
 * that every figure of thud is a number, and every bound but those known to be missed. */
#include "extreme.h"

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
        if (figure_holds(f, e))
            continue;
        if (!(known_misses(x, f) & 1u << e))
            fail_msg("%s: %s: %g (%s), bound %g", x->name, f->what, f->reached[e], entrant_name(e),
                     f->bound.value);
        print_message("missed, as known: %s: %s: %g (%s), bound %g\n", x->name, f->what,
                      f->reached[e], entrant_name(e), f->bound.value);
    }
}

static void extreme_in_quick_form_keeps_its_bounds(void **state) {
    const extreme *x = *state;
    ledger *l = calloc(1, sizeof *l);
    assert_non_null(l);
    l->quick = true;
    l->entrants = ON_THUD;
    x->run(l);
    assert_false(l->failed);
    assert_true(l->count > 0);
    for (int i = 0; i < l->count; i++) {
        assert_true(l->figures[i].measured != 0);
        check_figure(x, &l->figures[i]);
    }
    const char *stray = known_misses_stray(x, l);
    if (stray)
        fail_msg("%s: known_misses.c has a line that is no figure: %s", x->name, stray);
    free(l);
}

int main(void) {
    struct CMUnitTest *tests = calloc((size_t)EXTREME_COUNT, sizeof *tests);
    if (!tests)
        return 1;
    for (int i = 0; i < EXTREME_COUNT; i++)
        tests[i] = (struct CMUnitTest){.name = EXTREMES[i]->name,
                                       .test_func = extreme_in_quick_form_keeps_its_bounds,
                                       .initial_state = (void *)EXTREMES[i]};
    int failed = _cmocka_run_group_tests("stability", tests, (size_t)EXTREME_COUNT, NULL, NULL);
    free(tests);
    return failed;
}
