/* parts.h: what scenes with joints are made of. Bodies are told by their indices in the scene,
 * which joints go by. */
#ifndef THUD_DEMO_PARTS_H
#define THUD_DEMO_PARTS_H

#include "scene.h"

/* A mask that no shape's category is in: nothing meets such a shape, but what draws and picks finds
 * it. */
enum { PART_MEETS_NOTHING = 1 << 30 };

/* The angle of a direction, in (-pi, pi], by square roots and a series alone. */
double part_angle(double x, double y);

/* Dynamic bodies of the scene's present material, with one shape; their angle is 0. */
int part_box(scene *s, double x, double y, double hx, double hy);
int part_circle(scene *s, double x, double y, double radius);
/* A bar whose middle line goes from a to b and that is 2 * half wide: the shape is turned, not the
 * body. It ends `short_of` before both. */
int part_bar(scene *s, scene_point a, scene_point b, double half, double short_of);
/* A further bar of the latest body, by places in the world. */
scene_shape *part_add_bar(scene *s, scene_point a, scene_point b, double half);

/* Ties at a place without an angle. */
scene_joint *part_hinge(scene *s, int a, int b, scene_point at);

/* A wheel of the present material on a sprung axle that goes up and down in the body, which has
 * `wheels` of them; see parts.c for what it is tuned by. */
scene_joint *part_wheel(scene *s, int body, int wheels, double x, double y, double radius);

/* None of the shapes of all bodies from `first` on meets another of the same group, which is < 0.
 */
void part_keep_apart(scene *s, int first, int group);

/* The mass of a body made of circles and boxes. */
double part_mass(const scene *s, int body);

/* Where two circles of radii ra and rb about a and b meet: that one of the two places which lies to
 * the left of the way from a to b. They have to meet. */
scene_point part_meeting(scene_point a, double ra, scene_point b, double rb);

#endif
