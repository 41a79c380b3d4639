/* pairs.h: finds pairs of shapes that are near each other, by sort and sweep along x. */
#ifndef THUD_ORACLE_PAIRS_H
#define THUD_ORACLE_PAIRS_H

#include "model.h"

/* Indices of shapes. If one of them is ground it is `a`; otherwise `a` is the lower index. */
typedef struct near_pair {
    int a, b;
} near_pair;

typedef struct near_span {
    double low, high, bottom, top;
    int shape;
} near_span;

typedef struct near_pairs {
    near_pair *pairs; /* sorted by a, then by b */
    int count, capacity;
    near_span *spans; /* scratch space for the sweep */
} near_pairs;

bool near_pairs_init(near_pairs *near, const model *m); /* false if memory runs out */
void near_pairs_free(near_pairs *near);

/* Finds all pairs that may collide and whose bounding boxes overlap, enlarged by margins[shape] (m)
 * on each side; shapes without a finite place are left out. False if memory runs out. */
bool near_pairs_find(near_pairs *near, const model *m, const double *margins);

#endif
