/* test_small_worlds.c: worlds of thud_default_small_world_def, which have restitution and the grid
 * only where a call asks for them, and else give the bits of a whole world. Sensors, the third such
 * part, are tested in test_sensors.c. */
#include "engine_support.h"

#include <thud/thud_edits.h>
#include <thud/thud_listeners.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>

#include <stdio.h>
#include <string.h>

enum { STEPS = 120, BALLS = 6 };

/* What the world's log was told last. */
typedef struct told {
    thud_result result;
    char words[160];
} told;

static void listen(thud_result result, const char *message, void *context) {
    told *t = context;
    t->result = result;
    snprintf(t->words, sizeof t->words, "%s", message);
}

static thud_world_def small_def(told *t) {
    thud_world_def def = thud_default_small_world_def(&thud_quality_draft);
    def.log = t ? listen : NULL;
    def.log_context = t;
    return def;
}

static void names_the_part(told *t) {
    assert_int_equal(t->result, THUD_ERROR_INVALID);
    assert_non_null(strstr(t->words, "restitution"));
    assert_non_null(strstr(t->words, "thud_default_small_world_def"));
    memset(t, 0, sizeof *t);
}

static thud_shape_def bouncy_def(void) {
    thud_shape_def def = thud_default_shape_def();
    def.restitution = 0.5f;
    return def;
}

/* A floor, balls that fall on to each other, and a box. */
static thud_shape_id fill(thud_world *world) {
    thud_shape_def def = thud_default_shape_def();
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    thud_shape_id ground = add_shape(world, floor, 20, 1, true, &def);
    for (int i = 0; i < BALLS; i++) {
        add_ball(world, 0.1 * i, 2 + 1.1 * i, 0.5f);
    }
    add_box(world, 4, 3, 0.5f, 0.25f);
    return ground;
}

/* A floor with three boxes, which come to rest; returns the topmost. */
static thud_body_id stack(thud_world *world) {
    thud_shape_def def = thud_default_shape_def();
    add_shape(world, add_body(world, THUD_BODY_STATIC, 0, -1, 0), 20, 1, true, &def);
    add_box(world, 0, 0.5, 0.5f, 0.5f);
    add_box(world, 0, 1.6, 0.5f, 0.5f);
    return add_box(world, 4, 3, 0.5f, 0.25f);
}

static void two_worlds_agree(thud_world *small, thud_world *whole) {
    for (int step = 0; step < STEPS; step++) {
        run(small, 1);
        run(whole, 1);
        assert_true(thud_hash_of(small) == thud_hash_of(whole));
    }
    thud_world_destroy(small);
    thud_world_destroy(whole);
}

static void small_world_has_the_bits_of_a_whole_one(void **state) {
    (void)state;
    thud_world *small = make_world(small_def(NULL));
    thud_world *whole = make_world(thud_default_world_def_of(&thud_quality_draft));
    OK(thud_world_set_sleeping(whole, false));
    fill(small);
    fill(whole);
    two_worlds_agree(small, whole);
}

static void restitution_comes_with_the_first_that_is_set(void **state) {
    (void)state;
    told t = {0};
    thud_world *small = make_world(small_def(&t));
    thud_world *whole = make_world(thud_default_world_def_of(&thud_quality_draft));
    thud_shape_id ground = fill(small);
    thud_shape_def def = bouncy_def();
    OK(thud_world_set_sleeping(whole, false));
    thud_shape_id ignored;
    thud_body_id body = add_body(small, THUD_BODY_DYNAMIC, -4, 3, 0);
    uint64_t before = thud_hash_of(small);
    assert_int_equal(thud_shape_create_circle(small, body, &def, (thud_vec2){0, 0}, 0.5f, &ignored),
                     THUD_ERROR_INVALID);
    names_the_part(&t);
    assert_true(thud_hash_of(small) == before);
    thud_body_destroy(small, body);
    OK(thud_shape_set_restitution(small, ground, 0.5f));
    OK(thud_shape_set_restitution(whole, fill(whole), 0.5f));
    body = add_body(small, THUD_BODY_DYNAMIC, -4, 3, 0);
    OK(thud_shape_create_circle(small, body, &def, (thud_vec2){0, 0}, 0.5f, &ignored));
    /* The same handle as in the other world, of a body that was made twice. */
    thud_body_id twice = add_body(whole, THUD_BODY_DYNAMIC, -4, 3, 0);
    thud_body_destroy(whole, twice);
    twice = add_body(whole, THUD_BODY_DYNAMIC, -4, 3, 0);
    OK(thud_shape_create_circle(whole, twice, &def, (thud_vec2){0, 0}, 0.5f, &ignored));
    two_worlds_agree(small, whole);
}

static void a_bounce_leaves_the_floor(void **state) {
    (void)state;
    thud_world *world = make_world(small_def(NULL));
    thud_shape_def plain = thud_default_shape_def();
    thud_body_id floor = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    OK(thud_shape_set_restitution(world, add_shape(world, floor, 20, 1, true, &plain), 1));
    thud_body_id ball = add_ball(world, 0, 3, 0.5f);
    bool rises = false;
    for (int step = 0; step < STEPS && !rises; step++) {
        run(world, 1);
        rises = state_of(world, ball).velocity.y > 4;
    }
    assert_true(rises);
    thud_world_destroy(world);
}

static void a_rule_with_restitution_is_refused(void **state) {
    (void)state;
    told t = {0};
    thud_world *world = make_world(small_def(&t));
    thud_shape_id ground = fill(world);
    thud_rule rule = thud_default_rule();
    OK(thud_world_set_rule(world, 1, 1, &rule));
    rule.restitution = 0;
    OK(thud_world_set_rule(world, 1, 1, &rule));
    rule.restitution = 0.5f;
    assert_int_equal(thud_world_set_rule(world, 1, 1, &rule), THUD_ERROR_INVALID);
    names_the_part(&t);
    run(world, STEPS);
    OK(thud_shape_set_restitution(world, ground, 0));
    OK(thud_world_set_rule(world, 1, 1, &rule));
    run(world, STEPS);
    thud_world_destroy(world);
}

static bool ask_for_bounces(thud_world *world, const thud_contact *contact,
                            thud_contact_settings *settings, void *context) {
    (void)world, (void)contact, (void)context;
    settings->restitution = 1;
    return true;
}

static void a_prologue_with_restitution_is_refused(void **state) {
    (void)state;
    told t = {0};
    thud_world *world = make_world(small_def(&t));
    thud_world *other = make_world(small_def(NULL));
    thud_shape_id ground = fill(world);
    fill(other);
    set_listeners(world, ask_for_bounces, NULL, NULL);
    for (int step = 0; step < STEPS; step++) {
        run(world, 1);
        run(other, 1);
        assert_true(thud_hash_of(world) == thud_hash_of(other));
    }
    names_the_part(&t);
    OK(thud_shape_set_restitution(world, ground, 0));
    run(world, 1);
    assert_int_equal(t.result, THUD_OK);
    thud_world_destroy(world);
    thud_world_destroy(other);
}

/* A snapshot says whether contacts can bounce. */
static void snapshot_brings_restitution_into_a_small_world(void **state) {
    (void)state;
    static char bytes[2][1 << 17];
    size_t sizes[2];
    thud_world *from = make_world(small_def(NULL));
    thud_shape_id ground = fill(from);
    OK(thud_world_snapshot(from, bytes[0], sizeof bytes[0], &sizes[0]));
    OK(thud_shape_set_restitution(from, ground, 0.5f));
    OK(thud_world_snapshot(from, bytes[1], sizeof bytes[1], &sizes[1]));
    run(from, STEPS);
    thud_world *to = make_world(small_def(NULL));
    thud_shape_def def = bouncy_def();
    for (int i = 0; i < 4; i++) {
        thud_shape_id made;
        thud_body_id first;
        int count = 0;
        OK(thud_world_restore(to, bytes[i % 2], sizes[i % 2]));
        thud_world_get_bodies(to, &first, 1, &count);
        assert_int_equal(thud_shape_create_circle(to, first, &def, (thud_vec2){0, 0}, 1, &made),
                         i % 2 ? THUD_OK : THUD_ERROR_INVALID);
    }
    OK(thud_world_restore(to, bytes[1], sizes[1]));
    run(to, STEPS);
    assert_true(thud_hash_of(to) == thud_hash_of(from));
    thud_world_destroy(from);
    thud_world_destroy(to);
}

/* With thud_world_set_sleeping a small world has the bits of a whole one to the last body that
 * falls asleep, and wakes it likewise. */
static void bodies_sleep_once_it_is_set(void **state) {
    (void)state;
    told t = {0};
    thud_world_def def = small_def(&t);
    thud_world *refused = NULL;
    assert_false(def.sleeping);
    def.sleeping = true;
    assert_int_equal(thud_world_create(&def, &refused), THUD_ERROR_INVALID);
    assert_null(refused);
    assert_non_null(strstr(t.words, "sleeping"));
    assert_non_null(strstr(t.words, "thud_default_small_world_def"));
    thud_world *worlds[3];
    thud_body_id boxes[3];
    for (int i = 0; i < 3; i++) {
        bool whole = i == 1;
        worlds[i] =
            make_world(whole ? thud_default_world_def_of(&thud_quality_draft) : small_def(NULL));
        boxes[i] = stack(worlds[i]);
    }
    run(worlds[0], 1);
    run(worlds[1], 1);
    OK(thud_world_set_sleeping(worlds[0], true));
    for (int step = 0; step < 6 * STEPS; step++) {
        run(worlds[0], 1);
        run(worlds[1], 1);
        run(worlds[2], 1);
        assert_true(thud_hash_of(worlds[0]) == thud_hash_of(worlds[1]));
        assert_int_equal(thud_stats_of(worlds[0]).awake_bodies,
                         thud_stats_of(worlds[1]).awake_bodies);
    }
    assert_int_equal(thud_stats_of(worlds[0]).awake_bodies, 0);
    assert_int_equal(thud_stats_of(worlds[2]).awake_bodies, 3);
    for (int i = 0; i < 2; i++) {
        OK(thud_body_set_velocity(worlds[i], boxes[i], (thud_vec2){5, 5}, 0));
    }
    two_worlds_agree(worlds[0], worlds[1]);
    thud_world_destroy(worlds[2]);
}

/* A snapshot with sleeping bodies links what wakes them. */
static void snapshot_brings_sleep_into_a_small_world(void **state) {
    (void)state;
    static char bytes[1 << 17];
    size_t size;
    thud_world *from = make_world(small_def(NULL)), *to = make_world(small_def(NULL));
    OK(thud_world_set_sleeping(from, true));
    thud_body_id box = stack(from);
    run(from, 6 * STEPS);
    assert_int_equal(thud_stats_of(from).awake_bodies, 0);
    OK(thud_world_snapshot(from, bytes, sizeof bytes, &size));
    OK(thud_world_restore(to, bytes, size));
    OK(thud_body_set_velocity(from, box, (thud_vec2){5, 5}, 0));
    OK(thud_body_set_velocity(to, box, (thud_vec2){5, 5}, 0));
    two_worlds_agree(to, from);
}

static void same_errors(const thud_step_error *a, const thud_step_error *b) {
    assert_true(a->penetration_max == b->penetration_max);
    assert_true(a->penetration_mean == b->penetration_mean);
    assert_true(a->residual == b->residual);
    assert_true(a->energy_change == b->energy_change);
    assert_true(a->shortfall == b->shortfall);
    assert_int_equal(a->overlaps, b->overlaps);
}

/* Errors of steps are counted from the step after the call that asks for them, as in a whole world.
 */
static void errors_of_steps_are_counted_once_they_are_used(void **state) {
    (void)state;
    static char bytes[1 << 17];
    size_t size;
    told t = {0};
    thud_world *small = make_world(small_def(&t)), *restored = make_world(small_def(NULL));
    thud_world *whole = make_world(thud_default_world_def_of(&thud_quality_draft));
    OK(thud_world_set_sleeping(whole, false));
    fill(small);
    fill(whole);
    thud_step_error error = {.overlaps = -1}, right;
    run(small, STEPS);
    run(whole, STEPS);
    assert_int_equal(thud_world_get_step_error(small, &error), THUD_ERROR_INVALID);
    assert_int_equal(error.overlaps, -1);
    assert_int_equal(t.result, THUD_ERROR_INVALID);
    assert_non_null(strstr(t.words, "thud_world_use_step_error"));
    assert_non_null(strstr(t.words, "thud_default_small_world_def"));
    assert_int_equal(thud_world_use_step_error(NULL), THUD_ERROR_NULL);
    OK(thud_world_use_step_error(small));
    OK(thud_world_use_step_error(whole));
    OK(thud_world_snapshot(small, bytes, sizeof bytes, &size));
    OK(thud_world_restore(restored, bytes, size));
    for (int step = 0; step < STEPS; step++) {
        run(small, 1);
        run(restored, 1);
        run(whole, 1);
        OK(thud_world_get_step_error(small, &error));
        OK(thud_world_get_step_error(whole, &right));
        same_errors(&error, &right);
        OK(thud_world_get_step_error(restored, &error));
        same_errors(&error, &right);
    }
    assert_true(right.penetration_max > 0);
    thud_world_destroy(small);
    thud_world_destroy(restored);
    thud_world_destroy(whole);
}

static thud_result locked;

static bool ask_for_errors(thud_world *world, const thud_contact *contact,
                           thud_contact_settings *settings, void *context) {
    (void)contact, (void)settings, (void)context;
    locked = thud_world_use_step_error(world);
    return true;
}

static void errors_of_steps_are_not_asked_for_in_a_callback(void **state) {
    (void)state;
    thud_world *world = make_world(small_def(NULL));
    fill(world);
    set_listeners(world, ask_for_errors, NULL, NULL);
    run(world, STEPS);
    assert_int_equal(locked, THUD_ERROR_LOCKED);
    thud_step_error error;
    assert_int_equal(thud_world_get_step_error(world, &error), THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

static void a_broadphase_is_named_or_all_pairs(void **state) {
    (void)state;
    told t = {0};
    thud_world_def def = small_def(&t);
    thud_world *world = NULL;
    assert_ptr_equal(def.broadphase, &thud_broadphase_all);
    def.broadphase = NULL;
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    assert_null(world);
    assert_non_null(strstr(t.words, "broadphase"));
    assert_non_null(strstr(t.words, "thud_default_small_world_def"));
    def.broadphase = &thud_broadphase_grid;
    world = make_world(def);
    thud_world_def whole = thud_default_world_def_of(&thud_quality_draft);
    assert_ptr_equal(whole.broadphase, &thud_broadphase_grid);
    whole.broadphase = NULL;
    thud_world *other = make_world(whole);
    fill(world);
    fill(other);
    run(other, 1);
    thud_broadphase_counts counts;
    OK(thud_world_set_sleeping(other, false));
    OK(thud_world_get_broadphase_counts(other, &counts));
    assert_true(counts.cells > 0);
    run(world, 1);
    two_worlds_agree(world, other);
}

static double tell_no_time(void *context) {
    (void)context;
    return 0;
}

static void a_time_budget_is_refused(void **state) {
    (void)state;
    told t = {0};
    thud_world_def def = small_def(&t);
    thud_world *world = NULL;
    def.clock = tell_no_time;
    def.time_budget = 1e-3;
    assert_int_equal(thud_world_create(&def, &world), THUD_ERROR_INVALID);
    assert_null(world);
    assert_non_null(strstr(t.words, "time_budget"));
    assert_non_null(strstr(t.words, "thud_default_small_world_def"));
}

/* Lines of terrain, edited where bodies lie on them: their contacts follow as in a whole world. */
static void terrain_is_edited_as_in_a_whole_world(void **state) {
    (void)state;
    thud_world *worlds[2] = {make_world(small_def(NULL)),
                             make_world(thud_default_world_def_of(&thud_quality_draft))};
    OK(thud_world_set_sleeping(worlds[1], false));
    thud_body_id grounds[2], balls[2];
    for (int i = 0; i < 2; i++) {
        thud_shape_def def = thud_default_shape_def();
        grounds[i] = add_body(worlds[i], THUD_BODY_STATIC, 0, 0, 0);
        thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
        thud_shape_id line;
        OK(thud_shape_create_terrain(worlds[i], grounds[i], &def, &flat, &line));
        balls[i] = add_ball(worlds[i], 0, 1, 0.5f);
        add_box(worlds[i], 3, 1, 0.5f, 0.5f);
        run(worlds[i], STEPS);
        OK(thud_body_set_transform(worlds[i], balls[i], (thud_pos){256, 0.5}, 0));
        run(worlds[i], 5);
        OK(thud_body_set_transform(worlds[i], grounds[i], (thud_pos){0, -1}, 0));
    }
    two_worlds_agree(worlds[0], worlds[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_world_has_the_bits_of_a_whole_one),
        cmocka_unit_test(restitution_comes_with_the_first_that_is_set),
        cmocka_unit_test(a_bounce_leaves_the_floor),
        cmocka_unit_test(a_rule_with_restitution_is_refused),
        cmocka_unit_test(a_prologue_with_restitution_is_refused),
        cmocka_unit_test(snapshot_brings_restitution_into_a_small_world),
        cmocka_unit_test(bodies_sleep_once_it_is_set),
        cmocka_unit_test(snapshot_brings_sleep_into_a_small_world),
        cmocka_unit_test(errors_of_steps_are_counted_once_they_are_used),
        cmocka_unit_test(errors_of_steps_are_not_asked_for_in_a_callback),
        cmocka_unit_test(a_time_budget_is_refused),
        cmocka_unit_test(terrain_is_edited_as_in_a_whole_world),
        cmocka_unit_test(a_broadphase_is_named_or_all_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
