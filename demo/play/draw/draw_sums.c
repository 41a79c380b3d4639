/* draw_sums.c: see draw_sums.h. */
#include "draw/draw_sums.h"

#include "draw/palette.h"

#include <sum_picture.h>

/* The only shape of the body in a slot, where it stands; false where there is none. */
static bool placed_at(const session *s, const thud_pose *poses, int count, int slot,
                      thud_shape_instance *out) {
    for (int i = 0; i < s->body_count && slot < count; i++) {
        const session_body *body = &s->bodies[i];
        if ((int)body->id.index1 - 1 != slot || body->shape_count != 1)
            continue;
        const session_shape *shape = &s->shapes[body->first_shape];
        const thud_pose *p = &poses[slot];
        *out = (thud_shape_instance){.kind = shape->kind,
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

static void draw_sum(canvas *c, const camera *view, const thud_shape_instance *a,
                     const thud_shape_instance *b) {
    sum_picture sum;
    if (!sum_picture_of(a, b, &sum))
        return;
    SDL_Color color = sum.overlaps ? COLOR_CONTACT : COLOR_SUM;
    SDL_FPoint places[SUM_OUTLINE_MAX];
    for (int i = 0; i < sum.count; i++)
        places[i] = camera_from_center(view, (float)(a->x + sum.outline[i].x),
                                       (float)(a->y + sum.outline[i].y));
    for (int i = 0; i < sum.count; i++)
        canvas_line(c, places[i], places[(i + 1) % sum.count], 1.5f * c->unit, color);
    SDL_FPoint origin = camera_from_center(view, (float)a->x, (float)a->y);
    SDL_FPoint point = camera_from_center(view, (float)b->x, (float)b->y);
    SDL_FPoint edge =
        camera_from_center(view, (float)(a->x + sum.edge.x), (float)(a->y + sum.edge.y));
    canvas_line(c, point, edge, c->unit, color);
    canvas_circle(c, origin, 2.5f * c->unit, (canvas_style){COLOR_TEXT_DIM, COLOR_TEXT_DIM, 0});
    canvas_circle(c, point, 4 * c->unit, (canvas_style){color, COLOR_TEXT_STRONG, c->unit});
}

void draw_sums(canvas *c, const camera *view, session *s) {
    int count = 0;
    const thud_pose *poses = thud_world_poses(s->world, view->center, s->alpha, &count);
    for (int i = 0; i < s->scene.sum_pairs; i++) {
        thud_shape_instance a, b;
        if (placed_at(s, poses, count, 2 * i, &a) && placed_at(s, poses, count, 2 * i + 1, &b))
            draw_sum(c, view, &a, &b);
    }
}
