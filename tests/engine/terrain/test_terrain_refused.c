/* test_terrain_refused.c: terrain edits that are refused (no memory, wrong input, inside a
 * callback) leave everything unchanged. */
#include "terrain_support.h"

#include "hostile_memory.h"

/* The result of edit number `which`. */
static thud_result edit_result(const ground *g, int which) {
    const thud_pos more[] = {{0.1, 1}, {0.2, 2}, {0.3, 1}};
    const double heights[] = {1, 2, 3};
    switch (which) {
    case 0:
        return thud_shape_dig(g->world, g->shape, (thud_pos){0, 0}, 3);
    case 1:
        return thud_shape_raise(g->world, g->shape, 0, 3, 1);
    case 2:
        return thud_shape_replace_range(g->world, g->shape, 0.1, 0.3, more, 3);
    default:
        return thud_shape_set_heights(g->world, g->shape, 7, heights, 3);
    }
}

static void edit_without_memory_leaves_line_and_world_as_they_were(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    thud_body_id box = add_box(g.world, 0, 0.25, 0.25f, 0.25f);
    thud_pos room[ROOM];
    run_to_sleep(&g);
    for (int which = 0; which < 4; which++) {
        int failures = 0;
        for (thud_result result = THUD_ERROR_MEMORY; result != THUD_OK; failures++) {
            thud_terrain old = keep_line(&g, room);
            memory_allowed = failures;
            result = edit_result(&g, which);
            memory_allowed = -1;
            if (result != THUD_OK) {
                assert_int_equal(result, THUD_ERROR_MEMORY);
                line_is(&g, &old);
                run(g.world, 1);
                assert_false(awake(&g, box));
            }
        }
        assert_true(failures > 1 || which == 2);
        run_to_sleep(&g);
    }
    thud_world_destroy(g.world);
}

static int messages;

static void count_message(thud_result result, const char *message, void *context) {
    (void)context;
    assert_true(result != THUD_OK && message[0]);
    messages++;
}

static void edit_with_bad_input_is_refused_with_a_message(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.log = count_message;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    ground u = level_ground(THUD_TERRAIN_UNIFORM, def);
    thud_world *w = g.world;
    thud_shape_id s = g.shape, none = {0, 0};
    thud_terrain slope = {.kind = THUD_TERRAIN_FLAT, .slope = 0.5};
    thud_shape_id flat = add_line(w, g.body, &slope, false);
    thud_shape_id box = add_shape(w, add_body(w, THUD_BODY_STATIC, 0, 9, 0), 1, 1, true, NULL);
    const thud_pos fine[] = {{1, 0}, {2, 0}}, back[] = {{2, 0}, {1, 0}}, twice[] = {{1, 0}, {1, 0}};
    const thud_pos holes[] = {{1, 0}, {1.5, NAN}}, high[] = {{1, 0}, {2, 2e9}};
    const double heights[] = {0, NAN};
    thud_pos room[ROOM];
    thud_terrain old = keep_line(&g, room);
    const struct {
        thud_result got, wanted;
    } calls[] = {
        {thud_shape_dig(NULL, s, (thud_pos){0, 0}, 1), THUD_ERROR_NULL},
        {thud_shape_dig(w, none, (thud_pos){0, 0}, 1), THUD_ERROR_STALE},
        {thud_shape_dig(w, u.shape, (thud_pos){0, 0}, 1), THUD_ERROR_STALE},
        {thud_shape_dig(w, box, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, flat, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){NAN, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, INFINITY}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, -1e9}, 100), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, 0), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, -1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, NAN), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, 16385), THUD_ERROR_INVALID},
        {thud_shape_raise(NULL, s, 0, 1, 1), THUD_ERROR_NULL},
        {thud_shape_raise(w, none, 0, 1, 1), THUD_ERROR_STALE},
        {thud_shape_raise(w, box, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, flat, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, NAN, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 0, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, INFINITY), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, NAN), THUD_ERROR_INVALID},
        {thud_shape_replace_range(NULL, s, 0, 3, fine, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, none, 0, 3, fine, 2), THUD_ERROR_STALE},
        {thud_shape_replace_range(w, box, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, flat, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(u.world, u.shape, 0, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, NULL, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, s, 3, 0, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, NAN, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, fine, -1), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 1.5, 3, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 1.5, fine, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, back, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, twice, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, holes, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, high, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, -INFINITY, INFINITY, fine, 1), THUD_ERROR_INVALID},
        {thud_shape_set_heights(NULL, s, 0, heights, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, NULL, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, heights, 2), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, s, 200, heights, 2), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, s, -1, heights, 1), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, flat, 0, heights, 1), THUD_ERROR_INVALID},
    };
    int wordless = 0; /* without a world there is no log */
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        if (calls[i].got != calls[i].wanted) {
            fail_msg("call %d: %d", (int)i, calls[i].got);
        }
        wordless += calls[i].got == THUD_ERROR_NULL;
    }
    wordless -= 2; /* null points and heights are logged */
    assert_int_equal(messages, (int)(sizeof calls / sizeof *calls) - wordless);
    line_is(&g, &old);
    thud_world_destroy(w);
    thud_world_destroy(u.world);
}

static thud_shape_id to_dig;

static bool dig_inside(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    (void)settings;
    (void)contact;
    *(thud_result *)context = thud_shape_dig(world, to_dig, (thud_pos){0, 0}, 1);
    return true;
}

static void edit_inside_a_callback_is_refused(void **state) {
    (void)state;
    thud_result result = THUD_OK;
    thud_world_def def = thud_default_world_def();
    ground g = level_ground(THUD_TERRAIN_UNIFORM, def);
    to_dig = g.shape;
    set_listeners(g.world, dig_inside, NULL, &result);
    add_ball(g.world, 0, 0.25, 0.25f);
    run(g.world, 2);
    assert_int_equal(result, THUD_ERROR_LOCKED);
    assert_true(height_at(&g, 0) == 0);
    thud_world_destroy(g.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edit_without_memory_leaves_line_and_world_as_they_were),
        cmocka_unit_test(edit_with_bad_input_is_refused_with_a_message),
        cmocka_unit_test(edit_inside_a_callback_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
