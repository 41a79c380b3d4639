/* test_memory.c: failed allocations leave the world unchanged, and a settled step makes none. */
#include "engine_support.h"

#include "hostile_memory.h"

#include "base/memory.h"
#include "build_thud.h"
#include "scenes.h"

#if defined(__linux__)
#include <sys/resource.h>
#endif

static thud_world *build(const char *name, int size) {
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    memory_allowed = -1;
    assert_true(scenes_fill(scenes_find(name), size, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    scene_free(&s);
    return world;
}

/* Fails the first allocation of a step, then the second, until the step succeeds; returns how many
 * attempts failed. */
static long step_with_failures(thud_world *world) {
    for (long failures = 0;; failures++) {
        uint64_t before = thud_hash_of(world);
        memory_allowed = failures;
        thud_result result = thud_world_step(world);
        memory_allowed = -1;
        if (result == THUD_OK) {
            return failures;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
        assert_true(thud_hash_of(world) == before);
    }
}

/* A step that succeeds after failed attempts ends with the hash and events of a world whose memory
 * never fails. */
static void step_after_failed_ones_is_the_same_step(void **state) {
    (void)state;
    const struct {
        const char *name;
        int size;
    } scenes[] = {{"tall_stack", 30}, {"tumbler_half", 100}, {"mixed_terrain", 200},
                  {"bullets", 15},    {"asleep", 60},        {"one_spot", 150}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        thud_world *never = build(scenes[i].name, scenes[i].size);
        thud_world *often = build(scenes[i].name, scenes[i].size);
        long failures = 0;
        for (int k = 0; k < 120; k++) {
            run(never, 1);
            failures += step_with_failures(often);
            if (thud_hash_of(never) != thud_hash_of(often)) {
                fail_msg("%s: differs at step %d", scenes[i].name, k);
            }
            thud_events e = thud_events_of(never), f = thud_events_of(often);
            assert_int_equal(e.begin_count, f.begin_count);
            assert_int_equal(e.end_count, f.end_count);
        }
        assert_true(failures > 5);
        thud_world_destroy(never);
        thud_world_destroy(often);
    }
    assert_int_equal(memory_held, 0);
}

/* Creating a world, body or shape that fails for memory changes no count and leaves no block. */
static void creation_that_fails_leaves_nothing_behind(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    thud_world *world = NULL;
    for (long n = 0;; n++) {
        memory_allowed = n;
        thud_result result = thud_world_create(&def, &world);
        memory_allowed = -1;
        if (result == THUD_OK) {
            break;
        }
        assert_int_equal(result, THUD_ERROR_MEMORY);
        assert_int_equal(memory_held, 0);
    }
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id id;
    int refused = 0;
    for (int made = 0; made < 300;) {
        memory_allowed = 0;
        thud_stats before = thud_stats_of(world);
        thud_result result = thud_body_create(world, &body, &id);
        if (result != THUD_OK) {
            assert_int_equal(thud_stats_of(world).bodies, before.bodies);
            refused++;
            memory_allowed = -1;
            OK(thud_body_create(world, &body, &id));
        }
        memory_allowed = 0;
        result = thud_shape_create_circle(world, id, &shape, (thud_vec2){0, 0}, 1, NULL);
        if (result != THUD_OK) {
            assert_int_equal(thud_stats_of(world).shapes, before.shapes);
            refused++;
            memory_allowed = -1;
            OK(thud_shape_create_circle(world, id, &shape, (thud_vec2){0, 0}, 1, NULL));
        }
        made++;
    }
    memory_allowed = -1;
    assert_true(refused > 5);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

static void settled_world_allocates_nothing(void **state) {
    (void)state;
    const char *const names[] = {"tall_stack", "platformer", "tumbler"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        thud_world *world = build(names[i], 30);
        run(world, 400);
        for (int k = 0; k < 100; k++) {
            run(world, 1);
            assert_int_equal(thud_stats_of(world).step_allocations, 0);
        }
        thud_world_destroy(world);
    }
}

/* Reserved memory must not be written before it is used: in a step in which arrays grow, each page
 * that is written costs a page fault. */
static void room_that_nothing_is_in_touches_no_page(void **state) {
    (void)state;
#if defined(__linux__)
    enum { BYTES = 64 << 20, PAGE = 4096 };
    struct rusage before, after;
    td_memory memory = td_memory_make((thud_allocator){0});
    td_array array = {.stride = 64};
    assert_int_equal(getrusage(RUSAGE_SELF, &before), 0);
    assert_true(td_array_reserve(&memory, &array, BYTES / 64));
    assert_int_equal(getrusage(RUSAGE_SELF, &after), 0);
    long faults = after.ru_minflt - before.ru_minflt;
    print_message("%ld page faults for %d MB of room\n", faults, BYTES >> 20);
    assert_true(faults < BYTES / PAGE / 4); /* a sanitizer causes some for its own records */
    for (int i = 0; i < BYTES; i += PAGE) {
        assert_int_equal(((char *)array.data)[i], 0);
    }
    td_array_free(&memory, &array);
    assert_int_equal(memory.bytes, 0);
#else
    skip(); /* other systems do not count page faults in this way */
#endif
}

/* Blocks of all sizes are zeroed and aligned to 64 bytes, also where they were used before. */
static void rooms_of_all_sizes_are_zeroed_and_begin_a_cache_line(void **state) {
    (void)state;
    enum { ROOMS = 200 };
    td_memory memory = td_memory_make((thud_allocator){0});
    for (int round = 0; round < 3;
         round++) { /* released blocks are used again, and were written to */
        char *rooms[ROOMS];
        for (int i = 0; i < ROOMS; i++) {
            size_t bytes = (size_t)(1 + i * i * 7);
            rooms[i] = td_memory_get(&memory, bytes);
            assert_non_null(rooms[i]);
            assert_int_equal((uintptr_t)rooms[i] % 64, 0);
            for (size_t k = 0; k < bytes; k++) {
                assert_true(rooms[i][k] == 0);
            }
            memset(rooms[i], 0xff, bytes);
        }
        for (int i = 0; i < ROOMS; i++) {
            td_memory_put(&memory, rooms[i], (size_t)(1 + i * i * 7));
        }
    }
    assert_int_equal(memory.bytes, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(step_after_failed_ones_is_the_same_step),
        cmocka_unit_test(creation_that_fails_leaves_nothing_behind),
        cmocka_unit_test(settled_world_allocates_nothing),
        cmocka_unit_test(room_that_nothing_is_in_touches_no_page),
        cmocka_unit_test(rooms_of_all_sizes_are_zeroed_and_begin_a_cache_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
