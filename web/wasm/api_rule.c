/* api_rule.c: exports for collision rules between kinds of shapes, and impulse events
 * (thud_rules.h). api.h has the conventions. */
#include "api.h"

#include <thud/thud_rules.h>

static api_buffer impulses;

/* A rule as the slots have it. */
static struct rule_options told(const thud_rule *rule) {
    return (struct rule_options){
        .kind = rule->kind,
        .solid_side = {(double)rule->solid_side.x, (double)rule->solid_side.y},
        .friction = (double)rule->friction,
        .restitution = (double)rule->restitution,
        .surface_speed = (double)rule->surface_speed,
        .event_impulse = (double)rule->event_impulse,
    };
}

/* Slots out: rule_options. */
void api_rule_defaults(void) {
    thud_rule rule = thud_default_rule();
    api_slots.rule_options = told(&rule);
}

/* Sets the rule in the slots, or removes the rule where `is_set` is 0. Slots in: rule_options. */
int api_world_set_rule(thud_world *world, uint32_t first, uint32_t second, int is_set) {
    const struct rule_options *s = &api_slots.rule_options;
    const thud_rule rule = {.kind = (thud_rule_kind)api_to_int(s->kind),
                            .solid_side = {(float)s->solid_side[0], (float)s->solid_side[1]},
                            .friction = (float)s->friction,
                            .restitution = (float)s->restitution,
                            .surface_speed = (float)s->surface_speed,
                            .event_impulse = (float)s->event_impulse};
    return thud_world_set_rule(world, first, second, is_set ? &rule : NULL);
}

/* Slots out: rule_found. */
int api_world_rule(const thud_world *world, uint32_t first, uint32_t second) {
    thud_rule rule;
    bool is_set = false, reversed = false;
    thud_result result = thud_world_get_rule(world, first, second, &rule, &is_set, &reversed);
    if (result == THUD_OK)
        api_slots.rule_found = (struct rule_found){told(&rule), is_set, reversed};
    return result;
}

int api_world_use_rules(thud_world *world) {
    return thud_world_use_rules(world);
}

/* Slots out: list of impulse_event. */
int api_world_impulse_events(const thud_world *world) {
    int count = 0;
    const thud_impulse_event *events = thud_impulse_events_of(world, &count);
    api_buffer_clear(&impulses);
    for (int i = 0; i < count; i++) {
        const thud_impulse_event *e = &events[i];
        struct impulse_event row = {.shape_a = {e->shape_a.index1, e->shape_a.generation},
                                    .shape_b = {e->shape_b.index1, e->shape_b.generation},
                                    .point = {e->point.x, e->point.y},
                                    .normal = {(double)e->normal.x, (double)e->normal.y},
                                    .impulse = (double)e->impulse};
        api_buffer_push(&impulses, &row, sizeof row);
    }
    api_slots.list.address = (double)(uintptr_t)impulses.data;
    api_slots.list.count = count;
    return api_buffer_result(&impulses);
}
