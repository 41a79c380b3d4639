/* test_draws.c: the settings that `./run test` draws cover all pairs: with each of several seeds,
 * each guarantee is tested with any two values of two dimensions that it covers; and settings are
 * read as they are written. */
#include "draws.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

enum { MOST_DRAWS = 40 };

static bool have_pair(const settings *drawn, int count, int d, int v, int e, int u) {
    int i = 0;
    while (i < count && !(drawn[i].value[d] == v && drawn[i].value[e] == u)) {
        i++;
    }
    return i < count;
}

static bool is_covered(const guarantee *g, int d, int v, int e, int u) {
    for (int i = 0; i < settings_count(); i++) {
        settings s = settings_at(i);
        if (s.value[d] == v && s.value[e] == u && guarantee_covers(g, &s)) {
            return true;
        }
    }
    return false;
}

static void expect_pairs(const guarantee *g, const settings *drawn, int count, int d, int e) {
    for (int v = 0; v < dimensions[d].count; v++) {
        for (int u = 0; u < dimensions[e].count; u++) {
            if (is_covered(g, d, v, e, u) != have_pair(drawn, count, d, v, e, u)) {
                fail_msg("%s: %s=%s with %s=%s", g->name, dimensions[d].name,
                         dimensions[d].values[v], dimensions[e].name, dimensions[e].values[u]);
            }
        }
    }
}

static void any_two_values_come_together(void **state) {
    const guarantee *all[GUARANTEES_MAX];
    (void)state;
    int guarantees = guarantees_all(all);
    assert_true(guarantees > 50);
    for (int i = 0; i < guarantees; i++) {
        settings drawn[DRAWS_MAX];
        int count = draws_of(all[i], (uint64_t)i * 77, drawn);
        assert_true(count <= MOST_DRAWS);
        for (int d = 0; d < DIMENSIONS * DIMENSIONS; d++) {
            if (d / DIMENSIONS < d % DIMENSIONS) {
                expect_pairs(all[i], drawn, count, d / DIMENSIONS, d % DIMENSIONS);
            }
        }
    }
}

static void settings_are_read_as_they_are_written(void **state) {
    (void)state;
    for (int i = 0; i < settings_count(); i++) {
        char text[SETTINGS_TEXT];
        settings s = settings_at(i), read;
        settings_write(&s, text);
        assert_true(settings_read(text, &read));
        assert_memory_equal(&read, &s, sizeof s);
    }
    settings read;
    static const char *const wrong[] = {"", "quality=draft", "quality=best", "quality=draft,all"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(settings_read(wrong[i], &read));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_two_values_come_together),
        cmocka_unit_test(settings_are_read_as_they_are_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
