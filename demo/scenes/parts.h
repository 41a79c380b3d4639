/* parts.h: the parts of scenes with joints. Functions that add a body return its index in the
 * scene, which joints refer to. */
#ifndef THUD_DEMO_PARTS_H
#define THUD_DEMO_PARTS_H

#include "scene.h"

/* A mask that no shape's category is in: a shape with it collides with nothing, but is drawn, and
 * can be picked. */
enum { PART_MEETS_NOTHING = 1 << 30 };

/* The angle of the direction (x, y) in (-pi, pi]. It uses square roots and a series only, whose
 * bits are the same on every platform. */
double part_angle(double x, double y);

/* Dynamic bodies of the scene's current material, with one shape and angle 0. */
int part_box(scene *s, double x, double y, double hx, double hy);
int part_circle(scene *s, double x, double y, double radius);
/* A bar with the centre line from a to b and the width 2 * half, shorter by `short_of` at both
 * ends. The shape is rotated, the body's angle is 0. */
int part_bar(scene *s, scene_point a, scene_point b, double half, double short_of);
/* Adds another bar to the latest body; a and b are in the world. */
scene_shape *part_add_bar(scene *s, scene_point a, scene_point b, double half);

/* A hinge of two bodies at a place in the world, with the frames' angle 0. */
scene_joint *part_hinge(scene *s, int a, int b, scene_point at);

/* A wheel of the current material on a sprung axle that moves up and down in the body, which has
 * `wheels` of them; parts.c says how it is tuned. */
scene_joint *part_wheel(scene *s, int body, int wheels, double x, double y, double radius);

/* Gives all shapes of the bodies from `first` on the same group, which is negative: they do not
 * collide with each other. */
void part_keep_apart(scene *s, int first, int group);

/* The mass of a body made of circles and boxes. */
double part_mass(const scene *s, int body);

/* The intersection of two circles of radii ra and rb about a and b that is to the left of the
 * direction from a to b. The circles have to intersect. */
scene_point part_meeting(scene_point a, double ra, scene_point b, double rb);

#endif
