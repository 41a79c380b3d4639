/* draw_fields.h: what acts on the bodies of a scene, as far as there is something to see. */
#ifndef THUD_PLAY_DRAW_FIELDS_H
#define THUD_PLAY_DRAW_FIELDS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

/* Over the bodies: water from its surface to the ground below it, and the rings that explosions
 * leave for a moment. */
void draw_fields(canvas *c, const camera *view, session *s);

#endif
