/* catalog.h: everything the viewer can show: the built-in scenes, then the level files found. */
#ifndef THUD_PLAY_CATALOG_H
#define THUD_PLAY_CATALOG_H

#include <scenes.h>

#include <stdbool.h>
#include <stddef.h>

typedef struct catalog_entry {
    const scene_info *info; /* null for a level */
    char *path;             /* of a level, else null */
    char *title;            /* for the menu */
} catalog_entry;

typedef struct catalog {
    catalog_entry *entries;
    int count;
} catalog;

/* All scenes, and the *.tmj and *.tmx of `level_directory` by name (none if it cannot be read).
 * False when memory is short. */
bool catalog_init(catalog *c, const char *level_directory);
void catalog_free(catalog *c);

/* The entry of a scene's name, a level's path, or the name of a level already listed. A path that
 * is not listed yet is added. -1 if it is neither; -2 when memory is short. */
int catalog_find(catalog *c, const char *name_or_path);

/* Fills *s, which the caller frees. False, *s is empty and `message` says why, if that fails. What
 * of a level cannot be modelled is left out and listed on stderr, and `message` says how much. */
bool catalog_fill(const catalog_entry *entry, scene *s, char *message, size_t message_size);

#endif
