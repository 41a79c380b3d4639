/* chipmunk_joints.h: creates a scene's joints in Chipmunk. */
#ifndef THUD_ADAPTERS_CHIPMUNK_JOINTS_H
#define THUD_ADAPTERS_CHIPMUNK_JOINTS_H

#include "engine.h"

#include <chipmunk/chipmunk.h>

/* False for scenes with targets, which Chipmunk does not have, and with gears, because Chipmunk's
 * gears lose count of whole turns. */
bool chipmunk_has_joints(const scene *s);

/* Largest number of constraints for a joint of a scene. */
enum { CHIPMUNK_PARTS = 5 };

/* Writes the created constraints to `parts`, which has room for CHIPMUNK_PARTS; unused elements
 * stay null. */
void chipmunk_add_joint(cpSpace *space, const scene_joint *j, cpBody *const *bodies,
                        cpConstraint *parts[CHIPMUNK_PARTS]);

#endif
