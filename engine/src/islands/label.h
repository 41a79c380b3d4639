/* label.h: the island of every awake body: the connected components of the graph whose nodes are
 * dynamic bodies and whose edges are touching contacts and acting joints, by union-find (Tarjan,
 * "Efficiency of a good but not linear set union algorithm", 1975). */
#ifndef TD_LABEL_H
#define TD_LABEL_H

#include "state/world.h"

/* The root of a slot in a forest where each slot has a parent and a root is its own parent. On the
 * way it links every other slot to its grandparent (path halving), so that later calls take fewer
 * steps. */
static inline td_awake_slot td_root_of(td_awake_slot *parents, td_awake_slot i) {
    while (parents[i.at].at != i.at) {
        parents[i.at] = parents[parents[i.at].at];
        i = parents[i.at];
    }
    return i;
}

/* Unites two trees. The lower root becomes the root of both, so that roots do not depend on the
 * order of calls. False if both slots were in one tree before. */
bool td_join_trees(td_awake_slot *parents, td_awake_slot a, td_awake_slot b);

/* Sets scratch.parents of each awake slot to the lowest slot of its island. False when memory is
 * short. `keep_awake`: the idle time of a dynamic body that touches a moving kinematic body, or is
 * joined to one, becomes 0, so that its island does not fall asleep. */
bool td_islands_label(thud_world *w, bool keep_awake);

#endif
