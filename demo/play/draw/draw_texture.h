/* draw_texture.h: the texture of a scene's ground, and what it says under every foot. */
#ifndef THUD_PLAY_DRAW_TEXTURE_H
#define THUD_PLAY_DRAW_TEXTURE_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

enum { TEXTURE_PRINTS = 80, TEXTURE_FEET = 64 };

/* Where a foot trod and, for as long as it stood, slid to. */
typedef struct texture_print {
    thud_shape_id foot;
    thud_pos from, to;
    thud_vec2 normal; /* of the ground */
} texture_print;

/* The latest of them; all zero at first. */
typedef struct texture_prints {
    texture_print of[TEXTURE_PRINTS];
    int count;                            /* since the scene began */
    thud_shape_id standing[TEXTURE_FEET]; /* at the last picture */
    int standing_count;
    uint64_t steps; /* of the world, then */
} texture_prints;

/* Of scenes that are textured: stripes at equal distances of the texture, prints, and at every
 * contact a dot in the colour of its material, with the weights of the vertices beside it. */
void draw_texture(canvas *c, const camera *view, const session *s, texture_prints *prints);

#endif
