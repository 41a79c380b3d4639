/* box_faces.h: overlap and contact of two boxes by the separating axis theorem (Gottschalk, Lin and
 * Manocha, "OBBTree", 1996), where the caller may exclude axes.
 *
 * internal_edges.c uses it for boxes that stand side by side: an axis is hidden, and excluded,
 * where its normal is that of a face or corner that a neighbouring shape covers; otherwise it is
 * open. All is in double precision, relative to an origin that the caller chooses; lengths are the
 * caller's unit. */
#ifndef TD_BOX_FACES_H
#define TD_BOX_FACES_H

#include "geometry/shape_instance.h"

/* The contact of two boxes. The points lie in the middle between both surfaces. */
typedef struct td_internal_edge_contact {
    double nx, ny;                    /* unit normal, from a to b */
    int count;                        /* of points: 1 or 2 */
    double x[2], y[2], separation[2]; /* separation along the normal; negative: overlap */
} td_internal_edge_contact;

/* Whether two boxes share a point. Boxes that touch do. */
bool td_boxes_overlap(const thud_geometry *a, const thud_geometry *b);

/* Whether the axis with the unit normal (nx, ny), from a to b, is hidden: a neighbour of one of the
 * boxes covers the face or corner that the normal belongs to. */
typedef bool td_axis_hidden_fn(double nx, double ny, void *context);

/* Finds the open axis with the largest separation, and the contact along it; `context` is handed to
 * `hidden`. False, with *out undefined, where all axes are hidden, where the boxes are further
 * apart than `margin`, where the overlap along the axis is much deeper than along a hidden one
 * (OPEN_DEPTH_RATIO_MAX in box_faces.c), or where no contact point is within `margin`. */
bool td_box_contact_on_open_axis(const thud_geometry *a, const thud_geometry *b, double margin,
                                 td_axis_hidden_fn *hidden, void *context,
                                 td_internal_edge_contact *out);

#endif
