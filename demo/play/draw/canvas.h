/* canvas.h: filled, soft-edged primitives in pixels, y down, gathered into large batches.
 *
 * A renderer without anti-aliasing draws them smooth all the same: every outline ends in a band
 * one pixel wide that fades to nothing. Whoever uses the renderer directly flushes first. */
#ifndef THUD_PLAY_CANVAS_H
#define THUD_PLAY_CANVAS_H

#include "draw/font.h"

#include <SDL.h>
#include <stdbool.h>

typedef struct canvas {
    SDL_Renderer *renderer;
    int width, height; /* pixels of the output */
    float unit;        /* pixels of one point: 1 on an ordinary display, 2 on a dense one */
    font text;
    SDL_Vertex *vertices;
    int *indices;
    int vertex_count, index_count;
} canvas;

typedef struct canvas_style {
    SDL_Color fill, edge;
    float border; /* pixels from edge colour to fill colour */
} canvas_style;

/* The canvas does not own the renderer. False, with SDL_GetError, when memory is short. */
bool canvas_init(canvas *c, SDL_Renderer *renderer, float unit);
void canvas_free(canvas *c);
/* Takes over the output's present size and the display's density. */
bool canvas_resize(canvas *c, float unit);
void canvas_flush(canvas *c);

void canvas_rect(canvas *c, SDL_FRect r, SDL_Color top, SDL_Color bottom);
void canvas_round_rect(canvas *c, SDL_FRect r, float radius, canvas_style style);
void canvas_quad(canvas *c, const SDL_FPoint corners[4], const SDL_Color colors[4]);
void canvas_circle(canvas *c, SDL_FPoint center, float radius, canvas_style style);
void canvas_ring(canvas *c, SDL_FPoint center, float radius, float width, SDL_Color color);
/* `axis` is the unit vector along which `half.x` is measured. */
void canvas_box(canvas *c, SDL_FPoint center, SDL_FPoint axis, SDL_FPoint half, canvas_style style);
void canvas_line(canvas *c, SDL_FPoint a, SDL_FPoint b, float width, SDL_Color color);
/* (x, y) is the left end of the base line; returns the width in pixels. */
float canvas_text(canvas *c, float x, float y, SDL_Color color, const char *text);
/* As canvas_text, cut with two dots so that it is no wider than `width`. */
void canvas_text_fit(canvas *c, float x, float y, float width, SDL_Color color, const char *text);

#endif
