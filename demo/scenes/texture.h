/* texture.h: textured ground, for the scene `textured` and the viewer: its materials, and the
 * texture coordinates at a place on it. */
#ifndef THUD_DEMO_TEXTURE_H
#define THUD_DEMO_TEXTURE_H

#include <thud/thud_textured.h>

/* The texture has a row for each material, one above the other: its coordinate v chooses the row, u
 * runs along the ground in metres. */
enum { TEXTURE_ROWS = 4, TEXTURE_POINTS = 5 };

typedef struct texture_row {
    const char *name;
    double friction;
} texture_row;

extern const texture_row TEXTURE[TEXTURE_ROWS];

/* The texture at a place on the ground. */
typedef struct texture_place {
    thud_terrain_sample sample; /* its weights interpolate the coordinates of both vertices */
    thud_uv uv;
    const texture_row *row;
} texture_place;

/* Gives a line of `count` vertices, at most TEXTURE_POINTS, the friction of the texture's row
 * `row`. Its first and its last vertex lie midway to the row before and after, so that friction
 * goes over from band to band: the rows follow each other in a circle. */
thud_result texture_weave(thud_world *world, thud_shape_id line, int row, int count);

/* Computes the texture at `x` on a line. The line has to be irregular, with at most TEXTURE_POINTS
 * vertices, whose distances on the texture are those on the ground; all of it has the material
 * `row`. An x beyond an end counts as that end. False for any other line. */
bool texture_at(const thud_terrain *line, int row, double x, texture_place *out);

#endif
