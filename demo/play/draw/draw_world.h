/* draw_world.h: background, terrain and bodies. */
#ifndef THUD_PLAY_DRAW_WORLD_H
#define THUD_PLAY_DRAW_WORLD_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "panel/overlays.h"
#include "session.h"

void draw_background(canvas *c, const camera *view);
void draw_world(canvas *c, const camera *view, session *s, overlay_set overlays);

/* Draw one shape at a position on the screen, rotated by (cosine, sine), counter-clockwise. */
void draw_circle(canvas *c, SDL_FPoint center, float radius, float cosine, float sine,
                 SDL_Color color);
void draw_box(canvas *c, SDL_FPoint center, SDL_FPoint half, float cosine, float sine,
              SDL_Color color);

/* The colour of a sleeping body. */
SDL_Color draw_dimmed(SDL_Color color);

/* The length of a grid cell in units of the world: 1, 2 or 5 times a power of ten. */
double draw_grid_step(const canvas *c, const camera *view);

#endif
