/* listener_hooks.h: the calls by which a step runs the caller's listeners: prologues (pre-solve
 * callbacks) and epilogues (post-solve). A world gets this table with its first listeners
 * (thud_world_set_listeners), so that a program without does not link them. */
#ifndef TD_LISTENER_HOOKS_H
#define TD_LISTENER_HOOKS_H

#include "state/world.h"

typedef struct td_listener_hooks {
    /* Makes room for the lists of prologue_all and epilogue_all. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Calls the prologue for every contact that touches, and applies its answers for this step. */
    void (*ask)(thud_world *w);
    /* Calls the prologue for an impact that detection has found within the step, and updates the
     * settings of the impact by its answer; an answer out of range is refused, and the settings
     * stay as they were. False: the prologue vetoes the impact. */
    bool (*ask_one)(thud_world *w, const thud_contact *seen, thud_contact_settings *settings);
    /* Calls the epilogue for every solved contact and every impact of the step. */
    void (*tell)(thud_world *w);
    void (*end)(thud_world *w); /* frees the listeners, as the world is destroyed */
} td_listener_hooks;

#endif
