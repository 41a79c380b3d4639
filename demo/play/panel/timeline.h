/* timeline.h: what the viewer draws of a recording beside its world: a bar of its steps with
 * buttons, above the help at the lower edge; a list of the calls of the present step; and where the
 * played world differs from the recording. These functions do nothing where a scene is shown in
 * place of a recording. */
#ifndef THUD_PLAY_TIMELINE_H
#define THUD_PLAY_TIMELINE_H

#include "viewer.h"

float timeline_height(const viewer *v); /* pixels; 0 where it is not shown */
/* Whether the pointer is over the bar or its buttons. */
bool timeline_hovered(const viewer *v);
/* Draws the line and its buttons, which act when they are clicked, and the list of calls. */
void timeline_draw(viewer *v);
/* Says which step of the recording is shown. (x, y) is the left end of the baseline. */
void timeline_tell_step(viewer *v, float x, float y);
/* Marks the body whose state differs from the recording. */
void timeline_mark(viewer *v);

#endif
