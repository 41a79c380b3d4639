/* break_thud.h: after each step, what bore more than its rule lets it bear goes to pieces. */
#ifndef THUD_DEMO_BREAK_THUD_H
#define THUD_DEMO_BREAK_THUD_H

#include "scene.h"

#include <thud/thud.h>

/* Puts four boxes of half the size in place of each body whose shape, a box, is of the kind
 * `breaks` and had an impulse event in the last step. They go on as it moved there. */
thud_result scene_break_thud(const scene_fields *fields, thud_world *world);

#endif
