/* scenes.h: the built-in scenes, one per file, shared by viewer, page, benchmark and tests.
 *
 * A scene's size is the number of whatever it is made of (see `size_means`); the default is the
 * one that benchmarks use. Filling a scene reads no file and no clock, and uses only + - * / and
 * the square root in double: its bits are the same everywhere. */
#ifndef THUD_DEMO_SCENES_H
#define THUD_DEMO_SCENES_H

#include "scene.h"

/* A scene's file defines one as `const scene_info scene_NAME = {…};` and is found by that: no list
 * has its name. Where the page has a module of the same name, its title, its sentence and its sizes
 * stand there alone, and SCENE_FACTS(NAME) of "scene_facts.h" brings them, but for a max_size that
 * the C file gives itself, because more fits outside of a browser. */
typedef struct scene_info {
    const char *name;       /* as on a command line */
    const char *title;      /* as in a menu */
    const char *about;      /* one sentence: what to look at */
    const char *size_means; /* what `size` counts */
    int default_size, min_size, max_size;
    int place; /* menus and lists go by it, upwards */
    void (*fill)(scene *s, int size);
} scene_info;

int scenes_count(void);
const scene_info *scenes_at(int index);          /* null outside 0..count-1 */
const scene_info *scenes_find(const char *name); /* null if there is none */

/* Initialises and fills *s; size 0 takes the default. False, and *s is empty, when the size is
 * out of range or memory runs out. */
bool scenes_fill(const scene_info *info, int size, scene *s);

/* Made when the build is configured: SCENE_LIST, addresses of all scenes by their places, and what
 * it names. */
#include "scene_list.h"

#endif
