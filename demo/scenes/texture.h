/* texture.h: ground with a texture, for the scene `textured` and the viewer: what it is made of,
 * and the texture's coordinates at a place of it. */
#ifndef THUD_DEMO_TEXTURE_H
#define THUD_DEMO_TEXTURE_H

#include <thud/thud_terrain.h>

/* Rows of the texture, one above the other: v goes from row to row, u along the ground in metres.
 */
enum { TEXTURE_ROWS = 4, TEXTURE_POINTS = 5 };

typedef struct texture_row {
    const char *name;
    double friction;
} texture_row;

extern const texture_row TEXTURE[TEXTURE_ROWS];

/* What the texture has at a place of the ground. */
typedef struct texture_place {
    thud_terrain_sample sample; /* its weights are those of the coordinates at both vertices */
    thud_uv uv;
    const texture_row *row;
} texture_place;

/* `line` is irregular, of at most TEXTURE_POINTS vertices, which are as far apart on the texture as
 * they are on the ground; its row is `row`. A place beside it counts as its end. False for any
 * other line. */
bool texture_at(const thud_terrain *line, int row, double x, texture_place *out);

#endif
