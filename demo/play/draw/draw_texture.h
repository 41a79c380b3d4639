/* draw_texture.h: draws the texture of a scene's ground, and its material and coordinates under
 * each foot. */
#ifndef THUD_PLAY_DRAW_TEXTURE_H
#define THUD_PLAY_DRAW_TEXTURE_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

/* Max number of prints that are kept, and of contacts that are looked at. */
enum { TEXTURE_PRINTS = 80, TEXTURE_FEET = 64 };

/* The place where a foot touched down, and to which it slid since. */
typedef struct texture_print {
    thud_shape_id foot;
    thud_pos from, to;
    thud_vec2 normal; /* of the ground */
} texture_print;

/* The latest prints, and the feet that stand. All zero at first. */
typedef struct texture_prints {
    texture_print of[TEXTURE_PRINTS];
    int count; /* number of prints since the scene began; `of` is a ring buffer */
    thud_shape_id standing[TEXTURE_FEET]; /* feet in contact when the last frame was drawn */
    int standing_count;
    uint64_t steps; /* the world's number of steps at that time */
} texture_prints;

/* In a textured scene: draws stripes at equal distances on the texture, the prints, and at each
 * contact a dot in the colour of its material, with the interpolation weights of the two vertices.
 */
void draw_texture(canvas *c, const camera *view, const session *s, texture_prints *prints);

#endif
