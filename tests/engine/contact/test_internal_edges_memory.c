/* test_internal_edges_memory.c: edits of a tile of the ground while allocations fail: either the
 * whole edit has happened, or nothing has changed, including the covered edges of its
 * neighbours. */
#include "engine_support.h"

#include "hostile_memory.h"

#include <thud/thud_edits.h>
#include <thud/thud_reads.h>
#include <thud/thud_snapshot.h>

/* More than there is room reserved for end events of contacts. */
enum { BALLS = 120 };

typedef thud_result edit(thud_world *world, thud_shape_id middle);

static thud_result becomes_dynamic(thud_world *world, thud_shape_id middle) {
    thud_body_id body;
    OK(thud_shape_get_body(world, middle, &body));
    return thud_body_set_kind(world, body, THUD_BODY_DYNAMIC);
}

static thud_result becomes_sensor(thud_world *world, thud_shape_id middle) {
    return thud_shape_set_sensor(world, middle, true);
}

static thud_result meets_nothing(thud_world *world, thud_shape_id middle) {
    return thud_shape_set_filter(world, middle, (thud_filter){1, 0, 0});
}

/* Three tiles in a row; all the balls lie on the middle one. */
static thud_world *make_ground(thud_shape_id *middle) {
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    thud_world *world = make_world(def);
    for (int i = -1; i <= 1; i++) {
        thud_body_id tile = add_body(world, THUD_BODY_STATIC, i * 0.6 * (BALLS + 2), -1, 0);
        thud_shape_id shape = add_shape(world, tile, 0.3f * (BALLS + 2), 1, true, NULL);
        *middle = i == 0 ? shape : *middle;
    }
    for (int i = 0; i < BALLS; i++) {
        add_shape(world, add_body(world, THUD_BODY_DYNAMIC, 0.6 * (i - 0.5 * (BALLS - 1)), 0.25, 0),
                  0.25f, 0, false, NULL);
    }
    run(world, 3);
    return world;
}

/* A snapshot of the world. */
static void *image_of(const thud_world *world, size_t *bytes) {
    OK(thud_world_get_snapshot_size(world, bytes));
    void *image = malloc(*bytes);
    OK(thud_world_snapshot(world, image, *bytes, NULL));
    return image;
}

static void edit_that_runs_out_of_memory_leaves_the_ground_as_it_was(void **state) {
    (void)state;
    edit *const edits[] = {becomes_dynamic, becomes_sensor, meets_nothing};
    for (size_t k = 0; k < sizeof edits / sizeof *edits; k++) {
        thud_shape_id middle = {0, 0};
        thud_world *world = make_ground(&middle);
        thud_result result = THUD_ERROR_MEMORY;
        int failures = 0;
        while (result != THUD_OK) {
            size_t before_bytes, after_bytes;
            void *before = image_of(world, &before_bytes);
            memory_allowed = failures;
            result = edits[k](world, middle);
            memory_allowed = -1;
            if (result != THUD_OK) {
                void *after = image_of(world, &after_bytes);
                assert_int_equal(result, THUD_ERROR_MEMORY);
                assert_int_equal(before_bytes, after_bytes);
                assert_memory_equal(before, after, before_bytes);
                free(after);
                failures++;
            }
            free(before);
        }
        assert_true(failures >= 1);
        run(world, 1);
        thud_world_destroy(world);
        assert_int_equal(memory_held, 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edit_that_runs_out_of_memory_leaves_the_ground_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
