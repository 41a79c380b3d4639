/* texture.c: see texture.h. */
#include "texture.h"

#include <math.h>

const texture_row TEXTURE[TEXTURE_ROWS] = {{"rock", 1.2},
                                           {"grass", 0.6},
                                           {"ice", 0.01},
                                           {"sand", 0.3}};

/* x limited to the line: a foot at its end may touch it slightly beyond. */
static double within(const thud_terrain *line, double x) {
    double first = line->points[0].x, last = line->points[line->count - 1].x;
    return x < first ? first : x > last ? last : x;
}

bool texture_at(const thud_terrain *line, int row, double x, texture_place *out) {
    thud_uv vertices[TEXTURE_POINTS];
    if (line->kind != THUD_TERRAIN_IRREGULAR || line->count > TEXTURE_POINTS ||
        thud_terrain_sample_at(line, within(line, x), &out->sample) != THUD_OK)
        return false;
    vertices[0] = (thud_uv){0, row + 0.5};
    for (int i = 1; i < line->count; i++) {
        double dx = line->points[i].x - line->points[i - 1].x;
        double dy = line->points[i].y - line->points[i - 1].y;
        vertices[i] = (thud_uv){vertices[i - 1].u + sqrt(dx * dx + dy * dy), row + 0.5};
    }
    if (thud_terrain_texture_at(&out->sample, vertices, line->count, &out->uv) != THUD_OK)
        return false;
    out->row = &TEXTURE[(int)out->uv.v];
    return true;
}

thud_result texture_weave(thud_world *world, thud_shape_id line, int row, int count) {
    double vertices[TEXTURE_POINTS];
    float table[TEXTURE_ROWS];
    for (int i = 0; i < TEXTURE_ROWS; i++)
        table[i] = (float)TEXTURE[i].friction;
    for (int i = 0; i < count && i < TEXTURE_POINTS; i++) {
        double end = i == 0 ? -0.5 : i == count - 1 ? 0.5 : 0;
        vertices[i] = (row + end) / TEXTURE_ROWS;
    }
    return thud_shape_set_texture(world, line,
                                  &(thud_texture){.vertices = vertices,
                                                  .count = count,
                                                  .table = table,
                                                  .table_count = TEXTURE_ROWS,
                                                  .repeats = true});
}
