/* draw_sums.c: see draw_sums.h. */
#include "draw_sums.h"

#include "palette.h"

#include <thud/thud_minkowski.h>

#include <math.h>

/* The only shape of the body in a slot, where it stands; false where there is none. */
static bool placed_at(const session *s, const thud_pose *poses, int count, int slot,
                      thud_placed *out) {
    for (int i = 0; i < s->body_count && slot < count; i++) {
        const session_body *body = &s->bodies[i];
        if ((int)body->id.index1 - 1 != slot || body->shape_count != 1)
            continue;
        const session_shape *shape = &s->shapes[body->first_shape];
        const thud_pose *p = &poses[slot];
        *out = (thud_placed){.kind = shape->kind,
                             .x = p->x + p->c * shape->offset.x - p->s * shape->offset.y,
                             .y = p->y + p->s * shape->offset.x + p->c * shape->offset.y,
                             .c = p->c * shape->c - p->s * shape->s,
                             .s = p->s * shape->c + p->c * shape->s,
                             .hx = shape->half.x,
                             .hy = shape->half.y};
        return shape->kind != THUD_TERRAIN;
    }
    return false;
}

/* The outline as it goes on from the last point. */
typedef struct pen {
    canvas *canvas;
    const camera *view;
    SDL_Color color;
    bool down;
    SDL_FPoint at;
} pen;

static void draw_to(pen *p, double x, double y) {
    SDL_FPoint to = camera_from_center(p->view, (float)x, (float)y);
    if (p->down)
        canvas_line(p->canvas, p->at, to, 1.5f * p->canvas->unit, p->color);
    p->at = to;
    p->down = true;
}

/* Directions in which the rounding of a vertex begins and ends. */
static void rounding_of(const thud_minkowski *sum, int vertex, double *from, double *to) {
    int half = sum->count / 2, before = (vertex + sum->count - 1) % sum->count;
    double sign_a = before < half ? 1 : -1, sign_b = vertex < half ? 1 : -1;
    thud_pos a = sum->normals[before % half], b = sum->normals[vertex % half];
    *from = atan2(sign_a * a.y, sign_a * a.x);
    *to = atan2(sign_b * b.y, sign_b * b.x);
    if (*to < *from)
        *to += 2 * 3.14159265358979;
}

static void draw_outline(pen *p, const thud_minkowski *sum, double x, double y) {
    enum { ARC = 12 }; /* lines */
    for (int i = 0; i <= sum->count; i++) { /* and back to the first */
        const thud_pos *vertex = &sum->vertices[i % sum->count];
        double from, to;
        rounding_of(sum, i % sum->count, &from, &to);
        for (int k = 0; k <= ARC; k++) {
            double angle = from + (to - from) * k / ARC;
            draw_to(p, x + vertex->x + sum->radius * cos(angle),
                    y + vertex->y + sum->radius * sin(angle));
        }
    }
}

static void draw_sum(canvas *c, const camera *view, const thud_placed *a, const thud_placed *b) {
    thud_minkowski sum;
    bool inside;
    double distance, nx, ny, x = b->x - a->x, y = b->y - a->y;
    if (thud_minkowski_sum(a, b, &sum) != THUD_OK ||
        thud_minkowski_contains(&sum, x, y, &inside) != THUD_OK ||
        thud_minkowski_distance(&sum, x, y, &distance, &nx, &ny) != THUD_OK)
        return;
    pen p = {.canvas = c, .view = view, .color = inside ? COLOR_CONTACT : COLOR_SUM};
    if (sum.count > 1)
        draw_outline(&p, &sum, a->x, a->y);
    else
        canvas_ring(c, camera_from_center(view, (float)a->x, (float)a->y),
                    (float)(sum.radius * view->scale), 1.5f * c->unit, p.color);
    SDL_FPoint point = camera_from_center(view, (float)b->x, (float)b->y);
    SDL_FPoint edge =
        camera_from_center(view, (float)(b->x - nx * distance), (float)(b->y - ny * distance));
    SDL_FPoint origin = camera_from_center(view, (float)a->x, (float)a->y);
    canvas_line(c, point, edge, c->unit, p.color);
    canvas_circle(c, origin, 2.5f * c->unit, (canvas_style){COLOR_TEXT_DIM, COLOR_TEXT_DIM, 0});
    canvas_circle(c, point, 4 * c->unit, (canvas_style){p.color, COLOR_TEXT_STRONG, c->unit});
}

void draw_sums(canvas *c, const camera *view, session *s) {
    int count = 0;
    const thud_pose *poses = thud_world_poses(s->world, view->center, s->alpha, &count);
    for (int i = 0; i < s->scene.sum_pairs; i++) {
        thud_placed a, b;
        if (placed_at(s, poses, count, 2 * i, &a) && placed_at(s, poses, count, 2 * i + 1, &b))
            draw_sum(c, view, &a, &b);
    }
}
