/* draw_terrain.c: see draw_terrain.h. */
#include "draw/draw_terrain.h"

#include "draw/palette.h"

#include <math.h>

static const float SOIL_DEPTH = 90; /* points from the ground's upper colour to its lower one */

/* Draws the ground below one segment of the line. Its sides are at whole pixels, so that there is
 * no gap between adjacent columns. */
static void draw_column(canvas *c, const camera *view, SDL_FPoint a, SDL_FPoint b) {
    float bottom = view->view.y + view->view.h;
    float depth = SOIL_DEPTH * c->unit;
    a.x = roundf(a.x);
    b.x = roundf(b.x);
    SDL_FPoint a2 = {a.x, a.y + depth}, b2 = {b.x, b.y + depth};
    canvas_quad(c, (SDL_FPoint[4]){a, b, b2, a2},
                (SDL_Color[4]){COLOR_GROUND, COLOR_GROUND, COLOR_GROUND_DEEP, COLOR_GROUND_DEEP});
    if (a2.y < bottom || b2.y < bottom)
        canvas_quad(c,
                    (SDL_FPoint[4]){a2, b2, {b.x, fmaxf(bottom, b2.y)}, {a.x, fmaxf(bottom, a2.y)}},
                    (SDL_Color[4]){COLOR_GROUND_DEEP, COLOR_GROUND_DEEP, COLOR_GROUND_DEEP,
                                   COLOR_GROUND_DEEP});
}

/* Draws an infinite line, from one side of the view to the other. */
static void draw_flat(canvas *c, const camera *view, double slope, thud_pose pose) {
    double half = 0.5 * view->view.w / view->scale + 1;
    SDL_FPoint a =
        camera_from_center(view, (float)-half, (float)(pose.y + slope * (-half - pose.x)));
    SDL_FPoint b = camera_from_center(view, (float)half, (float)(pose.y + slope * (half - pose.x)));
    draw_column(c, view, a, b);
    canvas_line(c, a, b, 2 * c->unit, COLOR_SURFACE);
}

/* The position of the terrain's vertex i on the screen. */
static SDL_FPoint vertex(const camera *view, const thud_terrain *t, int i, thud_pose pose) {
    double x = t->kind == THUD_TERRAIN_UNIFORM ? t->x0 + i * t->spacing : t->points[i].x;
    return camera_from_center(view, (float)(pose.x + x), (float)(pose.y + t->points[i].y));
}

void draw_terrain(canvas *c, const camera *view, const thud_world *world, thud_shape_id shape,
                  thud_pose pose) {
    thud_terrain terrain;
    if (thud_shape_get_terrain(world, shape, &terrain) != THUD_OK)
        return;
    if (terrain.kind == THUD_TERRAIN_FLAT) {
        draw_flat(c, view, terrain.slope, pose);
        return;
    }
    double half = 0.5 * view->view.w / view->scale;
    int first, last;
    thud_terrain_segments(&terrain, -half - pose.x, half - pose.x, &first, &last);
    if (first > last)
        return;
    /* If several vertices share a pixel, only every stride-th is drawn. `first` is a multiple of
     * the stride, so that a pan of the camera does not change which. */
    int stride = (int)((float)(last - first + 1) / view->view.w) + 1;
    first -= first % stride;
    for (int pass = 0; pass < 2; pass++)
        for (int i = first; i <= last; i += stride) {
            int next = i + stride < terrain.count ? i + stride : terrain.count - 1;
            SDL_FPoint a = vertex(view, &terrain, i, pose), b = vertex(view, &terrain, next, pose);
            if (pass == 0)
                draw_column(c, view, a, b);
            else
                canvas_line(c, a, b, 2 * c->unit, COLOR_SURFACE);
        }
}
