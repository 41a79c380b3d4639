/* touch.h: where two shapes touch, or are about to: points, normals and gaps. */
#ifndef THUD_ORACLE_TOUCH_H
#define THUD_ORACLE_TOUCH_H

#include "depth.h"

typedef struct touch_point {
    double x, y;               /* half way between the two surfaces */
    double normal_x, normal_y; /* from a to b */
    double gap;                /* m, along the normal; negative inside */
    int feature;               /* stays the same while the same parts touch */
} touch_point;

/* The longest separation that any of the tested axes shows: a lower bound of the distance, and
 * while it stays positive along that axis the shapes cannot meet. */
typedef struct touch_axis {
    double normal_x, normal_y; /* from a to b */
    double separation;         /* m */
} touch_axis;

/* Points with a gap below `margin` (m, >= 0); at most 2. A box on a box is clipped against the face
 * of least overlap; *axis may be null. */
int touch_pair(const depth_shape *a, const depth_shape *b, double margin, touch_point points[2],
               touch_axis *axis);

enum { TOUCH_GROUND_POINTS = 16 };

/* The ground is a, the shape b. Where more points would be found, the deepest are kept. Along a
 * smooth line there is no contact with the hidden ends of its segments. */
int touch_ground(const depth_ground *ground, const depth_shape *shape, double margin,
                 touch_point points[TOUCH_GROUND_POINTS]);

#endif
