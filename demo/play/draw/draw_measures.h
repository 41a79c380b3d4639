/* draw_measures.h: draws the distance of two shapes, where they will touch, and volumes around a
 * shape. Positions of shapes are relative to the camera's centre. */
#ifndef THUD_PLAY_DRAW_MEASURES_H
#define THUD_PLAY_DRAW_MEASURES_H

#include "draw/camera.h"
#include "draw/canvas.h"

#include <thud/thud_geometry.h>

/* Draws the outline of a circle or box, so many pixels wide. */
void draw_outline(canvas *c, const camera *view, const thud_geometry *s, float width,
                  SDL_Color color);

/* Draws the shortest line between two shapes, or out of each other if they overlap, with its
 * length. */
void draw_closest(canvas *c, const camera *view, const thud_geometry *a, const thud_geometry *b);

/* Draws both shapes where they first touch, or where they are after a second if they do not touch
 * within it. Nothing if both are at rest. */
void draw_impact(canvas *c, const camera *view, const thud_geometry *a, thud_motion by_a,
                 const thud_geometry *b, thud_motion by_b);

/* Draws the smallest circle, AABB and OBB around a shape, and writes their areas as multiples of
 * the shape's. */
void draw_volumes(canvas *c, const camera *view, const thud_geometry *shape);

#endif
