/* draw_queries.h: draws the queries of a step of a recording. */
#ifndef THUD_PLAY_DRAW_QUERIES_H
#define THUD_PLAY_DRAW_QUERIES_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "playback.h"

/* Draws the way of each ray, the outlines with which each shape began and would have ended, and
 * each hit with its normal. */
void draw_queries(canvas *c, const camera *view, const playback *p);

#endif
