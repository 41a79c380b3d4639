/* break_thud.h: breaks boxes into pieces after a step, if a contact pressed them with more than the
 * max impulse of its rule. */
#ifndef THUD_DEMO_BREAK_THUD_H
#define THUD_DEMO_BREAK_THUD_H

#include "scene.h"

#include <thud/thud.h>

/* Replaces each body whose box shape is of the kind `fields->breaks`, and which had an impulse
 * event in the last step, by four boxes of half its size and of the kind `fields->pieces`. Each
 * piece has the velocity that the body had at its centre. Does nothing if `breaks` is 0. */
thud_result scene_break_thud(const scene_fields *fields, thud_world *world);

#endif
