/* test_one_way.c: one-way shapes by collision rules (thud_rules.h), which hold bodies on one of
 * their sides only, under every detection. */
#include "rules_support.h"

#include <thud/thud_edits.h>

#include <thud/thud_snapshot.h>

/* A player jumps from the ground up through a plank, and stands on it. */
static void planks_are_jumped_through(void **unused) {
    (void)unused;
    const float speeds[] = {9, 14, 40};
    for (int i = 0; i < DETECTIONS * BROADPHASES * 3 * 3 * 2; i++) {
        int d = i % 4, b = i / 4 % 3, form = i / 12 % 3, s = i / 36 % 3, plank_form = 1 + i / 108;
        thud_world *w = make(detections[d], broadphases[b]);
        thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
        OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
        add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
        add(w, THUD_BODY_STATIC, PLANK, plank_form, 0, 2, 3, 0.1f);
        thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, form, 0, 0.4, 0.4f, 0.4f);
        steps(w, 10);
        throw_up(w, player, 0, speeds[s]);
        steps(w, 700);
        if (fabs(get(w, player).position.y - 2.5) > 0.03) {
            fail_msg("case %d: detection %d, form %d, speed %g: at %g", i, d, form,
                     (double)speeds[s], get(w, player).position.y);
        }
        thud_world_destroy(w);
    }
}

/* A jump that is too low falls back, wherever in the plank it turns. */
static void low_jumps_fall_back(void **unused) {
    (void)unused;
    for (int i = 0; i < DETECTIONS * 12; i++) {
        thud_world *w = make(detections[i % DETECTIONS], NULL);
        thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
        OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
        add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
        add(w, THUD_BODY_STATIC, PLANK, 2, 0, 2, 3, 0.4f);
        thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, i % 3, 0, 0.4, 0.4f, 0.4f);
        steps(w, 10);
        /* feet rise to 1.25 .. 2.1 */
        throw_up(w, player, 0, 5.0f + 0.14f * (float)(i / DETECTIONS));
        steps(w, 200);
        assert_true(fabs(get(w, player).position.y - 0.4) < 0.03);
        thud_world_destroy(w);
    }
}

/* A body that falls fast is held, also where a step would end inside the plank. */
static void planks_hold_what_falls_fast(void **unused) {
    (void)unused;
    for (int i = 0; i < DETECTIONS * 3 * 5; i++) {
        thud_world *w = make(detections[i % DETECTIONS], NULL);
        thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
        OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
        add(w, THUD_BODY_STATIC, PLANK, 2, 0, 2, 3, 0.3f);
        thud_body_id player =
            add(w, THUD_BODY_DYNAMIC, PLAYER, i / DETECTIONS % 3, 0, 5, 0.4f, 0.4f);
        throw_up(w, player, 0, -3.0f * (float)(i / (DETECTIONS * 3)));
        steps(w, 200);
        assert_true(fabs(get(w, player).position.y - 2.7) < 0.03);
        thud_world_destroy(w);
    }
}

/* The solid side turns with its body; and a rule holds whichever category is named first. */
static void the_side_is_the_bodys(void **unused) {
    (void)unused;
    for (int reversed = 0; reversed < 2; reversed++) {
        thud_world_def def = weightless();
        thud_world *w = make_world(def);
        thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
        rule.solid_side = (thud_vec2){0, reversed ? -3.0f : 3.0f};
        OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
        thud_shape_def plank = of_kind(PLANK);
        thud_body_id wall = add_body(w, THUD_BODY_STATIC, 0, 0, 1.5707963); /* its top faces -x */
        add_shape(w, wall, 3, 0.1f, false, &plank);
        thud_body_id left = add(w, THUD_BODY_DYNAMIC, PLAYER, 0, -3, 1, 0.3f, 0);
        thud_body_id right = add(w, THUD_BODY_DYNAMIC, PLAYER, 0, 3, -1, 0.3f, 0);
        throw_up(w, left, 4, 0);
        throw_up(w, right, -4, 0);
        steps(w, 120);
        assert_true(reversed ? get(w, left).position.x > 2 : get(w, left).position.x < 0);
        assert_true(reversed ? get(w, right).position.x > 0 : get(w, right).position.x < -2);
        thud_rule read;
        bool set, other_way;
        OK(thud_world_get_rule(w, PLAYER, PLANK, &read, &set, &other_way));
        assert_true(set && other_way && read.kind == THUD_RULE_ONE_WAY);
        OK(thud_world_get_rule(w, PLAYER, GROUND, &read, &set, &other_way));
        assert_true(!set && !other_way && read.kind == THUD_RULE_COLLIDE);
        thud_world_destroy(w);
    }
}

/* A row of planks flush with solid ground is one floor for a body that walks over it, and a wall
 * behind a plank still stops it. */
static void planks_beside_ground(void **unused) {
    (void)unused;
    for (int d = 0; d < DETECTIONS; d++) {
        thud_world *w = make(detections[d], NULL);
        thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
        OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
        for (int i = 0; i < 12; i++) {
            add(w, THUD_BODY_STATIC, i / 3 % 2 ? PLANK : GROUND, 2, i, -0.2, 0.5f, 0.2f);
        }
        add(w, THUD_BODY_STATIC, GROUND, 2, 12.5, 1, 0.5f, 2);
        thud_shape_def smooth = of_kind(PLAYER);
        smooth.friction = 0;
        thud_body_id player = add_body(w, THUD_BODY_DYNAMIC, 0, 0.4, 0);
        add_shape(w, player, 0.4f, 0.4f, true, &smooth);
        steps(w, 5);
        throw_up(w, player, 4, 0);
        for (int i = 0; i < 240; i++) {
            steps(w, 1);
            assert_true(fabs(get(w, player).position.y - 0.4) < 0.02);
        }
        assert_true(fabs(get(w, player).position.x - 11.6) < 0.03);
        thud_world_destroy(w);
    }
}

/* A snapshot taken while a player is inside of a plank continues with the same bits in another
 * world. */
static void passing_goes_through_a_snapshot(void **unused) {
    (void)unused;
    thud_world *w = make(NULL, NULL), *twin = make(NULL, NULL);
    thud_rule rule = rule_of_kind(THUD_RULE_ONE_WAY);
    OK(thud_world_set_rule(w, PLANK, PLAYER, &rule));
    OK(thud_world_set_rule(twin, PLANK, PLAYER, &rule));
    add(w, THUD_BODY_STATIC, PLANK, 2, 0, 2, 3, 0.4f);
    thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, 2, 0, 0, 0.4f, 0.4f);
    throw_up(w, player, 0, 8);
    steps(w, 22); /* it is inside of the plank */
    size_t bytes;
    OK(thud_world_get_snapshot_size(w, &bytes));
    void *snapshot = malloc(bytes);
    OK(thud_world_snapshot(w, snapshot, bytes, &bytes));
    OK(thud_world_restore(twin, snapshot, bytes));
    for (int i = 0; i < 100; i++) {
        assert_true(thud_hash_of(w) == thud_hash_of(twin));
        steps(w, 1);
        steps(twin, 1);
    }
    free(snapshot);
    thud_world_destroy(w);
    thud_world_destroy(twin);
}

/* A body that was held and is then pushed into the plank comes out where it came from, also with a
 * prologue that changes friction, and where an edit makes the pair new. */
static bool grease(thud_world *w, const thud_contact *contact, thud_contact_settings *settings,
                   void *context) {
    (void)w, (void)contact, (void)context;
    settings->friction *= 0.5f;
    return true;
}

static void what_is_held_stays_so_under_a_prologue_and_an_edit(void **unused) {
    (void)unused;
    for (int i = 0; i < 4; i++) {
        thud_world *w = make(NULL, NULL);
        thud_rule one_way = rule_of_kind(THUD_RULE_ONE_WAY);
        OK(thud_world_set_rule(w, PLANK, PLAYER, &one_way));
        thud_body_id plank = add(w, THUD_BODY_STATIC, PLANK, 1, 0, -0.25, 3, 0.25f);
        thud_body_id player = add(w, THUD_BODY_DYNAMIC, PLAYER, 0, 0, 0.5, 0.5f, 0);
        set_listeners(w, i & 1 ? grease : NULL, NULL, NULL);
        steps(w, 30);
        OK(thud_body_set_transform(w, player, (thud_pos){0, 0.4}, 0));
        if (i & 2) {
            thud_shape_id shape;
            int count;
            OK(thud_body_get_shapes(w, plank, &shape, 1, &count));
            OK(thud_shape_set_friction(w, shape, 0.3f));
        }
        steps(w, 60);
        if (fabs(get(w, player).position.y - 0.5) > 0.02) {
            fail_msg("%d: it is at %g", i, get(w, player).position.y);
        }
        thud_world_destroy(w);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planks_are_jumped_through),
        cmocka_unit_test(low_jumps_fall_back),
        cmocka_unit_test(planks_hold_what_falls_fast),
        cmocka_unit_test(the_side_is_the_bodys),
        cmocka_unit_test(planks_beside_ground),
        cmocka_unit_test(passing_goes_through_a_snapshot),
        cmocka_unit_test(what_is_held_stays_so_under_a_prologue_and_an_edit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
