/* draw_sums.h: the Minkowski sums of a scene that is there to show them. */
#ifndef THUD_PLAY_DRAW_SUMS_H
#define THUD_PLAY_DRAW_SUMS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

/* Of each pair, see scene.sum_pairs: the sum about the first one's centre, the second as a point,
 * and the shortest way from the point to the edge of the sum. */
void draw_sums(canvas *c, const camera *view, session *s);

#endif
