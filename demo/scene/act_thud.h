/* act_thud.h: makes the steps of a scene's world: before each, water, wind and explosions act on
 * what is awake, and kinds of shapes are to each other what the scene says for that step.
 *
 * All depends on the world and the number of its steps alone, so that a world that is restored from
 * a snapshot goes on as the first did. The page's scenes do the same with the package, number for
 * number (web/public/scenes/fields/act.js). */
#ifndef THUD_DEMO_ACT_THUD_H
#define THUD_DEMO_ACT_THUD_H

#include "scene.h"

#include <thud/thud.h>

/* A step of the world of a scene with these fields. An error of what acts ends it before the step.
 */
thud_result scene_step_thud(const scene_fields *fields, thud_world *world);

/* Sets the rules of the step that comes, where they differ from those that the world has. Part of
 * building and of each step. */
thud_result scene_rule_thud(const scene_fields *fields, thud_world *world);

/* m/s, to the right, after so many steps at a place. Gusts take turns in parabolas, and come from
 * where the wind does. Uses only + - * / and floor: its bits are the same everywhere. */
double scene_wind_at(const scene_fields *fields, double step, double x);

#endif
