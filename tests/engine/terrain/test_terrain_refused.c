/* test_terrain_refused.c: terrain edits that are refused (no memory, wrong input, inside a
 * callback) leave everything unchanged. */
#include "terrain_support.h"

#include "hostile_memory.h"

typedef enum edit { DIG, RAISE, REPLACE_RANGE, SET_HEIGHTS, EDIT_COUNT } edit;

/* Makes a valid edit, and returns its result. */
static thud_result make_edit(const ground *g, edit which) {
    const thud_pos more[] = {{0.1, 1}, {0.2, 2}, {0.3, 1}};
    const double heights[] = {1, 2, 3};
    switch (which) {
    case DIG:
        return thud_shape_dig(g->world, g->shape, (thud_pos){0, 0}, 3);
    case RAISE:
        return thud_shape_raise(g->world, g->shape, 0, 3, 1);
    case REPLACE_RANGE:
        return thud_shape_replace_range(g->world, g->shape, 0.1, 0.3, more, 3);
    case SET_HEIGHTS:
    case EDIT_COUNT:
        break;
    }
    return thud_shape_set_heights(g->world, g->shape, 7, heights, 3);
}

/* Tries each edit with one more successful allocation than before, until it succeeds. While it
 * fails, the line stays as it was, and the box on it stays asleep. */
static void edit_without_memory_changes_neither_terrain_nor_world(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    thud_body_id box = add_box(g.world, 0, 0.25, 0.25f, 0.25f);
    thud_pos points[POINTS_MAX];
    run_to_sleep(&g);
    for (edit which = DIG; which < EDIT_COUNT; which++) {
        int failures = 0;
        for (bool done = false; !done;) {
            thud_terrain old = copy_line(&g, points);
            memory_allowed = failures; /* allocations that succeed before one fails */
            thud_result result = make_edit(&g, which);
            memory_allowed = -1; /* all succeed */
            done = result == THUD_OK;
            if (!done) {
                failures++;
                assert_int_equal(result, THUD_ERROR_MEMORY);
                assert_line_is(&g, &old);
                run(g.world, 1);
                assert_false(awake(&g, box));
            }
        }
        /* Replacing a range copies no points, and the array of the line has room for three more:
         * its capacity doubles as it grows. */
        assert_true(failures > 0 || which == REPLACE_RANGE);
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

/* g: an irregular terrain in the world w, with the shape s; u: a uniform one in another world. Both
 * have 201 points, from x = -50 to 50, at height 0. */
static void edit_with_bad_input_is_refused_with_a_message(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.log = count_message;
    ground g = level_ground(THUD_TERRAIN_IRREGULAR, def);
    ground u = level_ground(THUD_TERRAIN_UNIFORM, def);
    thud_world *w = g.world;
    thud_shape_id s = g.shape, none = {0, 0};
    /* A flat terrain is a straight line without ends, which has no points that an edit could move.
     */
    thud_terrain straight = {.kind = THUD_TERRAIN_FLAT, .slope = 0.5};
    thud_shape_id flat = add_terrain(w, g.body, &straight);
    thud_body_id box_body = add_body(w, THUD_BODY_STATIC, 0, 9, 0);
    thud_shape_id box = add_shape(w, box_body, 1, 1, /* upright: */ true, NULL);
    const thud_pos valid[] = {{1, 0}, {2, 0}}, descending[] = {{2, 0}, {1, 0}};
    const thud_pos same_x[] = {{1, 0}, {1, 0}}, with_nan[] = {{1, 0}, {1.5, NAN}};
    const thud_pos too_high[] = {{1, 0}, {2, 2 * THUD_PLACE_MAX}};
    const double heights[] = {0, NAN};
    thud_pos points[POINTS_MAX];
    thud_terrain old = copy_line(&g, points);
    const struct {
        thud_result got, wanted;
    } calls[] = {
        {thud_shape_dig(NULL, s, (thud_pos){0, 0}, 1), THUD_ERROR_NULL},
        {thud_shape_dig(w, none, (thud_pos){0, 0}, 1), THUD_ERROR_STALE},
        {thud_shape_dig(w, u.shape, (thud_pos){0, 0}, 1), THUD_ERROR_STALE}, /* of another world */
        {thud_shape_dig(w, box, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, flat, (thud_pos){0, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){NAN, 0}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, INFINITY}, 1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, -THUD_PLACE_MAX}, 100),
         THUD_ERROR_INVALID}, /* its bottom would be beyond THUD_PLACE_MAX */
        {thud_shape_dig(w, s, (thud_pos){0, 0}, 0), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, -1), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, NAN), THUD_ERROR_INVALID},
        {thud_shape_dig(w, s, (thud_pos){0, 0}, THUD_SIZE_MAX + 1), THUD_ERROR_INVALID},
        {thud_shape_raise(NULL, s, 0, 1, 1), THUD_ERROR_NULL},
        {thud_shape_raise(w, none, 0, 1, 1), THUD_ERROR_STALE},
        {thud_shape_raise(w, box, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, flat, 0, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, NAN, 1, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 0, 1), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, INFINITY), THUD_ERROR_INVALID},
        {thud_shape_raise(w, s, 0, 1, NAN), THUD_ERROR_INVALID},
        {thud_shape_replace_range(NULL, s, 0, 3, valid, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, none, 0, 3, valid, 2), THUD_ERROR_STALE},
        {thud_shape_replace_range(w, box, 0, 3, valid, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, flat, 0, 3, valid, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(u.world, u.shape, 0, 3, valid, 2),
         THUD_ERROR_INVALID}, /* not irregular */
        {thud_shape_replace_range(w, s, 0, 3, NULL, 2), THUD_ERROR_NULL},
        {thud_shape_replace_range(w, s, 3, 0, valid, 2), THUD_ERROR_INVALID}, /* x0 > x1 */
        {thud_shape_replace_range(w, s, NAN, 3, valid, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, valid, -1), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 1.5, 3, valid, 2),
         THUD_ERROR_INVALID}, /* a point left of x0 */
        {thud_shape_replace_range(w, s, 0, 1.5, valid, 2),
         THUD_ERROR_INVALID}, /* a point right of x1 */
        {thud_shape_replace_range(w, s, 0, 3, descending, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, same_x, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, with_nan, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, 0, 3, too_high, 2), THUD_ERROR_INVALID},
        {thud_shape_replace_range(w, s, -INFINITY, INFINITY, valid, 1),
         THUD_ERROR_INVALID}, /* one point would be left */
        {thud_shape_set_heights(NULL, s, 0, heights, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, NULL, 1), THUD_ERROR_NULL},
        {thud_shape_set_heights(w, s, 0, heights, 2), THUD_ERROR_INVALID},   /* NaN */
        {thud_shape_set_heights(w, s, 200, heights, 2), THUD_ERROR_INVALID}, /* no point 201 */
        {thud_shape_set_heights(w, s, -1, heights, 1), THUD_ERROR_INVALID},
        {thud_shape_set_heights(w, flat, 0, heights, 1), THUD_ERROR_INVALID},
    };
    int unlogged = 0; /* calls without a world, which have no log */
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        if (calls[i].got != calls[i].wanted) {
            fail_msg("call %d: %d", (int)i, calls[i].got);
        }
        unlogged += calls[i].got == THUD_ERROR_NULL;
    }
    unlogged -= 2; /* THUD_ERROR_NULL with a world, for null points and heights, is logged */
    assert_int_equal(messages, (int)(sizeof calls / sizeof *calls) - unlogged);
    assert_line_is(&g, &old);
    thud_world_destroy(w);
    thud_world_destroy(u.world);
}

static thud_shape_id shape_to_dig;

/* A prologue that digs; `context` is where it stores the result (a thud_result). */
static bool dig_in_prologue(thud_world *world, const thud_contact *contact,
                            thud_contact_settings *settings, void *context) {
    (void)settings;
    (void)contact;
    *(thud_result *)context = thud_shape_dig(world, shape_to_dig, (thud_pos){0, 0}, 1);
    return true;
}

static void edit_inside_a_callback_is_refused(void **state) {
    (void)state;
    thud_result result = THUD_OK;
    thud_world_def def = thud_default_world_def();
    ground g = level_ground(THUD_TERRAIN_UNIFORM, def);
    shape_to_dig = g.shape;
    set_listeners(g.world, dig_in_prologue, NULL, &result);
    add_ball(g.world, 0, 0.25, 0.25f);
    run(g.world, 2);
    assert_int_equal(result, THUD_ERROR_LOCKED);
    assert_true(height_at(&g, 0) == 0);
    thud_world_destroy(g.world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edit_without_memory_changes_neither_terrain_nor_world),
        cmocka_unit_test(edit_with_bad_input_is_refused_with_a_message),
        cmocka_unit_test(edit_inside_a_callback_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
