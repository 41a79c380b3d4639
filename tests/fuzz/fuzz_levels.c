/* fuzz_levels.c: a fuzz target for maps of the Tiled editor, as JSON and as XML, and the files that
 * they refer to. The reader has to refuse a map, or to give a scene of finite numbers that the
 * engine accepts and steps.
 *
 * An input is a map; or a first line "@PATH MAP" and the text of the file PATH, which the map MAP
 * refers to: "@tiles/ground.tsx shapes.tmx" and then the text of ground.tsx. */
#include "build_thud.h"
#include "level.h"
#include "progress.h"
#include "session.h"
#include "target.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAPS "tests/levels/maps/"
enum { NAME = 64 };

/* The folder of maps, in which the input replaces one file. */
typedef struct folder {
    char replaced[NAME];
    const char *text;
    size_t length;
} folder;

static char *read_file(const char *name, size_t *length) {
    char path[2 * NAME + sizeof MAPS];
    enum { LARGEST = 1 << 17 };
    snprintf(path, sizeof path, "%s%s", MAPS, name);
    FILE *file = fopen(path, "rb");
    if (!file) {
        return NULL;
    }
    char *text = malloc(LARGEST);
    *length = fread(text, 1, LARGEST, file);
    fclose(file);
    return text;
}

/* Opens a file for the map reader. Null for paths that lead out of the maps' folder. */
static char *open_file(void *context, const char *path, size_t *length) {
    const folder *f = context;
    if (strcmp(path, f->replaced) == 0) {
        char *copy = malloc(f->length + 1);
        memcpy(copy, f->text, f->length);
        *length = f->length;
        return copy;
    }
    return strstr(path, "..") || strlen(path) > NAME ? NULL : read_file(path, length);
}

static void fail(const char *what) {
    fprintf(stderr, "FINDING: %s\n", what);
    abort();
}

static void check_scene(const scene *s) {
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (!isfinite(b->x) || !isfinite(b->y) || !isfinite(b->angle) ||
            (b->shape_count <= 0 && b->kind != SCENE_STATIC)) {
            fail("a body of a level is not finite, or moves without a shape");
        }
    }
    for (int i = 0; i < s->shape_count; i++) {
        const scene_shape *shape = &s->shapes[i];
        if (!isfinite(shape->x) || !isfinite(shape->y) || !isfinite(shape->angle) ||
            !(shape->hx >= 0 && shape->hx < 1e9 && shape->hy >= 0 && shape->hy < 1e9)) {
            fail("a shape of a level is not finite");
        }
        for (int k = 1; k < shape->point_count; k++) {
            const scene_point *p = &s->points[shape->first_point + k];
            if (!(p->x > p[-1].x) || !isfinite(p->y)) {
                fail("a line of a level does not go to the right");
            }
        }
    }
}

/* Creates the scene's world and makes three steps. Scenes of more than 300 bodies are left out, to
 * save time. */
static void step_scene(const scene *s) {
    enum { MOST = 300 };
    thud_world_def def = thud_default_world_def();
    thud_world *world = NULL;
    if (s->body_count == 0 || s->body_count > MOST) {
        return;
    }
    thud_body_id *ids = malloc((size_t)s->body_count * sizeof *ids);
    fuzz_calls_made += (uint64_t)(s->body_count + s->shape_count + s->joint_count + 4);
    int refused = -1;
    thud_result result = scene_build_thud(s, &def, &world, ids, &refused);
    if (result != THUD_OK && refused < 0) {
        fail("a joint that was read is refused"); /* a body that is too far from the origin may have
                                                     been refused */
    }
    if (result == THUD_OK) {
        for (int i = 0; i < 3; i++) {
            if (thud_world_step(world) != THUD_OK) {
                fail("a level does not step");
            }
        }
        if (!isfinite(thud_measure_of(world).potential_energy)) {
            fail("a level is not finite");
        }
        thud_world_destroy(world);
    }
    free(ids);
}

/* Reads the line that names the file, if there is one. Returns the text of its map, and null if the
 * whole input is a map. */
static char *take_head(folder *f, size_t *length) {
    char map[NAME];
    const char *end = memchr(f->text, '\n', f->length);
    char line[2 * NAME] = "";
    if (!end || f->text[0] != '@' || end - f->text >= (long)sizeof line) {
        return NULL;
    }
    memcpy(line, f->text, (size_t)(end - f->text));
    if (sscanf(line, "@%63s %63s", f->replaced, map) != 2 || strstr(map, "..")) {
        f->replaced[0] = 0;
        return NULL;
    }
    f->length -= (size_t)(end + 1 - f->text);
    f->text = end + 1;
    return read_file(map, length);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    folder f = {.text = (const char *)data, .length = size};
    size_t of_map = 0;
    char *map = take_head(&f, &of_map);
    size_t length = map ? of_map : f.length;
    level_opener opener = {.open = open_file, .context = &f};
    scene s;
    level_report report;
    fuzz_calls_made++;
    if (level_read_with("m", map ? map : f.text, length, &opener, true, &s, &report)) {
        check_scene(&s);
        step_scene(&s);
    } else if (report.fatal <= 0 || report.count <= 0 || s.body_count != 0) {
        fail("a level is refused without a word, or in part");
    }
    scene_free(&s);
    level_report_free(&report);
    free(map);
    progress_tell();
    return 0;
}
