/* scenes.h: the built-in scenes, one per file, used by viewer, page, benchmark and tests.
 *
 * A scene's size is the number of its parts; `size_means` says of which. The default size is the
 * one that benchmarks use. Filling a scene reads no file and no clock, and computes only with + - *
 * / and square roots in double, so that its bits are the same on every platform. */
#ifndef THUD_DEMO_SCENES_H
#define THUD_DEMO_SCENES_H

#include "scene.h"

/* A scene's file defines `const scene_info scene_NAME = {…};`, and CMakeLists.txt finds it by that,
 * so that no list of names has to be kept. Where the page has a module of the same name, title,
 * sentence and sizes are written only there, and SCENE_FACTS(NAME) of the generated "scene_facts.h"
 * expands to them. A C file may define a larger max_size of its own, for use outside of a browser.
 */
typedef struct scene_info {
    const char *name;       /* as on a command line */
    const char *title;      /* as in a menu */
    const char *about;      /* one sentence: what to look at */
    const char *size_means; /* what `size` counts */
    int default_size, min_size, max_size;
    int place; /* position in menus and lists, ascending */
    void (*fill)(scene *s, int size);
} scene_info;

int scenes_count(void);
const scene_info *scenes_at(int index);          /* null outside 0..count-1 */
const scene_info *scenes_find(const char *name); /* null if there is none */

/* Initialises and fills *s; size 0 means the default. False, and *s is empty, if the size is out of
 * range or memory runs out. */
bool scenes_fill(const scene_info *info, int size, scene *s);

/* Generated when the build is configured: SCENE_LIST, the addresses of all scenes in the order of
 * their places, and the declarations of these scenes. */
#include "scene_list.h"

#endif
