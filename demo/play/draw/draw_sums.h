/* draw_sums.h: the Minkowski sum of two shapes, whose places are relative to the camera's centre.
 */
#ifndef THUD_PLAY_DRAW_SUMS_H
#define THUD_PLAY_DRAW_SUMS_H

#include "draw/camera.h"
#include "draw/canvas.h"

#include <thud/thud_shapes.h>

/* The sum about the first one's centre, the second as a point, and the shortest way from the point
 * to the edge of the sum. */
void draw_sum(canvas *c, const camera *view, const thud_shape_instance *a,
              const thud_shape_instance *b);

#endif
