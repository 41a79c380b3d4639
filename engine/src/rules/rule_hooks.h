/* rule_hooks.h: what a world's rules decide, as its stages ask. A world has them from its first
 * rule or filter on, so that a program without does not link them. */
#ifndef TD_RULE_HOOKS_H
#define TD_RULE_HOOKS_H

#include "state/world.h"

#include "thud/thud_rules.h"

/* How much of rules a snapshot has; see kept.c. */
typedef struct td_ruled {
    int32_t rules;    /* that are set */
    int32_t impulses; /* thud_impulse_event, of the last step */
} td_ruled;

/* A rule as it lies in a snapshot. */
typedef struct td_kept_rule {
    thud_rule rule;
    int32_t cell; /* of the table, row by row */
} td_kept_rule;

enum { TD_RULE_KINDS = 32, TD_RULES_MOST = TD_RULE_KINDS * (TD_RULE_KINDS + 1) / 2 };

/* The rules, then the impulses. */
static inline uint64_t td_ruled_bytes(td_ruled ruled) {
    return (uint64_t)ruled.rules * sizeof(td_kept_rule) +
           (uint64_t)ruled.impulses * sizeof(thud_impulse_event);
}

typedef struct td_rule_hooks {
    /* Whether two shapes, whose filters let them, may make a pair. */
    bool (*allows)(const thud_world *w, int shape_a, int shape_b);
    /* What the rule of two shapes makes of their settings. Returns what a lane of theirs keeps as
     * td_lane_marks.rule. */
    uint16_t (*settle)(const thud_world *w, int shape_a, int shape_b,
                       thud_contact_settings *settings);
    /* Whether a static shape, or one of the other's neighbours, hides what is behind it from
     * another that it may only hold from one side. */
    bool (*hides)(const thud_world *w, int shape, int other);
    /* Whether two that meet on the way pass through each other. */
    bool (*lets_through)(const thud_world *w, const thud_contact *seen);
    /* Which one-way pairs hold in this step; the others do nothing. */
    void (*decide)(thud_world *w);
    /* Room for events. False when memory is short. */
    bool (*reserve)(thud_world *w);
    /* Events of what has borne too much. */
    void (*tell)(thud_world *w);
    /* For snapshots: what there is; its bytes, td_ruled_bytes of it; whether such bytes hold rules;
     * room for as many, false when memory is short; and the rules in place of those that are. */
    td_ruled (*ruled)(const thud_world *w);
    void (*write)(const thud_world *w, char *to);
    bool (*valid)(const thud_world *w, td_ruled ruled, const char *from);
    bool (*make_room)(thud_world *w, td_ruled ruled);
    void (*read)(thud_world *w, td_ruled ruled, const char *from);
    void (*end)(thud_world *w); /* with the world */
} td_rule_hooks;

#endif
