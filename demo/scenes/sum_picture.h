/* sum_picture.h: what there is to draw of a Minkowski sum, for viewer and page. */
#ifndef THUD_DEMO_SUM_PICTURE_H
#define THUD_DEMO_SUM_PICTURE_H

#include <thud/thud_minkowski.h>

enum { SUM_ARC = 12, SUM_OUTLINE_MAX = THUD_MINKOWSKI_MAX * (SUM_ARC + 1) };

/* Places are relative to the centre of the first shape. */
typedef struct sum_picture {
    bool overlaps; /* the second's centre is in the sum */
    thud_pos edge; /* the place on the edge of the sum that is nearest to the second's centre */
    int count;
    thud_pos outline[SUM_OUTLINE_MAX]; /* counter-clockwise, the first place not repeated */
} sum_picture;

/* False where a shape is a terrain or out of range. */
bool sum_picture_of(const thud_shape_instance *a, const thud_shape_instance *b, sum_picture *out);

#endif
