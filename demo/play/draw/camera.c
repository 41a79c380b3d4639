/* camera.c: see camera.h. */
#include "draw/camera.h"

#include <math.h>

/* Pixels per unit of length. Chosen; beyond these, coordinates exceed the precision of float or
 * double. */
static const double SCALE_MIN = 1e-4, SCALE_MAX = 1e6;

void camera_look(camera *c, thud_pos center, double height, double width) {
    double scale = c->view.h / height;
    if (width > 0)
        scale = fmin(scale, c->view.w / width);
    c->center = center;
    c->scale = fmin(fmax(scale, SCALE_MIN), SCALE_MAX);
}

void camera_set_view(camera *c, SDL_FRect view) {
    if (c->view.h > 0 && view.h > 0)
        c->scale *= view.h / c->view.h;
    c->view = view;
}

SDL_FPoint camera_from_center(const camera *c, float x, float y) {
    return (SDL_FPoint){c->view.x + 0.5f * c->view.w + x * (float)c->scale,
                        c->view.y + 0.5f * c->view.h - y * (float)c->scale};
}

SDL_FPoint camera_to_screen(const camera *c, thud_pos p) {
    return camera_from_center(c, (float)(p.x - c->center.x), (float)(p.y - c->center.y));
}

thud_pos camera_to_world(const camera *c, float x, float y) {
    return (thud_pos){c->center.x + (x - c->view.x - 0.5 * c->view.w) / c->scale,
                      c->center.y - (y - c->view.y - 0.5 * c->view.h) / c->scale};
}

void camera_pan(camera *c, float dx, float dy) {
    c->center.x -= dx / c->scale;
    c->center.y += dy / c->scale;
}

void camera_zoom(camera *c, double factor, float x, float y) {
    thud_pos before = camera_to_world(c, x, y);
    c->scale = fmin(fmax(c->scale * factor, SCALE_MIN), SCALE_MAX);
    thud_pos after = camera_to_world(c, x, y);
    c->center.x += before.x - after.x;
    c->center.y += before.y - after.y;
}

void camera_bounds(const camera *c, thud_pos *lower, thud_pos *upper) {
    *lower = camera_to_world(c, c->view.x, c->view.y + c->view.h);
    *upper = camera_to_world(c, c->view.x + c->view.w, c->view.y);
}
