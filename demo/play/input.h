/* input.h: what keys and pointer do. */
#ifndef THUD_PLAY_INPUT_H
#define THUD_PLAY_INPUT_H

#include "viewer.h"

extern const char INPUT_HELP[]; /* the keys, for --help */

/* Handles all events that wait. */
void input_poll(viewer *v, SDL_Window *window);

#endif
