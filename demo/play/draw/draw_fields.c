/* draw_fields.c: see draw_fields.h. */
#include "draw/draw_fields.h"

#include "draw/palette.h"

#include <math.h>

/* Opacity of water at its surface, and from DEEP downwards. */
static const float LIGHT = 0.24f, DARK = 0.62f;
static const float DEEP = 6; /* depth at which the water is darkest, m */

static const double RING_STEPS = 40; /* number of steps for which a ring is visible */
static const double RING_SPEED = 18; /* growth of its radius, m/s */

static SDL_Color water_color(float depth) {
    float part = fminf(depth / DEEP, 1);
    return color_fade(color_mix(COLOR_WATER, COLOR_WATER_DEEP, part),
                      LIGHT + (DARK - LIGHT) * part);
}

/* Draws the water above one segment of the ground; positions are relative to the view's centre. */
static void draw_column(canvas *c, const camera *view, thud_vec2 a, thud_vec2 b, float level) {
    if (a.y >= level && b.y >= level)
        return;
    float cut = (level - a.y) / (b.y - a.y);
    thud_vec2 shore = {a.x + cut * (b.x - a.x), level};
    if (a.y > level)
        a = shore;
    else if (b.y > level)
        b = shore;
    SDL_FPoint corners[4] = {camera_from_center(view, a.x, level),
                             camera_from_center(view, b.x, level),
                             camera_from_center(view, b.x, b.y),
                             camera_from_center(view, a.x, a.y)};
    for (int i = 0; i < 4; i++)
        corners[i].x = roundf(corners[i].x);
    SDL_Color top = water_color(0);
    SDL_Color colors[4] = {top, top, water_color(level - b.y), water_color(level - a.y)};
    canvas_quad(c, corners, colors);
    canvas_line(c, corners[0], corners[1], 1.5f * c->unit, COLOR_SURFACE_OF_WATER);
}

static void draw_water_over(canvas *c, const camera *view, const thud_terrain *t, thud_pose pose,
                            float level) {
    if (t->kind != THUD_TERRAIN_IRREGULAR)
        return;
    for (int i = 0; i + 1 < t->count; i++) {
        const thud_pos *p = &t->points[i];
        draw_column(c, view, (thud_vec2){(float)(pose.x + p[0].x), (float)(pose.y + p[0].y)},
                    (thud_vec2){(float)(pose.x + p[1].x), (float)(pose.y + p[1].y)}, level);
    }
}

static void draw_water(canvas *c, const camera *view, session *s) {
    int count = 0;
    const thud_pose *poses = thud_poses_of(s->world, view->center, s->alpha, &count);
    float level = (float)(s->scene.fields.water_level - view->center.y);
    for (int i = 0; i < s->body_count; i++) {
        const session_body *body = &s->bodies[i];
        int slot = (int)body->id.index1 - 1;
        for (int k = 0; k < body->shape_count && slot < count; k++) {
            thud_terrain terrain;
            const session_shape *shape = &s->shapes[body->first_shape + k];
            if (shape->kind == THUD_SHAPE_TERRAIN &&
                thud_shape_get_terrain(s->world, shape->id, &terrain) == THUD_OK)
                draw_water_over(c, view, &terrain, poses[slot], level);
        }
    }
}

/* Draws the ring of an explosion `age` steps after it. */
static void draw_ring(canvas *c, const camera *view, const session *s, thud_pos center,
                      double age) {
    float part = (float)(age / RING_STEPS);
    if (part < 0 || part > 1)
        return;
    SDL_FPoint at = camera_to_screen(view, center);
    float radius = (float)((0.4 + RING_SPEED * age * s->time_step) * view->scale);
    float glow = (1 - part) * (1 - part);
    SDL_Color flash = color_fade(COLOR_BLAST, 0.5f * glow);
    canvas_circle(c, at, 0.5f * radius, (canvas_style){flash, color_fade(flash, 0), 0.4f * radius});
    SDL_Color edge = color_fade(COLOR_BLAST, glow);
    canvas_circle(c, at, radius,
                  (canvas_style){color_fade(edge, 0), edge, (4 + 12 * glow) * c->unit});
}

void draw_fields(canvas *c, const camera *view, session *s) {
    const scene_fields *fields = &s->scene.fields;
    double step = (double)thud_stats_of(s->world).steps - 1 + s->alpha;
    if (fields->water_density > 0)
        draw_water(c, view, s);
    for (int i = 0; i < fields->blast_count; i++) {
        const scene_blast *blast = &fields->blasts[i];
        draw_ring(c, view, s, (thud_pos){blast->x, blast->y}, step - blast->step);
    }
    for (int i = 0; i < SESSION_BLASTS; i++)
        draw_ring(c, view, s, s->blasts[i].at, step - s->blasts[i].step);
}
