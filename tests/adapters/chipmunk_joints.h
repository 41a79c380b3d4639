/* chipmunk_joints.h: a scene's joints in Chipmunk. */
#ifndef THUD_ADAPTERS_CHIPMUNK_JOINTS_H
#define THUD_ADAPTERS_CHIPMUNK_JOINTS_H

#include "engine.h"

#include <chipmunk/chipmunk.h>

/* Chipmunk has no targets, and its gears lose count of turns. */
bool chipmunk_has_joints(const scene *s);

/* What a scene's joint is made of there. */
enum { CHIPMUNK_PARTS = 5 };

/* `parts` gets room for CHIPMUNK_PARTS a joint, of which those not needed are null. */
void chipmunk_add_joint(cpSpace *space, const scene_joint *j, cpBody *const *bodies,
                        cpConstraint *parts[CHIPMUNK_PARTS]);

#endif
