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
    bool acceleration_reduced[2]; /* the body's `acceleration` has changed, so that its times of
                                     impact must be computed again */
} td_impact;

/* The point at which two bodies act on each other, relative to `origin`. Lengths. */
typedef struct td_impact_point {
    td_position origin;
    double nx, ny;   /* normal, from the first body to the second */
    double x, y;     /* the middle between both surfaces */
    double distance; /* of the surfaces; negative: overlap */
    double speed;    /* closing speed of the trajectories there, lengths a step; > 0: closing */
    double closing_distance; /* distance by which both trajectories would close there in the rest of
                                the step, `acceleration` included */
} td_impact_point;

/* Finds the impact point of a candidate at `time`: the contact point with the greater
 * closing_distance. If a second point closes by more than half as much, the bodies meet along a
 * face, and the middle of both points is taken. False if the shapes are further apart than
 * TD_SPECULATIVE. */
bool td_impact_point_of(thud_world *w, const td_toi_candidate *e, double time, td_impact_point *at);

/* The contact as callbacks see it, before the impact is resolved. */
thud_contact td_impact_view(const thud_world *w, const td_toi_candidate *e,
                            const td_impact_point *at);

/* Resolves the impact of a candidate whose trajectories stand at `time`: Newtonian restitution and
 * Coulomb friction. Changes velocities, trajectories, and all fields of `impact` except `touching`,
 * which the caller sets. Afterwards the trajectories do not close at the point, unless a body keeps
 * its motion. */
void td_impact_resolve(thud_world *w, const td_toi_candidate *e, const td_impact_point *at,
                       double time, const thud_contact_settings *settings, td_impact *impact);

#endif
