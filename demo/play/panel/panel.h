/* panel.h: the side panel: what to show, and the controls. */
#ifndef THUD_PLAY_PANEL_H
#define THUD_PLAY_PANEL_H

#include "viewer.h"

float panel_width(const canvas *c);
void panel_draw(viewer *v); /* draws it and does what was clicked */

#endif
