/* draw_pairs.h: what the engine's geometry tells of the two shapes of a pair, in a scene that is
 * there to show it. */
#ifndef THUD_PLAY_DRAW_PAIRS_H
#define THUD_PLAY_DRAW_PAIRS_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "session.h"

typedef enum pair_look {
    PAIR_SUM = 0, /* the Minkowski sum about the first one's centre, with the second as a point */
    PAIR_CLOSEST, /* the closest points; and where they would touch if they went on as they move */
    PAIR_BOUNDS,  /* circle, AABB and OBB around each, with the area of each in shapes */
    PAIR_LOOKS
} pair_look;

/* "sum", "closest" or "bounds". */
const char *pair_look_name(pair_look look);
/* -1 where there is none of that name. */
int pair_look_find(const char *name);

/* Of each pair, see scene.sum_pairs. */
void draw_pairs(canvas *c, const camera *view, session *s, pair_look look);

#endif
