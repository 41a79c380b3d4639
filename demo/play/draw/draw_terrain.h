/* draw_terrain.h: draws a terrain line and the ground below it. */
#ifndef THUD_PLAY_DRAW_TERRAIN_H
#define THUD_PLAY_DRAW_TERRAIN_H

#include "draw/camera.h"
#include "draw/canvas.h"

#include <thud/thud.h>

/* `pose` is that of the terrain's body, relative to the camera's centre. */
void draw_terrain(canvas *c, const camera *view, const thud_world *world, thud_shape_id shape,
                  thud_pose pose);

#endif
