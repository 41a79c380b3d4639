/* rules.c: sets and reads collision rules and the caller's filter, and answers the stages that ask
 * which pairs may have contacts and with which settings; see thud_rules.h. */
#include "rules/rules.h"

#include "contact/contact.h"
#include "edits/edit.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "state/surface.h"

/* NaN: the pair keeps the value of its shapes. */
#define OF_SHAPES __builtin_nanf("")

thud_rule thud_default_rule(void) {
    return (thud_rule){.kind = THUD_RULE_COLLIDE,
                       .solid_side = {0.0f, 1.0f},
                       .friction = OF_SHAPES,
                       .restitution = OF_SHAPES,
                       .surface_speed = OF_SHAPES,
                       .event_impulse = __builtin_inff()};
}

/* ---- the hooks ---- */

/* td_rule_hooks.allows: neither the rule nor the caller's filter forbids the pair. */
static bool allows(const thud_world *world, int shape_a, int shape_b) {
    const td_rules *rules = world->rules;
    const td_rule *rule = td_rule_of_pair(world, shape_a, shape_b);
    if (rule && rule->rule.kind == THUD_RULE_IGNORE) {
        return false;
    }
    if (!rules->filter) {
        return true;
    }
    thud_world *w = (thud_world *)world; /* only `locked` changes: it keeps the filter from editing
                                            the world */
    bool locked = w->locked;
    w->locked = true;
    bool yes = rules->filter(w, td_shape_handle(w, shape_a), td_shape_handle(w, shape_b),
                             rules->filter_context);
    w->locked = locked;
    return yes;
}

/* Replaces a value, unless the rule's value is NaN. */
static void override(float *value, float rule_value) {
    *value = rule_value == rule_value ? rule_value : *value;
}

/* td_rule_hooks.settle. */
static uint16_t settle(const thud_world *w, int shape_a, int shape_b,
                       thud_contact_settings *settings) {
    const td_rule *rule = td_rule_of_pair(w, shape_a, shape_b);
    if (!rule) {
        return 0;
    }
    override(&settings->friction, rule->rule.friction);
    override(&settings->restitution, rule->rule.restitution);
    override(&settings->surface_speed, rule->rule.surface_speed);
    unsigned marks = (rule->rule.kind == THUD_RULE_ONE_WAY ? TD_RULE_ONE_WAY : 0u) |
                     (td_rule_counts_impulses(rule) ? TD_RULE_IMPULSE : 0u);
    return (uint16_t)(marks ? marks | (unsigned)(rule - w->rules->table[0]) : 0u);
}

/* td_rule_hooks.end. */
static void end(thud_world *w) {
    td_array_free(&w->memory, &w->rules->impulses);
    td_memory_put(&w->memory, w->rules, sizeof *w->rules);
}

static const td_rule_hooks HOOKS = {.allows = allows,
                                    .settle = settle,
                                    .hides = td_rules_hide,
                                    .lets_through = td_rules_let_through,
                                    .decide = td_rules_decide,
                                    .reserve = td_rules_reserve,
                                    .tell = td_rules_tell,
                                    .ruled = td_rules_ruled,
                                    .write = td_rules_keep,
                                    .valid = td_rules_kept,
                                    .make_room = td_rules_make_room,
                                    .read = td_rules_bring_back,
                                    .end = end};

/* ---- setting rules and filter ---- */

static thud_result check_unlocked(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    return w->locked ? td_refuse(w, THUD_ERROR_LOCKED, "rule or filter: not inside a callback")
                     : THUD_OK;
}

/* Creates the world's rules and sets the hooks, if it has none yet. False when memory is short. */
static bool make_rules(thud_world *w) {
    if (!w->rules) {
        w->rules = td_memory_get(&w->memory, sizeof *w->rules);
        if (w->rules) {
            w->rules->impulses.stride = (int)sizeof(thud_impulse_event);
            w->rule_hooks = &HOOKS;
            w->sweep_is_vetoed = td_sweep_is_vetoed;
        }
    }
    return w->rules != NULL;
}

/* Whether the shape exists and its kind is in `kinds`, or `kinds` has all bits. */
static bool is_affected(const thud_world *w, int shape, uint32_t kinds) {
    const td_shape *s = td_shape_at(w, shape);
    uint32_t category = s->filter.category;
    return (s->flags & TD_SHAPE_LIVE) && (kinds == UINT32_MAX || (category & -category & kinds));
}

/* Applies changed rules to all shapes of these kinds: wakes their bodies, ends the contacts that
 * are no longer allowed, updates the settings of the others, and makes the broadphase search for
 * new pairs. Memory for the end events must be reserved. */
static void update_shapes_of(thud_world *w, uint32_t kinds) {
    for (int i = 0; i < w->shapes.count; i++) {
        if (is_affected(w, i, kinds)) {
            td_body_index body = td_shape_at(w, i)->body;
            td_edit_wake(w, body, i);
            td_edit_end_contacts(w, body, i, false);
            td_edit_settle_contacts(w, i);
            td_edit_look_around(w, i);
            td_body_mark(w, body, TD_CHANGE_SHAPES);
        }
    }
}

thud_result thud_world_set_rule(thud_world *w, uint32_t first, uint32_t second,
                                const thud_rule *rule) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = check_unlocked(w);
    if (result != THUD_OK) {
        return result;
    }
    const char *error = first && second ? (rule ? td_rule_error(w, first, second, rule) : NULL)
                                        : "rule: no kind is named";
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (!make_rules(w) || !td_contact_end_reserve(w, w->constraints.live)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "rule: out of memory");
    }
    td_rule made = {.rule = rule ? *rule : thud_default_rule(), .is_set = rule != NULL};
    td_rules_write(w->rules, first, second, &made);
    td_rules_look_through(w);
    update_shapes_of(w, first | second);
    return THUD_OK;
}

thud_result thud_world_use_rules(thud_world *w) {
    thud_result result = check_unlocked(w);
    if (result != THUD_OK) {
        return result;
    }
    return make_rules(w) ? THUD_OK : td_refuse(w, THUD_ERROR_MEMORY, "use rules: out of memory");
}

thud_result thud_world_get_rule(const thud_world *w, uint32_t first, uint32_t second,
                                thud_rule *out, bool *out_is_set, bool *out_reversed) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (__builtin_popcount(first) != 1 || __builtin_popcount(second) != 1) {
        return td_refuse(w, THUD_ERROR_INVALID, "rule: a kind is one bit");
    }
    td_rule rule = {.is_set = false};
    if (w->rules) {
        rule = w->rules->table[__builtin_ctz(first)][__builtin_ctz(second)];
    }
    if (!rule.is_set) {
        rule.rule = thud_default_rule();
    }
    if (out) {
        *out = rule.rule;
    }
    if (out_is_set) {
        *out_is_set = rule.is_set;
    }
    if (out_reversed) {
        *out_reversed = rule.is_set && rule.reversed;
    }
    return THUD_OK;
}

thud_result thud_world_set_filter(thud_world *w, thud_filter_fn *filter, void *context) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = check_unlocked(w);
    if (result != THUD_OK) {
        return result;
    }
    if (!make_rules(w) || !td_contact_end_reserve(w, w->constraints.live)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "filter: out of memory");
    }
    w->rules->filter = filter;
    w->rules->filter_context = context;
    update_shapes_of(w, UINT32_MAX);
    return THUD_OK;
}
