/* picture.h: writes a surface to a file. */
#ifndef THUD_PLAY_PICTURE_H
#define THUD_PLAY_PICTURE_H

#include <SDL.h>
#include <stdbool.h>

/* True if the path ends in .png or .bmp. */
bool picture_has_format(const char *path);
/* The suffix chooses the format. False, with SDL_GetError, when it cannot be written. */
bool picture_save(SDL_Surface *surface, const char *path);

#endif
