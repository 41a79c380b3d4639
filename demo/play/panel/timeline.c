/* timeline.c: see timeline.h. */
#include "panel/timeline.h"

#include "draw/palette.h"
#include "panel/hud.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

enum {
    HEIGHT = 36, /* in points, like all sizes here */
    PAD = 16,
    GAP = 6,
    BUTTON = 24, /* height of a button, and width of one with a sign */
    WORD = 58,   /* width of a button with a word */
    COUNTER = 110,
    LINE_MIN = 80, /* of the line, beside which there are no buttons where it would be shorter */
    KNOB = 6,
    LIST_WIDTH = 470,
    LIST_ROW = 17,
    LIST_TOP = 112 /* below the texts, also in a narrow window */
};

float timeline_height(const viewer *v) {
    return v->session.played && !v->bare ? HEIGHT * v->canvas.unit : 0;
}

/* The bar's place, above the help. */
static SDL_FRect bar_of(const viewer *v) {
    const SDL_FRect *r = &v->camera.view;
    return (SDL_FRect){r->x, (float)v->canvas.height - hud_footer(v), r->w, timeline_height(v)};
}

bool timeline_hovered(const viewer *v) {
    return timeline_height(v) > 0 && ui_hovers(&v->ui, bar_of(v));
}

/* The step that is shown, or that a seek goes to. */
static int64_t step_of(const playback *p) {
    return p->target < 0 ? p->progress.steps : p->target;
}

/* Takes a piece off the left end of a row, or with a negative width off the right one. */
static SDL_FRect take(SDL_FRect *row, float width, float gap) {
    SDL_FRect piece = {row->x, row->y, fabsf(width), row->h};
    if (width < 0)
        piece.x = row->x + row->w - piece.w;
    else
        row->x += piece.w + gap;
    row->w -= piece.w + gap;
    return piece;
}

/* The buttons at both ends of the bar, of which `row` keeps what is left. */
static void draw_buttons(viewer *v, SDL_FRect *row) {
    float u = v->canvas.unit, gap = GAP * u;
    const playback *p = v->session.played;
    const char *const signs[] = {"|<", "<", v->session.paused ? "Play" : "Pause", ">", ">|"};
    for (int i = 0; i < 5; i++) {
        SDL_FRect r = take(row, (i == 2 ? WORD : BUTTON) * u, gap);
        if (!ui_button(&v->ui, &v->canvas, r, signs[i], false))
            continue;
        if (i == 0)
            viewer_go_to(v, p->progress.first);
        else if (i == 2)
            viewer_toggle_pause(v);
        else if (i == 4)
            viewer_go_to(v, p->progress.end);
        else
            viewer_go(v, i == 1 ? -1 : 1);
    }
    if (ui_button(&v->ui, &v->canvas, take(row, -WORD * u, gap), "Calls", v->lists_calls))
        v->lists_calls = !v->lists_calls;
    if (ui_button(&v->ui, &v->canvas, take(row, -1.4f * WORD * u, gap),
                  p->forked ? "Back" : "Fork here", p->forked))
        viewer_fork(v);
}

static SDL_FRect part_of(SDL_FRect line, float share) {
    return (SDL_FRect){line.x, line.y, line.w * share, line.h};
}

/* Draws the line of steps, on which the pointer chooses one. */
static void draw_line(viewer *v, SDL_FRect area) {
    canvas *c = &v->canvas;
    float u = c->unit;
    const playback *p = v->session.played;
    const thud_player_progress *at = &p->progress;
    double all = fmax(1, (double)(at->end - at->first));
    if (v->ui.pressed && ui_hovers(&v->ui, area)) {
        v->ui.pressed = false;
        v->scrubbing = true;
    }
    v->scrubbing &= v->ui.down;
    if (v->scrubbing && area.w > 0) {
        double share = fmax(0, fmin(1, (v->ui.x - area.x) / area.w));
        viewer_go_to(v, at->first + (int64_t)llround(share * all));
    }
    float share = (float)((double)(step_of(p) - at->first) / all);
    SDL_FRect line = {area.x, area.y + 0.5f * area.h - 2 * u, area.w, 4 * u};
    SDL_Color done = p->forked ? COLOR_WIDGET_HOVER : COLOR_WIDGET_ON;
    canvas_round_rect(c, line, 2 * u, (canvas_style){COLOR_WIDGET, COLOR_WIDGET, 0});
    canvas_round_rect(c, part_of(line, share), 2 * u, (canvas_style){done, done, 0});
    if (at->differs) {
        float x = line.x + line.w * (float)((double)(at->differs_at - at->first) / all);
        SDL_FRect mark = {x - u, area.y + 3 * u, 2 * u, area.h - 6 * u};
        canvas_rect(c, mark, COLOR_OPEN, COLOR_OPEN);
    }
    SDL_FPoint knob = {line.x + line.w * share, line.y + 2 * u};
    canvas_circle(c, knob, KNOB * u, (canvas_style){done, COLOR_TEXT_STRONG, 1.4f * u});
}

/* Lists the calls of the present step, at the right. */
static void draw_calls(const viewer *v, canvas *c) {
    const playback *p = v->session.played;
    const SDL_FRect *view = &v->camera.view;
    float u = c->unit, row = LIST_ROW * u, top = LIST_TOP * u;
    int room = (int)((bar_of(v).y - top - 30 * u) / row) - 1;
    int kept = p->call_count < PLAYBACK_CALLS_MAX ? p->call_count : PLAYBACK_CALLS_MAX;
    int shown = kept <= room ? kept : room - 1;
    if (room < 2)
        return;
    int rows = 1 + (kept == 0 ? 1 : shown) + (shown < p->call_count);
    float width = fminf(LIST_WIDTH * u, view->w - 32 * u);
    SDL_FRect box = {view->x + view->w - width - PAD * u, top, width, row * (float)rows + 12 * u};
    canvas_round_rect(c, box, 6 * u, (canvas_style){COLOR_SHADE, COLOR_SHADE, 0});
    float x = box.x + 10 * u, y = box.y + row, inside = box.w - 20 * u;
    char text[80];
    snprintf(text, sizeof text, "Calls of step %" PRId64 ": %d", p->progress.steps, p->call_count);
    canvas_text_fit(c, x, y, inside, COLOR_TEXT_STRONG, text);
    for (int i = 0; i < shown; i++)
        canvas_text_fit(c, x, y += row, inside, COLOR_TEXT, p->calls[i]);
    if (kept == 0)
        canvas_text_fit(c, x, y + row, inside, COLOR_TEXT_DIM,
                        p->forked ? "A fork: what is done by hand is not listed."
                                  : "None beside the step itself.");
    snprintf(text, sizeof text, "and %d more", p->call_count - shown);
    if (shown < p->call_count)
        canvas_text_fit(c, x, y + row, inside, COLOR_TEXT_DIM, text);
}

void timeline_draw(viewer *v) {
    const playback *p = v->session.played;
    if (timeline_height(v) <= 0)
        return;
    canvas *c = &v->canvas;
    float u = c->unit, gap = GAP * u;
    SDL_FRect bar = bar_of(v);
    canvas_rect(c, bar, COLOR_SHADE, COLOR_SHADE);
    SDL_FRect row = {bar.x + PAD * u, bar.y + 0.5f * (bar.h - BUTTON * u), bar.w - 2 * PAD * u,
                     BUTTON * u};
    char text[64];
    snprintf(text, sizeof text, "%" PRId64 " / %" PRId64, step_of(p), p->progress.end);
    float buttons = (4 * BUTTON + 3.4f * WORD + 8 * GAP) * u;
    if (row.w - buttons - COUNTER * u >= LINE_MIN * u)
        draw_buttons(v, &row);
    SDL_FRect counter = take(&row, -COUNTER * u, 2 * gap);
    canvas_text_fit(c, counter.x, counter.y + 16.5f * u, counter.w, COLOR_TEXT, text);
    take(&row, KNOB * u, 0);
    draw_line(v, row);
    if (v->lists_calls)
        draw_calls(v, c);
}

void timeline_tell_step(viewer *v, float x, float y) {
    const playback *p = v->session.played;
    if (!p)
        return;
    const thud_player_progress *at = &p->progress;
    char text[160];
    int used = snprintf(text, sizeof text, p->forked ? "Fork of step %" PRId64 : "Step %" PRId64,
                        at->steps);
    if (p->forked)
        snprintf(text + used, sizeof text - (size_t)used,
                 ", %" PRId64 " steps by hand; H goes back to the recording", p->forked_steps);
    else
        snprintf(text + used, sizeof text - (size_t)used,
                 " of %" PRId64 ", %.2f s, %" PRId64 " hashes were the same%s", at->end,
                 (double)at->steps * v->session.time_step, at->hashes,
                 at->differs ? ", and now one differs" : "");
    canvas_text(&v->canvas, x, y, at->differs ? COLOR_OPEN : COLOR_TEXT, text);
}

void timeline_mark(viewer *v) {
    const playback *p = v->session.played;
    thud_body_state body;
    if (!p || !p->progress.differs || p->forked ||
        thud_body_get_state(p->world, p->progress.body, &body) != THUD_OK)
        return;
    canvas *c = &v->canvas;
    float u = c->unit, radius = (float)(v->session.scene.length_scale * v->camera.scale);
    radius = fmaxf(9 * u, fminf(radius, 60 * u));
    SDL_FPoint at = camera_to_screen(&v->camera, body.center);
    canvas_ring(c, at, radius, 2 * u, COLOR_OPEN);
    canvas_text(c, at.x + radius + 4 * u, at.y, COLOR_OPEN, "differs");
}
