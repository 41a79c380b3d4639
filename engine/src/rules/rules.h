/* rules.h: the collision rules of a world: a table of rules by two kinds of shapes (thud_rules.h).
 * The kind of a shape is the number of the lowest bit of its filter's category. */
#ifndef TD_RULES_H
#define TD_RULES_H

#include "rules/rule_hooks.h"

enum { TD_RULE_NONE = TD_RULE_KINDS, TD_RULE_CELLS = TD_RULE_KINDS * TD_RULE_KINDS };

/* Bits of td_lane_marks.rule of a contact whose rule acts within a step: it is one-way, or has an
 * event_impulse. The lower 10 bits are then the rule's index in the table; the bits between are
 * TD_LANE_ALTERED and TD_LANE_REFUSED (block.h). */
enum { TD_RULE_ONE_WAY = 1 << 15, TD_RULE_IMPULSE = 1 << 14 };

/* A cell of the table, for the kinds of its row and its column. */
typedef struct td_rule {
    thud_rule rule;
    bool is_set;
    bool reversed; /* solid_side belongs to the column's shape: the caller gave the kinds in the
                      other order */
} td_rule;

typedef struct td_rules {
    td_rule table[TD_RULE_KINDS][TD_RULE_KINDS]; /* by row and column; both orders are filled */
    thud_filter_fn *filter;                      /* the caller's filter; null: none */
    void *filter_context;
    bool one_way;      /* there is a one-way rule */
    float min_bound;   /* lowest event_impulse of all rules, infinite if none has one; valid only
                          while thud_world.adds_impulses is true */
    td_array impulses; /* thud_impulse_event, of the last step */
} td_rules;

/* The kind of a shape; TD_RULE_NONE for a category of 0. */
static inline int td_rule_kind_of(const thud_world *w, int shape) {
    uint32_t category = td_shape_at(w, shape)->filter.category;
    return category ? __builtin_ctz(category) : TD_RULE_NONE;
}

/* The rule of two shapes; a's kind is the row. Null: none is set. */
static inline const td_rule *td_rule_of_pair(const thud_world *w, int shape_a, int shape_b) {
    int a = td_rule_kind_of(w, shape_a), b = td_rule_kind_of(w, shape_b);
    const td_rule *rule = a < TD_RULE_KINDS && b < TD_RULE_KINDS ? &w->rules->table[a][b] : NULL;
    return rule && rule->is_set ? rule : NULL;
}

/* The rule at an index of the table, row by row. */
static inline td_rule *td_rule_at(const thud_world *w, int cell) {
    return &w->rules->table[cell / TD_RULE_KINDS][cell % TD_RULE_KINDS];
}

/* The rule of a lane if its marks have the bit `watched` (TD_RULE_ONE_WAY or TD_RULE_IMPULSE); else
 * null. */
static inline const td_rule *td_rule_of_lane(const thud_world *w, const td_block *block, int lane,
                                             int watched) {
    int mark = block->mark[lane].rule;
    return mark & watched ? td_rule_at(w, mark % TD_RULE_CELLS) : NULL;
}

/* Whether the rule has an event_impulse. */
static inline bool td_rule_counts_impulses(const td_rule *rule) {
    return rule->rule.event_impulse < __builtin_inff();
}

/* table.c */
/* The reason why a rule between these kinds (bits) is refused; null: it is valid. */
const char *td_rule_error(const thud_world *w, uint32_t first, uint32_t second,
                          const thud_rule *rule);
/* Sets the cells for each kind of `first` with each kind of `second`, in both orders. */
void td_rules_write(td_rules *rules, uint32_t first, uint32_t second, const td_rule *rule);
/* Recomputes one_way, min_bound and thud_world.adds_impulses after the table has changed. */
void td_rules_look_through(thud_world *w);
/* kept.c: for snapshots; td_rule_hooks says what each does. */
td_ruled td_rules_ruled(const thud_world *w);
void td_rules_keep(const thud_world *w, char *to);
bool td_rules_kept(const thud_world *w, td_ruled ruled, const char *from);
bool td_rules_make_room(thud_world *w, td_ruled ruled);
void td_rules_bring_back(thud_world *w, td_ruled ruled, const char *from);
/* one_way.c: functions of td_rule_hooks. */
bool td_rules_hide(const thud_world *w, int shape, int other);
bool td_rules_let_through(const thud_world *w, const thud_contact *seen);
void td_rules_decide(thud_world *w);
/* impulses.c: functions of td_rule_hooks. */
bool td_rules_reserve(thud_world *w);
void td_rules_tell(thud_world *w);

#endif
