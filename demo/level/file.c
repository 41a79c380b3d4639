/* file.c: access to files for the level reader, which makes a scene of a level's map: reads the
 * map, and the files that it refers to. */
#include "reader.h"
#include "whole_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Max size of a file that is read, bytes. Chosen, far above the size of any real map. A map can
 * name any file as its tileset. */
enum { FILE_BYTES_MAX = 1 << 28 };

/* The part of a path after the last slash or backslash. */
static const char *last_part(const char *path) {
    const char *base = path;
    for (const char *p = path; *p; p++)
        if (*p == '/' || *p == '\\')
            base = p + 1;
    return base;
}

/* Opens a file by its path from the map's folder: level_opener.open, with the map's own path as the
 * context. */
static char *open_beside(void *context, const char *path, size_t *length) {
    const char *map = context;
    size_t folder = (size_t)(last_part(map) - map);
    char *whole = malloc(folder + strlen(path) + 1);
    if (!whole)
        return NULL;
    memcpy(whole, map, folder);
    strcpy(whole + folder, path);
    char *text = whole_file_read(whole, FILE_BYTES_MAX, length);
    free(whole);
    return text;
}

/* The file's name without folder and suffix: "assets/levels/quarry.tmj" gives "quarry". */
static void name_of(const char *path, char *name, size_t size) {
    const char *base = last_part(path);
    const char *dot = strrchr(base, '.');
    size_t length = dot && dot != base ? (size_t)(dot - base) : strlen(base);
    snprintf(name, size, "%.*s", (int)(length < size ? length : size - 1), base);
}

bool level_read_file(const char *path, bool skip_unsupported, scene *s, level_report *report) {
    scene_init(s);
    *report = (level_report){0};
    size_t length = 0;
    char *text = whole_file_read(path, FILE_BYTES_MAX, &length);
    if (!text) {
        level_problem_add(report, LEVEL_FATAL, LEVEL_NO_OBJECT, "the file cannot be read");
        return false;
    }
    char name[128]; /* a longer one is cut. Chosen */
    name_of(path, name, sizeof name);
    level_opener opener = {.open = open_beside, .context = (void *)(uintptr_t)path};
    bool read = level_read_with(name, text, length, &opener, skip_unsupported, s, report);
    free(text);
    return read;
}
