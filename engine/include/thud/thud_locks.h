/* thud_locks.h: dynamic bodies that do not move along x, or y, of the world: paddles, lifts that a
 * weight may not tilt, platforms on rails. Rotation has fixed_rotation of thud.h.
 *
 * A lock is a joint (thud_joint.h) between the body's centre of mass and a static body without
 * shapes, which the engine makes where there is none near, and which goes with the last lock: lists
 * leave it out, and statistics count it. A lock of x or of y is a wheel that nothing drives, of
 * both a hinge, and it is among the joints that are listed; destroyed there, it is gone. So it is
 * solved with all else: what presses against a locked axis presses against something that does not
 * give way, as far as joints do not, of which docs/joints.md has the figures; and what pulls along
 * it, gravity too, moves nothing. Sleep, workers and snapshots are those of joints: a world that
 * never had a joint or a lock needs thud_world_use_joints before it is restored from a snapshot
 * with locks.
 *
 * A lock holds where the centre of mass is when the lock takes effect with the next step, to 1e-7
 * of the way that a body that is locked already is put elsewhere by thud_body_set_transform: it
 * then holds there, as it does where shapes or a mass that was set move the centre. Velocities
 * along a locked axis that are set are gone with the next step.
 *
 * A program that uses none of this does not link it. */
#ifndef THUD_LOCKS_H
#define THUD_LOCKS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of a dynamic body; both false: it is free again. Wakes it. THUD_ERROR_NULL for a null world,
 * THUD_ERROR_STALE, THUD_ERROR_INVALID for a body that is not dynamic, THUD_ERROR_LOCKED inside a
 * callback, THUD_ERROR_MEMORY: then nothing has changed. While it has locks it stays dynamic, see
 * thud_body_set_kind. */
THUD_API thud_result thud_body_set_locks(thud_world *world, thud_body_id body, bool x, bool y);
/* Either may be null. */
THUD_API thud_result thud_body_locks(const thud_world *world, thud_body_id body, bool *x, bool *y);

#ifdef __cplusplus
}
#endif

#endif
