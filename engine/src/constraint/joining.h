/* joining.h: when constraints that are no contacts take effect, and when they let go. A world has
 * it from its first joint on, so that a program without joints does not link it. */
#ifndef TD_JOINING_H
#define TD_JOINING_H

#include "state/world.h"

struct td_island_work;

typedef struct td_joining_ops {
    /* Gives lanes to those that wait, where their bodies are in the world and enabled. False when
     * memory is short: the rest goes on waiting. */
    bool (*engage)(thud_world *w);
    /* The joints of a body give their lanes back, and wait until it is enabled. */
    void (*suspend)(thud_world *w, td_body_index body);
    /* Whether a joint of both has their shapes pass through each other. */
    bool (*keeps_apart)(const thud_world *w, td_body_index a, td_body_index b);
    /* A part is no more; the joint is gone with its last one. */
    void (*leave)(thud_world *w, int joint, int part);
    /* island_joints.c: see island_solve.h. */
    double (*solve)(struct td_island_work *work, double tolerance);
} td_joining_ops;

/* joining.c */
bool td_joints_engage(thud_world *w);
void td_joints_suspend(thud_world *w, td_body_index body);
void td_joints_leave(thud_world *w, int joint, int part);
bool td_joints_keep_apart(const thud_world *w, td_body_index a, td_body_index b);

#endif
