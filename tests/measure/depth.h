/* depth.h: how deep two shapes overlap, exactly and in double precision. It shares no code with
 * any engine: it judges them. */
#ifndef THUD_BENCH_DEPTH_H
#define THUD_BENCH_DEPTH_H

#include "scene.h"

/* A circle (hy 0, radius hx) or a box in its place. */
typedef struct depth_shape {
    bool circle;
    double x, y;         /* centre */
    double cosine, sine; /* of the angle; a circle heeds neither */
    double hx, hy;       /* half extents; a circle's radius is hx */
} depth_shape;

/* A ground line with solid below, its vertices from left to right in world coordinates. */
typedef struct depth_ground {
    const scene_point *points;
    int count; /* >= 2 */
} depth_ground;

/* The shortest way that parts the two; zero or negative if they do not overlap. */
double depth_of_pair(const depth_shape *a, const depth_shape *b);

/* How far the shape reaches into the ground: for a circle, its deepest point's distance from the
 * line; for a box, the largest of each corner's distance below the line and each ground vertex's
 * distance inside the box. Zero or negative if it does not; there is no ground beyond the ends. */
double depth_in_ground(const depth_ground *ground, const depth_shape *shape);

#endif
