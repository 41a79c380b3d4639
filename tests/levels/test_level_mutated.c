/* test_level_mutated.c: reads maps of all formats, and the files that they refer to, with bytes
 * changed, removed or doubled: the reader has to refuse them, or to return numbers that the engine
 * accepts; sanitizers check memory accesses. THUD_MUTATIONS sets the number of attempts. */
#include "build_thud.h"
#include "level.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

typedef struct text_file {
    const char *path;
    char *text;
    size_t length;
} text_file;

static text_file files[] = {
    {"shapes.tmj", NULL, 0},         {"shapes.tmx", NULL, 0},       {"hills.tmj", NULL, 0},
    {"hills.tmx", NULL, 0},          {"props.tmj", NULL, 0},        {"props.tmx", NULL, 0},
    {"infinite.tmj", NULL, 0},       {"infinite.tmx", NULL, 0},     {"unmarked.tmj", NULL, 0},
    {"unmarked.tmx", NULL, 0},       {"wrong.tmj", NULL, 0},        {"wrong.tmx", NULL, 0},
    {"joints.tmj", NULL, 0},         {"joints.tmx", NULL, 0},       {"loose.tmj", NULL, 0},
    {"loose.tmx", NULL, 0},          {"csv.tmx", NULL, 0},          {"base64.tmj", NULL, 0},
    {"gzip.tmx", NULL, 0},           {"zlib.tmj", NULL, 0},         {"zstd.tmj", NULL, 0},
    {"tiles/ground.tsx", NULL, 0},   {"tiles/things.tsj", NULL, 0}, {"templates/crate.tx", NULL, 0},
    {"templates/plank.tj", NULL, 0},
};
enum { FILES = sizeof files / sizeof files[0], MAPS = 21 };

static int read_files(void **state) {
    (void)state;
    for (int i = 0; i < FILES; i++) {
        char path[64];
        snprintf(path, sizeof path, "tests/levels/maps/%s", files[i].path);
        FILE *file = fopen(path, "rb");
        if (!file)
            return -1;
        files[i].text = malloc(1 << 16);
        files[i].length = fread(files[i].text, 1, 1 << 16, file);
        fclose(file);
    }
    return 0;
}

static int free_files(void **state) {
    (void)state;
    for (int i = 0; i < FILES; i++)
        free(files[i].text);
    return 0;
}

static uint32_t random_state = 1;

static uint32_t random_below(size_t count) {
    random_state = random_state * 1664525u + 1013904223u;
    return (uint32_t)((random_state >> 8) % count);
}

/* A mutated copy, in a block of exactly its length. */
static text_file mutate(const text_file *file) {
    static const char REPLACEMENTS[] = "0129-.eE\"{}[],:xt\\<>/=&;'!A+\0\xff";
    size_t length = file->length, at = random_below(length);
    char *text = malloc(2 * length);
    memcpy(text, file->text, length);
    size_t size = 1 + random_below(1 + length / 8);
    if (size > length - at)
        size = length - at;
    uint32_t way = random_below(4);
    if (way == 0) { /* removes a piece */
        memmove(text + at, text + at + size, length - at - size);
        length -= size;
    } else if (way == 1) { /* doubles a piece */
        memcpy(text + at + size, file->text + at, length - at);
        length += size;
    } else {
        for (uint32_t i = 0; i < way; i++)
            text[random_below(length)] = REPLACEMENTS[random_below(sizeof REPLACEMENTS - 1)];
    }
    char *exact = malloc(length + (length == 0));
    memcpy(exact, text, length);
    free(text);
    return (text_file){file->path, exact, length};
}

/* Opens a file of the maps' folder, of which one is replaced by the mutated copy. */
static char *open_mutated(void *context, const char *path, size_t *length) {
    const text_file *mutated = context;
    const text_file *found = strcmp(path, mutated->path) == 0 ? mutated : NULL;
    for (int i = 0; i < FILES && !found; i++)
        if (strcmp(path, files[i].path) == 0)
            found = &files[i];
    if (!found)
        return NULL;
    char *copy = malloc(found->length + 1);
    memcpy(copy, found->text, found->length);
    *length = found->length;
    return copy;
}

static bool is_finite(double value) {
    return value - value == 0;
}

static void check_scene(const scene *s) {
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        assert_true(is_finite(b->x) && is_finite(b->y) && is_finite(b->angle));
        assert_true(b->shape_count > 0 || b->kind == SCENE_STATIC);
    }
    for (int i = 0; i < s->shape_count; i++) {
        const scene_shape *shape = &s->shapes[i];
        assert_true(is_finite(shape->x) && is_finite(shape->y) && is_finite(shape->angle));
        assert_true(shape->hx >= 0 && shape->hx < 1e9 && shape->hy >= 0 && shape->hy < 1e9);
        for (int k = 1; k < shape->point_count; k++) {
            const scene_point *p = &s->points[shape->first_point + k];
            assert_true(p->x > p[-1].x && is_finite(p->y));
        }
    }
}

/* The engine accepts all joints that the reader returns; bodies may be refused because they are too
 * far from the origin. */
static void check_joints(const scene *s) {
    for (int i = 0; i < s->joint_count; i++) {
        const scene_joint *joint = &s->joints[i];
        int most = joint->kind == SCENE_GEAR ? i : s->body_count;
        for (int side = 0; side < 2; side++) {
            assert_true(joint->body[side] >= 0 && joint->body[side] < most);
            assert_true(is_finite(joint->x[side]) && is_finite(joint->y[side]) &&
                        is_finite(joint->angle[side]));
        }
    }
    if (s->joint_count > 0) {
        thud_world *world = NULL;
        int failed = -1;
        thud_result result = scene_build_thud(s, NULL, &world, NULL, &failed);
        assert_true(result == THUD_OK || failed >= 0);
        if (result == THUD_OK)
            assert_int_equal(thud_world_step(world), THUD_OK);
        thud_world_destroy(world);
    }
}

static void map_or_its_files_with_something_wrong_are_refused_or_finite(void **state) {
    (void)state;
    const char *wanted = getenv("THUD_MUTATIONS");
    int rounds = wanted ? atoi(wanted) : 4000, read = 0, refused = 0;
    for (int round = 0; round < rounds; round++) {
        const text_file *map = &files[random_below(MAPS)];
        bool of_map = random_below(2) == 0;
        text_file mutated = mutate(of_map ? map : &files[MAPS + random_below(FILES - MAPS)]);
        level_opener opener = {.open = open_mutated, .context = &mutated};
        const text_file *content = of_map ? &mutated : map;
        scene s;
        level_report report;
        if (level_read_with("m", content->text, content->length, &opener, true, &s, &report)) {
            check_scene(&s);
            check_joints(&s);
            read++;
        } else {
            assert_true(report.fatal > 0 && report.count > 0);
            assert_int_equal(s.body_count, 0);
            refused++;
        }
        scene_free(&s);
        level_report_free(&report);
        free(mutated.text);
    }
    assert_true(read > rounds / 10 && refused > rounds / 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(map_or_its_files_with_something_wrong_are_refused_or_finite,
                                        read_files, free_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
