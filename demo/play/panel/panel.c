/* panel.c: see panel.h. The controls are at the bottom; the list above them has the other space and
 * scrolls. */
#include "panel/panel.h"

#include "draw/palette.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    WIDTH = 236, /* in points, like all sizes here */
    PAD = 12,
    ROW = 24,
    GAP = 6,
    LIST_ROW = 22,
    TITLE_HEIGHT = 40,
    LABEL_HEIGHT = 20
};

float panel_width(const canvas *c) {
    return WIDTH * c->unit;
}

/* The rectangle of column `index` of `count` in a row of the panel. */
static SDL_FRect cell(const viewer *v, float y, int index, int count) {
    float u = v->canvas.unit;
    float inside = (WIDTH - 2 * PAD) * u, gap = GAP * u;
    float width = (inside - gap * (float)(count - 1)) / (float)count;
    return (SDL_FRect){PAD * u + (float)index * (width + gap), y, width, ROW * u};
}

static float label(viewer *v, float y, const char *text) {
    canvas_text(&v->canvas, PAD * v->canvas.unit, y + 14 * v->canvas.unit, COLOR_TEXT_DIM, text);
    return y + LABEL_HEIGHT * v->canvas.unit;
}

/* This function and the next ones draw a group of controls at the height y, and return the y below
 * it. */
static float draw_time_controls(viewer *v, float y) {
    canvas *c = &v->canvas;
    float next = (ROW + GAP) * c->unit;
    if (ui_button(&v->ui, c, cell(v, y, 0, 4), v->session.paused ? "Run" : "Pause",
                  v->session.paused))
        viewer_toggle_pause(v);
    if (ui_button(&v->ui, c, cell(v, y, 1, 4), "Step", false))
        viewer_single_step(v);
    if (ui_button(&v->ui, c, cell(v, y, 2, 4), "Reset", false))
        viewer_reset(v);
    if (ui_button(&v->ui, c, cell(v, y, 3, 4), "Home", false))
        viewer_look_home(v);
    y += next;
    char speed[32];
    snprintf(speed, sizeof speed, "%gx", v->session.speed);
    if (ui_button(&v->ui, c, cell(v, y, 0, 3), "Slower", false))
        viewer_change_speed(v, -1);
    SDL_FRect middle = cell(v, y, 1, 3);
    float width = font_width(&c->text, speed, strlen(speed));
    canvas_text(c, middle.x + 0.5f * (middle.w - width), y + 16.5f * c->unit, COLOR_TEXT_STRONG,
                speed);
    if (ui_button(&v->ui, c, cell(v, y, 2, 3), "Faster", false))
        viewer_change_speed(v, 1);
    return y + next;
}

static float draw_quality(viewer *v, float y) {
    y = label(v, y, "Quality");
    for (int i = 0; i < QUALITY_CHOICES; i++)
        if (ui_button(&v->ui, &v->canvas, cell(v, y, i, QUALITY_CHOICES), QUALITIES[i]->name,
                      session_quality(&v->session) == i))
            session_set_quality(&v->session, i);
    return y + (ROW + GAP) * v->canvas.unit;
}

/* Each click chooses the next one. A world does not tell its broadphase: that of a recording is not
 * known. */
static float draw_systems(viewer *v, float y) {
    session *s = &v->session;
    int detection = session_detection(s);
    y = label(v, y, "Detection, broadphase");
    if (ui_button(&v->ui, &v->canvas, cell(v, y, 0, 2), DETECTIONS[detection].name,
                  detection != DETECTION_DEFAULT))
        viewer_set_detection(v, (s->detection + 1) % DETECTION_CHOICES);
    if (ui_button(&v->ui, &v->canvas, cell(v, y, 1, 2),
                  s->played ? "as recorded" : BROADPHASES[s->broadphase].name,
                  !s->played && s->broadphase != BROADPHASE_DEFAULT))
        viewer_set_broadphase(v, (s->broadphase + 1) % BROADPHASE_CHOICES);
    return y + (ROW + GAP) * v->canvas.unit;
}

static float draw_toggles(viewer *v, float y) {
    y = label(v, y, "Show");
    for (int i = 0; i < OVERLAY_COUNT; i++) {
        char text[32];
        snprintf(text, sizeof text, "%c %s", overlay_key((overlay)i), overlay_name((overlay)i));
        SDL_FRect r = cell(v, y + (float)(i / 2) * (ROW + GAP) * v->canvas.unit, i % 2, 2);
        if (ui_toggle(&v->ui, &v->canvas, r, text, overlay_color((overlay)i),
                      overlays_have(v->overlays, (overlay)i)))
            viewer_toggle_overlay(v, (overlay)i);
    }
    return y + (float)((OVERLAY_COUNT + 1) / 2) * (ROW + GAP) * v->canvas.unit;
}

static float draw_spawn(viewer *v, float y) {
    y = label(v, y, "Drop a new");
    if (ui_button(&v->ui, &v->canvas, cell(v, y, 0, 2), "Circle", false))
        viewer_spawn_at_home(v, THUD_SHAPE_CIRCLE);
    if (ui_button(&v->ui, &v->canvas, cell(v, y, 1, 2), "Box", false))
        viewer_spawn_at_home(v, THUD_SHAPE_OBB);
    return y + (ROW + GAP) * v->canvas.unit;
}

static float controls_height(void) {
    enum { ROWS = 2 + 1 + 1 + (OVERLAY_COUNT + 1) / 2 + 1, LABELS = 4 };
    return ROWS * (ROW + GAP) + LABELS * LABEL_HEIGHT + PAD;
}

/* The row of an entry in the list, with headings: one before the scenes, and an empty row and one
 * before the levels. */
static int list_row(const viewer *v, int entry) {
    return entry + (v->catalog.entries[entry].path ? 3 : 1);
}

/* Scrolls by the wheel, and to the selected entry if that was asked for. */
static void scroll_list(viewer *v, SDL_FRect area, int rows) {
    float row = LIST_ROW * v->canvas.unit;
    if (ui_hovers(&v->ui, area))
        v->list_scroll -= 3 * row * v->ui.wheel;
    if (v->reveal && v->selected >= 0) {
        float top = row * (float)list_row(v, v->selected);
        v->list_scroll = fminf(v->list_scroll, top - row);
        v->list_scroll = fmaxf(v->list_scroll, top + row - area.h);
        v->reveal = false;
    }
    v->list_scroll = fmaxf(0, fminf(v->list_scroll, row * (float)rows - area.h));
}

static void draw_scroll_bar(viewer *v, SDL_FRect area, int rows) {
    float u = v->canvas.unit;
    float total = LIST_ROW * u * (float)rows;
    if (total <= area.h)
        return;
    SDL_FRect bar = {(WIDTH - 7) * u, area.y + area.h * v->list_scroll / total, 3 * u,
                     area.h * area.h / total};
    canvas_round_rect(&v->canvas, bar, 2 * u,
                      (canvas_style){COLOR_WIDGET_HOVER, COLOR_WIDGET_HOVER, 0});
}

static void draw_list(viewer *v, SDL_FRect area) {
    canvas *c = &v->canvas;
    float row = LIST_ROW * c->unit;
    int rows = v->catalog.count > 0 ? list_row(v, v->catalog.count - 1) + 1 : 0;
    scroll_list(v, area, rows);
    canvas_flush(c);
    SDL_Rect clip = {(int)area.x, (int)area.y, (int)area.w, (int)area.h};
    SDL_RenderSetClipRect(c->renderer, &clip);
    bool usable = ui_hovers(&v->ui, area);
    int chosen = -1;
    for (int i = 0; i < v->catalog.count; i++) {
        bool first_level = v->catalog.entries[i].path && (i == 0 || v->catalog.entries[i - 1].info);
        float y = area.y + row * (float)list_row(v, i) - v->list_scroll;
        if (i == 0 || first_level)
            label(v, y - row, first_level ? "Levels" : "Scenes");
        SDL_FRect r = {area.x + (PAD - 6) * c->unit, y, area.w - 2 * (PAD - 6) * c->unit, row};
        if (y + row < area.y || y > area.y + area.h)
            continue;
        bool pressed = v->ui.pressed;
        v->ui.pressed = pressed && usable;
        if (ui_list_row(&v->ui, c, r, v->catalog.entries[i].title, i == v->selected))
            chosen = i;
        else
            v->ui.pressed = pressed;
    }
    canvas_flush(c);
    SDL_RenderSetClipRect(c->renderer, NULL);
    draw_scroll_bar(v, area, rows);
    if (chosen >= 0)
        viewer_open(v, chosen);
}

void panel_draw(viewer *v) {
    canvas *c = &v->canvas;
    float u = c->unit, height = (float)c->height;
    canvas_rect(c, (SDL_FRect){0, 0, WIDTH * u, height}, COLOR_PANEL, COLOR_PANEL);
    canvas_rect(c, (SDL_FRect){WIDTH * u - u, 0, u, height}, COLOR_PANEL_EDGE, COLOR_PANEL_EDGE);
    float name = canvas_text(c, PAD * u, 25 * u, COLOR_TEXT_STRONG, "thud");
    canvas_text(c, PAD * u + name + 8 * u, 25 * u, COLOR_TEXT_DIM, "2D game physics");
    float top = fmaxf(height - controls_height() * u, (TITLE_HEIGHT + 3 * LIST_ROW) * u);
    draw_list(v, (SDL_FRect){0, TITLE_HEIGHT * u, WIDTH * u, top - (TITLE_HEIGHT + GAP) * u});
    canvas_rect(c, (SDL_FRect){0, top - 4 * u, WIDTH * u, u}, COLOR_PANEL_EDGE, COLOR_PANEL_EDGE);
    float y = top + GAP * u;
    y = draw_time_controls(v, y);
    y = draw_quality(v, y);
    y = draw_systems(v, y);
    y = draw_toggles(v, y);
    draw_spawn(v, y);
}
