/* scenes.h: the built-in scenes, one per file, shared by viewer, page, benchmark and tests.
 *
 * A scene's size is the number of whatever it is made of (see `size_means`); the default is the
 * one that benchmarks use. Filling a scene reads no file and no clock, and uses only + - * / and
 * the square root in double: its bits are the same everywhere. */
#ifndef THUD_DEMO_SCENES_H
#define THUD_DEMO_SCENES_H

#include "scene.h"

typedef struct scene_info {
    const char *name;       /* as on a command line */
    const char *title;      /* as in a menu */
    const char *about;      /* one sentence: what to look at */
    const char *size_means; /* what `size` counts */
    int default_size, min_size, max_size;
    void (*fill)(scene *s, int size);
} scene_info;

int scenes_count(void);
const scene_info *scenes_at(int index);          /* null outside 0..count-1 */
const scene_info *scenes_find(const char *name); /* null if there is none */

/* Initialises and fills *s; size 0 takes the default. False, and *s is empty, when the size is
 * out of range or memory runs out. */
bool scenes_fill(const scene_info *info, int size, scene *s);

extern const scene_info scene_pyramid, scene_circle_pit, scene_mixed_terrain, scene_tumbler,
    scene_tumbler_half, scene_smash, scene_platformer, scene_gas, scene_tall_stack,
    scene_heavy_on_light, scene_cradle, scene_slopes, scene_bullets, scene_sizes, scene_one_spot,
    scene_asleep, scene_digging, scene_detection_lanes, scene_minkowski, scene_broadphases;

#endif
