/* trial.h: a trial is a scene run with one entrant (extreme.h). It steps the engine and measures
 * the bodies in the same way for all engines. */
#ifndef THUD_STABILITY_TRIAL_H
#define THUD_STABILITY_TRIAL_H

#include "engine.h"
#include "extremes/extreme.h"
#include "joint_gaps.h"
#include "penetration.h"

typedef struct trial trial;

/* Whether the entrant's engine supports everything in the scene: Box2D, for example, has no gears.
 */
bool trial_is_possible(entrant e, const scene *s);

/* Null if the world cannot be created; the ledger has then failed. The scene must outlive the
 * trial. The entrant's quality is filled in. */
trial *trial_begin(ledger *l, entrant e, const scene *s, engine_settings settings);
void trial_end(trial *t); /* may be null */

/* From now on positions are read relative to (x, y); before, they are absolute. */
void trial_look_from(trial *t, double x, double y);

/* False if a step is refused; the ledger has then failed. */
bool trial_step(trial *t);
bool trial_steps(trial *t, int count);
bool trial_set_time_step(trial *t, double seconds);

/* Destroys a body that has one circle and creates it again as in the scene. False if that is
 * refused; the ledger has then failed. */
bool trial_renew(trial *t, int body);

/* Makes an invalid call, on this body if the call concerns a body. True if the engine reports an
 * error. */
bool trial_misuse(trial *t, int body, misuse call, double value);

/* All bodies in the scene's order, in their present state. The array belongs to the trial and is
 * valid until its next call. */
const engine_body *trial_read(trial *t);
/* A body's pose as the engine's own floats x, y, cosine, sine: equal bits mean equal states. */
void trial_pose(trial *t, int body, float out[4]);

/* Measures the overlaps of the present state by geometry in double precision that is independent of
 * the engines. `seen` accumulates over calls. */
void trial_penetration(trial *t, penetration *seen);
/* Measures the joint gaps of the present state, in the same way. */
void trial_joint_gaps(trial *t, joint_gaps *seen);
/* Kinetic and potential energy, J; the latter is measured from `floor`, a y relative to
 * trial_look_from. */
double trial_energy(trial *t, double floor);
double trial_kinetic_energy(trial *t);
/* The largest speed of any body, m/s; infinite if a body's state is not finite. */
double trial_speed(trial *t);
uint64_t trial_bytes(trial *t); /* memory held by the world */
/* Memory allocations of the last step; 0 for Box2D, which does not report them. */
uint64_t trial_allocations(trial *t);

const scene *trial_scene(const trial *t);

#endif
