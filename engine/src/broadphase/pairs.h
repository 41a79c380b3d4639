/* pairs.h: new pairs on their way from the broadphase to becoming contacts. */
#ifndef TD_PAIRS_H
#define TD_PAIRS_H

#include "state/world.h"

typedef struct td_new_pair {
    int32_t a, b, child;
} td_new_pair;

/* Adds to scratch.pairs; `child` is a terrain segment or 0. False when memory is short. */
bool td_pairs_add(thud_world *w, int a, int b, int child);

/* Adds those of lines and awake shapes, or sensors, of which one moved. False when memory is short.
 */
bool td_pairs_add_ground(thud_world *w); /* ground_pairs.c */

/* Drops the pairs that may not touch, from the one at `first` on. */
void td_pairs_filter(thud_world *w, int first);

/* Puts the pairs into the order of their shapes, whichever broadphase found them. */
bool td_pairs_sort(thud_world *w);

/* Whether there is a contact of the pair, whose shapes stand as td_pair_of has them. */
bool td_pair_has_contact(const thud_world *w, const td_new_pair *pair);

/* Makes a contact of each that has none, or, when memory is short, of none. */
bool td_pairs_create(thud_world *w);

static inline bool td_senses(const thud_world *w, int shape) {
    return td_shape_at(w, shape)->flags & TD_SHAPE_SENSOR;
}

/* Whether a pair of shapes with these marks, together, may have a contact or none whatever bounds
 * they had before: their contacts are to be looked through. */
static inline bool td_bounds_tell_nothing(const thud_world *w, int marks) {
    return marks & TD_MARK_WOKEN || w->vast;
}

/* The bounds that the shape had when pairs were last made. */
static inline const td_bounds *td_bounds_before(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED ? td_was_at(w, shape) : td_fat_at(w, shape);
}

#endif
