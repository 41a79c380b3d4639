/* table.c: checks rules, and writes them into the table. */
#include "rules/rules.h"

/* Whether the value is NaN (the shapes' own value is used) or in range. */
static bool in_range(float value, float min, float max) {
    return value != value || (value >= min && value <= max);
}

const char *td_rule_error(const thud_world *w, uint32_t first, uint32_t second,
                          const thud_rule *rule) {
    float max_speed = THUD_SURFACE_SPEED_MAX * w->length_scale;
    float x = rule->solid_side.x, y = rule->solid_side.y;
    if ((unsigned)rule->kind >= THUD_RULE_KIND_COUNT) {
        return "rule: kind is none";
    }
    if (rule->kind == THUD_RULE_ONE_WAY && (first & second)) {
        return "rule: a kind is one-way to itself";
    }
    if (!td_finite((double)x + (double)y) || (x == 0.0f && y == 0.0f)) {
        return "rule: solid_side is zero or not finite";
    }
    if (!in_range(rule->friction, 0.0f, THUD_FRICTION_MAX) ||
        !in_range(rule->restitution, 0.0f, THUD_PAIR_RESTITUTION_MAX) ||
        !in_range(rule->surface_speed, -max_speed, max_speed) || !(rule->event_impulse >= 0.0f)) {
        return "rule: friction, restitution, surface_speed or event_impulse is out of range";
    }
    if (rule->restitution > 0.0f && !w->restitution_hooks) {
        return TD_NO_RESTITUTION("rule: ");
    }
    return NULL;
}

/* Writes a rule into the cells for each kind of `first` with each kind of `second`, and, reversed,
 * into those of the other order. The cell of a kind with itself has the rule as given. */
void td_rules_write(td_rules *rules, uint32_t first, uint32_t second, const td_rule *rule) {
    td_rule reversed = *rule;
    reversed.reversed = true;
    for (uint32_t f = first; f; f &= f - 1) {
        for (uint32_t s = second; s; s &= s - 1) {
            int a = __builtin_ctz(f), b = __builtin_ctz(s);
            rules->table[b][a] = reversed;
            rules->table[a][b] = *rule;
        }
    }
}

/* Recomputes what the stages check first: whether any rule is one-way, the lowest event_impulse,
 * and whether any rule has one. */
void td_rules_look_through(thud_world *w) {
    w->rules->one_way = false;
    w->rules->min_bound = __builtin_inff();
    for (int a = 0; a < TD_RULE_KINDS; a++) {
        for (int b = a; b < TD_RULE_KINDS; b++) {
            const td_rule *rule = &w->rules->table[a][b];
            if (rule->is_set) {
                w->rules->one_way |= rule->rule.kind == THUD_RULE_ONE_WAY;
                w->rules->min_bound = td_min_float(w->rules->min_bound, rule->rule.event_impulse);
            }
        }
    }
    w->adds_impulses = w->rules->min_bound < __builtin_inff();
}
