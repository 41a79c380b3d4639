/* box2d_joints.h: creates a scene's joints in Box2D. */
#ifndef THUD_ADAPTERS_BOX2D_JOINTS_H
#define THUD_ADAPTERS_BOX2D_JOINTS_H

#include "engine.h"

#include <box2d/box2d.h>

/* False for scenes with gears, which Box2D does not have. */
bool box2d_has_joints(const scene *s);

/* False if one cannot be created. `bodies` are in the scene's order. */
bool box2d_add_joints(b2WorldId world, const scene *s, const b2BodyId *bodies,
                      const engine_settings *settings);

#endif
