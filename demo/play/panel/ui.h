/* ui.h: buttons that are drawn and asked in one call; no state but the pointer's. */
#ifndef THUD_PLAY_UI_H
#define THUD_PLAY_UI_H

#include "draw/canvas.h"

typedef struct ui {
    float x, y;   /* the pointer, in pixels of the output */
    bool down;    /* the left button */
    bool pressed; /* it went down since the last frame */
    float wheel;  /* notches since the last frame, up positive */
} ui;

bool ui_hovers(const ui *u, SDL_FRect r);
/* True in the frame in which it is pressed. `on`: drawn as the chosen one. */
bool ui_button(ui *u, canvas *c, SDL_FRect r, const char *label, bool on);
/* A line of a list, its label to the left. */
bool ui_list_row(ui *u, canvas *c, SDL_FRect r, const char *label, bool on);
/* A switch with the colour of what it shows. */
bool ui_toggle(ui *u, canvas *c, SDL_FRect r, const char *label, SDL_Color color, bool on);

#endif
