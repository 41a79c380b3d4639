/* hud.h: the texts over the world: title, numbers, speed, help and messages. */
#ifndef THUD_PLAY_HUD_H
#define THUD_PLAY_HUD_H

#include "viewer.h"

/* Height in pixels of the bars at the lower edge: help, and above it the steps of a recording. */
float hud_footer(const viewer *v);
void hud_draw(viewer *v);

#endif
