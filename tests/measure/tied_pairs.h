/* tied_pairs.h: the pairs of bodies of a scene that do not collide because a joint connects them.
 */
#ifndef THUD_MEASURE_TIED_PAIRS_H
#define THUD_MEASURE_TIED_PAIRS_H

#include "scene.h"

typedef struct tied_pairs {
    uint64_t *keys; /* a key for each pair of bodies, sorted */
    size_t count;
} tied_pairs;

/* False, with nothing to free, if memory runs out. */
bool tied_pairs_init(tied_pairs *t, const scene *s);
void tied_pairs_free(tied_pairs *t);

/* Whether a joint keeps two bodies from colliding, in either order. */
bool tied_pairs_have(const tied_pairs *t, int a, int b);

#endif
