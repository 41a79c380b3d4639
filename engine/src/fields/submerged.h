/* submerged.h: area and centroid of the part of a circle or box below a line. */
#ifndef TD_SUBMERGED_H
#define TD_SUBMERGED_H

#include "fields/fields.h"

typedef struct td_submerged_part {
    double area, x, y; /* x, y: the centroid; the shape's centre where the area is 0 */
} td_submerged_part;

/* The part of a shape below a line. `height`: of the shape's centre above the line, along `up`, the
 * line's normal, of length 1. */
td_submerged_part td_submerged_part_of(const thud_geometry *shape, double height, thud_pos up);

/* Scales a vector to length 1. False where its length is not 1 within THUD_NORMAL_ERROR. */
bool td_line_normal(double x, double y, thud_pos *up);

#endif
