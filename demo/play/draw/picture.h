/* picture.h: writes a surface to an image file. */
#ifndef THUD_PLAY_PICTURE_H
#define THUD_PLAY_PICTURE_H

#include <SDL.h>
#include <stdbool.h>

/* True if the path ends in .png or .bmp. */
bool picture_has_format(const char *path);
/* Writes the format that the suffix names. False, with SDL_GetError, if that fails. */
bool picture_save(SDL_Surface *surface, const char *path);

#endif
