/* thud_listeners.h: the prologue and the epilogue of contacts (pre-solve and post-solve), called
 * for one contact after the other or once a step for all. A program without listeners does not
 * link them; what most prologues are for, rules do without a call: thud_rules.h. */
#ifndef THUD_LISTENERS_H
#define THUD_LISTENERS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Called once a step for every pair that touches or is about to, before it is solved; and where
 * detection finds another one on the way, before each time that it is resolved there (`continuous`
 * asks about static shapes as the body meets them, up to the one that stops it, and heeds only the
 * answer). Not of pairs that a rule lets through. A terrain makes a pair of its own with each of
 * its segments. False: the pair does nothing. */
typedef bool thud_prologue_fn(thud_world *world, const thud_contact *contact,
                              thud_contact_settings *settings, void *context);
/* Called for every touching pair that was solved, after the step's motion; and for every impact
 * that was resolved within the step. */
typedef void thud_epilogue_fn(thud_world *world, const thud_contact *contact, void *context);

/* What a prologue answers: whether the pair does anything, and how its surfaces act. */
typedef struct thud_contact_answer {
    thud_contact_settings settings;
    bool collide;
} thud_contact_answer;

/* The same for all pairs of a step at once, for languages in which every call is dear: `answers`
 * has one for each contact, and begins with what the pairs have by themselves. What detection finds
 * on the way is asked about one by one, with a count of 1. */
typedef void thud_prologue_all_fn(thud_world *world, const thud_contact *contacts,
                                  thud_contact_answer *answers, int count, void *context);
typedef void thud_epilogue_all_fn(thud_world *world, const thud_contact *contacts, int count,
                                  void *context);

/* Parts of a contact that take longest to find, which a listener may do without. Where all contacts
 * of a heap have a prologue and an epilogue that get them all, a step takes 1.1 times as long as
 * without. */
typedef enum thud_contact_part {
    THUD_CONTACT_BODIES = 1, /* body_a and body_b */
    THUD_CONTACT_POINT = 2
} thud_contact_part;

/* Null: none. Of either, one form. */
typedef struct thud_listeners {
    thud_prologue_fn *prologue;
    thud_epilogue_fn *epilogue;
    thud_prologue_all_fn *prologue_all;
    thud_epilogue_all_fn *epilogue_all;
    void *context; /* handed to all */
    /* Of thud_contact_part, any together: what these listeners never look at. It takes no time
     * then, and may be zero. Default 0: they see all. */
    uint32_t without;
} thud_listeners;

/* In place of those that the world had, from the next step on. Null: none. Where there is or was a
 * prologue, all bodies wake. A snapshot has what a prologue wanted of the pairs that touched: a
 * world without one that is restored from it keeps to that until they part. The world is locked
 * while it calls them: edits wait for the next step, or are refused. THUD_ERROR_NULL without a
 * world, THUD_ERROR_INVALID for both forms of one or an unknown part, THUD_ERROR_MEMORY,
 * THUD_ERROR_LOCKED inside a callback: then nothing has changed. */
THUD_API thud_result thud_world_set_listeners(thud_world *world, const thud_listeners *listeners);

#ifdef __cplusplus
}
#endif

#endif
