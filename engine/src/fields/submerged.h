/* submerged.h: area and centroid of the part of a circle or box below a line. */
#ifndef TD_SUBMERGED_H
#define TD_SUBMERGED_H

#include "fields/fields.h"

typedef struct td_submerged_part {
    double area, x, y; /* x, y: the centroid; the shape's centre if the area is 0 */
} td_submerged_part;

/* The part of a shape below a line. `height`: height of the shape's centre above the line, along
 * `up`, the line's unit normal. */
td_submerged_part td_submerged_part_of(const thud_geometry *shape, double height, thud_pos up);

/* Normalises a vector. False if its length differs from 1 by more than THUD_NORMAL_ERROR. */
bool td_line_normal(double x, double y, thud_pos *up);

#endif
