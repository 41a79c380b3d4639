/* hud.c: see hud.h. */
#include "panel/hud.h"

#include "draw/draw_world.h"
#include "draw/palette.h"
#include "panel/timeline.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Height of the help at the lower edge. */
static float help_height(const canvas *c) {
    return 30 * c->unit;
}

float hud_footer(const viewer *v) {
    return help_height(&v->canvas) + timeline_height(v);
}

static void draw_title(viewer *v) {
    canvas *c = &v->canvas;
    const scene *s = &v->session.scene;
    float u = c->unit, x = v->camera.view.x + 16 * u;
    canvas_text(c, x, 25 * u, COLOR_TEXT_STRONG, s->title ? s->title : s->name);
    if (s->about)
        canvas_text_fit(c, x, 45 * u, v->camera.view.w - 32 * u, COLOR_TEXT_DIM, s->about);
}

/* The greatest speed that a user allows, along a diagonal, since x and y are clamped each by
 * itself; 0: none was chosen. In lengths a second. */
static double top_speed(const session *s) {
    return sqrt(2) * s->top_speed * s->scene.length_scale;
}

/* What collision detection could not do; with bisection, or where the greatest speed is chosen,
 * also the speed beyond which bisection may miss hits. Red where that speed is allowed. */
static void draw_missed(viewer *v, float y) {
    session *s = &v->session;
    char text[160] = "";
    size_t used = 0;
    double limit = 0;
    bool broken = false;
    bool bisects = DETECTIONS[session_detection(s)].detection == &thud_detection_bisect;
    if ((bisects || s->missed.fast > 0 || s->top_speed > 0) &&
        thud_world_get_bisection_limit(s->world, &limit) == THUD_OK && isfinite(limit)) {
        used = (size_t)snprintf(text, sizeof text, "bisects up to %.3g m/s  %ld times too fast  ",
                                limit, s->missed.fast);
        broken = top_speed(s) >= limit;
        if (s->top_speed > 0)
            used += (size_t)snprintf(text + used, sizeof text - used,
                                     "speed x step %.3g, thinnest %.3g  ",
                                     top_speed(s) * s->time_step, limit * s->time_step);
    }
    if (s->missed.held > 0)
        snprintf(text + used, sizeof text - used, "%ld times held back  %.3f s lost",
                 s->missed.held, s->missed.seconds);
    canvas_text(&v->canvas, v->camera.view.x + 16 * v->canvas.unit, y,
                broken ? COLOR_OPEN : COLOR_TIMINGS, text);
}

static void draw_numbers(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit;
    thud_stats stats = thud_stats_of(v->session.world);
    thud_step_error error = thud_step_error_of(v->session.world);
    char text[200];
    int length = snprintf(text, sizeof text,
                          "%d bodies  %d awake  %d contacts  %.4f deepest  %+.3g energy  %.2f ms",
                          stats.bodies, stats.awake_bodies, stats.contacts, error.penetration_max,
                          error.energy_change, stats.step_seconds * 1e3);
    if (v->frame_seconds > 0)
        snprintf(text + length, sizeof text - (size_t)length, "  %.0f fps", 1 / v->frame_seconds);
    float x = (float)c->width - 16 * u - font_width(&c->text, text, strlen(text));
    float left = v->camera.view.x + 16 * u;
    /* In a narrow window the numbers are below the title. */
    bool narrow = x < left + 220 * u;
    canvas_text(c, narrow ? left : x, narrow ? 65 * u : 25 * u, COLOR_TEXT, text);
    float y = (narrow ? 85 : 65) * u;
    float after = left;
    if (v->session.paused)
        after += canvas_text(c, left, y, COLOR_TIMINGS, "Paused") + 16 * u;
    timeline_tell_step(v, after, y);
    draw_missed(v, y + 20 * u);
}

static const char HELP[] =
    "Drag a body to pull it, the ground to move; wheel zooms; C, B drop and G digs "
    "here; Space pauses; N steps; Tab hides all this";
static const char HELP_CHARACTER[] =
    "Arrows or A D walk; Space jumps; Down drops through planks; P pauses; N steps; the wheel "
    "zooms; Tab hides all this";

static const char HELP_RECORDING[] =
    "Left, Right step; Shift: 60 steps; Home, End; Space plays; , . speed; H forks: goes on by hand; "
    "I lists calls; Tab hides all this";

/* The bar at the lower edge: the length of a grid cell drawn to scale, and help for pointer and
 * keys. */
static void draw_footer(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit, x = v->camera.view.x + 16 * u, y = (float)c->height - 10 * u;
    float height = help_height(c);
    SDL_FRect bar = {v->camera.view.x, (float)c->height - height, v->camera.view.w, height};
    canvas_rect(c, bar, COLOR_SHADE, COLOR_SHADE);
    double step = draw_grid_step(c, &v->camera);
    SDL_FPoint left = {x, y}, right = {x + (float)(step * v->camera.scale), y};
    canvas_line(c, left, right, u, COLOR_TEXT);
    canvas_line(c, left, (SDL_FPoint){left.x, y - 5 * u}, u, COLOR_TEXT);
    canvas_line(c, right, (SDL_FPoint){right.x, y - 5 * u}, u, COLOR_TEXT);
    char text[32];
    snprintf(text, sizeof text, "%g m", step);
    x = right.x + 10 * u;
    x += canvas_text(c, x, y, COLOR_TEXT, text) + 24 * u;
    const char *keys = v->character.present ? HELP_CHARACTER
                       : v->session.played  ? HELP_RECORDING
                                            : HELP;
    canvas_text_fit(c, x, y, (float)c->width - 16 * u - x, COLOR_TEXT_DIM, keys);
}

/* The session's message, in a box above the footer. */
static void draw_message(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit, x = v->camera.view.x + 16 * u, y = (float)c->height - hud_footer(v) - 22 * u;
    SDL_FRect box = {x - 6 * u, y - 20 * u, v->camera.view.w - 20 * u, 30 * u};
    canvas_round_rect(c, box, 5 * u, (canvas_style){COLOR_SHADE, COLOR_ERROR, 1.2f * u});
    canvas_text_fit(c, x + 4 * u, y, box.w - 16 * u, COLOR_ERROR, v->session.message);
}

void hud_draw(viewer *v) {
    canvas *c = &v->canvas;
    if (v->session.world) {
        draw_title(v);
        draw_numbers(v);
        draw_footer(v);
        timeline_draw(v);
    }
    if (overlays_have(v->overlays, OVERLAY_TIMINGS))
        timings_draw(&v->timings, c, hud_footer(v));
    if (v->session.message[0])
        draw_message(v);
}
