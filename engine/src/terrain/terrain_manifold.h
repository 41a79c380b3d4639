/* terrain_manifold.h: the contact manifold of a circle or box with one segment of a terrain. Called
 * by the narrowphase (contact/wide_terrain.c), for each segment under the shape's bounds. */
#ifndef TD_TERRAIN_MANIFOLD_H
#define TD_TERRAIN_MANIFOLD_H

#include "thud/thud_geometry.h"

/* A contact point. */
typedef struct td_terrain_point {
    double px, py;     /* halfway between the surfaces, relative to the shape's centre */
    double separation; /* along the normal; negative: overlap */
    /* The feature of the contact, by which warm starting recognises the point. A circle: 0. A box:
     * 0 to 3, its corner; 4 and 5, the vertex at the segment's left and right end, inside a face of
     * the box; 6, the box's centre. */
    uint32_t id;
} td_terrain_point;

/* A manifold: one normal, up to two points. */
typedef struct td_terrain_manifold {
    double nx, ny; /* unit, out of the ground */
    int count;     /* 0..2 */
    td_terrain_point point[2];
} td_terrain_manifold;

/* Bits of `sealed`: ends of the line at which other ground continues (contact/internal_edges.h), so
 * that no shape can touch the vertical side there. They are 1 << TD_FACE_RIGHT and 1 <<
 * TD_FACE_LEFT. */
enum { TD_SEALED_RIGHT = 1, TD_SEALED_LEFT = 4 };

/* Computes the manifold. The shape's coordinates are relative to the terrain's origin. Points with
 * a separation greater than `margin` are left out. Each contact is reported by only one of the
 * segments that the shape's bounds touch, and a shape that slides over collinear segments gets no
 * normal other than theirs. */
void td_terrain_segment_manifold(const thud_terrain *terrain, int segment,
                                 const thud_geometry *shape, unsigned sealed, double margin,
                                 td_terrain_manifold *out);

#endif
