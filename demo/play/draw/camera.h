/* camera.h: which part of the world is seen, and where on the screen. World y is up, screen y is
 * down; places are double, so that a scene far from the origin looks like one near it. */
#ifndef THUD_PLAY_CAMERA_H
#define THUD_PLAY_CAMERA_H

#include <thud/thud_math.h>

#include <SDL.h>

typedef struct camera {
    thud_pos center;
    double scale;   /* pixels per unit of the world */
    SDL_FRect view; /* pixels of the screen that show the world */
} camera;

/* Shows `height` units of the world from top to bottom about `center`, or more, so that `width` of
 * them are to be seen from left to right. */
void camera_look(camera *c, thud_pos center, double height, double width);
/* Keeps the centre and the height in units when the view changes its size. */
void camera_set_view(camera *c, SDL_FRect view);
SDL_FPoint camera_to_screen(const camera *c, thud_pos p);
thud_pos camera_to_world(const camera *c, float x, float y);
/* The same for places relative to the centre, which is where thud's float poses are exact. */
SDL_FPoint camera_from_center(const camera *c, float x, float y);
void camera_pan(camera *c, float dx, float dy); /* by pixels */
/* Zooms in by `factor` so that what lies under the pixel stays there. */
void camera_zoom(camera *c, double factor, float x, float y);
void camera_bounds(const camera *c, thud_pos *lower, thud_pos *upper);

#endif
