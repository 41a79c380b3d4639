/* test_page.c: what the page says of figures and bounds. */
#include "page.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A page of the first extreme alone, with these notes; the caller frees it. */
static char *page_of(const ledger *l, const char *notes) {
    FILE *file = tmpfile();
    assert_non_null(file);
    page_part part = {EXTREMES[0], l};
    page_write(file, &part, 1, notes);
    long size = ftell(file);
    char *text = calloc((size_t)size + 1, 1);
    assert_non_null(text);
    rewind(file);
    assert_int_equal(fread(text, 1, (size_t)size, file), size);
    fclose(file);
    return text;
}

static void assert_says(const ledger *l, const char *notes, const char *words) {
    char *page = page_of(l, notes);
    if (!strstr(page, words))
        fail_msg("\"%s\" is not in:\n%s", words, page);
    free(page);
}

static void page_bound_that_is_kept_says_yes(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    figure *f = ledger_add(&l, bound_at_most(1, ON_EXACT), "box of %d", 7);
    figure_tell(f, ENTRANT_EXACT, 1);
    figure_tell(f, ENTRANT_BOX2D, 2);
    assert_says(&l, "", "| box of 7 | ≤ 1 at exact | – | – | – | 1 | 2 | yes |\n");
    assert_says(&l, "", "| 1 of 1 | 0 of 1 |\n");
}

static void page_bound_that_is_missed_says_what_was_reached(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    figure *f = ledger_add(&l, bound_at_least(99.9, ON_DEFAULT | ON_EXACT), "kept");
    figure_tell(f, ENTRANT_DEFAULT, 12.5);
    figure_tell(f, ENTRANT_EXACT, INFINITY);
    assert_says(&l, "", "| ≥ 99.9 at default, exact |");
    assert_says(&l, "", "| **no**: default reached 12.5, exact reached fails |\n");
    assert_says(&l, "", "| 0 of 1 | – |\n");
}

static void page_figure_without_bound_is_only_told(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    figure_tell(ledger_add(&l, bound_none(), "told"), ENTRANT_DRAFT, 3);
    assert_says(&l, "", "| told | – | 3 | – | – | – | – | – |\n");
    assert_says(&l, "", "| 0 of 0 | – |\n");
}

static void bound_not_a_number_is_never_kept(void **state) {
    (void)state;
    figure most = {.bound = bound_at_most(1, ON_THUD)},
           least = {.bound = bound_at_least(1, ON_THUD)};
    figure_tell(&most, ENTRANT_HIGH, NAN);
    figure_tell(&least, ENTRANT_HIGH, NAN);
    assert_false(figure_holds(&most, ENTRANT_HIGH));
    assert_false(figure_holds(&least, ENTRANT_HIGH));
    figure_tell(&least, ENTRANT_HIGH, INFINITY); /* how a loss is told */
    assert_false(figure_holds(&least, ENTRANT_HIGH));
    assert_true(figure_holds(&least, ENTRANT_DRAFT)); /* was not measured */
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

static void page_notes_stand_below_their_extreme(void **state) {
    (void)state;
    static ledger l;
    l = (ledger){0};
    ledger_add(&l, bound_none(), "a");
    char notes[200];
    snprintf(notes, sizeof notes, "Opening.\n\n## %s\n\nMine.\n\n## %s\n\nAnother's.\n",
             EXTREMES[0]->name, EXTREMES[1]->name);
    char *page = page_of(&l, notes);
    assert_true(strncmp(page, "Opening.\n\n| extreme |", 21) == 0);
    const char *table = strstr(page, "| a | – |"), *mine = strstr(page, "\nMine.\n");
    assert_true(table && mine && table < mine);
    assert_null(strstr(page, "Another's."));
    free(page);
}

static void page_notes_of_no_extreme_are_found(void **state) {
    (void)state;
    const char *line = NULL;
    char known[64];
    snprintf(known, sizeof known, "text\n## %s\nmore", EXTREMES[0]->name);
    assert_false(page_notes_stray(known, &line));
    assert_false(page_notes_stray("", &line));
    assert_true(page_notes_stray("text\n## nonsense\nmore\n", &line));
    assert_true(strncmp(line, "## nonsense", 11) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(page_bound_that_is_kept_says_yes),
        cmocka_unit_test(page_bound_that_is_missed_says_what_was_reached),
        cmocka_unit_test(page_figure_without_bound_is_only_told),
        cmocka_unit_test(bound_not_a_number_is_never_kept),
        cmocka_unit_test(ledger_with_too_many_figures_has_failed),
        cmocka_unit_test(page_notes_stand_below_their_extreme),
        cmocka_unit_test(page_notes_of_no_extreme_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
