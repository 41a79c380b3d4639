/* listener_hooks.h: what a step has to do for listeners. A world has it from its first ones on, so
 * that a program without does not link it. */
#ifndef TD_LISTENER_HOOKS_H
#define TD_LISTENER_HOOKS_H

#include "state/world.h"

typedef struct td_listener_hooks {
    /* Room for what is asked and told at once. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Asks about everything that touches. */
    void (*ask)(thud_world *w);
    /* Asks about two that meet on the way; false where the answer is no. Settings out of range are
     * refused, and stay as they were. */
    bool (*ask_one)(thud_world *w, const thud_contact *seen, thud_contact_settings *settings);
    /* Tells what was solved. */
    void (*tell)(thud_world *w);
    void (*end)(thud_world *w); /* with the world */
} td_listener_hooks;

#endif
