/* demo.c: exports that make worlds with the built-in scenes of demo/, for tests and measurements in
 * JavaScript. Linked to a module of its own beside the exports of the package. */
#include "api.h"

#include <act_thud.h>
#include <build_thud.h>
#include <scenes.h>

int api_scene_count(void) {
    return scenes_count();
}

/* The name of a scene; null for an index out of range. */
const char *api_scene_name(int index) {
    const scene_info *info = scenes_at(index);
    return info == NULL ? NULL : info->name;
}

/* The default size of a scene; 0 for an index out of range. */
int api_scene_size(int index) {
    const scene_info *info = scenes_at(index);
    return info == NULL ? 0 : info->default_size;
}

/* What acts on bodies (wind, water) in the scene that was made last. */
static scene_fields fields;

/* Creates a world with a scene of this size; 0: the default. Slots in: world_options. Slots out:
 * list, whose address is the world's. */
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

/* Runs a step of the world of the scene that was made last, with what acts on its bodies. */
int api_scene_step(thud_world *world) {
    return scene_step_thud(&fields, world);
}
