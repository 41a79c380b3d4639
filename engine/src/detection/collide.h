/* collide.h: two bodies that meet at a point get new velocities at once. */
#ifndef TD_COLLIDE_H
#define TD_COLLIDE_H

#include "detection/trajectory.h"

/* What was done to a pair that met within the step. */
typedef struct td_impact {
    thud_contact seen; /* as callbacks see it */
    float approach;    /* speed at which they met, > 0 where they closed */
    bool touching;     /* they have a contact with the solver */
    bool stayed[2];    /* the body keeps the motion of this step; its velocity is a new one */
    bool bent[2];      /* but no longer falls on as it did, so that it meets others elsewhere */
} td_impact;

/* The point at which two bodies act on each other, relative to `origin`. */
typedef struct td_impact_point {
    td_position origin;
    double nx, ny; /* from the first to the second */
    double x, y;
    double distance;
    double speed;   /* at which they close there, by their motions; lengths a step */
    double closing; /* how far the rest of their motion takes them into each other there */
} td_impact_point;

/* The place where they press most, among those where they are nearest; where two press alike, the
 * middle of the two. False where they are apart. */
bool td_impact_point_of(thud_world *w, const td_toi_candidate *e, double time, td_impact_point *at);

/* The pair as callbacks see it, before anything is done. */
thud_contact td_impact_view(const thud_world *w, const td_toi_candidate *e,
                            const td_impact_point *at);

/* Newtonian impact with restitution and Coulomb friction. Their trajectories, which stand at the
 * time of the impact, go on without approaching each other. */
void td_impact_resolve(thud_world *w, const td_toi_candidate *e, const td_impact_point *at,
                       double time, const thud_contact_settings *settings, td_impact *impact);

#endif
