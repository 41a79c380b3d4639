/* ballistics.h: exact parabolas, x + v t + g t^2 / 2, for swept bodies in free flight, which
 * substeps would move along a polygon. Called by impacts.c. */
#ifndef TD_BALLISTICS_H
#define TD_BALLISTICS_H

#include "state/world.h"

/* Begins a new trajectory for each awake body, and saves its velocity there (td_trajectory.before)
 * before the solver changes it. */
void td_ballistics_save_velocities(thud_world *w);
/* Runs after the solver, before motions become poses. Each dynamic swept body in free flight (only
 * gravity and forces changed its velocity, up to FREE_SHARE_MAX of that change) gets the motion of
 * its parabola; sets td_trajectory.free and `acceleration`. */
void td_ballistics_set_parabolas(thud_world *w);

#endif
