/* test_kinds.c: tests the viewer's keys L and M, which choose a pair of categories of a scene and
 * change the rule between them. */
#include "session.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <thud/thud_rules.h>

static void open_scene(session *s, const char *name) {
    catalog_entry entry = {.info = scenes_find(name)};
    assert_non_null(entry.info);
    session_init(s);
    assert_true(session_load(s, &entry));
}

static thud_rule_kind rule_kind_of(const session *s, int a, int b) {
    thud_rule rule = {0};
    assert_int_equal(thud_world_get_rule(s->world, 2u << a, 2u << b, &rule, NULL, NULL), THUD_OK);
    return rule.kind;
}

static void every_pair_of_kinds_is_chosen_in_its_turn(void **state) {
    (void)state;
    session s;
    open_scene(&s, "meetings");
    assert_int_equal(s.scene.kinds, 4);
    int from[2] = {s.pair[0], s.pair[1]}, seen[4][4] = {{0}};
    for (int i = 0; i < 10; i++) {
        session_next_pair(&s);
        assert_true(s.pair[0] <= s.pair[1] && s.pair[1] < 4);
        assert_int_equal(seen[s.pair[0]][s.pair[1]]++, 0);
    }
    assert_int_equal(s.pair[0], from[0]);
    assert_int_equal(s.pair[1], from[1]);
    session_free(&s);
}

static void chosen_pair_is_told_with_what_it_is_to_each_other(void **state) {
    (void)state;
    session s;
    open_scene(&s, "meetings");
    session_step(&s); /* the scene's timetable begins: the first two categories ignore each other */
    while (s.pair[0] != 0 || s.pair[1] != 1)
        session_next_pair(&s);
    assert_string_equal(s.message, "Kinds 1 and 2 ignore each other.");
    session_next_meeting(&s);
    assert_string_equal(s.message, "Kinds 1 and 2 meet one way.");
    session_step(&s);
    session_next_meeting(&s);
    assert_string_equal(s.message, "Kinds 1 and 2 collide.");
    session_next_pair(&s);
    assert_string_equal(s.message, "Kinds 1 and 3 collide.");
    session_free(&s);
}

static void meeting_that_a_user_set_stays_against_the_timetable(void **state) {
    (void)state;
    session s;
    open_scene(&s, "meetings");
    session_step(&s);
    while (s.pair[0] != 0 || s.pair[1] != 1)
        session_next_pair(&s);
    assert_int_equal(rule_kind_of(&s, 0, 1), THUD_RULE_IGNORE);
    session_next_meeting(&s);
    for (int i = 0; i < 120; i++) /* during these steps the timetable would let them collide */
        session_step(&s);
    assert_int_equal(rule_kind_of(&s, 0, 1), THUD_RULE_ONE_WAY);
    assert_int_equal(rule_kind_of(&s, 0, 2), THUD_RULE_IGNORE); /* as the timetable sets it */
    session_free(&s);
}

static void kind_and_itself_collide_or_ignore_each_other(void **state) {
    (void)state;
    session s;
    open_scene(&s, "meetings");
    session_step(&s);
    while (s.pair[0] != 2 || s.pair[1] != 2)
        session_next_pair(&s);
    static const thud_rule_kind expected[] = {THUD_RULE_IGNORE, THUD_RULE_COLLIDE,
                                              THUD_RULE_IGNORE};
    for (int i = 0; i < 3; i++) {
        session_next_meeting(&s);
        session_step(&s);
        assert_int_equal(rule_kind_of(&s, 2, 2), expected[i]);
    }
    session_free(&s);
}

static void scene_without_kinds_has_no_pairs_to_choose(void **state) {
    (void)state;
    session s;
    open_scene(&s, "tall_stack");
    session_next_pair(&s);
    session_next_meeting(&s);
    assert_string_equal(s.message, "");
    assert_int_equal(s.scene.fields.rule_count, 0);
    session_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pair_of_kinds_is_chosen_in_its_turn),
        cmocka_unit_test(chosen_pair_is_told_with_what_it_is_to_each_other),
        cmocka_unit_test(meeting_that_a_user_set_stays_against_the_timetable),
        cmocka_unit_test(kind_and_itself_collide_or_ignore_each_other),
        cmocka_unit_test(scene_without_kinds_has_no_pairs_to_choose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
