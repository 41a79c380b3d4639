/* draw_overlays.h: what the engine knows of the world, drawn through its debug-draw callbacks. */
#ifndef THUD_PLAY_DRAW_OVERLAYS_H
#define THUD_PLAY_DRAW_OVERLAYS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "panel/overlays.h"
#include "session.h"

/* `footer`: pixels at the lower edge that something else will cover. */
void draw_overlays(canvas *c, const camera *view, session *s, overlay_set overlays, float footer);
/* The band between a held point and where it is pulled to. */
void draw_pull(canvas *c, const camera *view, thud_pos from, thud_pos to);

#endif
