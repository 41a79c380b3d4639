/* thud_listeners.h: callbacks for contacts: the prologue before a contact is solved (pre-solve) and
 * the epilogue after it (post-solve), either for one contact a call or once a step for all. A
 * program without listeners does not link them. For fixed behaviour of kinds of shapes the rules of
 * thud_rules.h need no calls. */
#ifndef THUD_LISTENERS_H
#define THUD_LISTENERS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Called once a step for every pair of shapes that touches or is about to touch, before it is
 * solved. Where detection finds a further collision within the step, it is called before each time
 * that the collision is resolved (thud_detection_continuous calls it for static shapes in the order
 * in which a body meets them, up to the one that stops the body, and uses only the return value).
 * It is not called for pairs that a rule lets pass. Each segment of a terrain makes a pair of its
 * own. Returns whether the pair collides; false: the pair has no effect in this step. */
typedef bool thud_prologue_fn(thud_world *world, const thud_contact *contact,
                              thud_contact_settings *settings, void *context);
/* Called after the motion of the step for every touching pair that was solved, and for every
 * collision that was resolved within the step. */
typedef void thud_epilogue_fn(thud_world *world, const thud_contact *contact, void *context);

/* What a prologue decides about a pair. */
typedef struct thud_contact_answer {
    thud_contact_settings settings; /* its surface in this step */
    bool collide;                   /* false: the pair has no effect in this step */
} thud_contact_answer;

/* The same for all pairs of a step in one call, for languages in which a call is slow. `answers`
 * has an element for each contact, with the values that follow from its shapes, for the callback to
 * change. Collisions that detection finds within the step come one by one, with a count of 1. */
typedef void thud_prologue_all_fn(thud_world *world, const thud_contact *contacts,
                                  thud_contact_answer *answers, int count, void *context);
typedef void thud_epilogue_all_fn(thud_world *world, const thud_contact *contacts, int count,
                                  void *context);

/* Fields of thud_contact that take the longest to compute, and that a listener can do without.
 * Where all contacts of a heap have a prologue and an epilogue with all fields, a step takes 1.0
 * times as long as without. */
typedef enum thud_contact_part {
    THUD_CONTACT_BODIES = 1, /* body_a and body_b */
    THUD_CONTACT_POINT = 2   /* point */
} thud_contact_part;

/* The callbacks of a world. Null: none. Prologue and epilogue each may have one of their two forms.
 */
typedef struct thud_listeners {
    thud_prologue_fn *prologue;
    thud_epilogue_fn *epilogue;
    thud_prologue_all_fn *prologue_all;
    thud_epilogue_all_fn *epilogue_all;
    void *context; /* handed to all */
    /* A sum of thud_contact_part: fields that these listeners never read. They are not computed
     * then, and may be zero. Default 0: all fields are set. */
    uint32_t without;
} thud_listeners;

/* Replaces the listeners of the world from the next step on; null: none. Where there is or was a
 * prologue, all bodies wake. A snapshot contains what the prologue decided about touching pairs: a
 * world without a prologue that is restored from it keeps these decisions until the pairs part. The
 * world is locked during the callbacks: edits wait for the next step, or are refused.
 * THUD_ERROR_NULL for a null world, THUD_ERROR_INVALID for both forms of a prologue or epilogue or
 * an unknown part, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback: then nothing has
 * changed. */
THUD_API thud_result thud_world_set_listeners(thud_world *world, const thud_listeners *listeners);

#ifdef __cplusplus
}
#endif

#endif
