/* draw_sums.h: draws the Minkowski sum of two shapes, whose positions are relative to the camera's
 * centre. */
#ifndef THUD_PLAY_DRAW_SUMS_H
#define THUD_PLAY_DRAW_SUMS_H

#include "draw/camera.h"
#include "draw/canvas.h"

#include <thud/thud_geometry.h>

/* Draws the sum about the first shape's centre, the second's centre as a point, and the shortest
 * line from that point to the edge of the sum. */
void draw_sum(canvas *c, const camera *view, const thud_geometry *a, const thud_geometry *b);

#endif
