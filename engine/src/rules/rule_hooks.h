/* rule_hooks.h: the decisions that collision rules make (thud_rules.h), as the stages of a step ask
 * for them. A world gets this table with its first rule or filter, so that a program without does
 * not link it. */
#ifndef TD_RULE_HOOKS_H
#define TD_RULE_HOOKS_H

#include "state/world.h"

#include "thud/thud_rules.h"

/* How much a snapshot has of rules: kept.c. */
typedef struct td_ruled {
    int32_t rules;    /* number of rules (td_kept_rule) */
    int32_t impulses; /* number of impulse events of the last step (thud_impulse_event) */
} td_ruled;

/* A rule in a snapshot. */
typedef struct td_kept_rule {
    thud_rule rule;
    int32_t cell; /* index in td_rules.table: row * TD_RULE_KINDS + column */
} td_kept_rule;

/* Kinds of shapes: one for each bit of thud_filter.category; and rules between each two of them, a
 * kind and itself included. */
enum { TD_RULE_KINDS = 32, TD_RULES_MAX = TD_RULE_KINDS * (TD_RULE_KINDS + 1) / 2 };

/* The bytes of both in a snapshot. */
static inline uint64_t td_ruled_bytes(td_ruled ruled) {
    return (uint64_t)ruled.rules * sizeof(td_kept_rule) +
           (uint64_t)ruled.impulses * sizeof(thud_impulse_event);
}

typedef struct td_rule_hooks {
    /* Whether two shapes that pass each other's filters may have a contact. */
    bool (*allows)(const thud_world *w, int shape_a, int shape_b);
    /* Replaces the settings that the rule of two shapes has a value for. Returns the bits that a
     * lane of theirs keeps in td_lane_marks.rule (rules.h). */
    uint16_t (*settle)(const thud_world *w, int shape_a, int shape_b,
                       thud_contact_settings *settings);
    /* Whether static `shape` can cover the faces of its neighbours against `other`, for internal
     * edges. False where a one-way rule lets `other` pass through it at present. */
    bool (*hides)(const thud_world *w, int shape, int other);
    /* Whether a one-way rule lets the two shapes of an impact within the step pass. */
    bool (*lets_through)(const thud_world *w, const thud_contact *seen);
    /* Decides which one-way contacts hold in this step; removes the points of the others. */
    void (*decide)(thud_world *w);
    /* Makes room for impulse events. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Adds events of the contacts whose impulse exceeds the bound of their rule. */
    void (*tell)(thud_world *w);
    /* For snapshots: how much there is; writes it, td_ruled_bytes long; whether such bytes hold
     * valid rules; makes room to read them, false when memory is short; replaces the rules by them.
     */
    td_ruled (*ruled)(const thud_world *w);
    void (*write)(const thud_world *w, char *to);
    bool (*valid)(const thud_world *w, td_ruled ruled, const char *from);
    bool (*make_room)(thud_world *w, td_ruled ruled);
    void (*read)(thud_world *w, td_ruled ruled, const char *from);
    void (*end)(thud_world *w); /* frees the rules, as the world is destroyed */
} td_rule_hooks;

#endif
