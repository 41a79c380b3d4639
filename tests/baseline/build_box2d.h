/* build_box2d.h: makes a Box2D world of a scene, the counterpart of demo/scenes/build_thud.h. */
#ifndef THUD_BASELINE_BUILD_BOX2D_H
#define THUD_BASELINE_BUILD_BOX2D_H

#include "scene.h"

#include <box2d/box2d.h>
#include <stdbool.h>

typedef struct box2d_settings {
    bool sleeping;
    bool events; /* contact, hit and sensor events, which Box2D leaves out by default */
} box2d_settings;

/* Creates a world of one thread with Box2D's defaults but for `settings`, the scene's gravity and
 * its length scale, and every body and shape in the scene's order. `bodies` has room for
 * scene.body_count handles. False, and no world, when memory runs out or the scene is incomplete.
 *
 * The length scale is one number for all of Box2D: worlds of different scales cannot live at the
 * same time. */
bool scene_build_box2d(const scene *s, box2d_settings settings, b2WorldId *out, b2BodyId *bodies);

#endif
