/* timeline.h: what is shown of a recording, apart from its world: a line of its steps with buttons,
 * above the help at the lower edge; the calls of the present step; and what differs. All do nothing
 * where a scene is shown. */
#ifndef THUD_PLAY_TIMELINE_H
#define THUD_PLAY_TIMELINE_H

#include "viewer.h"

float timeline_height(const viewer *v); /* pixels; 0 where it is not shown */
/* Whether the pointer is over it. */
bool timeline_hovered(const viewer *v);
/* Draws the line and its buttons, which act when they are clicked, and the list of calls. */
void timeline_draw(viewer *v);
/* Says which step of the recording is shown. (x, y) is the left end of the baseline. */
void timeline_tell_step(viewer *v, float x, float y);
/* Marks the body in which the recording differs. */
void timeline_mark(viewer *v);

#endif
