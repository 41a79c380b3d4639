/* input.h: keyboard and pointer. */
#ifndef THUD_PLAY_INPUT_H
#define THUD_PLAY_INPUT_H

#include "viewer.h"

extern const char INPUT_HELP[]; /* the list of keys, for --help */

/* Handles all pending events. */
void input_poll(viewer *v, SDL_Window *window);

#endif
