/* rule_hooks.h: the functions by which the stages of a step ask for the decisions of collision
 * rules (thud_rules.h). A world gets this table with its first rule or filter, so that a program
 * without rules does not link it. */
#ifndef TD_RULE_HOOKS_H
#define TD_RULE_HOOKS_H

#include "state/world.h"

#include "thud/thud_rules.h"

/* Numbers of rules and events in a snapshot: kept.c. */
typedef struct td_ruled {
    int32_t rules;    /* number of rules (td_kept_rule) */
    int32_t impulses; /* number of impulse events of the last step (thud_impulse_event) */
} td_ruled;

/* A rule in a snapshot. */
typedef struct td_kept_rule {
    thud_rule rule;
    int32_t cell; /* index in td_rules.table: row * TD_RULE_KINDS + column */
} td_kept_rule;

/* Kinds of shapes: one for each bit of thud_filter.category; and the maximum number of rules: one
 * for each pair of kinds, including pairs of equal kinds. */
enum { TD_RULE_KINDS = 32, TD_RULES_MAX = TD_RULE_KINDS * (TD_RULE_KINDS + 1) / 2 };

/* The number of bytes of rules and events in a snapshot. */
static inline uint64_t td_ruled_bytes(td_ruled ruled) {
    return (uint64_t)ruled.rules * sizeof(td_kept_rule) +
           (uint64_t)ruled.impulses * sizeof(thud_impulse_event);
}

typedef struct td_rule_hooks {
    /* Whether two shapes that pass each other's filters may have a contact. */
    bool (*allows)(const thud_world *w, int shape_a, int shape_b);
    /* Replaces the settings for which the rule of two shapes has a value. Returns the bits for
     * td_lane_marks.rule of their lane (rules.h). */
    uint16_t (*settle)(const thud_world *w, int shape_a, int shape_b,
                       thud_contact_settings *settings);
    /* Whether `shape`, which is static or belongs to the same moving body as its neighbours, can
     * cover their faces against `other`, for internal edges. False if the two have a one-way rule
     * and no contact that is TD_HELD. */
    bool (*hides)(const thud_world *w, int shape, int other);
    /* Whether a one-way rule lets the two shapes of an impact within the step pass. */
    bool (*lets_through)(const thud_world *w, const thud_contact *seen);
    /* Decides which one-way contacts act in this step; removes the points of the others. Also drops
     * the impulse events of the last step. */
    void (*decide)(thud_world *w);
    /* Reserves memory for impulse events. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Adds events of the contacts whose impulse exceeds event_impulse of their rule. */
    void (*tell)(thud_world *w);
    /* For snapshots, in this order: counts rules and events; writes them, td_ruled_bytes bytes;
     * checks whether such bytes hold valid rules; reserves memory to read them, false when memory
     * is short; replaces the rules by them. */
    td_ruled (*ruled)(const thud_world *w);
    void (*write)(const thud_world *w, char *to);
    bool (*valid)(const thud_world *w, td_ruled ruled, const char *from);
    bool (*make_room)(thud_world *w, td_ruled ruled);
    void (*read)(thud_world *w, td_ruled ruled, const char *from);
    void (*end)(thud_world *w); /* frees the rules, as the world is destroyed */
} td_rule_hooks;

#endif
