/* step.h: the stages of a step, in the order in which step.c runs them. Stages read and write the
 * state of the world, and never call each other; those of detection are td_detection_stage.
 *
 * A stage that returns false is out of memory. Then no body has moved and no event is published,
 * and the next call of thud_world_step goes on with the stage that failed (thud_world.paired,
 * narrowed), so that its result is the same as if there had been memory. After td_narrowphase only
 * reservations can fail; after them the step cannot fail. */
#ifndef TD_STEP_H
#define TD_STEP_H

#include "state/world.h"

/* step.c: makes a step of a world that is not in a step. */
thud_result td_step(thud_world *w);

/* changes.c: applies the edits that the API and callbacks made since the last step. */
bool td_changes_apply(thud_world *w);
/* broadphase.c: makes a contact, which waits, of each new pair of overlapping fat bounds. */
bool td_broadphase(thud_world *w);
/* Builds both proxy sets, of awake bodies and of bodies at rest, for the present bounds where they
 * are out of date. */
bool td_broadphase_refresh(thud_world *w);
/* narrowphase.c: finds the pairs that touch, which get lanes, and those that do not any more; makes
 * their begin and end events; computes the manifolds of all lanes. */
bool td_narrowphase(thud_world *w);
/* broadphase.c: thud_parts.few_resting. */
bool td_broadphase_few_resting(thud_world *w, const td_array **few);
/* contact_view.c: makes hit events of contacts that have begun in this step with a closing speed
 * above hit_speed. */
void td_contacts_hit(thud_world *w);
/* solve.c: computes the velocity that gravity and forces add in a substep (substep_gain), for all
 * awake bodies, where it may have changed. Forces act for one step: they are cleared, and the next
 * step computes it again. */
void td_solve_begin(thud_world *w);
/* solve.c: the soft solver: computes the velocities at the end of the step, and the motions. */
void td_solve(thud_world *w);
/* finalize.c: adds motions to poses; updates shapes, bounds and idle times; quarantines bodies
 * whose numbers are not finite. */
void td_finalize(thud_world *w);
/* sensed_pairs.c: sensors at the end of a step. td_sensed_reserve reserves their memory before
 * bodies move. td_sensed_list lists the awake bodies that have a sensor. td_sensed_pairs makes a
 * contact for each new pair of a sensor and a shape. It returns false where the reserved room is
 * too small for all pairs. This does not fail the step: no contact is made, and the next step's
 * broadphase finds the pairs, whose begin events then come one step later. */
bool td_sensed_reserve(thud_world *w);
void td_sensed_list(thud_world *w);
bool td_sensed_pairs(thud_world *w);
/* sensor_events.c: reserves room; makes begin and end events of sensors, for the poses at the end
 * of the step. */
bool td_sensors_reserve(thud_world *w);
void td_sensors_test(thud_world *w);

/* Reserves what td_finalize needs, so that it cannot fail. */
bool td_finalize_reserve(thud_world *w);

#endif
