/* draw_measures.c: see draw_measures.h. */
#include "draw/draw_measures.h"

#include "draw/palette.h"

#include <thud/thud_volumes.h>

#include <math.h>
#include <stdio.h>

/* Sum of both speeds below which they count as at rest, units of length / s. Chosen. */
static const double STILL = 0.02;

/* A position on the screen. */
static SDL_FPoint at(const camera *view, double x, double y) {
    return camera_from_center(view, (float)x, (float)y);
}

void draw_outline(canvas *c, const camera *view, const thud_geometry *s, float width,
                  SDL_Color color) {
    if (s->kind == THUD_SHAPE_CIRCLE) {
        canvas_ring(c, at(view, s->x, s->y), (float)(s->hx * view->scale), width, color);
        return;
    }
    SDL_FPoint corners[4];
    for (int i = 0; i < 4; i++) {
        double u = i == 1 || i == 2 ? s->hx : -s->hx, v = i >= 2 ? s->hy : -s->hy;
        corners[i] = at(view, s->x + s->c * u - s->s * v, s->y + s->s * u + s->c * v);
    }
    for (int i = 0; i < 4; i++)
        canvas_line(c, corners[i], corners[(i + 1) % 4], width, color);
}

static void dot(canvas *c, SDL_FPoint center, SDL_Color color) {
    canvas_circle(c, center, 3.5f * c->unit, (canvas_style){color, COLOR_TEXT_STRONG, c->unit});
}

void draw_closest(canvas *c, const camera *view, const thud_geometry *a, const thud_geometry *b) {
    thud_closest between;
    if (thud_geometry_closest(a, b, &between) != THUD_OK)
        return;
    SDL_Color color = between.distance < 0 ? COLOR_CONTACT : COLOR_TOUCHING;
    SDL_FPoint from = at(view, between.ax, between.ay), to = at(view, between.bx, between.by);
    char text[48];
    snprintf(text, sizeof text, between.distance < 0 ? "%.2f deep" : "%.2f apart",
             fabs(between.distance));
    canvas_line(c, from, to, 2 * c->unit, color);
    dot(c, from, color);
    dot(c, to, color);
    canvas_text(c, 0.5f * (from.x + to.x) - 34 * c->unit, fminf(from.y, to.y) - 10 * c->unit, color,
                text);
}

/* The shape moved on for `time` seconds. */
static thud_geometry later(const thud_geometry *s, thud_motion by, double time) {
    double angle = s->kind == THUD_SHAPE_OBB ? atan2(s->s, s->c) + time * by.turn : 0;
    thud_geometry there = *s;
    there.x += time * by.dx;
    there.y += time * by.dy;
    there.c = cos(angle);
    there.s = sin(angle);
    return there;
}

void draw_impact(canvas *c, const camera *view, const thud_geometry *a, thud_motion by_a,
                 const thud_geometry *b, thud_motion by_b) {
    bool hit = false;
    double time = 1;
    if (hypot(by_a.dx, by_a.dy) + hypot(by_b.dx, by_b.dy) < STILL ||
        thud_geometry_time_of_impact(a, by_a, b, by_b, 0, &hit, &time) != THUD_OK)
        return;
    SDL_Color color = color_fade(hit ? COLOR_CONTACT : COLOR_MOTION, 0.8f);
    thud_geometry end[] = {later(a, by_a, time), later(b, by_b, time)};
    draw_outline(c, view, &end[0], 1.2f * c->unit, color);
    draw_outline(c, view, &end[1], 1.2f * c->unit, color);
    canvas_line(c, at(view, a->x, a->y), at(view, end[0].x, end[0].y), c->unit, color);
    canvas_line(c, at(view, b->x, b->y), at(view, end[1].x, end[1].y), c->unit, color);
    if (hit) {
        char text[48];
        snprintf(text, sizeof text, "touch in %.2f s", time);
        canvas_text(c, at(view, end[1].x, end[1].y).x, at(view, end[1].x, end[1].y).y, color, text);
    }
}

static double area(const thud_geometry *s) {
    return s->kind == THUD_SHAPE_CIRCLE ? 3.14159265358979 * s->hx * s->hx : 4 * s->hx * s->hy;
}

void draw_volumes(canvas *c, const camera *view, const thud_geometry *shape) {
    static const struct {
        thud_shape_kind kind;
        const char *name;
        SDL_Color color;
    } volumes[] = {{THUD_SHAPE_CIRCLE, "circle", COLOR_INTERVAL},
                   {THUD_SHAPE_AABB, "AABB", COLOR_BOUNDS},
                   {THUD_SHAPE_OBB, "OBB", COLOR_MOTION}};
    SDL_FPoint text = at(view, shape->x, shape->y);
    text.x -= 28 * c->unit;
    text.y += (float)(hypot(shape->hx, shape->hy) * view->scale) + 18 * c->unit;
    for (size_t i = 0; i < sizeof volumes / sizeof volumes[0]; i++) {
        thud_volume around;
        char line[48];
        if (thud_volume_around_shape(volumes[i].kind, shape, &around) != THUD_OK)
            continue;
        draw_outline(c, view, &around, 1.5f * c->unit, volumes[i].color);
        snprintf(line, sizeof line, "%s %.2f", volumes[i].name, area(&around) / area(shape));
        canvas_text(c, text.x, text.y, volumes[i].color, line);
        text.y += 15 * c->unit;
    }
}
