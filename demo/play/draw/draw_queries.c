/* draw_queries.c: see draw_queries.h. */
#include "draw/draw_queries.h"

#include "draw/draw_measures.h"
#include "draw/palette.h"

/* Length of the normal at a hit, pixels of a usual screen. Chosen. */
static const float NORMAL = 22;

static void draw_hit(canvas *c, const camera *view, const thud_ray_hit *hit) {
    /* Of a ray of many that hit nothing. */
    if (hit->normal.x == 0 && hit->normal.y == 0)
        return;
    SDL_FPoint at = camera_to_screen(view, hit->point);
    SDL_FPoint tip = {at.x + NORMAL * c->unit * hit->normal.x,
                      at.y - NORMAL * c->unit * hit->normal.y};
    canvas_line(c, at, tip, 1.5f * c->unit, COLOR_NORMAL);
    canvas_circle(c, at, 3.5f * c->unit, (canvas_style){COLOR_CONTACT, COLOR_TEXT_STRONG, c->unit});
}

static void draw_query(canvas *c, const camera *view, const playback_query *q) {
    thud_pos from = {q->shape.x, q->shape.y}, to = {from.x + q->dx, from.y + q->dy};
    if (q->dx != 0 || q->dy != 0)
        canvas_line(c, camera_to_screen(view, from), camera_to_screen(view, to), c->unit,
                    COLOR_INTERVAL);
    if (!q->ray) {
        thud_geometry begin = q->shape, end = q->shape; /* relative to the camera's centre */
        begin.x = from.x - view->center.x;
        begin.y = from.y - view->center.y;
        end.x = to.x - view->center.x;
        end.y = to.y - view->center.y;
        draw_outline(c, view, &begin, 1.5f * c->unit, COLOR_INTERVAL);
        draw_outline(c, view, &end, c->unit, COLOR_INTERVAL);
    }
    for (int i = 0; q->points && i < q->hit_count; i++)
        draw_hit(c, view, &q->hits[i]);
}

void draw_queries(canvas *c, const camera *view, const playback *p) {
    for (int i = 0; i < p->query_count; i++)
        draw_query(c, view, &p->queries[i]);
}
