/* ui.h: immediate-mode widgets: each call draws a widget and returns whether it was clicked. The
 * only state is that of the pointer. */
#ifndef THUD_PLAY_UI_H
#define THUD_PLAY_UI_H

#include "draw/canvas.h"

typedef struct ui {
    float x, y;   /* pointer position, pixels of the output */
    bool down;    /* the left button is down */
    bool pressed; /* the left button was pressed since the last frame */
    float wheel;  /* notches since the last frame; up is positive */
} ui;

bool ui_hovers(const ui *u, SDL_FRect r);
/* True in the frame in which it is pressed. `on`: drawn as chosen. */
bool ui_button(ui *u, canvas *c, SDL_FRect r, const char *label, bool on);
/* A row of a list, with the label at the left. */
bool ui_list_row(ui *u, canvas *c, SDL_FRect r, const char *label, bool on);
/* A check box with the colour of the overlay that it shows. */
bool ui_toggle(ui *u, canvas *c, SDL_FRect r, const char *label, SDL_Color color, bool on);

#endif
