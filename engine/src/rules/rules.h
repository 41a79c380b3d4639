/* rules.h: the rules of a world; see thud_rules.h. */
#ifndef TD_RULES_H
#define TD_RULES_H

#include "rules/rule_hooks.h"

enum { TD_RULE_NONE = TD_RULE_KINDS, TD_RULE_CELLS = TD_RULE_KINDS * TD_RULE_KINDS };

/* td_lane_marks.rule: which it is in the table, if a step has to look at it, and for what. */
enum { TD_RULE_ONE_WAY = 1 << 15, TD_RULE_IMPULSE = 1 << 14 };

/* Of the kinds of a row and a column. */
typedef struct td_rule {
    thud_rule rule;
    bool is_set;
    bool reversed; /* solid_side is of the column's shape */
} td_rule;

typedef struct td_rules {
    td_rule table[TD_RULE_KINDS][TD_RULE_KINDS];
    thud_filter_fn *filter; /* null: none */
    void *filter_context;
    bool one_way;        /* a rule is */
    float least_impulse; /* most_impulse of the rule that allows the least */
    td_array impulses;   /* thud_impulse_event */
} td_rules;

/* The kind of a shape, or TD_RULE_NONE. */
static inline int td_rule_kind_of(const thud_world *w, int shape) {
    uint32_t category = td_shape_at(w, shape)->filter.category;
    return category ? __builtin_ctz(category) : TD_RULE_NONE;
}

/* Of two shapes, a row's first; null where they have none. */
static inline const td_rule *td_rule_of_pair(const thud_world *w, int shape_a, int shape_b) {
    int a = td_rule_kind_of(w, shape_a), b = td_rule_kind_of(w, shape_b);
    const td_rule *rule = a < TD_RULE_KINDS && b < TD_RULE_KINDS ? &w->rules->table[a][b] : NULL;
    return rule && rule->is_set ? rule : NULL;
}

static inline td_rule *td_rule_at(const thud_world *w, int cell) {
    return &w->rules->table[cell / TD_RULE_KINDS][cell % TD_RULE_KINDS];
}

/* The rule of a lane, if there is one that is looked at for this. */
static inline const td_rule *td_rule_of_lane(const thud_world *w, const td_block *block, int lane,
                                             int watched) {
    int mark = block->mark[lane].rule;
    return mark & watched ? td_rule_at(w, mark % TD_RULE_CELLS) : NULL;
}

static inline bool td_rule_counts_impulses(const td_rule *rule) {
    return rule->rule.most_impulse < __builtin_inff();
}

/* table.c */
/* Why it is none, of kinds as in thud_world_set_rule, or null. */
const char *td_rule_error(const thud_world *w, uint32_t first, uint32_t second,
                          const thud_rule *rule);
void td_rules_write(td_rules *rules, uint32_t first, uint32_t second, const td_rule *rule);
/* Notes what steps have to look at, after the table has changed. */
void td_rules_look_through(thud_world *w);
/* kept.c */
td_ruled td_rules_ruled(const thud_world *w);
void td_rules_keep(const thud_world *w, char *to);
bool td_rules_kept(const thud_world *w, td_ruled ruled, const char *from);
bool td_rules_make_room(thud_world *w, td_ruled ruled);
void td_rules_bring_back(thud_world *w, td_ruled ruled, const char *from);
/* one_way.c */
bool td_rules_hide(const thud_world *w, int shape, int other);
bool td_rules_let_through(const thud_world *w, const thud_contact *seen);
void td_rules_decide(thud_world *w);
/* impulses.c */
bool td_rules_reserve(thud_world *w);
void td_rules_tell(thud_world *w);

#endif
