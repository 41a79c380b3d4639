/* draw_character.h: draws the character that a player controls. */
#ifndef THUD_PLAY_DRAW_CHARACTER_H
#define THUD_PLAY_DRAW_CHARACTER_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "character.h"

/* `alpha` interpolates between the last two steps. */
void draw_character(canvas *c, const camera *view, const character *who, double alpha);

#endif
