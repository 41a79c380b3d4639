/* thud_rollback.h: networked play without waiting: a peer plays each step at once by the inputs
 * that it knows, takes the others to hold what they held last, and plays again what that was wrong
 * in. Inputs alone are sent; what arrives after up to `depth` steps is in time. Included by whoever
 * uses it; a program that uses it links what thud_snapshot.h says.
 *
 *     thud_rollback_options options = {.step = play, .state = &game, .state_bytes = sizeof game};
 *     thud_rollback_create(world, &options, &rollback);
 *     ... each step: one's own input, and those of the others as they arrive, with their step
 *     thud_rollback_input(rollback, me, thud_rollback_get(rollback).steps, held);
 *     thud_rollback_advance(rollback, NULL);
 *
 * All calls return THUD_ERROR_NULL for a null pointer where none is allowed, and THUD_ERROR_LOCKED
 * inside a callback of the world and inside `step`; the world's log hears why. When they fail,
 * nothing has changed, unless said otherwise. */
#ifndef THUD_ROLLBACK_H
#define THUD_ROLLBACK_H

#include "thud_ids.h"
#include "thud_limits.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of one world, which it steps, and whose allocator it uses: to be destroyed before the world. */
typedef struct thud_rollback thud_rollback;

/* Plays one step: does what each player's input says, and calls thud_world_step. From the same
 * world, state and inputs it does the same, on every peer; nothing else changes the world. What it
 * returns but THUD_OK ends the call that asked for it, see thud_rollback_advance. */
typedef thud_result thud_rollback_step_fn(thud_world *world, const uint64_t *inputs, void *state);

/* Zero is the default. */
typedef struct thud_rollback_options {
    int players; /* [0, THUD_ROLLBACK_PLAYERS_MAX]; default (0) 2 */
    int depth;   /* steps that an input may be late, [0, THUD_ROLLBACK_DEPTH_MAX]; default (0) 60 */
    uint64_t idle; /* what a player holds until something is known of it; buttons and sticks are the
                      caller's to pack */
    thud_rollback_step_fn *step; /* never null */
    void *state; /* what goes back with the world: score, movers, handles and all. The caller's,
                    for `step` to change, kept while the rollback lives; null: none */
    size_t state_bytes; /* 0 without a state */
} thud_rollback_options;

/* A snapshot of the world is kept for each of depth + 1 steps: that memory is taken here, and again
 * only where the world outgrows it. THUD_ERROR_INVALID, THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_rollback_create(thud_world *world,
                                                         const thud_rollback_options *options,
                                                         thud_rollback **out);
/* Null is fine; so is the world's future. Where it may not be called the log hears
 * THUD_ERROR_LOCKED, and it lives on. */
THUD_API void thud_rollback_destroy(thud_rollback *rollback);

/* What a player, in [0, players), held in a step, from 0 on: in any order, late, early, or once
 * more. THUD_ERROR_INVALID for a step that is more than `depth` ahead, and for another input than
 * was told of that step before. */
THUD_API thud_result thud_rollback_input(thud_rollback *rollback, int player, int64_t step,
                                         uint64_t input);

/* Plays again what was wrong, and then the next step. *made (may be null) is false, and the next
 * step is not made, while an input of `depth` steps ago is not known: then wait for the others.
 * Where `step` fails, or memory (THUD_ERROR_MEMORY), that is the result: the step is not made,
 * world and state are at its beginning, or still at a later one's, and the next call begins there
 * again. */
THUD_API thud_result thud_rollback_advance(thud_rollback *rollback, bool *made);
/* Plays again what was wrong, and no more: world and state are then the best that is known. Fails
 * as thud_rollback_advance. */
THUD_API thud_result thud_rollback_settle(thud_rollback *rollback);

typedef struct thud_rollback_progress {
    int64_t steps;     /* made: the number of the next */
    int64_t confirmed; /* before this step every input is known: nothing there is played again */
    int64_t replayed;  /* steps that were played again, in all */
} thud_rollback_progress;

/* All 0 for null. */
THUD_API thud_rollback_progress thud_rollback_get(const thud_rollback *rollback);

/* How it was before a step of the last `depth`, or is before the next one: the world's hash, which
 * is the same on all peers up to `confirmed`, or else `step` does not do the same everywhere; and a
 * copy of the state, of state_bytes. Either output may be null. Settles first, and fails as
 * thud_rollback_settle; THUD_ERROR_INVALID for a step that is not kept. */
THUD_API thud_result thud_rollback_at(thud_rollback *rollback, int64_t step, uint64_t *hash,
                                      void *state);

#ifdef __cplusplus
}
#endif

#endif
