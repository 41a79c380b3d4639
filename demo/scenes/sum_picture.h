/* sum_picture.h: the outline of a Minkowski sum as points, for viewer and page to draw. */
#ifndef THUD_DEMO_SUM_PICTURE_H
#define THUD_DEMO_SUM_PICTURE_H

#include <thud/thud_minkowski.h>

/* Lines of the arc at a vertex, and max number of points of the outline. */
enum { SUM_ARC = 12, SUM_OUTLINE_MAX = THUD_MINKOWSKI_VERTICES_MAX * (SUM_ARC + 1) };

/* Positions are relative to the centre of the first shape. */
typedef struct sum_picture {
    bool overlaps; /* the second's centre is inside of the sum */
    thud_pos edge; /* the point on the sum's edge that is nearest to the second's centre */
    int count;
    thud_pos outline[SUM_OUTLINE_MAX]; /* counter-clockwise; the first point is not repeated at the
                                          end */
} sum_picture;

/* Computes the sum of two shapes. False if a shape is a terrain or out of range. */
bool sum_picture_of(const thud_geometry *a, const thud_geometry *b, sum_picture *out);

#endif
