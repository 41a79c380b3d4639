/* api_textured.c: exports for textured ground (thud_textured.h). api.h has the conventions. */
#include "api.h"

#include <string.h>

thud_texture api_texture(double *numbers, int count, int table_count, int has_table, int repeats) {
    char *table = (char *)(numbers + count);
    for (int i = 0; i < table_count; i++) {
        float entry = (float)numbers[count + i];
        memcpy(table + (size_t)i * sizeof entry, &entry, sizeof entry);
    }
    return (thud_texture){numbers, count, has_table ? (float *)table : NULL, table_count,
                          repeats != 0};
}

int api_shape_set_texture(thud_world *world, uint32_t index1, uint32_t generation, double *numbers,
                          int count, int table_count, int has_table, int repeats) {
    thud_texture texture = api_texture(numbers, count, table_count, has_table, repeats);
    return thud_shape_set_texture(world, api_shape(index1, generation), &texture);
}

int api_shape_remove_texture(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_shape_set_texture(world, api_shape(index1, generation), NULL);
}

/* Slots out: texture; its lists are valid until the next edit of the world. */
int api_shape_texture(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_texture texture;
    thud_result result = thud_shape_get_texture(world, api_shape(index1, generation), &texture);
    if (result == THUD_OK)
        api_slots.texture =
            (struct texture){.vertices = {(double)(uintptr_t)texture.vertices, texture.count},
                             .table = {(double)(uintptr_t)texture.table, texture.table_count},
                             .repeats = texture.repeats};
    return result;
}

/* Slots out: number. */
int api_friction_at(const thud_world *world, uint32_t index1, uint32_t generation, double x) {
    float friction;
    thud_result result =
        thud_shape_get_friction_at(world, api_shape(index1, generation), x, &friction);
    if (result == THUD_OK)
        api_slots.number.value = (double)friction;
    return result;
}

int api_world_use_textures(thud_world *world) {
    return thud_world_use_textures(world);
}
