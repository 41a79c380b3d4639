/* act_thud.c: see act_thud.h. */
#include "act_thud.h"

#include "break_thud.h"

#include <thud/thud_fields.h>
#include <thud/thud_lists.h>
#include <thud/thud_rules.h>

#include <math.h>

/* Periods of the two gusts that are added, in steps, and the delay of the gusts, in steps per metre
 * along the wind. Chosen; act.js has the same. */
static const double LONG_GUST = 300, SHORT_GUST = 113, STEPS_PER_METRE = 4;

/* A wave of period 1 with values from -1 to 1, made of parabolas; close to a sine. */
static double wave(double t) {
    t -= floor(t);
    return t < 0.5 ? 16 * t * (0.5 - t) : -16 * (t - 0.5) * (1 - t);
}

double scene_wind_at(const scene_fields *fields, double step, double x) {
    /* x counts in whole metres, which are exact wherever a scene is placed (scene_shift). */
    double metres = floor(x - fields->wind_origin);
    double t = step - STEPS_PER_METRE * (fields->wind < 0 ? -metres : metres);
    return fields->wind * (1 + 0.5 * wave(t / LONG_GUST) + 0.3 * wave(t / SHORT_GUST));
}

/* Triggers the explosions of this step. */
static thud_result explode(const scene_fields *fields, thud_world *world, double step) {
    thud_result result = THUD_OK;
    for (int i = 0; i < fields->blast_count && result == THUD_OK; i++) {
        const scene_blast *blast = &fields->blasts[i];
        if (blast->step != step)
            continue;
        thud_explosion explosion = thud_default_explosion();
        explosion.center = (thud_pos){blast->x, blast->y};
        explosion.radius = blast->radius;
        explosion.falloff = blast->falloff;
        explosion.impulse = (float)blast->impulse;
        result = thud_world_explode(world, &explosion, NULL);
    }
    return result;
}

/* Applies water and wind to a body, if it is dynamic and awake. */
static thud_result act_on(const scene_fields *fields, thud_world *world, double step,
                          thud_body_id id) {
    thud_body_state body;
    thud_result result = thud_body_get_state(world, id, &body);
    if (result != THUD_OK || body.kind != THUD_BODY_DYNAMIC || !body.awake)
        return result;
    if (fields->water_density > 0) {
        thud_water water = thud_default_water();
        water.point = (thud_pos){body.position.x, fields->water_level};
        water.density = (float)fields->water_density;
        water.linear_drag = water.angular_drag = (float)fields->water_drag;
        result = thud_body_apply_buoyancy(world, id, &water);
    }
    if (fields->air_density > 0 && result == THUD_OK) {
        thud_vec2 wind = {(float)scene_wind_at(fields, step, body.position.x), 0};
        result = thud_body_apply_wind(world, id, wind, (float)fields->air_density,
                                      (float)fields->air_drag, (float)fields->air_lift);
    }
    return result;
}

/* Equal, or both NaN. */
static bool same(float a, float b) {
    return a == b || (isnan(a) && isnan(b));
}

/* Whether the world has this rule for the pair of kinds `first` and `second`, one bit each. */
static bool pair_has(const thud_world *world, uint32_t first, uint32_t second,
                     const thud_rule *rule) {
    thud_rule old;
    bool is_set, reversed;
    return thud_world_get_rule(world, first, second, &old, &is_set, &reversed) == THUD_OK &&
           is_set && (!reversed || rule->kind != THUD_RULE_ONE_WAY) && old.kind == rule->kind &&
           same(old.friction, rule->friction) && same(old.restitution, rule->restitution) &&
           same(old.surface_speed, rule->surface_speed) &&
           same(old.event_impulse, rule->event_impulse);
}

/* Whether all pairs of the kinds `first` and `second` have this rule. A rule that the world has is
 * not set again, because setting a rule wakes all bodies of its kinds. */
static bool is_there(const thud_world *world, uint32_t first, uint32_t second,
                     const thud_rule *rule) {
    for (uint32_t f = first; f; f &= f - 1)
        for (uint32_t s = second; s; s &= s - 1)
            if (!pair_has(world, f & (~f + 1), s & (~s + 1), rule))
                return false;
    return true;
}

static thud_result set_rule(thud_world *world, const scene_rule *from) {
    thud_rule rule = thud_default_rule();
    rule.kind = (thud_rule_kind)from->kind;
    rule.friction = (float)from->friction;
    rule.restitution = (float)from->restitution;
    rule.surface_speed = (float)from->surface_speed;
    rule.event_impulse = (float)from->event_impulse;
    if (is_there(world, from->first, from->second, &rule))
        return THUD_OK;
    return thud_world_set_rule(world, from->first, from->second, &rule);
}

/* Whether a later rule of the list with the same kinds is in effect at this step and replaces this
 * one. */
static bool replaced(const scene_fields *fields, int index, double step) {
    const scene_rule *rule = &fields->rules[index];
    for (int i = index + 1; i < fields->rule_count; i++) {
        const scene_rule *later = &fields->rules[i];
        if (later->step <= step && later->first == rule->first && later->second == rule->second)
            return true;
    }
    return false;
}

thud_result scene_rule_thud(const scene_fields *fields, thud_world *world) {
    double step = fields->rule_count > 0 ? (double)thud_stats_of(world).steps : 0;
    thud_result result = THUD_OK;
    for (int i = 0; i < fields->rule_count && result == THUD_OK; i++)
        if (fields->rules[i].step <= step && !replaced(fields, i, step))
            result = set_rule(world, &fields->rules[i]);
    return result;
}

thud_result scene_step_thud(const scene_fields *fields, thud_world *world) {
    double step = (double)thud_stats_of(world).steps;
    thud_result result = scene_rule_thud(fields, world);
    if (result == THUD_OK)
        result = explode(fields, world, step);
    int slots = 0;
    if (fields->water_density > 0 || fields->air_density > 0)
        thud_world_get_slot_counts(world, &slots, NULL);
    for (int i = 0; i < slots && result == THUD_OK; i++) {
        thud_body_id id;
        if (thud_world_get_body_at(world, i, &id) == THUD_OK && id.index1 != 0)
            result = act_on(fields, world, step, id);
    }
    if (result == THUD_OK)
        result = thud_world_step(world);
    return result == THUD_OK ? scene_break_thud(fields, world) : result;
}
