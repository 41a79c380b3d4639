/* file.c: access to files for the level reader, which makes a scene of a level's map: reads the
 * map, and the files that it refers to. */
#define _POSIX_C_SOURCE 200809L /* S_ISREG */

#include "reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Max size of a file that is read, bytes. Chosen, far above the size of any real map. */
enum { FILE_BYTES_MAX = 1 << 28 };

/* Reads a file into memory from malloc, without a zero at its end. Null if it cannot be read, is no
 * regular file or is too large. A map can name any file as its tileset, also one that never ends,
 * as ../../dev/zero, or a named pipe, which blocks the program that opens it; so the kind of file
 * is asked for before it is opened. */
static char *read_whole(const char *path, size_t *length) {
    struct stat about;
    if (stat(path, &about) != 0 || !S_ISREG(about.st_mode) || about.st_size > FILE_BYTES_MAX)
        return NULL;
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    char *text = malloc((size_t)about.st_size + 1); /* + 1: malloc(0) may be null */
    if (text) {
        *length = fread(text, 1, (size_t)about.st_size, file);
        if (ferror(file)) {
            free(text);
            text = NULL;
        }
    }
    fclose(file);
    return text;
}

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
    char *text = read_whole(whole, length);
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
    char *text = read_whole(path, &length);
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
