/* library.c: the tilesets and templates that a map refers to. Each file is read once. */
#include "reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct file {
    struct file *next;
    cJSON *json; /* null: the file cannot be used; `trouble` says why */
    bool reported;
    char trouble[120];
    char path[];
} file;

struct level_library {
    const level_opener *opener;
    file *files;
};

level_library *level_library_create(const level_opener *opener) {
    level_library *library = calloc(1, sizeof *library);
    if (library)
        library->opener = opener;
    return library;
}

void level_library_free(level_library *library) {
    while (library && library->files) {
        file *next = library->files->next;
        cJSON_Delete(library->files->json);
        free(library->files);
        library->files = next;
    }
    free(library);
}

void level_library_forget_reports(level_library *library) {
    for (file *f = library->files; f; f = f->next)
        f->reported = false;
}

/* Room for a path. Chosen. */
enum { LONGEST_PATH = 1024 };

/* Removes the last part of a path. False if there is none, or if it is "..". */
static bool go_up(char *path, size_t *length) {
    size_t at = *length;
    while (at > 0 && path[at - 1] != '/')
        at--;
    if (*length == 0 || strcmp(path + at, "..") == 0)
        return false;
    *length = at > 0 ? at - 1 : 0;
    path[*length] = 0;
    return true;
}

/* Appends a part to a path. False if it gets too long. */
static bool append(char *path, size_t *length, const char *part, size_t size) {
    if (*length + size + 2 > LONGEST_PATH)
        return false;
    if (*length > 0)
        path[(*length)++] = '/';
    memcpy(path + *length, part, size);
    *length += size;
    path[*length] = 0;
    return true;
}

/* Makes of `source`, a path in the file `from`, a path from the map's folder. False if it is
 * absolute, names a host, or is too long. */
static bool join(const char *from, const char *source, char path[LONGEST_PATH]) {
    if (source[0] == '/' || source[0] == '\\' || strchr(source, ':'))
        return false;
    path[0] = 0;
    size_t length = 0;
    const char *slash = strrchr(from, '/');
    if (slash && !append(path, &length, from, (size_t)(slash - from)))
        return false;
    while (*source) {
        size_t size = strcspn(source, "/\\");
        bool up = size == 2 && memcmp(source, "..", 2) == 0;
        bool stay = size == 0 || (size == 1 && *source == '.');
        if (!stay && !(up && go_up(path, &length)) && !append(path, &length, source, size))
            return false;
        source += size + (source[size] != 0);
    }
    return length > 0;
}

/* The file with this path, if it was read before; else null. */
static file *find(const level_library *library, const char *path) {
    for (file *f = library->files; f; f = f->next)
        if (strcmp(f->path, path) == 0)
            return f;
    return NULL;
}

/* Reads and parses a file. Its JSON stays null, and `trouble` says why, if it cannot be used or is
 * not of this type. */
static void load(const level_library *library, file *f, const char *type) {
    size_t length = 0;
    char *text =
        library->opener ? library->opener->open(library->opener->context, f->path, &length) : NULL;
    if (!text) {
        snprintf(f->trouble, sizeof f->trouble, "it is not there, or cannot be read");
        return;
    }
    f->json = level_document(text, length, f->trouble, sizeof f->trouble);
    free(text);
    if (f->json && strcmp(level_field_text(f->json, "type", ""), type) != 0) {
        cJSON_Delete(f->json);
        f->json = NULL;
        snprintf(f->trouble, sizeof f->trouble, "it is no %s", type);
    }
}

const cJSON *level_library_open(level_library *library, level_report *report, const char *from,
                                const char *source, const char *type, const char **path) {
    char joined[LONGEST_PATH];
    *path = "";
    if (!join(from, source, joined)) {
        level_problem_add(report, LEVEL_SKIP, LEVEL_NO_OBJECT,
                          "%s '%.60s': only files by a path from the map's folder are read", type,
                          source);
        return NULL;
    }
    file *f = find(library, joined);
    if (!f) {
        f = calloc(1, sizeof *f + strlen(joined) + 1);
        if (!f) {
            level_problem_add(report, LEVEL_FATAL, LEVEL_NO_OBJECT, "out of memory");
            return NULL;
        }
        strcpy(f->path, joined);
        f->next = library->files;
        library->files = f;
        load(library, f, type);
    } else if (f->json && strcmp(level_field_text(f->json, "type", ""), type) != 0) {
        level_problem_add(report, LEVEL_SKIP, LEVEL_NO_OBJECT, "'%.80s' is no %s", joined, type);
        return NULL;
    }
    if (!f->json && !f->reported) {
        f->reported = true;
        level_problem_add(report, LEVEL_SKIP, LEVEL_NO_OBJECT, "%s '%.80s': %s", type, joined,
                          f->trouble);
    }
    *path = f->path;
    return f->json;
}
