/* pairs.h: new pairs of shapes, collected in scratch.pairs by the broadphase until they become
 * contacts. */
#ifndef TD_PAIRS_H
#define TD_PAIRS_H

#include "state/world.h"

/* Two shapes, and the terrain segment that the contact is with, or 0. */
typedef struct td_new_pair {
    int32_t a, b, child;
} td_new_pair;

/* Maximum number of hits that are collected, while the bounds that their test reads are prefetched.
 * Chosen. */
enum { TD_HELD_MAX = 64 };

/* The state of the search for pairs among awake shapes: the context of add_hits in broadphase.c. */
typedef struct td_pair_search {
    thud_world *w;
    int64_t overlaps;     /* overlapping pairs found so far */
    int64_t overlaps_max; /* with more of them the world is crowded */
    bool crowded;         /* pairs wait for their turn */
    /* Hits that are kept until the bounds by which they are tested have been prefetched into the
     * cache. `hits` has `held` elements: the counts[0] hits of shapes[0], then the counts[1] hits
     * of shapes[1], and so on, for `shape_count` shapes. */
    int held, shape_count;
    int hits[TD_HELD_MAX], shapes[TD_HELD_MAX], counts[TD_HELD_MAX];
} td_pair_search;

/* Appends a pair to scratch.pairs. False when memory is short. */
bool td_pairs_add(thud_world *w, int a, int b, int child);

/* Adds the new pairs of lines (terrain shapes) with awake shapes or sensors. False when memory is
 * short. */
bool td_pairs_add_ground(thud_world *w); /* ground_pairs.c */

/* Drops the pairs, from index `first` on, that filters, rules or joints keep from colliding
 * (td_pair_allowed) or whose bounds only seem to overlap (td_pair_meets). */
void td_pairs_filter(thud_world *w, int first);

/* Sorts the pairs by their lower, then their higher shape index, so that their order does not
 * depend on the broadphase; swaps a and b where a is higher. False when memory is short. */
bool td_pairs_sort(thud_world *w);

/* Whether there is a contact of the pair, whose shapes are in the order of td_pair_of. */
bool td_pair_has_contact(const thud_world *w, const td_new_pair *pair);

/* Makes a contact of each pair that has none. False when memory is short: then it has made none. */
bool td_pairs_create(thud_world *w);

/* Whether the shape is a sensor. */
static inline bool td_senses(const thud_world *w, int shape) {
    return td_shape_at(w, shape)->flags & TD_SHAPE_SENSOR;
}

/* Usually the bounds tell which pairs are new: a pair has a contact exactly if the fat bounds of
 * its shapes overlapped at the last broadphase. True where this does not hold, so that the contact
 * lists of the bodies must be searched for the pair instead: if a shape belongs to a body that
 * woke, or the world is so wide that bounds wrap around (thud_world.vast). `marks`: the union of
 * both shapes' marks. */
static inline bool td_bounds_tell_nothing(const thud_world *w, int marks) {
    return marks & TD_MARK_WOKEN || w->vast;
}

/* The fat bounds that the shape had at the last broadphase. */
static inline const td_bounds *td_bounds_before(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED ? td_previous_fat_at(w, shape)
                                                  : td_fat_at(w, shape);
}

/* Whether the bounds of a pair overlapped at the last broadphase, so that it has a contact. Valid
 * only where td_bounds_tell_nothing is false. `marks`: the union of both shapes' marks; `before`:
 * td_bounds_before of the shape that is not `other`. */
static inline bool td_bounds_had_met(const thud_world *w, int marks, const td_bounds *before,
                                     int other) {
    return !(marks & TD_MARK_FRESH) && td_bounds_overlap(before, td_bounds_before(w, other));
}

/* Prefetches what td_bounds_before reads of a shape. */
static inline void td_bounds_before_fetch(const thud_world *w, int shape) {
    __builtin_prefetch(td_marks_at(w, shape));
    __builtin_prefetch(td_previous_fat_at(w, shape));
    __builtin_prefetch(td_fat_at(w, shape));
}

#endif
