/* thud_rules.h: what two kinds of shapes are to each other, as a table that the world keeps; a
 * filter of the caller's own; and events of contacts that bear too much. They do what most
 * prologues are for, without being called for each contact in each step. A program that uses none
 * of it does not link it.
 *
 * The kind of a shape is the lowest bit of its filter's category; a shape whose category is zero
 * has none, and no rule. A snapshot has the rules and the events of the last step: a world that is
 * restored goes by the rules of then, and by none where there were none. The caller's filter is a
 * function, and no part of it: it stays as that world has it. Queries and movers have filters of
 * their own (thud_mover has thud_mover_passes_one_way), and heed no rules. */
#ifndef THUD_RULES_H
#define THUD_RULES_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum thud_meeting {
    THUD_COLLIDE = 0,
    THUD_IGNORE, /* the two never make a pair, as if their filters kept them apart; sensors too */
    THUD_ONE_WAY /* held on one side only, as a plank is that is jumped through from below */
} thud_meeting;

/* How many there are; no enumerator, so that a switch need not name it. */
enum { THUD_MEETING_COUNT = THUD_ONE_WAY + 1 };

/* Where a value is not-a-number, as by default, the pair has what its two shapes make of it; else
 * the rule's. A prologue is asked after the rules, and not of pairs that these let through. */
typedef struct thud_rule {
    thud_meeting meeting;
    /* ONE_WAY: the side of the first kind's shape on which it holds the second, as a direction in
     * the frame of its body; its length is nothing, but not zero. Default (0, 1): the top. What
     * comes from there is held until the two part; what comes from elsewhere, or begins inside,
     * passes until they part or it has come out there. */
    thud_vec2 solid_side;
    float friction;      /* [0, THUD_FRICTION_MAX] */
    float restitution;   /* [0, THUD_BOUNCE_MAX] */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX length scales a second; of
                            either surface, clockwise, as that of thud_shape_def */
    /* Mass * length / s, >= 0: a contact that gives more than this along its normal in a step makes
     * an event, see thud_world_impulses. Default infinite: none does. */
    float most_impulse;
} thud_rule;

/* Shapes collide, with the surfaces that they have, and no events. */
THUD_API thud_rule thud_default_rule(void);

/* The rule between the kinds of `first` and those of `second`, which are bits as in
 * thud_filter.category, at least one each; in place of those that were there, whichever of the two
 * kinds came first then. Null: none. It holds from the next step on, also for what touches now,
 * and wakes the shapes of these kinds.
 *
 * THUD_ERROR_NULL without a world, THUD_ERROR_INVALID without a bit, for a value out of range, or
 * for a one-way rule of a kind with itself, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback:
 * then nothing has changed. */
THUD_API thud_result thud_world_set_rule(thud_world *world, uint32_t first, uint32_t second,
                                         const thud_rule *rule);
/* Of two kinds, one bit each: *out is their rule, or the default, *is_set whether there is one, and
 * *reversed whether it was set with `second` first. Each of the three may be null. */
THUD_API thud_result thud_world_rule(const thud_world *world, uint32_t first, uint32_t second,
                                     thud_rule *out, bool *is_set, bool *reversed);

/* A world that never had a rule or a filter refuses to be restored from a snapshot that has rules:
 * this makes it ready, as setting one does. THUD_ERROR_NULL, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED
 * inside a callback. */
THUD_API thud_result thud_world_use_rules(thud_world *world);

/* False: the two never make a pair, as if their filters kept them apart. It is asked where bounds
 * come to overlap, and more than once of some; while nothing else changes it must answer the same.
 * To have all pairs asked anew, set it again. The world is locked meanwhile, and what it is given
 * is as of between two steps or of within one. Which of the two comes first is not said. */
typedef bool thud_filter_fn(const thud_world *world, thud_shape_id shape_a, thud_shape_id shape_b,
                            void *context);

/* Null: none. In addition to the filters of shapes and the rules, and asked only where these let
 * two meet. Errors as of thud_world_set_rule. */
THUD_API thud_result thud_world_set_filter(thud_world *world, thud_filter_fn *filter,
                                           void *context);

/* A contact that gave more than its rule's most_impulse. A terrain has a contact a segment; and a
 * collision that detection resolves within the step is one of its own. */
typedef struct thud_impulse_event {
    thud_shape_id shape_a, shape_b;
    thud_pos point;
    thud_vec2 normal; /* from a to b */
    float impulse;    /* along it, the sum over the step: mass * length / s */
} thud_impulse_event;

/* Those of the last step, or of all steps of the last thud_world_advance; valid as events are.
 * *count may be null. */
THUD_API const thud_impulse_event *thud_world_impulses(const thud_world *world, int *count);

#ifdef __cplusplus
}
#endif

#endif
