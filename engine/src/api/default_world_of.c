/* default_world_of.c: thud_default_world_def_of, whose def names all optional parts (thud_parts).
 * It is a file of its own because a program that links it also links these parts. */
#include "contact/sensors.h"
#include "api/step.h"
#include "solver/budget.h"
#include "solver/error.h"
#include "solver/restitution.h"
#include "state/sleep_hooks.h"

static const thud_parts ALL = {.sensors = &td_sensor_stages,
                               .restitution = &td_restitution,
                               .broadphase = &thud_broadphase_grid,
                               .sleep = &td_sleep_stages,
                               .errors = &td_error_report,
                               .keep_budget = td_budget_keep,
                               .few_resting = td_broadphase_few_resting};

thud_world_def thud_default_world_def_of(const thud_quality *quality) {
    thud_world_def def = td_world_def_of(quality);
    def.parts = &ALL;
    def.broadphase = ALL.broadphase;
    def.sleeping = true;
    return def;
}
