/* terrain_manifold.h: contact of a shape with one segment of a ground line. */
#ifndef TD_TERRAIN_MANIFOLD_H
#define TD_TERRAIN_MANIFOLD_H

#include "thud/thud_shapes.h"

typedef struct td_terrain_point {
    double px, py; /* halfway between the surfaces, relative to the shape's centre */
    double separation;
    /* 0 for a circle; a box's corner 0..3; 4 and 5: the vertex at the segment's left and right end
     * in a face of the box; 6: the box's centre */
    uint32_t id;
} td_terrain_point;

typedef struct td_terrain_manifold {
    double nx, ny; /* unit, out of the ground */
    int count;     /* 0..2 */
    td_terrain_point point[2];
} td_terrain_manifold;

/* Ends of the line at which other ground goes on, so that nothing can meet their upright sides. */
enum { TD_SEALED_RIGHT = 1, TD_SEALED_LEFT = 4 };

/* `shape->x, y` are relative to the terrain's origin. Points further than `margin` are left out.
 * Summed over the segments that the shape's bounds touch, nothing is reported twice, and a shape
 * that slides over collinear segments meets the segments' normal alone. */
void td_terrain_segment_manifold(const thud_terrain *terrain, int segment,
                                 const thud_shape_instance *shape, unsigned sealed, double margin,
                                 td_terrain_manifold *out);

#endif
