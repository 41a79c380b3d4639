/* ui.c: see ui.h. */
#include "panel/ui.h"

#include "draw/palette.h"

#include <string.h>

bool ui_hovers(const ui *u, SDL_FRect r) {
    return u->x >= r.x && u->x < r.x + r.w && u->y >= r.y && u->y < r.y + r.h;
}

/* Whether the pointer was pressed in r since the last frame; consumes the press. */
static bool clicked(ui *u, SDL_FRect r) {
    if (!u->pressed || !ui_hovers(u, r))
        return false;
    u->pressed = false; /* so that one press is one click */
    return true;
}

static float base_line(const canvas *c, SDL_FRect r) {
    return r.y + 0.5f * r.h + 4.5f * c->unit;
}

/* The background of a widget. */
static void plate(canvas *c, SDL_FRect r, SDL_Color color) {
    canvas_round_rect(c, r, 4 * c->unit, (canvas_style){color, color, 0});
}

bool ui_button(ui *u, canvas *c, SDL_FRect r, const char *label, bool on) {
    plate(c, r, on ? COLOR_WIDGET_ON : ui_hovers(u, r) ? COLOR_WIDGET_HOVER : COLOR_WIDGET);
    float width = font_width(&c->text, label, strlen(label)) - c->unit;
    canvas_text(c, r.x + 0.5f * (r.w - width), base_line(c, r), on ? COLOR_TEXT_STRONG : COLOR_TEXT,
                label);
    return clicked(u, r);
}

bool ui_list_row(ui *u, canvas *c, SDL_FRect r, const char *label, bool on) {
    if (on || ui_hovers(u, r))
        plate(c, r, on ? COLOR_WIDGET_ON : COLOR_WIDGET);
    float pad = 8 * c->unit;
    canvas_text_fit(c, r.x + pad, base_line(c, r), r.w - 2 * pad,
                    on ? COLOR_TEXT_STRONG : COLOR_TEXT, label);
    return clicked(u, r);
}

bool ui_toggle(ui *u, canvas *c, SDL_FRect r, const char *label, SDL_Color color, bool on) {
    plate(c, r, ui_hovers(u, r) ? COLOR_WIDGET_HOVER : COLOR_WIDGET);
    float box = 10 * c->unit;
    SDL_FRect mark = {r.x + 7 * c->unit, r.y + 0.5f * (r.h - box), box, box};
    SDL_Color inside = on ? color : COLOR_SKY_TOP;
    canvas_round_rect(c, mark, 2 * c->unit, (canvas_style){inside, color, 1.2f * c->unit});
    canvas_text(c, mark.x + box + 7 * c->unit, base_line(c, r), on ? COLOR_TEXT_STRONG : COLOR_TEXT,
                label);
    return clicked(u, r);
}
