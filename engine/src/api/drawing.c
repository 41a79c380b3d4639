/* drawing.c: the helpers of debug_draw.h: fixed-point positions to the caller's coordinates, and
 * lines and boxes through the caller's functions. */
#include "api/debug_draw.h"

#include "state/shape.h"

thud_vec2 td_drawing_local(const td_drawing *d, td_position p) {
    return (thud_vec2){(float)((double)(p.x - d->origin.x) / d->w->to_fixed),
                       (float)((double)(p.y - d->origin.y) / d->w->to_fixed)};
}

void td_drawing_line(const td_drawing *d, thud_vec2 a, thud_vec2 b, thud_style style) {
    if (d->draw->line) {
        d->draw->line(a, b, style, d->draw->context);
    }
}

void td_drawing_bounds(const td_drawing *d, int64_t min_x, int64_t min_y, int64_t max_x,
                       int64_t max_y, thud_style style) {
    if (!d->draw->box) {
        return;
    }
    int64_t quantum = 1 << TD_COARSE_SHIFT;
    thud_vec2 a = td_drawing_local(d, (td_position){min_x * quantum, min_y * quantum});
    thud_vec2 b = td_drawing_local(d, (td_position){max_x * quantum, max_y * quantum});
    d->draw->box((thud_vec2){0.5f * (a.x + b.x), 0.5f * (a.y + b.y)},
                 (thud_vec2){0.5f * (b.x - a.x), 0.5f * (b.y - a.y)}, 1.0f, 0.0f, style, -1,
                 d->draw->context);
}

/* The point of the contact's terrain segment whose x is nearest to that of `other`. */
static thud_vec2 ground_point(const td_drawing *d, const td_contact *contact, thud_vec2 other) {
    thud_terrain ground = td_terrain_view(d->w, contact->shape_a);
    thud_vec2 at = td_drawing_local(d, td_shape_proxy_at(d->w, contact->shape_a)->center);
    double x = (double)other.x - (double)at.x, y = ground.slope * x;
    if (ground.kind != THUD_TERRAIN_FLAT) {
        const thud_pos *p = &ground.points[contact->child], *q = p + 1;
        x = x < p->x ? p->x : x > q->x ? q->x : x;
        y = p->y + (x - p->x) / (q->x - p->x) * (q->y - p->y);
    }
    return (thud_vec2){at.x + (float)x, at.y + (float)y};
}

void td_drawing_pair(const td_drawing *d, const td_constraint *contact, thud_style style) {
    if (!td_is_contact(contact)) {
        td_drawing_line(d, td_drawing_local(d, td_pose_at(d->w, contact->body[0])->center),
                        td_drawing_local(d, td_pose_at(d->w, contact->body[1])->center), style);
        return;
    }
    thud_vec2 b = td_drawing_local(d, td_shape_proxy_at(d->w, contact->shape_b)->center);
    thud_vec2 a = td_shape_at(d->w, contact->shape_a)->kind == THUD_SHAPE_TERRAIN
                      ? ground_point(d, contact, b)
                      : td_drawing_local(d, td_shape_proxy_at(d->w, contact->shape_a)->center);
    td_drawing_line(d, a, b, style);
}
