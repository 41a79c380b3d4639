/* draw_texture.c: see draw_texture.h. The ground is the scene's first body. */
#include "draw/draw_texture.h"

#include "draw/palette.h"

#include <texture.h>

#include <math.h>
#include <stdio.h>

static const SDL_Color COLORS[TEXTURE_ROWS] = COLOR_MATERIALS;
/* Along the ground, m: distance of stripes, half their width, and their depth. */
static const double EVERY = 0.5, HALF = 0.13, DEPTH = 0.32;

static SDL_FPoint to_screen(const camera *view, double x, double y) {
    return camera_to_screen(view, (thud_pos){x, y});
}

/* Draws a box in the ground, whose upper side is centred at `at`; (nx, ny) is the ground's normal.
 */
static void draw_in_ground(canvas *c, const camera *view, thud_pos at, double nx, double ny,
                           thud_pos half, SDL_Color color) {
    SDL_FPoint center = to_screen(view, at.x - half.y * nx, at.y - half.y * ny);
    float scale = (float)view->scale;
    canvas_box(c, center, (SDL_FPoint){(float)ny, (float)nx},
               (SDL_FPoint){(float)half.x * scale, (float)half.y * scale},
               (canvas_style){color, color, 0});
}

/* Draws a terrain line's stripes, every EVERY metres of the texture coordinate u. */
static void draw_stripes(canvas *c, const camera *view, const thud_terrain *line, int row) {
    double next = EVERY / 2;
    texture_place at;
    for (int i = 0; i + 1 < line->count; i++) {
        const thud_pos *a = &line->points[i], *b = a + 1;
        texture_place from, to;
        /* The coordinates at both ends are those of this segment: a vertex is on both of its
         * segments. */
        double middle = 0.5 * (a->x + b->x);
        if (!texture_at(line, row, middle, &at) || !texture_at(line, row, a->x, &from) ||
            !texture_at(line, row, b->x, &to))
            return;
        for (; next < to.uv.u; next += EVERY) {
            double part = (next - from.uv.u) / (to.uv.u - from.uv.u);
            thud_pos place = {a->x + part * (b->x - a->x), a->y + part * (b->y - a->y)};
            draw_in_ground(c, view, place, at.sample.nx, at.sample.ny, (thud_pos){HALF, DEPTH / 2},
                           COLORS[row]);
        }
    }
}

/* The latest print of a foot that was standing at the last frame; null if it has touched down
 * since. */
static texture_print *print_of(texture_prints *prints, thud_shape_id foot) {
    bool stood = false;
    for (int i = 0; i < prints->standing_count; i++)
        stood = stood || prints->standing[i].index1 == foot.index1;
    int oldest = prints->count > TEXTURE_PRINTS ? prints->count - TEXTURE_PRINTS : 0;
    for (int i = prints->count - 1; stood && i >= oldest; i--)
        if (prints->of[i % TEXTURE_PRINTS].foot.index1 == foot.index1)
            return &prints->of[i % TEXTURE_PRINTS];
    return NULL;
}

/* Updates the prints by the contacts of the ground. */
static void tread(texture_prints *prints, const thud_manifold *contacts, int count,
                  uint64_t steps) {
    if (steps < prints->steps)
        prints->count = prints->standing_count = 0;
    prints->steps = steps;
    for (int i = 0; i < count; i++) {
        const thud_manifold *m = &contacts[i];
        texture_print *print = print_of(prints, m->shape_b);
        if (print)
            print->to = m->point[0];
        else
            prints->of[prints->count++ % TEXTURE_PRINTS] =
                (texture_print){m->shape_b, m->point[0], m->point[0], m->normal};
    }
    for (int i = 0; i < count; i++)
        prints->standing[i] = contacts[i].shape_b;
    prints->standing_count = count;
}

static void draw_print(canvas *c, const camera *view, const texture_print *print) {
    double dx = print->to.x - print->from.x, dy = print->to.y - print->from.y;
    thud_pos middle = {print->from.x + 0.5 * dx, print->from.y + 0.5 * dy};
    thud_pos half = {0.12 + 0.5 * sqrt(dx * dx + dy * dy), 0.06};
    draw_in_ground(c, view, middle, print->normal.x, print->normal.y, half, COLOR_PRINT);
}

/* Draws a contact at x: its dot, the two vertices beside it, and the material with both weights. */
static void draw_touch(canvas *c, const camera *view, const thud_terrain *line, int row, double x) {
    texture_place at;
    if (!texture_at(line, row, x, &at))
        return;
    SDL_Color color = COLORS[(int)at.uv.v];
    for (int i = 0; i < 2; i++) {
        const thud_pos *vertex = &line->points[at.sample.segment + i];
        float radius = (float)((0.06 + 0.14 * at.sample.weight[i]) * view->scale);
        canvas_circle(c, to_screen(view, vertex->x, vertex->y), radius,
                      (canvas_style){COLOR_CONTACT, COLOR_CONTACT, 0});
    }
    SDL_FPoint foot = to_screen(view, x, at.sample.height);
    SDL_FPoint label = to_screen(view, x, at.sample.height - 1.2);
    canvas_line(c, foot, label, 1.5f * c->unit, color);
    canvas_circle(c, foot, (float)(0.16 * view->scale),
                  (canvas_style){color, COLOR_TEXT_STRONG, c->unit});
    char text[64];
    snprintf(text, sizeof text, "%s %.2f + %.2f", at.row->name, at.sample.weight[0],
             at.sample.weight[1]);
    canvas_text(c, label.x + 4 * c->unit, label.y, COLOR_TEXT_STRONG, text);
}

/* The texture's row of a terrain line, found by its friction, and the line. -1 for other shapes. */
static int row_of(const session *s, thud_shape_id shape, thud_terrain *line) {
    thud_shape_state state;
    if (thud_shape_get_terrain(s->world, shape, line) != THUD_OK ||
        thud_shape_get_state(s->world, shape, &state) != THUD_OK)
        return -1;
    for (int row = 0; row < TEXTURE_ROWS; row++)
        if (state.friction == (float)TEXTURE[row].friction)
            return row;
    return -1;
}

void draw_texture(canvas *c, const camera *view, const session *s, texture_prints *prints) {
    if (!s->scene.textured || s->body_count == 0)
        return;
    const session_body *ground = &s->bodies[0];
    thud_terrain line;
    for (int i = 0; i < ground->shape_count; i++) {
        thud_shape_id shape = s->shapes[ground->first_shape + i].id;
        int row = row_of(s, shape, &line);
        if (row >= 0)
            draw_stripes(c, view, &line, row);
    }
    thud_manifold all[TEXTURE_FEET], contacts[TEXTURE_FEET];
    int found = 0, count = 0;
    if (thud_body_get_contacts(s->world, ground->id, all, TEXTURE_FEET, &found) != THUD_OK)
        return;
    for (int i = 0; i < found && i < TEXTURE_FEET; i++)
        if (all[i].point_count > 0)
            contacts[count++] = all[i];
    tread(prints, contacts, count, thud_stats_of(s->world).steps);
    for (int i = 0; i < prints->count && i < TEXTURE_PRINTS; i++)
        draw_print(c, view, &prints->of[i]);
    for (int i = 0; i < count; i++) {
        int row = row_of(s, contacts[i].shape_a, &line);
        if (row >= 0)
            draw_touch(c, view, &line, row, contacts[i].point[0].x);
    }
}
