/* draw_measures.h: how far two shapes are apart, where they will touch, and what bounds one. Places
 * of shapes are relative to the camera's centre. */
#ifndef THUD_PLAY_DRAW_MEASURES_H
#define THUD_PLAY_DRAW_MEASURES_H

#include "draw/camera.h"
#include "draw/canvas.h"

#include <thud/thud_shapes.h>

/* The shortest way from one to the other, or out of each other, with its length. */
void draw_closest(canvas *c, const camera *view, const thud_shape_instance *a,
                  const thud_shape_instance *b);

/* Both where they first touch if they go on for a second; nothing where they stand. */
void draw_impact(canvas *c, const camera *view, const thud_shape_instance *a, thud_motion by_a,
                 const thud_shape_instance *b, thud_motion by_b);

/* The smallest circle, AABB and OBB around a shape, and how many times its area each has. */
void draw_volumes(canvas *c, const camera *view, const thud_shape_instance *shape);

#endif
