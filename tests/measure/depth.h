/* depth.h: penetration depth of two shapes, exact and in double precision. It shares no code with
 * any engine, since it is used to judge them. */
#ifndef THUD_BENCH_DEPTH_H
#define THUD_BENCH_DEPTH_H

#include "scene.h"

/* A circle or a box at its place in the world. */
typedef struct depth_shape {
    bool circle;
    double x, y;         /* centre */
    double cosine, sine; /* of the angle; not used for a circle */
    double hx, hy;       /* half extents; a circle's radius is hx */
} depth_shape;

/* A terrain line with solid below; vertices from left to right in world coordinates. */
typedef struct depth_ground {
    const scene_point *points;
    int count; /* >= 2 */
} depth_ground;

/* The penetration depth: the shortest distance by which one of the shapes has to be moved so that
 * they touch. Zero or negative if they do not overlap. */
double depth_of_pair(const depth_shape *a, const depth_shape *b);

/* The penetration depth of a shape in the ground. For a circle: its radius minus the signed
 * distance of its centre from the line. For a box: the largest of the distances of its corners
 * below the line and of the depths of vertices inside of the box. Zero or negative if they do not
 * overlap; there is no ground beyond the line's ends. */
double depth_in_ground(const depth_ground *ground, const depth_shape *shape);

#endif
