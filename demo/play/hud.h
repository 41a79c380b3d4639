/* hud.h: the texts over the world: what is shown, how much of it, how fast, and what went wrong. */
#ifndef THUD_PLAY_HUD_H
#define THUD_PLAY_HUD_H

#include "viewer.h"

void hud_draw(viewer *v);

#endif
