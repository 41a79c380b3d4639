/* draw_overlays.h: draws the engine's state by its debug-draw callbacks. */
#ifndef THUD_PLAY_DRAW_OVERLAYS_H
#define THUD_PLAY_DRAW_OVERLAYS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "panel/overlays.h"
#include "session.h"

/* `footer`: height in pixels at the lower edge that is covered by something else. */
void draw_overlays(canvas *c, const camera *view, session *s, overlay_set overlays, float footer);
/* Draws the line between the grabbed point of a body and the target of the pull. */
void draw_pull(canvas *c, const camera *view, thud_pos from, thud_pos to);

#endif
