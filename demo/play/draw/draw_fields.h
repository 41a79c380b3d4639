/* draw_fields.h: draws the fields of a scene that are visible: water and explosions. */
#ifndef THUD_PLAY_DRAW_FIELDS_H
#define THUD_PLAY_DRAW_FIELDS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

/* Draws, over the bodies, water from its surface down to the ground, and the rings that explosions
 * leave for a moment. */
void draw_fields(canvas *c, const camera *view, session *s);

#endif
