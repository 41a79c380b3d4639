/* submerged.h: the part of a shape below a line. */
#ifndef TD_SUBMERGED_H
#define TD_SUBMERGED_H

#include "fields/fields.h"

typedef struct td_part {
    double area, x, y; /* x, y: the centroid */
} td_part;

/* `height` is that of the shape's centre above the line, along `up`, which has length 1. */
td_part td_part_below(const thud_shape_instance *shape, double height, thud_pos up);

/* False for what is no direction. */
bool td_line_normal(double x, double y, thud_pos *up);

#endif
