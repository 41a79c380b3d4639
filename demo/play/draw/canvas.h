/* canvas.h: filled anti-aliased shapes in pixels, y down, which are collected and drawn in large
 * batches.
 *
 * The edges are smooth also with a renderer without anti-aliasing: each outline ends in a band one
 * pixel wide that fades out. Code that uses the renderer directly has to call canvas_flush first.
 */
#ifndef THUD_PLAY_CANVAS_H
#define THUD_PLAY_CANVAS_H

#include "draw/font.h"

#include <SDL.h>
#include <stdbool.h>

typedef struct canvas {
    SDL_Renderer *renderer;
    int width, height; /* size of the output, pixels */
    float unit;        /* pixels per point: 1 on an ordinary display, 2 on a dense one */
    font text;
    SDL_Vertex *vertices;
    int *indices;
    int vertex_count, index_count;
} canvas;

typedef struct canvas_style {
    SDL_Color fill, edge;
    float border; /* width of the border in the edge colour, pixels */
} canvas_style;

/* Creates a canvas on a renderer, which the caller owns. False, with SDL_GetError, if memory runs
 * out. */
bool canvas_init(canvas *c, SDL_Renderer *renderer, float unit);
void canvas_free(canvas *c);
/* Adopts the current size of the output, and the display's density. False, with SDL_GetError, if
 * the font cannot be made. */
bool canvas_resize(canvas *c, float unit);
/* Draws what was collected. */
void canvas_flush(canvas *c);

/* A rectangle with a vertical gradient. */
void canvas_rect(canvas *c, SDL_FRect r, SDL_Color top, SDL_Color bottom);
void canvas_round_rect(canvas *c, SDL_FRect r, float radius, canvas_style style);
void canvas_quad(canvas *c, const SDL_FPoint corners[4], const SDL_Color colors[4]);
void canvas_circle(canvas *c, SDL_FPoint center, float radius, canvas_style style);
void canvas_ring(canvas *c, SDL_FPoint center, float radius, float width, SDL_Color color);
/* `axis` is a unit vector, along which `half.x` is measured. */
void canvas_box(canvas *c, SDL_FPoint center, SDL_FPoint axis, SDL_FPoint half, canvas_style style);
void canvas_line(canvas *c, SDL_FPoint a, SDL_FPoint b, float width, SDL_Color color);
/* (x, y) is the left end of the baseline. Returns the width in pixels. */
float canvas_text(canvas *c, float x, float y, SDL_Color color, const char *text);
/* The same, with the text cut and two dots added where it would be wider than `width`. */
void canvas_text_fit(canvas *c, float x, float y, float width, SDL_Color color, const char *text);

#endif
