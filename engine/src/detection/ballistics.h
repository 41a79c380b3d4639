/* ballistics.h: bodies that nothing touches or joins fly exact parabolas, x + v t + g t^2 / 2,
 * where substeps would take them along a polygon. */
#ifndef TD_BALLISTICS_H
#define TD_BALLISTICS_H

#include "state/world.h"

/* Notes the velocities before the solver changes them. */
void td_ballistics_save_velocities(thud_world *w);
/* A body that gained hardly anything but gravity gets the motion of its parabola, and its
 * trajectory the fall, before the motion becomes a pose. */
void td_ballistics_set_parabolas(thud_world *w);

#endif
