/* draw_pairs.h: draws, in a scene with pairs of shapes, what the engine's geometry computes of a
 * pair. */
#ifndef THUD_PLAY_DRAW_PAIRS_H
#define THUD_PLAY_DRAW_PAIRS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

typedef enum pair_look {
    PAIR_SUM = 0, /* the Minkowski sum about the first shape's centre, and the second's centre as a
                     point */
    PAIR_CLOSEST, /* the closest points, and where they will touch at their current velocities */
    PAIR_BOUNDS,  /* circle, AABB and OBB around each shape, with their areas as multiples of the
                     shape's */
    PAIR_LOOKS
} pair_look;

/* The name of a look: "sum", "closest" or "bounds". */
const char *pair_look_name(pair_look look);
/* The look with this name, or -1. */
int pair_look_find(const char *name);

/* Draws each pair of the scene, see scene.sum_pairs. */
void draw_pairs(canvas *c, const camera *view, session *s, pair_look look);

#endif
