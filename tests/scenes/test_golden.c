/* test_golden.c: every scene's hash after 120 steps equals its row of tests/golden/hashes.txt. A
 * commit that changes a hash says why. A new scene fails this test with the row that it needs;
 * THUD_GOLDEN_UPDATE=1 writes the file anew. */
#include "engine_support.h"

#include "act_thud.h"
#include "build_thud.h"
#include "scenes.h"

#include <inttypes.h>
#include <stdio.h>

enum { ROW_LENGTH = 33 }; /* name, blanks, hash and line end */

static const char path[] = "tests/golden/hashes.txt";

/* A scene's hash after 120 steps; large scenes are built with size 600. */
static uint64_t hash_of(const scene_info *info) {
    scene s;
    thud_world *world;
    int size = info->default_size > 1000 ? 600 : info->default_size;
    assert_true(scenes_fill(info, size, &s));
    OK(scene_build_thud(&s, NULL, &world, NULL, NULL));
    for (int i = 0; i < 120; i++)
        OK(scene_step_thud(&s.fields, world));
    uint64_t hash = thud_hash_of(world);
    thud_world_destroy(world);
    scene_free(&s);
    return hash;
}

/* The row of a scene: its name, blanks, its hash. Null if there is none. */
static const char *row_of(const char *rows, const char *name) {
    size_t length = strlen(name);
    for (const char *row = rows; row; row = strchr(row, '\n')) {
        row += *row == '\n';
        if (strncmp(row, name, length) == 0 && row[length] == ' ')
            return row;
    }
    return NULL;
}

static void scenes_end_as_they_always_did(void **state) {
    (void)state;
    char wanted[8192] = "", now[8192] = "";
    for (int i = 0; i < scenes_count(); i++) {
        size_t used = strlen(now);
        snprintf(now + used, sizeof now - used, "%-16s %016" PRIx64 "\n", scenes_at(i)->name,
                 hash_of(scenes_at(i)));
    }
    if (getenv("THUD_GOLDEN_UPDATE")) {
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        fputs(now, file);
        fclose(file);
        return;
    }
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    wanted[fread(wanted, 1, sizeof wanted - 1, file)] = 0;
    fclose(file);
    for (int i = 0; i < scenes_count(); i++) {
        const char *name = scenes_at(i)->name;
        if (!row_of(wanted, name))
            fail_msg("%s has no row in %s yet. If it runs as it should (thud-run %s), this is its "
                     "row, at the place that it has in thud-run --list:\n%.*s",
                     name, path, name, ROW_LENGTH, row_of(now, name));
    }
    assert_string_equal(now, wanted);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(scenes_end_as_they_always_did)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
