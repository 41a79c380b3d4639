/* test_ledger.c: tests whether bounds hold or fail as they should (also for NaN and infinite
 * values), and the JSON that is recorded of figures. */
#include "record.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void assert_records(const ledger *l, const char *words) {
    FILE *file = tmpfile();
    assert_non_null(file);
    json out = {.file = file};
    record_write(&out, EXTREMES[0], l);
    char text[2000] = "";
    rewind(file);
    assert_true(fread(text, 1, sizeof text - 1, file) > 0);
    fclose(file);
    if (!strstr(text, words))
        fail_msg("\"%s\" is not in:\n%s", words, text);
}

static void record_tells_bound_and_figures_of_the_measured(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    figure *f = ledger_add(&l, bound_at_least(99.9, ON_DEFAULT | ON_EXACT), "kept");
    figure_tell(f, ENTRANT_DRAFT, NAN);
    figure_tell(f, ENTRANT_DEFAULT, 12.5);
    figure_tell(f, ENTRANT_EXACT, INFINITY);
    assert_records(&l, EXTREMES[0]->name);
    assert_records(&l, "\"what\": \"kept\"");
    assert_records(&l, "{\"kind\": \"at least\", \"value\": 99.9, "
                       "\"on\": [\"default\", \"exact\"]}");
    assert_records(&l, "{\"draft\": \"not a number\", \"default\": 12.5, \"exact\": null}");
}

static void record_of_figure_without_bound_has_none(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    figure_tell(ledger_add(&l, bound_none(), "told"), ENTRANT_BOX2D, 3);
    assert_records(&l, "{\"what\": \"told\", \"reached\": {\"Box2D\": 3}}");
}

static void bound_not_a_number_is_never_kept(void **state) {
    (void)state;
    figure most = {.bound = bound_at_most(1, ON_THUD)},
           least = {.bound = bound_at_least(1, ON_THUD)};
    figure_tell(&most, ENTRANT_HIGH, NAN);
    figure_tell(&least, ENTRANT_HIGH, NAN);
    assert_false(figure_holds(&most, ENTRANT_HIGH));
    assert_false(figure_holds(&least, ENTRANT_HIGH));
    figure_tell(&least, ENTRANT_HIGH, INFINITY); /* the value of a lost body */
    assert_false(figure_holds(&least, ENTRANT_HIGH));
    assert_true(figure_holds(&least, ENTRANT_DRAFT)); /* it was not measured */
}

static void ledger_with_too_many_figures_has_failed(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    for (int i = 0; i < LEDGER_FIGURES; i++)
        ledger_add(&l, bound_none(), "%d", i);
    assert_false(l.failed);
    assert_non_null(ledger_add(&l, bound_none(), "one more"));
    assert_true(l.failed);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(record_tells_bound_and_figures_of_the_measured),
        cmocka_unit_test(record_of_figure_without_bound_has_none),
        cmocka_unit_test(bound_not_a_number_is_never_kept),
        cmocka_unit_test(ledger_with_too_many_figures_has_failed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
