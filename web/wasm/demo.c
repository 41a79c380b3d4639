/* demo.c: the built-in scenes for the page, on top of the same layer as the package. */
#include "api.h"

#include <build_thud.h>
#include <scenes.h>
#include <sum_picture.h>

int api_scene_count(void) {
    return scenes_count();
}

/* Slots out, texts by address: 0 name  1 title  2 about  3 what its size means  4 default size
 * 5 smallest  6 largest. */
int api_scene_info(int index) {
    const scene_info *info = scenes_at(index);
    if (info == NULL)
        return THUD_ERROR_INVALID;
    double *s = api_slots;
    s[0] = (double)(uintptr_t)info->name;
    s[1] = (double)(uintptr_t)info->title;
    s[2] = (double)(uintptr_t)info->about;
    s[3] = (double)(uintptr_t)info->size_means;
    s[4] = info->default_size;
    s[5] = info->min_size;
    s[6] = info->max_size;
    return THUD_OK;
}

/* A world with the scene in it, made from the slots of api_world_defaults; size 0 takes the
 * default. Slots out: 0 world  1, 2 camera  3 camera height  4, 5 place to spawn
 * 6 length scale  7 what to show over the bodies, see scene_show  8 pairs with a Minkowski sum. */
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
    double *s = api_slots;
    s[0] = (double)(uintptr_t)world;
    s[1] = filled.camera_x;
    s[2] = filled.camera_y;
    s[3] = filled.camera_height;
    s[4] = filled.spawn_x;
    s[5] = filled.spawn_y;
    s[6] = filled.length_scale;
    s[7] = filled.show;
    s[8] = filled.sum_pairs;
    scene_free(&filled);
    return result;
}

/* The Minkowski sum of two shapes. Slots in: 0 kind  1, 2 half extents  3, 4 cosine and sine of the
 * first, 5 to 9 the same of the second, 10, 11 from the first's centre to the second's. Slots out:
 * 0 whether they overlap  1, 2 the nearest place on the edge of the sum  3 address  4 count of its
 * outline's places (two doubles each). All places are relative to the first's centre. */
int api_sum_picture(void) {
    static sum_picture picture;
    double *s = api_slots;
    thud_shape_instance a = {
        .kind = (thud_shape_kind)api_to_int(s[0]), .hx = s[1], .hy = s[2], .c = s[3], .s = s[4]};
    thud_shape_instance b = {.kind = (thud_shape_kind)api_to_int(s[5]),
                             .hx = s[6],
                             .hy = s[7],
                             .c = s[8],
                             .s = s[9],
                             .x = s[10],
                             .y = s[11]};
    if (!sum_picture_of(&a, &b, &picture))
        return THUD_ERROR_INVALID;
    s[0] = picture.overlaps;
    s[1] = picture.edge.x;
    s[2] = picture.edge.y;
    s[3] = (double)(uintptr_t)picture.outline;
    s[4] = picture.count;
    return THUD_OK;
}
