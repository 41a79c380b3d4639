/* touch.h: contact points of two shapes: positions, normals and gaps. */
#ifndef THUD_ORACLE_TOUCH_H
#define THUD_ORACLE_TOUCH_H

#include "depth.h"

typedef struct touch_point {
    double x, y;               /* midway between the two surfaces */
    double normal_x, normal_y; /* from a to b */
    double gap;                /* m, along the normal; negative if they overlap */
    int feature;               /* identifies the touching parts; constant while they touch */
} touch_point;

/* The largest separation along the tested axes: a lower bound of the distance. While it is positive
 * along that axis the shapes cannot touch. */
typedef struct touch_axis {
    double normal_x, normal_y; /* from a to b */
    double separation;         /* m */
} touch_axis;

/* Finds at most 2 points with a gap below `margin` (m, >= 0) and returns their number. Boxes are
 * clipped at the face of least overlap; `axis` may be null. */
int touch_pair(const depth_shape *a, const depth_shape *b, double margin, touch_point points[2],
               touch_axis *axis);

enum { TOUCH_GROUND_POINTS = 16 };

/* The ground is a, the shape is b. If there are more points, the deepest are kept. Inner vertices
 * of a straight line make no contacts. */
int touch_ground(const depth_ground *ground, const depth_shape *shape, double margin,
                 touch_point points[TOUCH_GROUND_POINTS]);

#endif
