/* thud_locks.h: locks of a dynamic body's motion along x or y of the world: for paddles, lifts that
 * a weight must not tilt, platforms on rails. Rotation is locked by fixed_rotation of thud.h.
 *
 * A lock is a joint (thud_joint.h) between the body's centre of mass and a static body without
 * shapes, the anchor, which the engine creates if there is none nearby, and destroys with its last
 * lock. Lists leave anchors out, but statistics and poses do not. A lock of x or of y is a wheel
 * joint without spring and motor, a lock of both is a hinge. It is in the lists of joints, and can
 * be destroyed as a joint. It is solved together with all other constraints: a locked body resists
 * forces along the locked axis, including gravity, as stiffly as joints do (docs/joints.md has the
 * figures). Sleep, workers and snapshots treat it as any joint: a world that never had a joint or a
 * lock needs thud_world_use_joints before it is restored from a snapshot with locks.
 *
 * A lock takes effect with the next step, and keeps the coordinate that the centre of mass has
 * then. If thud_body_set_transform moves a locked body, or changed shapes or a set mass move its
 * centre, the lock keeps the new position, to 1e-7 of the distance moved. The next step removes a
 * velocity that is set along a locked axis.
 *
 * A program that does not use this header does not link it. */
#ifndef THUD_LOCKS_H
#define THUD_LOCKS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets which axes of a dynamic body are locked; both false: none. Wakes the body. While a body has
 * locks it stays dynamic, see thud_body_set_kind. THUD_ERROR_NULL for a null world,
 * THUD_ERROR_STALE, THUD_ERROR_INVALID for a body that is not dynamic, THUD_ERROR_LOCKED inside a
 * callback, THUD_ERROR_MEMORY: then nothing has changed. */
THUD_API thud_result thud_body_set_locks(thud_world *world, thud_body_id body, bool x, bool y);
/* Which axes are locked. Either output may be null. THUD_ERROR_NULL, THUD_ERROR_STALE. */
THUD_API thud_result thud_body_get_locks(const thud_world *world, thud_body_id body, bool *out_x,
                                         bool *out_y);

#ifdef __cplusplus
}
#endif

#endif
