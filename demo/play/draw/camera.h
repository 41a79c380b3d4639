/* camera.h: the mapping between the world (y up) and the screen (y down). Positions are double, so
 * that a scene far from the origin is drawn like one near it. */
#ifndef THUD_PLAY_CAMERA_H
#define THUD_PLAY_CAMERA_H

#include <thud/thud_math.h>

#include <SDL.h>

typedef struct camera {
    thud_pos center;
    double scale;   /* pixels per unit of length */
    SDL_FRect view; /* the part of the screen that shows the world, pixels */
} camera;

/* Centres the view at `center`, with the largest scale at which `height` and `width` units of
 * length are visible. A width of 0 is ignored. */
void camera_look(camera *c, thud_pos center, double height, double width);
/* Changes the part of the screen. The centre and the visible height in units stay. */
void camera_set_view(camera *c, SDL_FRect view);
SDL_FPoint camera_to_screen(const camera *c, thud_pos p);
thud_pos camera_to_world(const camera *c, float x, float y);
/* The same for a position relative to the centre, as those of thud_world_get_poses, which are exact
 * there. */
SDL_FPoint camera_from_center(const camera *c, float x, float y);
void camera_pan(camera *c, float dx, float dy); /* by pixels */
/* Multiplies the scale by `factor`. The position under the pixel (x, y) stays there. */
void camera_zoom(camera *c, double factor, float x, float y);
/* The corners of the visible part of the world. */
void camera_bounds(const camera *c, thud_pos *lower, thud_pos *upper);

#endif
