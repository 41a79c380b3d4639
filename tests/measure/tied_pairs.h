/* tied_pairs.h: which bodies of a scene do not meet because a joint ties them. */
#ifndef THUD_MEASURE_TIED_PAIRS_H
#define THUD_MEASURE_TIED_PAIRS_H

#include "scene.h"

typedef struct tied_pairs {
    uint64_t *keys; /* of two bodies, in order */
    size_t count;
} tied_pairs;

/* False, and nothing to free, if memory runs out. */
bool tied_pairs_init(tied_pairs *t, const scene *s);
void tied_pairs_free(tied_pairs *t);

bool tied_pairs_have(const tied_pairs *t, int a, int b);

#endif
