/* font.h: the viewer's font, made of strokes on a small grid and rasterised for the display's
 * density. */
#ifndef THUD_PLAY_FONT_H
#define THUD_PLAY_FONT_H

#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>

enum { FONT_GLYPHS = 95 }; /* ASCII 32..126; any other character is drawn as '?' */

typedef struct font {
    SDL_Texture *atlas; /* a row of cells, one for each glyph */
    int cell_width, cell_height;
    float unit;
} font;

/* Rasterises the font. A unit of the grid becomes `unit` pixels; capitals are 9 units high. False,
 * with SDL_GetError, if that fails. */
bool font_init(font *f, SDL_Renderer *renderer, float unit);
void font_free(font *f);
float font_width(const font *f, const char *text, size_t length);
/* (x, y) is the left end of the baseline. Returns the width in pixels. */
float font_draw(const font *f, SDL_Renderer *renderer, float x, float y, SDL_Color color,
                const char *text, size_t length);

#endif
