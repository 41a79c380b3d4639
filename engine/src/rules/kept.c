/* kept.c: rules in snapshots. The bytes are first the rules that are set, in the order of their
 * index in the table, each pair of kinds once, and then the impulse events of the last step. The
 * caller's filter is a function and not part of a snapshot: a restore does not change it. */
#include "rules/rules.h"

#include <string.h>

/* Whether the cell of this rule goes into a snapshot. A rule is in two cells of the table, one for
 * each order of its kinds; only the cell with the caller's order is stored. */
static bool is_stored(const td_rule *rule) {
    return rule->is_set && !rule->reversed;
}

/* The number of rules and events to store. */
td_ruled td_rules_ruled(const thud_world *w) {
    td_ruled ruled = {.impulses = w->rules->impulses.count};
    for (int cell = 0; cell < TD_RULE_CELLS; cell++) {
        ruled.rules += is_stored(td_rule_at(w, cell));
    }
    return ruled;
}

/* Writes rules and events to `to`, which has td_ruled_bytes bytes. */
void td_rules_keep(const thud_world *w, char *to) {
    const td_array *impulses = &w->rules->impulses;
    for (int32_t cell = 0; cell < TD_RULE_CELLS; cell++) {
        const td_rule *rule = td_rule_at(w, cell);
        if (is_stored(rule)) {
            td_kept_rule kept = {rule->rule, cell};
            memcpy(to, &kept, sizeof kept);
            to += sizeof kept;
        }
    }
    if (impulses->count) {
        memcpy(to, impulses->data, (size_t)impulses->count * sizeof(thud_impulse_event));
    }
}

/* The i-th rule of the bytes, which need not be aligned. */
static td_kept_rule kept_at(const char *from, int i) {
    td_kept_rule kept;
    memcpy(&kept, from + (size_t)i * sizeof kept, sizeof kept);
    return kept;
}

/* The kinds of the rule's row and column, as bits. */
static uint32_t row_of(td_kept_rule kept) {
    return 1u << kept.cell / TD_RULE_KINDS;
}

static uint32_t column_of(td_kept_rule kept) {
    return 1u << kept.cell % TD_RULE_KINDS;
}

/* Whether the bytes hold valid rules, in the order of their cells. The bytes come from the caller,
 * and may be corrupt. */
bool td_rules_kept(const thud_world *w, td_ruled ruled, const char *from) {
    int last = -1;
    for (int i = 0; i < ruled.rules; i++) {
        td_kept_rule kept = kept_at(from, i);
        if (kept.cell <= last || kept.cell >= TD_RULE_CELLS ||
            td_rule_error(w, row_of(kept), column_of(kept), &kept.rule)) {
            return false;
        }
        last = kept.cell;
    }
    return true;
}

bool td_rules_make_room(thud_world *w, td_ruled ruled) {
    return td_array_reserve(&w->memory, &w->rules->impulses, ruled.impulses);
}

/* Replaces the world's rules and events by those of the bytes, which are valid. */
void td_rules_bring_back(thud_world *w, td_ruled ruled, const char *from) {
    memset(w->rules->table, 0, sizeof w->rules->table);
    for (int i = 0; i < ruled.rules; i++) {
        td_kept_rule kept = kept_at(from, i);
        td_rule rule = {.rule = kept.rule, .is_set = true};
        td_rules_write(w->rules, row_of(kept), column_of(kept), &rule);
    }
    td_rules_look_through(w);
    w->rules->impulses.count = ruled.impulses;
    if (ruled.impulses) {
        memcpy(w->rules->impulses.data, from + (size_t)ruled.rules * sizeof(td_kept_rule),
               (size_t)ruled.impulses * sizeof(thud_impulse_event));
    }
}
