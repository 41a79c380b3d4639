/* act_thud.h: steps the world of a scene: before each step, water, wind and explosions act on awake
 * bodies, and the collision rules of that step are set.
 *
 * Forces and rules depend only on the world and its number of steps, so that a world restored from
 * a snapshot continues exactly as the first one did. The page's scenes do the same in JavaScript,
 * with the same numbers (web/public/scenes/fields/act.js). */
#ifndef THUD_DEMO_ACT_THUD_H
#define THUD_DEMO_ACT_THUD_H

#include "scene.h"

#include <thud/thud.h>

/* Applies the fields, steps the world once, and breaks what the rules break. If a rule or a field
 * returns an error, the world is not stepped. */
thud_result scene_step_thud(const scene_fields *fields, thud_world *world);

/* Sets the rules of the next step where they differ from the world's. Called when a world is built
 * and before each step. */
thud_result scene_rule_thud(const scene_fields *fields, thud_world *world);

/* The wind's velocity in m/s, to the right, at the place `x` after `step` steps. Its gusts follow
 * parabolas over time and travel with the wind. Uses only + - * / and floor, so its bits are the
 * same on every platform. */
double scene_wind_at(const scene_fields *fields, double step, double x);

#endif
