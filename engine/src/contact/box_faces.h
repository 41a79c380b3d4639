/* box_faces.h: contact of two boxes along the axes that are allowed. */
#ifndef TD_BOX_FACES_H
#define TD_BOX_FACES_H

#include "geometry/shape_instance.h"

/* Up to two points in the middle between both surfaces; the normal is from a to b. */
typedef struct td_internal_edge_contact {
    double nx, ny;
    int count;
    double x[2], y[2], separation[2];
} td_internal_edge_contact;

/* Whether two boxes share a point. */
bool td_internal_edge_boxes_meet(const thud_shape_instance *a, const thud_shape_instance *b);

/* Whether a normal, from a to b, is out of the question. */
typedef bool td_axis_hidden_fn(double nx, double ny, void *context);

/* The separating axis with the largest separation among those that are not hidden; false where
 * there is none, or one that would push much further than a hidden one, or no point within
 * `margin`. */
bool td_internal_edge_boxes(const thud_shape_instance *a, const thud_shape_instance *b,
                            double margin, td_axis_hidden_fn *hidden, void *context,
                            td_internal_edge_contact *out);

#endif
