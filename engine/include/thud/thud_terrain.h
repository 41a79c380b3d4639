/* thud_terrain.h: what games do with ground: texture it, stand on it, dig it up. The line itself,
 * its height at x and the tests against shapes are in thud_shapes.h. */
#ifndef THUD_TERRAIN_H
#define THUD_TERRAIN_H

#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- without a world ---- */

/* Texture coordinates, in the caller's own scale. */
typedef struct thud_uv {
    double u, v;
} thud_uv;

/* Texture coordinates at a sample: those of the vertices on both sides of it, `vertices[segment]`
 * and `vertices[segment + 1]`, by the sample's weights. The caller keeps one thud_uv a vertex; a
 * flat line has two, at x = 0 and x = 1, and goes on beyond them. THUD_ERROR_INVALID when there are
 * no such vertices among the `count`, or the outcome is not finite; *out is then as it was. */
thud_result thud_terrain_texture_at(const thud_terrain_sample *sample, const thud_uv *vertices,
                                    int count, thud_uv *out);

/* Where a foot comes to stand. */
typedef struct thud_foot {
    double height;  /* of the highest ground under the sole, so that no part of it sinks in */
    double x;       /* where that is; of several places the one nearest to the sole's middle */
    double nx, ny;  /* unit normal, ny > 0, of the straight line between the ground under the sole's
                       two ends: how the character leans */
} thud_foot;

/* Puts a level sole of the given width (>= 0, finite) onto the ground, with its middle at x. What
 * juts out beyond an end of the line does not count. Takes three look-ups and a pass over the
 * vertices under the sole. THUD_ERROR_INVALID when no part of the sole is over the line; *out is then as it
 * was. */
thud_result thud_terrain_place_foot(const thud_terrain *terrain, double x, double width,
                                    thud_foot *out);

#ifdef __cplusplus
}
#endif

#endif
