/* collide.h: the impact of two bodies at a point, at the time at which they meet. Called by
 * impacts.c, in the order of time. */
#ifndef TD_COLLIDE_H
#define TD_COLLIDE_H

#include "detection/trajectory.h"

/* The impact of a pair within the step. scratch.impacts lists them. */
typedef struct td_impact {
    thud_contact seen;   /* as callbacks see it */
    float closing_speed; /* normal speed at which the pair met, length/s; > 0: closing */
    bool touching;       /* the pair has a touching contact, which the solver works on */
    bool kept_motion[2]; /* the body keeps its motion of this step; only its velocity changed */
    bool
        fall_reduced[2]; /* its trajectory has another `fall`, so that its times of impact change */
} td_impact;

/* The point at which two bodies act on each other, relative to `origin`. Lengths. */
typedef struct td_impact_point {
    td_position origin;
    double nx, ny;   /* normal, from the first body to the second */
    double x, y;     /* the middle between both surfaces */
    double distance; /* of the surfaces; negative: overlap */
    double speed;    /* closing speed of the trajectories there, lengths a step; > 0: closing */
    double closing_distance; /* by how much the rest of both trajectories would close there, with
                                `fall` */
} td_impact_point;

/* Finds the impact point of a candidate at `time`: of its contact points that with the greater
 * closing_distance. Where a second one closes by more than half as much, both bodies touch along a
 * face, and the middle of both is taken. False where the shapes are further apart than
 * TD_SPECULATIVE. */
bool td_impact_point_of(thud_world *w, const td_toi_candidate *e, double time, td_impact_point *at);

/* The contact as callbacks see it, before the impact is resolved. */
thud_contact td_impact_view(const thud_world *w, const td_toi_candidate *e,
                            const td_impact_point *at);

/* Resolves the impact of a candidate whose trajectories stand at `time`: Newtonian restitution and
 * Coulomb friction. Changes velocities, trajectories, and all of `impact` but `touching`, which is
 * read. The new trajectories do not close at the point, but those of bodies that keep their
 * motion. */
void td_impact_resolve(thud_world *w, const td_toi_candidate *e, const td_impact_point *at,
                       double time, const thud_contact_settings *settings, td_impact *impact);

#endif
