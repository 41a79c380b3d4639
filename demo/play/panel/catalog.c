/* catalog.c: see catalog.h. */
#define _POSIX_C_SOURCE 200809L /* for opendir, strdup */
#include "panel/catalog.h"

#include <level.h>

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Length of ".tmj" and ".tmx". */
enum { SUFFIX = 4 };

static bool is_level_file(const char *path) {
    size_t length = strlen(path);
    return length > SUFFIX && (strcmp(path + length - SUFFIX, ".tmj") == 0 ||
                               strcmp(path + length - SUFFIX, ".tmx") == 0);
}

/* "levels/wrecking_ball.tmj" becomes "wrecking_ball", in memory from malloc. */
static char *level_name(const char *path) {
    const char *slash = strrchr(path, '/');
    char *name = strdup(slash ? slash + 1 : path);
    if (name)
        name[strlen(name) - SUFFIX] = '\0';
    return name;
}

/* "wrecking_ball" becomes "Wrecking ball". */
static void make_title(char *name) {
    for (char *p = name; *p; p++)
        if (*p == '_' || *p == '-')
            *p = ' ';
    if (name[0] >= 'a' && name[0] <= 'z')
        name[0] -= 'a' - 'A';
}

/* Appends an entry and takes over its memory, also if that fails. */
static bool add_entry(catalog *c, catalog_entry entry) {
    catalog_entry *entries = realloc(c->entries, (size_t)(c->count + 1) * sizeof *entries);
    if (entries)
        c->entries = entries;
    if (!entries || !entry.title || (!entry.info && !entry.path)) {
        free(entry.title);
        free(entry.path);
        return false;
    }
    c->entries[c->count++] = entry;
    return true;
}

static bool add_level(catalog *c, const char *path) {
    catalog_entry entry = {.path = strdup(path), .title = level_name(path)};
    if (entry.title)
        make_title(entry.title);
    return add_entry(c, entry);
}

static int compare_entries(const void *a, const void *b) {
    return strcmp(((const catalog_entry *)a)->path, ((const catalog_entry *)b)->path);
}

/* Adds the levels of a directory, sorted by path. */
static bool add_levels_of(catalog *c, const char *directory) {
    DIR *stream = opendir(directory);
    if (!stream)
        return true;
    int first = c->count;
    bool ok = true;
    for (struct dirent *file; ok && (file = readdir(stream));) {
        char path[4096];
        int length = snprintf(path, sizeof path, "%s/%s", directory, file->d_name);
        if (length < (int)sizeof path && is_level_file(file->d_name))
            ok = add_level(c, path);
    }
    closedir(stream);
    qsort(c->entries + first, (size_t)(c->count - first), sizeof *c->entries, compare_entries);
    return ok;
}

bool catalog_init(catalog *c, const char *level_directory) {
    *c = (catalog){0};
    for (int i = 0; i < scenes_count(); i++) {
        const scene_info *info = scenes_at(i);
        if (!add_entry(c, (catalog_entry){.info = info, .title = strdup(info->title)})) {
            catalog_free(c);
            return false;
        }
    }
    if (add_levels_of(c, level_directory))
        return true;
    catalog_free(c);
    return false;
}

void catalog_free(catalog *c) {
    for (int i = 0; i < c->count; i++) {
        free(c->entries[i].title);
        free(c->entries[i].path);
    }
    free(c->entries);
    *c = (catalog){0};
}

/* Whether `wanted` is the entry's scene name, level path or level name. */
static bool entry_has_name(const catalog_entry *entry, const char *wanted) {
    if (entry->info)
        return strcmp(entry->info->name, wanted) == 0;
    if (strcmp(entry->path, wanted) == 0)
        return true;
    char *name = level_name(entry->path);
    bool same = name && strcmp(name, wanted) == 0;
    free(name);
    return same;
}

int catalog_find(catalog *c, const char *name_or_path) {
    for (int i = 0; i < c->count; i++)
        if (entry_has_name(&c->entries[i], name_or_path))
            return i;
    if (!is_level_file(name_or_path))
        return -1;
    return add_level(c, name_or_path) ? c->count - 1 : -2;
}

bool catalog_fill(const catalog_entry *entry, scene *s, char *message, size_t message_size) {
    if (entry->info) {
        if (scenes_fill(entry->info, 0, s))
            return true;
        snprintf(message, message_size, "%s: out of memory", entry->info->name);
        return false;
    }
    level_report report;
    bool read = level_read_file(entry->path, true, s, &report);
    static const char *const WORDS[] = {"note", "left out", "error"};
    const char *worst = "";
    for (int i = 0; i < report.count; i++) {
        const level_problem *problem = &report.problems[i];
        fprintf(stderr, "thud-play: %s: %s: %s\n", entry->path, WORDS[problem->severity],
                problem->text);
        if (problem->severity == LEVEL_FATAL && !worst[0])
            worst = problem->text;
    }
    if (!read)
        snprintf(message, message_size, "%s: %s", entry->path, worst);
    else if (report.skipped > 0)
        snprintf(message, message_size,
                 "%d things of this level cannot be modelled: the terminal lists them",
                 report.skipped);
    level_report_free(&report);
    return read;
}
