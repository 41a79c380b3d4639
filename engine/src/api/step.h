/* step.h: the stages of a step, in the order in which step.c runs them. They meet in the world's
 * state alone and never call each other, detection's among them: see td_detection_stage. A stage
 * that returns false is out of memory: nothing has moved then and no event is told, and the step
 * that is tried again goes on there, so that it ends as it would have. After td_narrowphase only
 * reservations can fail. */
#ifndef TD_STEP_H
#define TD_STEP_H

#include "state/world.h"

/* step.c: a whole step of a world that is not in one. */
thud_result td_step(thud_world *w);

/* changes.c: applies what the API and callbacks asked for since the last step. */
bool td_changes_apply(thud_world *w);
/* broadphase.c: makes a contact of each new pair of overlapping fat bounds. */
bool td_broadphase(thud_world *w);
bool td_broadphase_refresh(thud_world *w); /* both grids hold the present bounds */
/* narrowphase.c: which pairs touch; lanes, begin and end events; manifolds of all lanes. */
bool td_narrowphase(thud_world *w);
/* contact_view.c: hit events of what the solver will stop. */
void td_contacts_hit(thud_world *w);
/* solve.c: substeps. */
void td_solve(thud_world *w);
/* finalize.c: motion becomes pose; shapes, bounds, idle times; quarantine. */
void td_finalize(thud_world *w);
/* sensed_pairs.c: lists the bodies with sensors that are awake; and makes a contact of each new
 * pair of a sensor. Where memory is short the next step does, and tells of it. */
bool td_sensed_reserve(thud_world *w);
void td_sensed_list(thud_world *w);
bool td_sensed_pairs(thud_world *w);
/* sensor_events.c: what is in sensors, by where bodies stand now. */
bool td_sensors_reserve(thud_world *w);
void td_sensors_test(thud_world *w);
/* sleep.c: islands at rest fall asleep. */
void td_sleep(thud_world *w);

/* Room for what the stages after the narrowphase note down, so that they cannot fail. */
bool td_finalize_reserve(thud_world *w);
bool td_sleep_reserve(thud_world *w);

#endif
