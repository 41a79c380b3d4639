/* test_save.c: a world that is saved to a file and loaded continues with the same bits; a damaged
 * or foreign file is refused and changes nothing, and a failed save leaves the old file. */
#include "snapshot_support.h"

#include "hostile_memory.h"

#include <stdio.h>

#define PATH "test_save.thud"

/* A game's own data, which is saved with the world. */
typedef struct score {
    int lives;
    thud_body_id hero;
} score;

/* The last message of the log. */
static char heard[128];

static void keep(thud_result result, const char *message, void *context) {
    (void)result, (void)context;
    strncpy(heard, message, sizeof heard - 1);
}

static thud_world_def hostile_def(void) {
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    def.log = keep;
    return def;
}

static thud_world *make_heap(score *own) {
    thud_world *world = make_world(hostile_def());
    add_floor(world, NULL);
    for (int i = 0; i < 12; i++) {
        own->hero = add_box(world, 0.3 * (i % 3), 1 + i, 0.5f, 0.5f);
    }
    own->lives = 3;
    run(world, 40);
    return world;
}

static char *read_all(long *bytes) {
    FILE *file = fopen(PATH, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *bytes = ftell(file);
    rewind(file);
    char *all = malloc((size_t)*bytes);
    assert_int_equal(fread(all, 1, (size_t)*bytes, file), *bytes);
    fclose(file);
    return all;
}

static void write_all(const char *from, long bytes) {
    FILE *file = fopen(PATH, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(from, 1, (size_t)bytes, file), bytes);
    fclose(file);
}

static bool is_there(const char *path) {
    FILE *file = fopen(path, "rb");
    if (file) {
        fclose(file);
    }
    return file;
}

static void loaded_world_goes_on_to_the_same_bits(void **state) {
    (void)state;
    score own, back = {0};
    thud_world *world = make_heap(&own), *other = make_world(hostile_def());
    OK(thud_world_save(world, PATH, &own, sizeof own));
    assert_false(is_there(PATH "~"));
    OK(thud_world_load(other, PATH, &back, sizeof back));
    assert_true(back.lives == 3 && thud_body_is_valid(other, back.hero));
    for (int i = 0; i < 60; i++) {
        run(world, 1);
        run(other, 1);
        assert_true(digest_of(world) == digest_of(other));
    }
    OK(thud_world_load(world, PATH, &back, sizeof back)); /* into the same world */
    OK(thud_world_load(other, PATH, &back, sizeof back));
    assert_true(digest_of(world) == digest_of(other));
    OK(thud_world_save(world, PATH, NULL, 0)); /* over the existing file */
    OK(thud_world_load(other, PATH, NULL, 0));
    remove(PATH);
    thud_world_destroy(world);
    thud_world_destroy(other);
    assert_int_equal(memory_held, 0);
}

/* Asserts that the file is refused with a message that contains `word`, and that nothing has
 * changed. */
static void refused(thud_world *world, const char *word) {
    score back = {.lives = -77};
    uint64_t before = digest_of(world);
    long held = memory_held;
    heard[0] = 0;
    assert_int_equal(thud_world_load(world, PATH, &back, sizeof back), THUD_ERROR_INVALID);
    if (!strstr(heard, word)) {
        fail_msg("'%s' does not contain '%s'", heard, word);
    }
    assert_true(back.lives == -77 && digest_of(world) == before && memory_held == held);
}

/* A file with any changed byte, cut short, lengthened, or of another kind of world is refused. */
static void every_damage_is_refused(void **state) {
    (void)state;
    score own;
    long bytes;
    thud_world *world = make_heap(&own);
    OK(thud_world_save(world, PATH, &own, sizeof own));
    char *good = read_all(&bytes), *bad = malloc((size_t)bytes + 8);
    memcpy(bad, good, (size_t)bytes);
    for (long at = 0; at < bytes; at += at < 80 || at > bytes - 40 ? 1 : 61) {
        bad[at] ^= 4;
        write_all(bad, bytes);
        refused(world, at < 8 ? "no file of thud_world_save" : ": ");
        bad[at] ^= 4;
    }
    remove(PATH);
    refused(world, "not there");
    write_all(good, 0);
    refused(world, "no file of thud_world_save");
    write_all(good, 20);
    refused(world, "no file of thud_world_save");
    write_all(good, 100);
    refused(world, "cut short");
    write_all(good, bytes - 1);
    refused(world, "cut short");
    memset(bad + bytes, 0, 8);
    write_all(bad, bytes + 8);
    refused(world, "after it");
    write_all(good, bytes);
    char wider[sizeof(score) + 1];
    assert_int_equal(thud_world_load(world, PATH, wider, sizeof wider), THUD_ERROR_INVALID);
    assert_non_null(strstr(heard, "another number"));
    thud_world_def def = hostile_def();
    def.length_scale = 16;
    thud_world *large = make_world(def);
    assert_int_equal(thud_world_load(large, PATH, &own, sizeof own), THUD_ERROR_INVALID);
    OK(thud_world_load(world, PATH, &own, sizeof own));
    remove(PATH);
    free(good);
    free(bad);
    thud_world_destroy(large);
    thud_world_destroy(world);
}

/* A file whose snapshot is not packed, as thud wrote them before, is loaded; a packed one takes a
 * fraction of its bytes, and needs memory for the snapshot when it is loaded. */
static void files_are_small_and_those_of_before_are_loaded(void **state) {
    (void)state;
    score own, back = {0};
    long bytes;
    thud_world *world = make_heap(&own);
    OK(thud_world_save(world, PATH, &own, sizeof own));
    char *small = read_all(&bytes);
    saved snapshot = save(world);
    assert_true((size_t)bytes * 2 < snapshot.size);
    uint64_t before = digest_of(world);
    run(world, 5);
    memory_allowed = 1;
    assert_int_equal(thud_world_load(world, PATH, &back, sizeof back), THUD_ERROR_MEMORY);
    memory_allowed = -1;
    assert_true(back.lives == 0 && digest_of(world) != before);
    enum { HEAD = 32, WORLD_BYTES_AT = 8 };
    size_t size = HEAD + snapshot.size + sizeof own;
    uint64_t world_bytes = snapshot.size;
    char *whole = malloc(size);
    memcpy(whole, small, HEAD);
    memcpy(whole + WORLD_BYTES_AT, &world_bytes, sizeof world_bytes);
    memcpy(whole + HEAD, snapshot.bytes, snapshot.size);
    memcpy(whole + HEAD + snapshot.size, &own, sizeof own);
    write_all(whole, (long)size);
    OK(thud_world_load(world, PATH, &back, sizeof back));
    assert_true(back.lives == own.lives && digest_of(world) == before);
    remove(PATH);
    free(small);
    free(snapshot.bytes);
    free(whole);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

/* A save that fails for a wrong path or for memory leaves the old file, and the world,
 * unchanged. */
static void failed_save_leaves_the_file_as_it_was(void **state) {
    (void)state;
    score own;
    long bytes, after;
    thud_world *world = make_heap(&own);
    assert_int_equal(thud_world_save(world, "no such folder/" PATH, NULL, 0), THUD_ERROR_INVALID);
    assert_int_equal(thud_world_save(world, ".", NULL, 0), THUD_ERROR_INVALID);
    assert_false(is_there(".~"));
    OK(thud_world_save(world, PATH, &own, sizeof own));
    char *good = read_all(&bytes);
    run(world, 5);
    uint64_t before = digest_of(world);
    memory_allowed = 0;
    assert_int_equal(thud_world_save(world, PATH, &own, sizeof own), THUD_ERROR_MEMORY);
    memory_allowed = 0;
    assert_int_equal(thud_world_load(world, PATH, &own, sizeof own), THUD_ERROR_MEMORY);
    memory_allowed = -1;
    assert_true(digest_of(world) == before);
    assert_int_equal(thud_world_save(world, PATH, &own, SIZE_MAX - 8), THUD_ERROR_MEMORY);
    char *same = read_all(&after);
    assert_true(after == bytes && memcmp(good, same, (size_t)bytes) == 0);
    remove(PATH);
    free(good);
    free(same);
    thud_world_destroy(world);
    assert_int_equal(memory_held, 0);
}

static void null_is_refused(void **state) {
    (void)state;
    score own;
    thud_world *world = make_heap(&own);
    assert_int_equal(thud_world_save(NULL, PATH, &own, 1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_save(world, NULL, &own, 1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_save(world, PATH, NULL, 1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_load(NULL, PATH, &own, 1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_load(world, NULL, &own, 1), THUD_ERROR_NULL);
    assert_int_equal(thud_world_load(world, PATH, NULL, 1), THUD_ERROR_NULL);
    assert_false(is_there(PATH));
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loaded_world_goes_on_to_the_same_bits),
        cmocka_unit_test(every_damage_is_refused),
        cmocka_unit_test(files_are_small_and_those_of_before_are_loaded),
        cmocka_unit_test(failed_save_leaves_the_file_as_it_was),
        cmocka_unit_test(null_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
