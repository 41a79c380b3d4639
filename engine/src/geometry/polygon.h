/* polygon.h: simple polygons as arrays of points: their area, and a partition into triangles. */
#ifndef TD_POLYGON_H
#define TD_POLYGON_H

#include "base/base.h"

/* Twice the signed area of a triangle, positive if a, b, c are counter-clockwise. */
static inline double td_turn_of(thud_pos a, thud_pos b, thud_pos c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* The signed area of a polygon, positive if it is counter-clockwise (the shoelace formula). */
double td_polygon_area(const thud_pos *points, int count);

/* Cuts a simple, counter-clockwise polygon into triangles, whose corners are indices of points.
 * `left` has room for count ints, `triangles` for count - 2. Returns the number of triangles, which
 * is less than count - 2 if three points lie on a line. */
int td_polygon_triangles(const thud_pos *points, int count, int *left, int (*triangles)[3]);

#endif
