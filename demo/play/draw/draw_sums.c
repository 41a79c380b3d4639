/* draw_sums.c: see draw_sums.h. */
#include "draw/draw_sums.h"

#include "draw/palette.h"

#include <sum_picture.h>

void draw_sum(canvas *c, const camera *view, const thud_geometry *a, const thud_geometry *b) {
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
