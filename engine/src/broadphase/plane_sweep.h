/* plane_sweep.h: what the broadphases that sort and sweep share: lists of keys (td_proxy_set.keys),
 * kept sorted along an axis by insertion sort. See plane_sweep.c. */
#ifndef TD_PLANE_SWEEP_H
#define TD_PLANE_SWEEP_H

#include "state/world.h"

/* Makes the keys those of the shapes in set->list, in `lists` lists, 1 or 2, one behind the other,
 * not yet sorted. False when memory is short; the set is then not valid. */
bool td_sweep_list(thud_world *w, td_proxy_set *set, int lists);

/* Gives a list of keys its values along the axis and sorts it, counting in set->sort_moves. */
void td_sweep_sort(thud_world *w, td_proxy_set *set, td_sweep_key *keys, td_axis axis);

/* Sorts the first list along the axis, makes `ids` its order, and the set valid. */
void td_sweep_fill(thud_world *w, td_proxy_set *set, td_axis axis);

/* Lists, sorts and fills a set with one list along the axis. False when memory is short. */
bool td_sweep_build(thud_world *w, td_proxy_set *set, td_axis axis);

#endif
