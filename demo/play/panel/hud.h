/* hud.h: the texts over the world: what is shown, how much of it, how fast, and what went wrong. */
#ifndef THUD_PLAY_HUD_H
#define THUD_PLAY_HUD_H

#include "viewer.h"

float hud_footer(const canvas *c); /* pixels that it takes at the lower edge */
void hud_draw(viewer *v);

#endif
