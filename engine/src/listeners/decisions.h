/* decisions.h: the collisions whose velocities a prologue has decided by itself
 * (thud_contact_decide). A world has them from the first decision on, so that a program that never
 * decides does not link decide.c. */
#ifndef TD_DECISIONS_H
#define TD_DECISIONS_H

#include "state/world.h"

struct td_impact; /* detection/collide.h */

/* A collision whose outcome a prologue (the program's callback before the solver) has decided: it
 * has given one or both bodies their velocities, and the engine does not solve the contact. By
 * side: 0 is the body of seen.shape_a, 1 that of seen.shape_b. */
typedef struct td_decision {
    thud_contact seen;    /* as listeners see it; the impulses are set as it takes effect */
    int number;           /* of the contact among those that the prologue is asked about */
    bool given[2];        /* the velocity of this side is decided; else it does not change */
    float velocity[2][3]; /* x, y (length/s), turn (rad/s) */
} td_decision;

typedef struct td_decisions {
    td_array list;      /* td_decision: of the contacts that touch as the step begins */
    td_decision impact; /* for the impact that the prologue was asked about last */
    bool has_impact;    /* the prologue has decided that impact */
    /* Gives the bodies of `list` their velocities, before the step is solved. */
    void (*apply)(thud_world *w);
    /* Gives the bodies of `impact` their velocities, and sets the impulses of *resolved. The
     * trajectories of both bodies must have been advanced to the time of the impact. */
    void (*resolve)(thud_world *w, struct td_impact *resolved);
} td_decisions;

#endif
