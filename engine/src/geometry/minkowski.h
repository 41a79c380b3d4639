/* minkowski.h: Minkowski sums for the files that build on them; shapes and points are known to be
 * valid, boxes may be flat (hy = 0). */
#ifndef TD_MINKOWSKI_H
#define TD_MINKOWSKI_H

#include "geometry/shape_instance.h"
#include "thud/thud_minkowski.h"

/* The shape about its own centre: its sum with a point. */
void td_minkowski_of(const thud_shape_instance *shape, thud_minkowski *sum);

void td_minkowski_sum(const thud_shape_instance *a, const thud_shape_instance *b,
                      thud_minkowski *sum);

bool td_minkowski_contains(const thud_minkowski *sum, double x, double y);

double td_minkowski_distance(const thud_minkowski *sum, double x, double y, double *nx, double *ny);

/* Where a point from outside enters the sum within its motion. The caller has made sure that it is
 * outside, but for sums with a point: false if it starts in one of those. */
bool td_minkowski_enter(const thud_minkowski *sum, double x, double y, double dx, double dy,
                        double *fraction, double *nx, double *ny);

#endif
