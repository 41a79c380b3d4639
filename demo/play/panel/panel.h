/* panel.h: the side panel: the list of scenes and levels, and the controls. */
#ifndef THUD_PLAY_PANEL_H
#define THUD_PLAY_PANEL_H

#include "viewer.h"

float panel_width(const canvas *c);
void panel_draw(viewer *v); /* draws it, and performs the actions of what was clicked */

#endif
