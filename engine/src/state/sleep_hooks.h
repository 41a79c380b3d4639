/* sleep_hooks.h: the part of a world by which islands fall asleep and wake.
 *
 * A world has it by its def (thud_parts), or is given it by thud_world_set_sleeping or a snapshot,
 * so that a program in which nothing sleeps does not link it. */
#ifndef TD_SLEEP_HOOKS_H
#define TD_SLEEP_HOOKS_H

#include "state/world.h"

typedef struct td_sleep_hooks {
    /* Reserves what a step needs to put islands to sleep. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* The stage: puts islands to sleep whose bodies have all been at rest for TD_SLEEP_TIME. */
    void (*sleep)(thud_world *w);
    /* Wakes the whole island of a body that is asleep. False when memory is short; nothing has
     * changed then. */
    bool (*wake)(thud_world *w, td_body_index body);
    void (*drop_woken)(thud_world *w); /* td_proxy_set_drop_woken */
} td_sleep_hooks;

/* islands/sleep.c */
extern const td_sleep_hooks td_sleep_stages;

#endif
