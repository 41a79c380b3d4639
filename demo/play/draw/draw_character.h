/* draw_character.h: the figure that is played with. */
#ifndef THUD_PLAY_DRAW_CHARACTER_H
#define THUD_PLAY_DRAW_CHARACTER_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "character.h"

void draw_character(canvas *c, const camera *view, const character *who, double alpha);

#endif
