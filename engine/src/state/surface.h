/* surface.h: contact settings (friction, restitution, surface speed) of a pair of shapes: combined
 * from the two shapes and the rules, changed for one step by a prologue (pre-solve callback), and
 * stored in a lane of the solver. */
#ifndef TD_SURFACE_H
#define TD_SURFACE_H

#include "state/world.h"

/* The settings of a pair: friction is the geometric mean of both shapes', restitution the greater
 * one, surface speed the sum; a rule of the pair may replace each. */
thud_contact_settings td_surface_of_pair(const thud_world *w, int shape_a, int shape_b);
/* td_surface_of_pair with these frictions in place of the two shapes' own: for shapes with a
 * texture. */
thud_contact_settings td_surface_of_frictions(const thud_world *w, int shape_a, int shape_b,
                                              float friction_a, float friction_b);
/* The settings at the point of a collision that detection finds within a step. They differ from
 * those of the pair where a texture gives the point another friction. */
thud_contact_settings td_surface_of_impact(const thud_world *w, const thud_contact *seen);

/* Sets a lane's settings from its pair again. contact/contact_lanes.c */
void td_contact_settle(thud_world *w, td_block *block, int lane, int contact);

/* Whether two shapes that detection finds to collide within a step do collide, according to the
 * rules and the prologue, which may change the settings. */
bool td_surface_meet(thud_world *w, const thud_contact *seen, thud_contact_settings *settings);
/* Whether there are rules or a prologue to ask. */
static inline bool td_surface_asks(const thud_world *w) {
    return w->asks || w->rule_hooks;
}

/* Stores settings in a lane, and updates the world's counts of lanes with restitution and with
 * surface speed. An empty lane has settings of zero. `points`: contact points of the block's kind.
 */
void td_surface_set(thud_world *w, td_block *block, int points, int lane,
                    const thud_contact_settings *settings);
/* Removes all points of the lane for this step: no mass, no impulse, TD_APART as separation. */
void td_surface_mute(td_block *block, int points, int lane);
/* The settings stored in a lane. */
static inline thud_contact_settings td_surface_get(td_block *block, int points, int lane) {
    return (thud_contact_settings){.friction = block->friction[lane],
                                   .restitution = block->restitution[lane],
                                   .surface_speed = td_surface_at(block, points)->speed[lane]};
}

#endif
