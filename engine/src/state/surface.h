/* surface.h: how the surfaces of two shapes act on each other: as their defs have it, as a prologue
 * wants it for a step, and as a lane of the solver keeps it. */
#ifndef TD_SURFACE_H
#define TD_SURFACE_H

#include "state/world.h"

/* The settings of a pair as the two shape defs have them. */
thud_contact_settings td_surface_of_pair(const thud_world *w, int shape_a, int shape_b);

/* A lane takes its settings anew. contact/contact_lanes.c */
void td_contact_settle(thud_world *w, td_block *block, int lane, int contact);

/* Asks the rules and the prologue, of two that meet on the way. */
bool td_surface_meet(thud_world *w, const thud_contact *seen, thud_contact_settings *settings);
/* Whether there is either. */
static inline bool td_surface_asks(const thud_world *w) {
    return w->asks || w->rule_hooks;
}

/* Gives a lane its settings, and counts in the world the lanes that bounce or have a surface speed.
 * The settings of an empty lane are all zero. */
void td_surface_set(thud_world *w, td_block *block, int points, int lane,
                    const thud_contact_settings *settings);
/* Has the lane do nothing in this step. */
void td_surface_mute(td_block *block, int points, int lane);
static inline thud_contact_settings td_surface_get(td_block *block, int points, int lane) {
    return (thud_contact_settings){.friction = block->friction[lane],
                                   .restitution = block->restitution[lane],
                                   .surface_speed = td_surface_at(block, points)->speed[lane]};
}

#endif
