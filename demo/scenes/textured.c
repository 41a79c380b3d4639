/* textured.c: walkers on textured ground, whose texture shows its material: rock, grass, ice and
 * sand in turn, each with its friction, which is read from the texture where a foot stands.
 *
 * Bodies: the ground, with one terrain line for each band; then the walkers. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"
#include "texture.h"
#include "walker.h"

static const double BAND = 6, WALL = 4; /* m: width of a band; height of the wall at both ends */

/* Adds the bands. Vertices are at uneven distances; adjacent bands share their end points. */
static void add_bands(scene *s, double start, int count) {
    scene_random random = {5};
    scene_point end = {start, WALL};
    for (int i = 0; i < count; i++) {
        scene_point points[TEXTURE_POINTS] = {end};
        for (int j = 1; j < TEXTURE_POINTS; j++) {
            double jitter = scene_random_range(&random, -0.3, 0.3);
            points[j].x = start + BAND * i + BAND / (TEXTURE_POINTS - 1) * j +
                          (j < TEXTURE_POINTS - 1 ? jitter : 0);
            points[j].y = scene_random_range(&random, -0.1, 0.1);
        }
        if (i == count - 1)
            points[TEXTURE_POINTS - 1].y = WALL;
        end = points[TEXTURE_POINTS - 1];
        s->material.friction = TEXTURE[i % TEXTURE_ROWS].friction;
        scene_shape *band = scene_add_irregular(s, points, TEXTURE_POINTS);
        band->texture_row = 1 + i % TEXTURE_ROWS;
    }
}

static void fill(scene *s, int size) {
    s->textured = true;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    add_bands(s, -6.0 * size - 6, 12 + 2 * size);
    s->material.friction = 0.9; /* of the walkers' bars, as in the scene walker */
    for (int i = 0; i < size; i++)
        walker_add(s, i, 12.0 * (i - 0.5 * (size - 1)));
    s->camera_x = 9; /* ahead of the walkers, since the camera does not follow them */
    s->camera_y = 2;
    s->camera_height = 9;
    s->camera_width = 24 + 11 * size;
    s->spawn_y = 9;
}

const scene_info scene_textured = {SCENE_FACTS(textured), .place = 275, .fill = fill};
