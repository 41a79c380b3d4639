/* demo.c: the built-in scenes for tests and measurements, on top of the same layer as the package.
 */
#include "api.h"

#include <act_thud.h>
#include <build_thud.h>
#include <scenes.h>

int api_scene_count(void) {
    return scenes_count();
}

/* Null for an index out of range. */
const char *api_scene_name(int index) {
    const scene_info *info = scenes_at(index);
    return info == NULL ? NULL : info->name;
}

/* The default; 0 for an index out of range. */
int api_scene_size(int index) {
    const scene_info *info = scenes_at(index);
    return info == NULL ? 0 : info->default_size;
}

/* Of the scene that was made last. */
static scene_fields fields;

/* A world with the scene in it, made from the slots of api_world_defaults; size 0 takes the
 * default. Slots out: its address, as that of a list. */
int api_scene_create(int index, int size) {
    const scene_info *info = scenes_at(index);
    if (info == NULL)
        return THUD_ERROR_INVALID;
    thud_world_def def = api_world_def();
    scene filled;
    if (!scenes_fill(info, size, &filled))
        return THUD_ERROR_INVALID;
    thud_world *world = NULL;
    thud_result result = scene_build_thud(&filled, &def, &world, NULL, NULL);
    api_slots.list.address = (double)(uintptr_t)world;
    fields = filled.fields;
    scene_free(&filled);
    return result;
}

/* A step of a world with what acts in the scene that was made last. */
int api_scene_step(thud_world *world) {
    return scene_step_thud(&fields, world);
}
