/* test_grab.c: tests which bodies the viewer's pointer can grab, and how a grabbed body moves. */
#include "grab.h"
#include "session.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Opens the scene of that name. */
static void open_scene(session *s, const char *name) {
    catalog_entry entry = {.info = scenes_find(name)};
    assert_non_null(entry.info);
    session_init(s);
    assert_true(session_load(s, &entry));
}

static thud_body_state body_at(const session *s, int index) {
    thud_body_state state;
    assert_int_equal(thud_body_get_state(s->world, s->bodies[index].id, &state), THUD_OK);
    return state;
}

static void steps(session *s, int count) {
    for (int i = 0; i < count; i++)
        session_step(s);
}

static double gap_to(const grab *g, const session *s, thud_pos target) {
    thud_pos anchor;
    assert_true(grab_anchor(g, s, &anchor));
    return hypot(anchor.x - target.x, anchor.y - target.y);
}

enum { TOP_BOX = 30 }; /* the top box of tall_stack; the floor is body 0 */

static void held_body_comes_to_the_pointer_and_stays(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "tall_stack");
    thud_pos from = body_at(&s, TOP_BOX).position;
    assert_true(grab_start(&g, &s, (thud_pos){from.x + 0.3, from.y}, 0.01));
    thud_pos target = {from.x + 3, from.y + 4};
    grab_move(&g, &s, target);
    steps(&s, 240);
    assert_true(gap_to(&g, &s, target) < 0.05);
    thud_body_state held = body_at(&s, TOP_BOX);
    assert_true(hypot(held.velocity.x, held.velocity.y) < 0.05);
    grab_end(&g, &s);
    steps(&s, 30);
    assert_true(body_at(&s, TOP_BOX).velocity.y < -3);
    session_free(&s);
}

static void sleeping_body_wakes_when_it_is_pulled(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "tall_stack");
    for (int i = 0; i < 1200 && body_at(&s, TOP_BOX).awake; i++)
        session_step(&s);
    assert_false(body_at(&s, TOP_BOX).awake);
    thud_pos from = body_at(&s, TOP_BOX).position;
    assert_true(grab_start(&g, &s, from, 0.01));
    grab_move(&g, &s, (thud_pos){from.x, from.y + 2});
    steps(&s, 120);
    assert_true(body_at(&s, TOP_BOX).position.y > from.y + 1.9);
    grab_end(&g, &s);
    session_free(&s);
}

static int joint_count(const session *s) {
    int count = -1;
    thud_world_get_joints(s->world, NULL, 0, &count);
    return count;
}

/* The static body that the joint is attached to is removed too. */
static void letting_go_leaves_the_world_as_it_was(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "tall_stack");
    int bodies = thud_stats_of(s.world).bodies;
    assert_true(grab_start(&g, &s, body_at(&s, TOP_BOX).position, 0.01));
    assert_int_equal(joint_count(&s), 1);
    grab_end(&g, &s);
    steps(&s, 1);
    assert_int_equal(joint_count(&s), 0);
    assert_int_equal(thud_stats_of(s.world).bodies, bodies);
    grab_end(&g, &s);
    session_free(&s);
}

static void body_removed_from_the_hand_ends_the_grab(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "tall_stack");
    int bodies = thud_stats_of(s.world).bodies;
    thud_pos from = body_at(&s, TOP_BOX).position;
    assert_true(grab_start(&g, &s, from, 0.01));
    session_remove(&s, s.bodies[TOP_BOX].id);
    thud_pos anchor;
    assert_false(grab_anchor(&g, &s, &anchor));
    grab_move(&g, &s, from); /* its joint is there until the next step */
    assert_false(g.held);
    assert_false(grab_anchor(&g, &s, &anchor));
    assert_string_equal(s.message, "");
    steps(&s, 1);
    assert_int_equal(thud_stats_of(s.world).bodies, bodies - 1);
    session_free(&s);
}

static void nothing_is_held_where_nothing_moves(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "tall_stack");
    assert_false(grab_start(&g, &s, (thud_pos){500, 500}, 0.01));
    assert_false(g.held);
    grab_move(&g, &s, (thud_pos){0, 0});
    assert_int_equal(joint_count(&s), 0);
    session_free(&s);
}

/* A ball with the mass of 10,000 links hangs on the chain: pulling at a link must not open its
 * joints. */
static void light_body_does_not_tear_the_heavy_one_along(void **state) {
    (void)state;
    session s;
    grab g = {0};
    open_scene(&s, "chain");
    session_set_quality(&s, quality_find("high"));
    steps(&s, 60);
    int link = 50;
    thud_pos from = body_at(&s, link).position;
    assert_true(grab_start(&g, &s, from, 0.2));
    grab_move(&g, &s, (thud_pos){from.x, from.y + 1000});
    for (int i = 0; i < 120; i++) {
        session_step(&s);
        assert_true(thud_step_error_of(s.world).joint_gap_max < 0.01);
    }
    grab_end(&g, &s);
    session_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(held_body_comes_to_the_pointer_and_stays),
        cmocka_unit_test(sleeping_body_wakes_when_it_is_pulled),
        cmocka_unit_test(letting_go_leaves_the_world_as_it_was),
        cmocka_unit_test(body_removed_from_the_hand_ends_the_grab),
        cmocka_unit_test(nothing_is_held_where_nothing_moves),
        cmocka_unit_test(light_body_does_not_tear_the_heavy_one_along),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
