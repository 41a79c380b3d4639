/* build_thud.h: builds a thud world from a scene. */
#ifndef THUD_DEMO_BUILD_THUD_H
#define THUD_DEMO_BUILD_THUD_H

#include "scene.h"

#include <thud/thud.h>

/* Creates a world from `settings` (null: the defaults) with the scene's gravity and length scale,
 * and every body, shape and joint in the scene's order. `bodies`, if not null, has room for
 * scene.body_count handles. If it fails, no world remains, *out is null, and *failed_body (if not
 * null) is the index of the body that was refused, or -1. */
thud_result scene_build_thud(const scene *s, const thud_world_def *settings, thud_world **out,
                             thud_body_id *bodies, int *failed_body);

#endif
