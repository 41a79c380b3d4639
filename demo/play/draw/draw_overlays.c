/* draw_overlays.c: see draw_overlays.h. */
#include "draw/draw_overlays.h"

#include "draw/draw_world.h"
#include "draw/palette.h"

#include <math.h>

/* The context of the debug-draw callbacks. */
typedef struct sink {
    canvas *canvas;
    const camera *view;
    overlay_set overlays;
    float mark; /* radius of a contact's dot, pixels; smaller if bodies are small */
} sink;

/* The colour of an island. The hue advances by the golden ratio, so that consecutive numbers have
 * very different hues. */
static SDL_Color island_color(int island) {
    float hue = 6 * fmodf((float)island * 0.61803399f, 1);
    float rgb[3];
    for (int i = 0; i < 3; i++) {
        float k = fmodf((float)(5 - 2 * i) + hue, 6); /* HSV with S = 0.55, V = 0.95 */
        rgb[i] = 0.95f * (1 - 0.55f * fmaxf(0, fminf(fminf(k, 4 - k), 1)));
    }
    return (SDL_Color){(Uint8)(255 * rgb[0]), (Uint8)(255 * rgb[1]), (Uint8)(255 * rgb[2]), 255};
}

/* The colour of a shape by its island. False if it is not to be drawn: islands are off, or the
 * shape was drawn with the world. */
static bool island_style(const sink *k, thud_style style, int island, SDL_Color *color) {
    if (!overlays_have(k->overlays, OVERLAY_ISLANDS) ||
        (style != THUD_STYLE_DYNAMIC && style != THUD_STYLE_SLEEPING))
        return false;
    *color = island < 0 ? COLOR_STATIC : island_color(island);
    if (style == THUD_STYLE_SLEEPING && overlays_have(k->overlays, OVERLAY_SLEEPING))
        *color = draw_dimmed(*color);
    return true;
}

/* Draws the outline of a box, rotated by (cosine c, sine s). */
static void outline(const sink *k, thud_vec2 center, thud_vec2 half, float c, float s,
                    SDL_Color color) {
    SDL_FPoint corners[4];
    for (int i = 0; i < 4; i++) {
        float u = i == 1 || i == 2 ? half.x : -half.x, v = i >= 2 ? half.y : -half.y;
        corners[i] =
            camera_from_center(k->view, center.x + c * u - s * v, center.y + s * u + c * v);
    }
    for (int i = 0; i < 4; i++)
        canvas_line(k->canvas, corners[i], corners[(i + 1) % 4], k->canvas->unit, color);
}

/* Callbacks of thud_debug_draw. Each draws one primitive in the colour of its style, if the overlay
 * is on that the style belongs to. */
static void on_circle(thud_vec2 center, float radius, float c, float s, thud_style style,
                      int island, void *context) {
    const sink *k = context;
    SDL_Color color;
    if (style == THUD_STYLE_MOTION)
        canvas_ring(k->canvas, camera_from_center(k->view, center.x, center.y),
                    radius * (float)k->view->scale, 1.2f * k->canvas->unit, COLOR_MOTION);
    else if (island_style(k, style, island, &color))
        draw_circle(k->canvas, camera_from_center(k->view, center.x, center.y),
                    radius * (float)k->view->scale, c, s, color);
}

static void on_box(thud_vec2 center, thud_vec2 half, float c, float s, thud_style style, int island,
                   void *context) {
    const sink *k = context;
    SDL_Color color;
    if (style == THUD_STYLE_BOUNDS || style == THUD_STYLE_CELL) {
        outline(k, center, half, 1, 0,
                color_fade(style == THUD_STYLE_CELL ? COLOR_CELL : COLOR_BOUNDS, 0.75f));
    } else if (style == THUD_STYLE_MOTION) {
        outline(k, center, half, c, s, COLOR_MOTION);
    } else if (island_style(k, style, island, &color)) {
        float scale = (float)k->view->scale;
        draw_box(k->canvas, camera_from_center(k->view, center.x, center.y),
                 (SDL_FPoint){half.x * scale, half.y * scale}, c, s, color);
    }
}

/* Draws a normal with a length in pixels, since only its direction has a meaning. */
static void draw_normal(const sink *k, SDL_FPoint a, SDL_FPoint b) {
    float dx = b.x - a.x, dy = b.y - a.y, length = hypotf(dx, dy);
    if (length <= 0)
        return;
    float wanted = 5.5f * k->mark / length;
    canvas_line(k->canvas, a, (SDL_FPoint){a.x + dx * wanted, a.y + dy * wanted},
                fmaxf(0.6f * k->mark, 1.6f), COLOR_NORMAL);
}

static void on_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    const sink *k = context;
    SDL_FPoint from = camera_from_center(k->view, a.x, a.y);
    SDL_FPoint to = camera_from_center(k->view, b.x, b.y);
    if (style == THUD_STYLE_NORMAL && overlays_have(k->overlays, OVERLAY_NORMALS))
        draw_normal(k, from, to);
    else if (style == THUD_STYLE_INTERVAL || style == THUD_STYLE_INTERVAL_OVERLAPPING)
        canvas_line(k->canvas, from, to, 2 * k->canvas->unit,
                    style == THUD_STYLE_INTERVAL ? COLOR_INTERVAL : COLOR_TOUCHING);
    else if (style == THUD_STYLE_PAIR || style == THUD_STYLE_PAIR_TOUCHING)
        canvas_line(k->canvas, from, to, k->canvas->unit,
                    style == THUD_STYLE_PAIR ? COLOR_PAIR : COLOR_TOUCHING);
    else if (style == THUD_STYLE_MOTION)
        canvas_line(k->canvas, from, to, 1.2f * k->canvas->unit, COLOR_MOTION);
}

static void on_point(thud_vec2 p, thud_style style, void *context) {
    const sink *k = context;
    if (style == THUD_STYLE_CONTACT && overlays_have(k->overlays, OVERLAY_CONTACTS))
        canvas_circle(k->canvas, camera_from_center(k->view, p.x, p.y), k->mark,
                      (canvas_style){COLOR_CONTACT, COLOR_CONTACT, 0});
}

void draw_overlays(canvas *c, const camera *view, session *s, overlay_set overlays, float footer) {
    float body = (float)(s->scene.length_scale * view->scale);
    sink k = {c, view, overlays, fmaxf(1, fminf(0.1f * body, 2.4f * c->unit))};
    thud_debug_draw draw = {.origin = view->center, .context = &k};
    draw.circle = on_circle;
    draw.box = on_box;
    draw.line = on_line;
    draw.point = on_point;
    /* In separate passes, so that contacts are drawn over bounds, and bounds over islands. */
    const struct {
        overlay_set wanted;
        unsigned flags;
    } passes[] = {
        {1u << OVERLAY_ISLANDS, THUD_DRAW_SHAPES | THUD_DRAW_ISLANDS},
        {1u << OVERLAY_CELLS, THUD_DRAW_CELLS},
        {1u << OVERLAY_BOUNDS, THUD_DRAW_SHAPE_BOUNDS},
        {1u << OVERLAY_AXES, THUD_DRAW_AXES},
        {1u << OVERLAY_MOTIONS, THUD_DRAW_MOTIONS},
        {1u << OVERLAY_PAIRS, THUD_DRAW_PAIRS},
        {1u << OVERLAY_CONTACTS | 1u << OVERLAY_NORMALS, THUD_DRAW_CONTACTS},
    };
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++)
        if (overlays & passes[i].wanted) {
            camera_bounds(view, &draw.lower, &draw.upper);
            /* The intervals are drawn from the lower edge up. */
            if (passes[i].flags == THUD_DRAW_AXES)
                draw.lower.y += footer / view->scale;
            draw.flags = passes[i].flags;
            thud_world_draw(s->world, &draw);
        }
}

void draw_pull(canvas *c, const camera *view, thud_pos from, thud_pos to) {
    SDL_FPoint a = camera_to_screen(view, from), b = camera_to_screen(view, to);
    canvas_line(c, a, b, 1.5f * c->unit, color_fade(COLOR_GRAB, 0.7f));
    canvas_circle(c, a, 3 * c->unit, (canvas_style){COLOR_GRAB, COLOR_GRAB, 0});
}
