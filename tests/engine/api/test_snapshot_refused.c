/* test_snapshot_refused.c: snapshots that are damaged, forged or of another kind of world are
 * refused with a message in the log, and the world continues as if nothing had been called. */
#include "refused_snapshot.h"

#include "hostile_memory.h"

#include "api/snapshot.h"

static double no_clock(void *context) {
    (void)context;
    return 0;
}

/* A yard after 30 steps, a snapshot of it, and its digests in the 20 steps after. */
typedef struct ready {
    yard y;
    saved snapshot;
    trail next;
} ready;

static ready make_ready(const thud_world_def *def) {
    ready r = {.y = make_yard(def)};
    run(r.y.world, 30);
    r.snapshot = save(r.y.world);
    r.next = walk(r.y.world, 20);
    back_to(r.y.world, r.snapshot);
    return r;
}

static void end(ready *r) {
    thud_world_destroy(r->y.world);
    free(r->snapshot.bytes);
}

static void flipped_bit_anywhere_is_refused(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    for (size_t i = 0; i < r.snapshot.size; i++) {
        char bit = (char)(1 << i % 8);
        r.snapshot.bytes[i] ^= bit;
        assert_int_equal(thud_world_restore(r.y.world, r.snapshot.bytes, r.snapshot.size),
                         THUD_ERROR_INVALID);
        r.snapshot.bytes[i] ^= bit;
    }
    walks_again(r.y.world, &r.next, "flipped");
    end(&r);
}

static void overwritten_and_swapped_bytes_are_refused(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    char *copy = malloc(r.snapshot.size);
    uint64_t seed = 42;
    for (int round = 0; round < 2000; round++) {
        memcpy(copy, r.snapshot.bytes, r.snapshot.size);
        size_t from = (size_t)random_in(&seed, 0, (double)r.snapshot.size - 1);
        size_t count = (size_t)random_in(&seed, 1, (double)(r.snapshot.size - from));
        for (size_t i = from; i < from + count; i++) {
            copy[i] = round % 2 ? (char)(unsigned char)random_in(&seed, 0, 255)
                                : r.snapshot.bytes[r.snapshot.size - 1 - i];
        }
        if (memcmp(copy, r.snapshot.bytes, r.snapshot.size) != 0) {
            assert_int_equal(thud_world_restore(r.y.world, copy, r.snapshot.size),
                             THUD_ERROR_INVALID);
        }
    }
    walks_again(r.y.world, &r.next, "overwritten");
    free(copy);
    end(&r);
}

static void cut_or_lengthened_snapshot_is_refused(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    for (size_t size = 0; size < r.snapshot.size; size += size < 2000 ? 1 : 97) {
        /* a block of its own, so that a sanitizer detects a read beyond its end */
        char *part = malloc(size + 1);
        memcpy(part, r.snapshot.bytes, size);
        assert_int_equal(thud_world_restore(r.y.world, part, size), THUD_ERROR_INVALID);
        free(part);
    }
    char *longer = calloc(1, r.snapshot.size + 64);
    memcpy(longer, r.snapshot.bytes, r.snapshot.size);
    refused(r.y.world, longer, r.snapshot.size + 64, "something after it");
    refused(r.y.world, longer, 10, "too short");
    refused(r.y.world, longer, r.snapshot.size - 1, "cut short");
    longer[0] = 'T';
    refused(r.y.world, longer, r.snapshot.size, "no snapshot");
    longer[0] = 't';
    longer[r.snapshot.size - 1] ^= 1;
    refused(r.y.world, longer, r.snapshot.size, "damaged");
    free(longer);
    end(&r);
}

static void snapshot_of_another_scale_or_broadphase_is_refused(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    thud_world_def larger = def, swept = def;
    larger.length_scale = 100;
    swept.broadphase = &thud_broadphase_sweep;
    thud_world *others[] = {make_world(larger), make_world(swept)};
    refused(others[0], r.snapshot.bytes, r.snapshot.size, "length scale");
    refused(others[1], r.snapshot.bytes, r.snapshot.size, "broadphase");
    thud_world_destroy(others[0]);
    thud_world_destroy(others[1]);
    end(&r);
}

/* Each of these settings decides what later steps do, so it has to agree. */
static void snapshot_of_a_world_of_other_settings_is_refused(void **state) {
    (void)state;
    enum { KINDS = 10 };
    thud_world_def def = telling();
    ready r = make_ready(&def);
    for (int i = 0; i < KINDS; i++) {
        thud_world_def other = def;
        other.clock = i == 9 ? no_clock : NULL;
        other.substeps = i == 0 ? 7 : 0;
        other.contact_stiffness = i == 1 ? 0.2f : 0;
        other.contact_damping = i == 2 ? 3 : 0;
        other.push_speed = i == 3 ? 2 : def.push_speed;
        other.restitution_threshold = i == 4 ? 2 : def.restitution_threshold;
        other.hit_speed = i == 5 ? 2 : def.hit_speed;
        other.maximum_speed = i == 6 ? 100 : def.maximum_speed;
        other.contact_events = i != 7;
        other.detection = i == 8 ? &thud_detection_swept : NULL;
        other.time_budget = i == 9 ? 0.01 : 0;
        thud_world *world = make_world(other);
        refused(world, r.snapshot.bytes, r.snapshot.size, "other settings");
        thud_world_destroy(world);
    }
    walks_again(r.y.world, &r.next, "other settings");
    end(&r);
}

/* A snapshot head with changed counts and a valid checksum. */
static void forged_counts_are_refused_or_do_no_harm(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    td_snapshot_head head;
    memcpy(&head, r.snapshot.bytes, sizeof head);
    const int32_t values[] = {-1, 0, 1, 7, 100, 1000, 100000, INT32_MAX / 16, INT32_MAX};
    size_t from = offsetof(td_snapshot_head, detection), refusals = 0, all = 0;
    for (size_t at = from; at + sizeof(int32_t) <= sizeof head; at += sizeof(int32_t)) {
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            int32_t old;
            memcpy(&old, r.snapshot.bytes + at, sizeof old);
            if (old == values[i]) {
                continue;
            }
            char *forged = malloc(r.snapshot.size);
            memcpy(forged, r.snapshot.bytes, r.snapshot.size);
            memcpy(forged + at, &values[i], sizeof values[i]);
            size_t summed = offsetof(td_snapshot_head, bytes);
            uint64_t sum = td_snapshot_checksum(forged + summed, r.snapshot.size - summed);
            memcpy(forged + offsetof(td_snapshot_head, checksum), &sum, sizeof sum);
            thud_world *world = make_world(def);
            refusals += thud_world_restore(world, forged, r.snapshot.size) != THUD_OK;
            all++;
            thud_world_destroy(world);
            free(forged);
        }
    }
    print_message("%zu of %zu refused\n", refusals, all);
    assert_true(refusals * 10 > all * 8);
    end(&r);
}

static void null_and_small_buffer_are_refused(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    size_t bytes = 7;
    char *before = malloc(r.snapshot.size);
    memcpy(before, r.snapshot.bytes, r.snapshot.size);
    assert_int_equal(thud_world_get_snapshot_size(NULL, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_world_get_snapshot_size(r.y.world, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_world_snapshot(NULL, before, 9, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_world_snapshot(r.y.world, NULL, 9, &bytes), THUD_ERROR_NULL);
    assert_int_equal(thud_world_restore(NULL, before, 9), THUD_ERROR_NULL);
    assert_int_equal(thud_world_restore(r.y.world, NULL, 9), THUD_ERROR_NULL);
    run(r.y.world, 1);
    OK(thud_world_get_snapshot_size(r.y.world, &bytes));
    assert_int_equal(thud_world_snapshot(r.y.world, before, bytes - 1, NULL), THUD_ERROR_INVALID);
    assert_memory_equal(before, r.snapshot.bytes, r.snapshot.size);
    free(before);
    end(&r);
}

/* The context of a prologue that tries snapshot calls. */
typedef struct inside {
    saved snapshot;
    int asked;
} inside;

/* A prologue in which snapshot calls are refused. */
static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    (void)contact;
    (void)settings;
    inside *i = context;
    size_t bytes;
    assert_int_equal(thud_world_get_snapshot_size(world, &bytes), THUD_ERROR_LOCKED);
    if (i->snapshot.bytes) {
        assert_int_equal(thud_world_snapshot(world, i->snapshot.bytes, i->snapshot.size, &bytes),
                         THUD_ERROR_LOCKED);
        assert_int_equal(thud_world_restore(world, i->snapshot.bytes, i->snapshot.size),
                         THUD_ERROR_LOCKED);
        i->asked++;
    }
    return true;
}

static void callback_is_refused(void **state) {
    (void)state;
    inside i = {.asked = 0};
    thud_world_def def = telling();
    yard y = make_yard(&def);
    set_listeners(y.world, ask, NULL, &i);
    run(y.world, 60);
    i.snapshot = save(y.world);
    run(y.world, 1);
    assert_true(i.asked > 0);
    thud_world_destroy(y.world);
    free(i.snapshot.bytes);
}

/* A world with little in it, or one with a terrain in the slot in which the snapshot has its
 * own. */
static thud_world *small_world(const thud_world_def *def, bool had_line) {
    if (!had_line) {
        thud_world *world = make_world(*def);
        add_ball(world, 0, 0, 1);
        return world;
    }
    yard y = make_yard(def);
    thud_shape_state ground;
    OK(thud_shape_get_state(y.world, y.ground, &ground));
    OK(thud_body_destroy(y.world, ground.body));
    run(y.world, 1);
    return y.world;
}

static void restore_without_memory_leaves_the_world_as_it_was(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    def.allocator = hostile_memory();
    memory_held = 0;
    for (int had_line = 0; had_line < 2; had_line++) {
        thud_result result = THUD_ERROR_MEMORY;
        long allowed = 0;
        for (; result != THUD_OK; allowed++) {
            thud_world *world = small_world(&def, had_line);
            saved before = save(world);
            memory_allowed = allowed;
            result = thud_world_restore(world, r.snapshot.bytes, r.snapshot.size);
            memory_allowed = -1;
            if (result == THUD_OK) {
                walks_again(world, &r.next, "with memory");
            } else {
                assert_int_equal(result, THUD_ERROR_MEMORY);
                assert_string_equal(told, "restore: out of memory");
                trail own = walk(world, 10);
                back_to(world, before);
                walks_again(world, &own, "in want of memory");
            }
            thud_world_destroy(world);
            free(before.bytes);
            assert_int_equal(memory_held, 0);
        }
        assert_true(allowed > (had_line ? 1 : 20));
    }
    end(&r);
}

static void restoring_again_and_again_takes_no_more_memory(void **state) {
    (void)state;
    thud_world_def def = telling();
    ready r = make_ready(&def);
    uint64_t allocated = 0;
    for (int i = 0; i < 50; i++) {
        OK(thud_shape_dig(r.y.world, r.y.ground, (thud_pos){5, 0.5}, 1.5));
        for (int k = 0; k < 40; k++) {
            add_ball(r.y.world, k - 20, 20, 0.3f);
        }
        run(r.y.world, 3);
        back_to(r.y.world, r.snapshot);
        uint64_t now = thud_stats_of(r.y.world).bytes;
        assert_true(i < 2 || now == allocated);
        allocated = now;
    }
    walks_again(r.y.world, &r.next, "again and again");
    end(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flipped_bit_anywhere_is_refused),
        cmocka_unit_test(overwritten_and_swapped_bytes_are_refused),
        cmocka_unit_test(cut_or_lengthened_snapshot_is_refused),
        cmocka_unit_test(snapshot_of_another_scale_or_broadphase_is_refused),
        cmocka_unit_test(snapshot_of_a_world_of_other_settings_is_refused),
        cmocka_unit_test(forged_counts_are_refused_or_do_no_harm),
        cmocka_unit_test(null_and_small_buffer_are_refused),
        cmocka_unit_test(callback_is_refused),
        cmocka_unit_test(restore_without_memory_leaves_the_world_as_it_was),
        cmocka_unit_test(restoring_again_and_again_takes_no_more_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
