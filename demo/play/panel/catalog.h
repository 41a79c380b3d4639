/* catalog.h: the list of everything that the viewer can show: built-in scenes, then level files. */
#ifndef THUD_PLAY_CATALOG_H
#define THUD_PLAY_CATALOG_H

#include <scenes.h>

#include <stdbool.h>
#include <stddef.h>

typedef struct catalog_entry {
    const scene_info *info; /* null for a level */
    char *path;             /* path of a level's file; else null */
    char *title;            /* for the menu */
} catalog_entry;

typedef struct catalog {
    catalog_entry *entries;
    int count;
} catalog;

/* Lists all scenes, and the *.tmj and *.tmx files of `level_directory` by name (none if it cannot
 * be read). False if memory runs out. */
bool catalog_init(catalog *c, const char *level_directory);
void catalog_free(catalog *c);

/* The index of the entry with a scene's name, a level's path, or a listed level's name. The path of
 * a level that is not listed is added. -1 if it is none of these; -2 if memory runs out. */
int catalog_find(catalog *c, const char *name_or_path);

/* Fills *s, which the caller frees. False, with *s empty and the reason in `message`, if that
 * fails. Parts of a level that cannot be modelled are left out and printed on stderr; `message`
 * says how many. */
bool catalog_fill(const catalog_entry *entry, scene *s, char *message, size_t message_size);

#endif
