/* trial.h: a scene run by one entrant, seen the same way whoever it is. */
#ifndef THUD_STABILITY_TRIAL_H
#define THUD_STABILITY_TRIAL_H

#include "engine.h"
#include "extremes/extreme.h"
#include "joint_gaps.h"
#include "penetration.h"

typedef struct trial trial;

/* Whether the entrant has all that is in the scene: Box2D has no gears. */
bool trial_is_possible(entrant e, const scene *s);

/* Null, and the ledger has failed, when the world cannot be made. The scene must outlive it. The
 * entrant's quality is filled in. */
trial *trial_begin(ledger *l, entrant e, const scene *s, engine_settings settings);
void trial_end(trial *t); /* null is fine */

/* Places are read relative to this one from now on; before, to (0, 0). */
void trial_look_from(trial *t, double x, double y);

/* False, and the ledger has failed, when a step is refused. */
bool trial_step(trial *t);
bool trial_steps(trial *t, int count);
bool trial_set_time_step(trial *t, double seconds);

/* Destroys a body of one circle, and makes it anew as the scene has it. False, and the ledger has
 * failed, when that is refused. */
bool trial_renew(trial *t, int body);

/* A wrong call, about this body where it is about one. True if the engine says that it is. */
bool trial_misuse(trial *t, int body, misuse call, double value);

/* All bodies in the scene's order, as of now. Belongs to the trial, valid until its next call. */
const engine_body *trial_read(trial *t);
/* The same as the engine's own floats: x, y, cosine, sine. Equal bits are equal states. */
void trial_pose(trial *t, int body, float out[4]);

/* Overlaps as of now, by exact geometry in double precision: no engine's own measure. `seen` adds
 * up what several calls saw. */
void trial_penetration(trial *t, penetration *seen);
/* By how much joints are open as of now, by geometry likewise. */
void trial_joint_gaps(trial *t, joint_gaps *seen);
/* Kinetic and potential, the latter above `floor` (y, relative to where it is looked from). */
double trial_energy(trial *t, double floor);
double trial_kinetic_energy(trial *t);
/* The largest speed of any body; infinite when a body's state is not finite. */
double trial_speed(trial *t);
uint64_t trial_bytes(trial *t); /* memory held by the world */
/* Memory blocks that the last step asked for; 0 for Box2D, which does not tell. */
uint64_t trial_allocations(trial *t);

const scene *trial_scene(const trial *t);

#endif
