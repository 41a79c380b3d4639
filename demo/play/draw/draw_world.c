/* draw_world.c: see draw_world.h. Bodies are drawn at their interpolated poses; shapes that are too
 * small for an edge are drawn without one. */
#include "draw/draw_world.h"

#include "draw/draw_terrain.h"
#include "draw/palette.h"

#include <math.h>

double draw_grid_step(const canvas *c, const camera *view) {
    double wanted = 70 * c->unit / view->scale;
    double power = pow(10, floor(log10(wanted)));
    double digits = wanted / power;
    return power * (digits <= 1 ? 1 : digits <= 2 ? 2 : digits <= 5 ? 5 : 10);
}

void draw_background(canvas *c, const camera *view) {
    canvas_rect(c, (SDL_FRect){0, 0, (float)c->width, (float)c->height}, COLOR_SKY_TOP,
                COLOR_SKY_BOTTOM);
    thud_pos lower, upper;
    camera_bounds(view, &lower, &upper);
    double step = draw_grid_step(c, view);
    SDL_FRect r = view->view;
    float width = floorf(fmaxf(c->unit, 1));
    for (double i = ceil(lower.x / step); i <= floor(upper.x / step); i++) {
        float x = floorf(camera_to_screen(view, (thud_pos){i * step, 0}).x);
        SDL_Color color = i == 0 ? COLOR_AXIS : COLOR_GRID;
        canvas_rect(c, (SDL_FRect){x, r.y, width, r.h}, color, color);
    }
    for (double i = ceil(lower.y / step); i <= floor(upper.y / step); i++) {
        float y = floorf(camera_to_screen(view, (thud_pos){0, i * step}).y);
        SDL_Color color = i == 0 ? COLOR_AXIS : COLOR_GRID;
        canvas_rect(c, (SDL_FRect){r.x, y, r.w, width}, color, color);
    }
}

/* A shape's fill is darker than its edge, so that adjacent bodies of a pile can be told apart. */
static canvas_style style_of(const canvas *c, SDL_Color color, float size) {
    SDL_Color dark = COLOR_SKY_TOP;
    dark.a = color.a;
    SDL_Color fill = color_mix(color, dark, 0.38f);
    if (size < 3 * c->unit)
        return (canvas_style){color_mix(color, dark, 0.2f), color_mix(color, dark, 0.2f), 0};
    return (canvas_style){fill, color, 1.4f * c->unit};
}

void draw_circle(canvas *c, SDL_FPoint center, float radius, float cosine, float sine,
                 SDL_Color color) {
    canvas_circle(c, center, fmaxf(radius, 0.5f), style_of(c, color, radius));
    if (radius > 5 * c->unit) {
        SDL_FPoint from = {center.x + 0.25f * radius * cosine, center.y - 0.25f * radius * sine};
        SDL_FPoint to = {center.x + 0.72f * radius * cosine, center.y - 0.72f * radius * sine};
        canvas_line(c, from, to, fminf(1.4f * c->unit, 0.2f * radius), color);
    }
}

void draw_box(canvas *c, SDL_FPoint center, SDL_FPoint half, float cosine, float sine,
              SDL_Color color) {
    SDL_FPoint at_least = {fmaxf(half.x, 0.5f), fmaxf(half.y, 0.5f)};
    canvas_box(c, center, (SDL_FPoint){cosine, -sine}, at_least,
               style_of(c, color, fminf(half.x, half.y)));
}

SDL_Color draw_dimmed(SDL_Color color) {
    return color_mix(color, COLOR_SKY_BOTTOM, 0.6f);
}

static void draw_sensor(canvas *c, const camera *view, SDL_FPoint center,
                        const session_shape *shape, float cosine, float sine) {
    canvas_style style = {color_fade(COLOR_SENSOR, 0.14f), color_fade(COLOR_SENSOR, 0.8f),
                          1.2f * c->unit};
    float scale = (float)view->scale;
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        canvas_circle(c, center, shape->half.x * scale, style);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        canvas_box(c, center, (SDL_FPoint){cosine, -sine},
                   (SDL_FPoint){shape->half.x * scale, shape->half.y * scale}, style);
        break;
    case THUD_SHAPE_TERRAIN: /* draw_terrain draws it, sensor or not */
        break;
    }
}

static void draw_shape(canvas *c, const camera *view, const session_shape *shape, thud_pose pose,
                       SDL_Color color) {
    float x = pose.x + pose.c * shape->offset.x - pose.s * shape->offset.y;
    float y = pose.y + pose.s * shape->offset.x + pose.c * shape->offset.y;
    float cosine = pose.c * shape->c - pose.s * shape->s;
    float sine = pose.s * shape->c + pose.c * shape->s;
    SDL_FPoint center = camera_from_center(view, x, y);
    float scale = (float)view->scale;
    SDL_FPoint half = {shape->half.x * scale, shape->half.y * scale};
    if (shape->sensor) {
        draw_sensor(c, view, center, shape, cosine, sine);
        return;
    }
    switch (shape->kind) {
    case THUD_SHAPE_CIRCLE:
        draw_circle(c, center, half.x, cosine, sine, color);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        draw_box(c, center, half, cosine, sine, color);
        break;
    case THUD_SHAPE_TERRAIN: /* draw_terrain draws it */
        break;
    }
}

static SDL_Color body_color(const session *s, const session_body *body, bool dim) {
    static const SDL_Color colors[COLOR_BODY_COUNT] = COLOR_BODIES;
    if (body->kind == THUD_BODY_STATIC)
        return COLOR_STATIC;
    if (body->kind == THUD_BODY_KINEMATIC)
        return COLOR_KINEMATIC;
    thud_body_state state;
    if (thud_body_get_state(s->world, body->id, &state) != THUD_OK)
        return COLOR_STATIC;
    if (state.quarantined)
        return COLOR_QUARANTINED;
    unsigned look = body->look > 0 ? (unsigned)body->look - 1 : body->id.index1 * 2654435761u >> 16;
    SDL_Color color = colors[look % COLOR_BODY_COUNT];
    return dim && !state.awake ? draw_dimmed(color) : color;
}

/* Whether a body may be visible. */
static bool in_sight(const camera *view, const session_body *body, thud_pose pose) {
    float scale = (float)view->scale;
    float reach = body->reach * scale + 2;
    return !(fabsf(pose.x) * scale > 0.5f * view->view.w + reach) &&
           !(fabsf(pose.y) * scale > 0.5f * view->view.h + reach);
}

void draw_world(canvas *c, const camera *view, session *s, overlay_set overlays) {
    bool islands = overlays_have(overlays, OVERLAY_ISLANDS);
    bool dim = overlays_have(overlays, OVERLAY_SLEEPING);
    int count = 0;
    const thud_pose *poses = thud_poses_of(s->world, view->center, s->alpha, &count);
    for (int pass = 0; pass < 2; pass++) /* dynamic bodies are drawn over the others */
        for (int i = 0; i < s->body_count; i++) {
            const session_body *body = &s->bodies[i];
            int slot = (int)body->id.index1 - 1;
            bool moves = body->kind == THUD_BODY_DYNAMIC;
            if (moves != (pass == 1) || (moves && islands) || slot >= count ||
                isnan(poses[slot].x) || !in_sight(view, body, poses[slot]))
                continue;
            SDL_Color color = body_color(s, body, dim);
            for (int k = 0; k < body->shape_count; k++) {
                const session_shape *shape = &s->shapes[body->first_shape + k];
                if (shape->kind == THUD_SHAPE_TERRAIN)
                    draw_terrain(c, view, s->world, shape->id, poses[slot]);
                else
                    draw_shape(c, view, shape, poses[slot], color);
            }
        }
}
