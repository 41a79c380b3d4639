/* thud_rules.h: collision rules: a table of how shapes of two kinds interact (ignore each other,
 * one-way, friction and so on), a filter function, and events of contacts with a large impulse.
 * Rules replace most prologues (pre-solve callbacks), without a call for each contact in each step.
 * A program that does not use this header does not link it.
 *
 * The kind of a shape is the lowest bit of its filter's category; a shape with category zero has no
 * kind, and no rule. A snapshot contains the rules, and the impulse events of the last step: a
 * restored world has exactly the rules of the snapshot. The filter function is not in a snapshot; a
 * restored world keeps its own. Queries and movers have their own filters (for one-way platforms a
 * mover has thud_mover_passes_one_way), and do not use rules. */
#ifndef THUD_RULES_H
#define THUD_RULES_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How shapes of two kinds interact. */
typedef enum thud_rule_kind {
    THUD_RULE_COLLIDE = 0, /* they collide */
    THUD_RULE_IGNORE,      /* they never form a pair, as if their filters excluded it; this includes
                              sensors */
    THUD_RULE_ONE_WAY /* they collide on one side only, as a platform that is jumped through from
                       * below
                       */
} thud_rule_kind;

/* The number of enumerators. It is not an enumerator itself, so that a switch need not name it. */
enum { THUD_RULE_KIND_COUNT = THUD_RULE_ONE_WAY + 1 };

/* The rule of two kinds. If friction, restitution or surface_speed is NaN, the default, the pair
 * has the value of its two shapes (thud_shape_def). A prologue is called after the rules, but not
 * for pairs that a rule lets pass. */
typedef struct thud_rule {
    thud_rule_kind kind; /* how the shapes interact; default THUD_RULE_COLLIDE */
    /* THUD_RULE_ONE_WAY: the side of the first kind's shape on which the second collides with it,
     * as a direction in the frame of the first's body, of any length but 0. Default (0, 1): the
     * top. A shape that comes from this side collides until the two separate. A shape that comes
     * from another side, or starts inside, passes until the two separate or it has come out on this
     * side. */
    thud_vec2 solid_side;
    float friction;      /* coefficient, [0, THUD_FRICTION_MAX]; default NaN */
    float restitution;   /* [0, THUD_PAIR_RESTITUTION_MAX]; default NaN */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX length scales a second; default
                            NaN. Replaces the sum of both shapes' surface speeds: the speed at which
                            one surface moves over the other, clockwise about either shape, as in
                            thud_shape_def */
    /* mass * length / s, >= 0: a contact whose normal impulse in a step is larger than this makes
     * an event, see thud_world_get_impulse_events. Default infinite: no events. */
    float event_impulse;
} thud_rule;

/* A rule without effect: shapes collide with the values of their defs, and without impulse
 * events. */
THUD_API thud_rule thud_default_rule(void);

/* Sets the rule between each kind of `first` and each of `second`: category bits, at least one
 * each. It replaces the rules that these pairs of kinds had, in either order. `rule` null removes
 * them. It takes effect with the next step, also for pairs that touch now, and wakes the bodies
 * with shapes of these kinds.
 *
 * THUD_ERROR_NULL for a null world, THUD_ERROR_INVALID without a bit, for a value out of range, or
 * for a one-way rule of a kind with itself, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback:
 * then nothing has changed. */
THUD_API thud_result thud_world_set_rule(thud_world *world, uint32_t first, uint32_t second,
                                         const thud_rule *rule);
/* Gets the rule of two kinds, one bit each: *out is the rule, or the default; *out_is_set: whether
 * there is one; *out_reversed: whether it was set with `second` as the first kind. Each output may
 * be null. THUD_ERROR_NULL for a null world, THUD_ERROR_INVALID unless each kind is exactly one
 * bit. */
THUD_API thud_result thud_world_get_rule(const thud_world *world, uint32_t first, uint32_t second,
                                         thud_rule *out, bool *out_is_set, bool *out_reversed);

/* Prepares a world that never had a rule or filter for thud_world_restore from a snapshot with
 * rules, which it would refuse otherwise. THUD_ERROR_NULL, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED
 * inside a callback. */
THUD_API thud_result thud_world_use_rules(thud_world *world);

/* Returns whether two shapes may form a pair; false has the same effect as filters that exclude it.
 * It is called when the bounds of two shapes begin to overlap, for some pairs more than once,
 * between steps or within a step. It must return the same value for a pair as long as nothing on
 * which it depends changes. Setting it again calls it again for all pairs. The world is locked
 * meanwhile. The order of the two shapes is not specified. */
typedef bool thud_filter_fn(const thud_world *world, thud_shape_id shape_a, thud_shape_id shape_b,
                            void *context);

/* Sets the filter function; null: none. It is called only for pairs that the filters of shapes and
 * the rules allow. Errors as in thud_world_set_rule. */
THUD_API thud_result thud_world_set_filter(thud_world *world, thud_filter_fn *filter,
                                           void *context);

/* A contact whose normal impulse was larger than its rule's event_impulse. Each segment of a
 * terrain is a separate contact, and so is each collision that detection resolves within the
 * step. */
typedef struct thud_impulse_event {
    thud_shape_id shape_a, shape_b;
    thud_pos point;   /* in the world */
    thud_vec2 normal; /* unit, from a to b */
    float impulse;    /* along the normal, the sum over the step, mass * length / s */
} thud_impulse_event;

/* The impulse events of the last step, or of all steps of the last thud_world_advance; valid until
 * the next of these calls. *out_count is their number. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_impulse_events(const thud_world *world,
                                                   const thud_impulse_event **out, int *out_count);

/* The same array, and its size in *out_count; null and 0 for a null world. */
static inline const thud_impulse_event *thud_impulse_events_of(const thud_world *world,
                                                               int *out_count) {
    const thud_impulse_event *events = NULL;
    int count = 0;
    thud_world_get_impulse_events(world, &events, &count);
    if (out_count) {
        *out_count = count;
    }
    return events;
}

#ifdef __cplusplus
}
#endif

#endif
