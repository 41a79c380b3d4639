/* hud.c: see hud.h. */
#include "hud.h"

#include "draw_world.h"
#include "palette.h"

#include <stdio.h>
#include <string.h>

static void draw_title(viewer *v) {
    canvas *c = &v->canvas;
    const scene *s = &v->session.scene;
    float u = c->unit, x = v->camera.view.x + 16 * u;
    canvas_text(c, x, 25 * u, COLOR_TEXT_STRONG, s->title ? s->title : s->name);
    if (s->about)
        canvas_text_fit(c, x, 45 * u, v->camera.view.w - 32 * u, COLOR_TEXT_DIM, s->about);
}

static void draw_numbers(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit;
    thud_stats stats = thud_world_stats(v->session.world);
    char text[160];
    int length =
        snprintf(text, sizeof text, "%d bodies  %d awake  %d contacts  %.2f ms", stats.bodies,
                 stats.awake_bodies, stats.contacts, stats.step_seconds * 1e3);
    if (v->frame_seconds > 0)
        snprintf(text + length, sizeof text - (size_t)length, "  %.0f fps", 1 / v->frame_seconds);
    float x = (float)c->width - 16 * u - font_width(&c->text, text, strlen(text));
    float left = v->camera.view.x + 16 * u;
    /* On a narrow window it goes below the title. */
    bool narrow = x < left + 220 * u;
    canvas_text(c, narrow ? left : x, narrow ? 65 * u : 25 * u, COLOR_TEXT, text);
    if (v->session.paused)
        canvas_text(c, left, (narrow ? 85 : 65) * u, COLOR_TIMINGS, "Paused");
}

static void draw_scale(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit, y = (float)c->height - 36 * u, x = v->camera.view.x + 16 * u;
    double step = draw_grid_step(c, &v->camera);
    float width = (float)(step * v->camera.scale);
    canvas_line(c, (SDL_FPoint){x, y}, (SDL_FPoint){x + width, y}, u, COLOR_TEXT_DIM);
    canvas_line(c, (SDL_FPoint){x, y - 4 * u}, (SDL_FPoint){x, y}, u, COLOR_TEXT_DIM);
    canvas_line(c, (SDL_FPoint){x + width, y - 4 * u}, (SDL_FPoint){x + width, y}, u,
                COLOR_TEXT_DIM);
    char text[32];
    snprintf(text, sizeof text, "%g m", step);
    canvas_text(c, x + width + 8 * u, y + u, COLOR_TEXT_DIM, text);
}

static void draw_message(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit, x = v->camera.view.x + 16 * u, y = (float)c->height - 92 * u;
    SDL_FRect box = {x - 6 * u, y - 20 * u, v->camera.view.w - 20 * u, 30 * u};
    canvas_round_rect(c, box, 5 * u, (canvas_style){COLOR_SHADE, COLOR_ERROR, 1.2f * u});
    canvas_text_fit(c, x + 4 * u, y, box.w - 16 * u, COLOR_ERROR, v->session.message);
}

void hud_draw(viewer *v) {
    canvas *c = &v->canvas;
    if (v->session.world) {
        draw_title(v);
        draw_numbers(v);
        draw_scale(v);
    }
    if (overlays_have(v->overlays, OVERLAY_TIMINGS))
        timings_draw(&v->timings, c);
    if (v->session.message[0])
        draw_message(v);
    canvas_text_fit(c, v->camera.view.x + 16 * c->unit, (float)c->height - 14 * c->unit,
                    v->camera.view.w - 32 * c->unit, color_fade(COLOR_TEXT_DIM, 0.8f),
                    "Drag a body to pull it, the ground to move; wheel zooms; C, B drop here; "
                    "Space pauses; N steps; Tab hides all this");
}
