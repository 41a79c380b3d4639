/* minkowski.h: the internal versions of thud_minkowski.h's functions, which do not check their
 * input: shapes and points must be valid, boxes may have hy = 0. */
#ifndef TD_MINKOWSKI_H
#define TD_MINKOWSKI_H

#include "geometry/shape_instance.h"
#include "thud/thud_minkowski.h"

/* The sum of a shape and a point: the shape itself, about its own centre. */
void td_minkowski_of(const thud_geometry *shape, thud_minkowski *sum);

void td_minkowski_sum(const thud_geometry *a, const thud_geometry *b, thud_minkowski *sum);

bool td_minkowski_contains(const thud_minkowski *sum, double x, double y);

double td_minkowski_distance(const thud_minkowski *sum, double x, double y, double *nx, double *ny);

/* Finds where a point that moves by (dx, dy) enters the sum: the fraction of the motion and the
 * outward normal. False if it does not. The caller ensures that the point starts outside; for a
 * point inside, the result is false if the radius is 0 or the sum has one vertex; for a polygon
 * with a radius (a box and a circle, or an added margin) it may be true. */
bool td_minkowski_enter(const thud_minkowski *sum, double x, double y, double dx, double dy,
                        double *fraction, double *nx, double *ny);

#endif
