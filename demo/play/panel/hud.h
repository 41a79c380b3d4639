/* hud.h: the texts over the world: title, numbers, speed, help and messages. */
#ifndef THUD_PLAY_HUD_H
#define THUD_PLAY_HUD_H

#include "viewer.h"

float hud_footer(const canvas *c); /* height in pixels of the bar at the lower edge */
void hud_draw(viewer *v);

#endif
