/* draw_world.h: background, terrain and bodies. */
#ifndef THUD_PLAY_DRAW_WORLD_H
#define THUD_PLAY_DRAW_WORLD_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "panel/overlays.h"
#include "session.h"

void draw_background(canvas *c, const camera *view);
void draw_world(canvas *c, const camera *view, session *s, overlay_set overlays);

/* One shape in its place on the screen; its turn is (cosine, sine) counter-clockwise. */
void draw_circle(canvas *c, SDL_FPoint center, float radius, float cosine, float sine,
                 SDL_Color color);
void draw_box(canvas *c, SDL_FPoint center, SDL_FPoint half, float cosine, float sine,
              SDL_Color color);

/* What sleeping does to a body's colour. */
SDL_Color draw_dimmed(SDL_Color color);

/* The scale line and its label: `step` is the length of a grid cell, a "nice" number. */
double draw_grid_step(const canvas *c, const camera *view);

#endif
