/* contact.h: pairs of shapes whose fat bounds overlap, from their first overlap to their last. */
#ifndef TD_CONTACT_H
#define TD_CONTACT_H

#include "constraint/constraint.h"

/* The kind of a pair, and whether the two change places so that a static shape, a terrain or the
 * box of a box-circle pair comes first. */
td_pair_kind td_pair_of(const thud_world *w, int *shape_a, int *shape_b);
/* False for shapes of one body or a disabled one, two of which neither gives way (or, where one is
 * a sensor, neither moves), and what the filters keep apart. */
bool td_pair_allowed(const thud_world *w, int shape_a, int shape_b);

/* Whether either makes no events. */
bool td_pair_is_silent(const thud_world *w, int shape_a, int shape_b);

/* Whether the fat bounds of two shapes, neither a terrain, overlap for real: in a vast world they
 * may wrap around and only seem to. */
bool td_pair_meets(const thud_world *w, int shape_a, int shape_b);

void td_contact_create(thud_world *w, td_pair_kind kind, int shape_a, int shape_b, int child);
/* Tells that the contact touches, or overlaps a sensor, unless a shape of it makes no events. Room
 * for the begin event must be there, in world.events. */
void td_contact_begin(thud_world *w, int contact);
/* Tells that it does so no more, if its begin was told. td_contact_end_reserve has made room for
 * the end event. */
void td_contact_end(thud_world *w, int contact);
/* Takes a joint as well, which has no end event. */
void td_contact_destroy(thud_world *w, int constraint);
bool td_contact_end_reserve(thud_world *w, int more);
/* Edits that wait for the next step end it, or the joint. */
bool td_contact_is_ending(const thud_world *w, const td_constraint *constraint);
/* A touching contact touches no more: it gives its lane back, and its end is told. */
void td_contact_part(thud_world *w, int contact);

/* Two shapes that have no lane as callers see them: `at` is between where they are nearest. */
thud_contact td_contact_between(const thud_world *w, int shape_a, int shape_b, td_position at,
                                thud_vec2 normal, double distance);

/* As an event tells it: what two bodies were given may add up to more than a float has. */
static inline float td_hit_speed(float approach) {
    return approach <= FLT_MAX ? approach : FLT_MAX;
}

/* A lane as callers see it, and how fast a point of it closes, > 0. contact_view.c */
thud_contact td_contact_view(const thud_world *w, td_block *block, int lane);
float td_contact_closing(const thud_world *w, const td_block *block, const td_point *p, int lane);

#endif
