/* font.h: the viewer's own letters, strokes on a small grid, rasterised to the display's density.
 */
#ifndef THUD_PLAY_FONT_H
#define THUD_PLAY_FONT_H

#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>

enum { FONT_GLYPHS = 95 }; /* ASCII 32..126; anything else shows as '?' */

typedef struct font {
    SDL_Texture *atlas; /* one glyph per cell, in one row */
    int cell_width, cell_height;
    float unit;
} font;

/* A grid unit becomes `unit` pixels; capitals are 9 units high. */
bool font_init(font *f, SDL_Renderer *renderer, float unit);
void font_free(font *f);
float font_width(const font *f, const char *text, size_t length);
/* (x, y) is the left end of the base line; returns the width in pixels. */
float font_draw(const font *f, SDL_Renderer *renderer, float x, float y, SDL_Color color,
                const char *text, size_t length);

#endif
