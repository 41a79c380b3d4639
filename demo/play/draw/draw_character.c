/* draw_character.c: see draw_character.h. The character is a rounded box whose eyes look ahead. */
#include "draw/draw_character.h"

#include "draw/palette.h"

#include <math.h>

static void draw_eye(canvas *c, SDL_FPoint at, float size, float facing) {
    canvas_circle(c, at, size, (canvas_style){COLOR_TEXT_STRONG, COLOR_TEXT_STRONG, 0});
    SDL_FPoint pupil = {at.x + 0.4f * size * facing, at.y};
    canvas_circle(c, pupil, 0.5f * size, (canvas_style){COLOR_SKY_TOP, COLOR_SKY_TOP, 0});
}

void draw_character(canvas *c, const camera *view, const character *who, double alpha) {
    SDL_FPoint at = camera_to_screen(view, character_place(who, alpha));
    float scale = (float)view->scale;
    float half_x = (float)who->mover.shape.hx * scale, half_y = (float)who->mover.shape.hy * scale;
    SDL_FRect box = {at.x - half_x, at.y - half_y, 2 * half_x, 2 * half_y};
    SDL_Color inside = color_mix(COLOR_CHARACTER, COLOR_SKY_TOP, 0.25f);
    canvas_round_rect(c, box, 0.6f * half_x,
                      (canvas_style){inside, COLOR_CHARACTER, fminf(2 * c->unit, 0.3f * half_x)});
    float eyes = at.y - 0.5f * half_y, middle = at.x + 0.35f * half_x * who->facing;
    draw_eye(c, (SDL_FPoint){middle - 0.32f * half_x, eyes}, 0.26f * half_x, who->facing);
    draw_eye(c, (SDL_FPoint){middle + 0.32f * half_x, eyes}, 0.26f * half_x, who->facing);
}
