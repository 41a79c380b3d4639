/* thud_rollback.h: rollback for networked games: each peer runs every step without waiting, with
 * the inputs that it knows; for players whose input has not arrived it assumes their last known
 * one. When an input arrives that differs from this prediction, the peer restores a snapshot and
 * runs the steps since then again. Only inputs are sent; an input may arrive up to `depth` steps
 * late. thud.h does not include this header; a program that uses it links what thud_snapshot.h
 * names.
 *
 *     thud_rollback_options options = {.step = play, .state = &game, .state_bytes = sizeof game};
 *     thud_rollback_create(world, &options, &rollback);
 *     ... each step: the own input, and those of other players as they arrive, with their step
 *     thud_rollback_input(rollback, me, thud_progress_of(rollback).steps, held);
 *     thud_rollback_advance(rollback, NULL);
 *
 * All calls return THUD_ERROR_NULL for a null pointer where none is allowed, and THUD_ERROR_LOCKED
 * inside a callback of the world and inside `step`; the reason is in the world's log. When a call
 * fails nothing has changed, unless its comment says otherwise. */
#ifndef THUD_ROLLBACK_H
#define THUD_ROLLBACK_H

#include "thud_ids.h"
#include "thud_limits.h"
#include "thud_math.h"

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The rollback of one world. It steps the world and uses its allocator; destroy it before the
 * world. */
typedef struct thud_rollback thud_rollback;

/* Runs one step of the game: applies the input of each player (inputs[player]), and calls
 * thud_world_step. It must be deterministic: from the same world, state and inputs it must do the
 * same on every peer, and nothing else may change the world. A result other than THUD_OK ends the
 * call that runs the step, see thud_rollback_advance. */
typedef thud_result thud_rollback_step_fn(thud_world *world, const uint64_t *inputs, void *state);

/* All zero selects the defaults; `step` must be set. */
typedef struct thud_rollback_options {
    int players;   /* [0, THUD_ROLLBACK_PLAYERS_MAX]; default (0) 2 */
    int depth;     /* maximum number of steps by which an input may be late, [0,
                      THUD_ROLLBACK_DEPTH_MAX]; default (0) 60 */
    int budget;    /* maximum number of steps that thud_rollback_advance runs again in one call, [0,
                      THUD_ROLLBACK_DEPTH_MAX]; 0: no limit */
    uint64_t idle; /* input of a player before the first known one; the caller packs buttons and
                      sticks into the 64 bits of an input */
    thud_rollback_step_fn *step; /* not null */
    void *state; /* the caller's data that is restored with the world: score, movers, handles.
                    `step` may change it; it must exist as long as the rollback. Null: none */
    size_t state_bytes; /* its size; 0 without a state */
} thud_rollback_options;

/* Creates a rollback, which keeps a snapshot of the world for each of depth + 1 steps. It allocates
 * their memory here, and more only if the world outgrows it. THUD_ERROR_INVALID,
 * THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_rollback_create(thud_world *world,
                                                         const thud_rollback_options *options,
                                                         thud_rollback **out);
/* Destroys a rollback; the world stays usable. Null does nothing. Inside a callback or `step` the
 * call does nothing either, and the log is told THUD_ERROR_LOCKED. */
THUD_API void thud_rollback_destroy(thud_rollback *rollback);

/* Sets the input of a player, in [0, players), in a step, >= 0. Inputs may come in any order, late,
 * early, or more than once. THUD_ERROR_INVALID for a step that is more than `depth` ahead, and for
 * an input that differs from the one set before for that step. */
THUD_API thud_result thud_rollback_input(thud_rollback *rollback, int player, int64_t step,
                                         uint64_t input);

/* Repeats the steps with a wrong prediction, and then runs the next step. If more than `budget`
 * steps have to be repeated, the call repeats only that many: the world is then before the step
 * `progress.settled`, the next step is not run, *out_made is false, and the next call continues.
 * While an input of `depth` steps ago is not known, the next step is not run and *out_made (may be
 * null) is false: wait for the other peers. If `step` fails, or memory is short
 * (THUD_ERROR_MEMORY), the call returns that error. World and state are then at the beginning of
 * the step that failed, or still at the beginning of a later one, and the next call starts from
 * there. */
THUD_API thud_result thud_rollback_advance(thud_rollback *rollback, bool *out_made);
/* Repeats all steps with a wrong prediction, and runs no further step: world and state then follow
 * from all known inputs. Errors as for thud_rollback_advance. */
THUD_API thud_result thud_rollback_settle(thud_rollback *rollback);

/* Where a rollback stands. */
typedef struct thud_rollback_progress {
    int64_t steps;     /* steps run: the number of the next step */
    int64_t confirmed; /* all inputs of the steps before this one are known: they are final */
    int64_t replayed;  /* number of times that a step was run again */
    int64_t settled;   /* the first step that has to be run again; `steps` if none has. States up to
                          the smaller of this and `confirmed` are the same on all peers */
    double ahead; /* by how many steps this peer is ahead of the mean of the other peers, computed
                     from the leads that thud_rollback_set_lead was given. Positive: slow down by
                     that many steps; negative: catch up */
} thud_rollback_progress;

/* THUD_ERROR_NULL. */
THUD_API thud_result thud_rollback_get_progress(const thud_rollback *rollback,
                                                thud_rollback_progress *out);

/* The same as a return value; all 0 for a null rollback. */
static inline thud_rollback_progress thud_progress_of(const thud_rollback *rollback) {
    thud_rollback_progress progress;
    memset(&progress, 0, sizeof progress);
    thud_rollback_get_progress(rollback, &progress);
    return progress;
}

/* The world's hash, and a copy of the state (state_bytes), before one of the last `depth` steps or
 * before the next one. Up to `confirmed` the hash is the same on all peers; if it is not, `step` is
 * not deterministic, or a peer cheats: see thud_rollback_report. Either output may be null. Beyond
 * `progress.settled` the call first repeats all wrongly predicted steps; errors as for
 * thud_rollback_settle, and THUD_ERROR_INVALID for a step that is no longer stored. */
THUD_API thud_result thud_rollback_get_state(thud_rollback *rollback, int64_t step,
                                             uint64_t *out_hash, void *out_state);

/* ---- peers that differ ---- */

/* Writes a report for a peer whose hash of a confirmed step differs: the hashes before all
 * confirmed steps that are stored and, unless `step` is -1, a hash of each body before `step`, one
 * of these, and the inputs of the step before it. It is written to `buffer` of `capacity` bytes;
 * *out_bytes is its size. With a null buffer, and a capacity of 0, only *out_bytes is written. The
 * bytes are the same on every platform. The call first repeats wrongly predicted steps; errors as
 * for thud_rollback_settle, and THUD_ERROR_INVALID for a step that is not confirmed or no longer
 * stored, and where `capacity` is less than the size. */
THUD_API thud_result thud_rollback_report(thud_rollback *rollback, int64_t step, void *buffer,
                                          size_t capacity, size_t *out_bytes);

/* How this peer differs from the one that wrote a report. */
typedef struct thud_rollback_difference {
    int64_t step;      /* the first step that both have stored before which the worlds differ; -1:
                          they do not differ */
    bool is_detailed;  /* the report has the bodies before that step. Otherwise the other fields say
                          nothing: tell the peer `step`, and compare its report of that step */
    thud_body_id body; /* the first that differs or is missing there, in the order of slots; null:
                          none, or one that is missing here */
    int body_slot;     /* its slot; -1: none */
    int bodies;        /* number of bodies that differ */
    int player; /* the first player whose input in the step before differs between the two peers, so
                   that they were sent different inputs. -1: none, or the inputs are no longer
                   stored */
} thud_rollback_difference;

/* Compares a report of `bytes` bytes, from a peer with the same number of players, with this peer.
 * A difference is found as long as the step is stored, so exchange hashes at least every `depth`
 * steps. Where inputs agree, and a single one of several peers differs from all others, that one is
 * at fault. The call first repeats wrongly predicted steps; errors as for thud_rollback_settle, and
 * THUD_ERROR_INVALID for bytes that are no report, or damaged; *out is then not written. */
THUD_API thud_result thud_rollback_compare(thud_rollback *rollback, const void *report,
                                           size_t bytes, thud_rollback_difference *out);

/* ---- clocks ---- */

/* How many more steps this peer has run than inputs of a player have arrived. Tell the player this
 * number with each message. THUD_ERROR_INVALID for a player that is none. */
THUD_API thud_result thud_rollback_get_lead(const thud_rollback *rollback, int player,
                                            int64_t *out_lead);
/* Stores the lead that a message of a player contains: what the player's thud_rollback_get_lead
 * returned for this peer: how many more steps it has run than it has inputs from here, |lead| <=
 * THUD_ROLLBACK_DEPTH_MAX. Half the difference of both leads is how far this peer is ahead: the
 * delay between them cancels out where it is the same in both directions. `progress.ahead` is the
 * mean of that over all players heard of, smoothed. It is as old as the delay, so correct a small
 * share of it in each frame. THUD_ERROR_INVALID. */
THUD_API thud_result thud_rollback_set_lead(thud_rollback *rollback, int player, int64_t lead);

/* ---- players who come and go ---- */

/* From this step on a player is absent: its input is `idle`, and nobody waits for it. All peers
 * have to make the call with the same step, at which no peer has an input of the player; inputs
 * before it that this peer lacks may still come. THUD_ERROR_INVALID for a step at or after which an
 * input of the player is known, one that is more than `depth` ahead or before the last `depth`
 * steps, and for a player that is none or absent. */
THUD_API thud_result thud_rollback_leave(thud_rollback *rollback, int player, int64_t step);
/* From this step on an absent player is there again, and its inputs are needed. All peers have to
 * make the call with the same step: announce one that is some steps ahead, with the inputs before
 * it. THUD_ERROR_INVALID for a step that is confirmed, or more than `depth` ahead, and for a player
 * that is none or not absent. */
THUD_API thud_result thud_rollback_enter(thud_rollback *rollback, int player, int64_t step);

/* Writes what somebody needs to join the game: the world and the state before the step `confirmed`,
 * and who is absent; as thud_rollback_report does. THUD_ERROR_INVALID where `capacity` is less than
 * the size. */
THUD_API thud_result thud_rollback_snapshot(thud_rollback *rollback, void *buffer, size_t capacity,
                                            size_t *out_bytes);
/* Joins a game: world, state and steps become those of `bytes` bytes that another peer's
 * thud_rollback_snapshot wrote; the world takes its bodies' handles over. Players and state_bytes
 * have to be the same in both, the world as for thud_world_restore. Then the inputs of all players
 * from `progress.steps` on are needed; a spectator gives none of its own. THUD_ERROR_INVALID for
 * bytes that are damaged or of another game, THUD_ERROR_MEMORY. */
THUD_API thud_result thud_rollback_restore(thud_rollback *rollback, const void *buffer,
                                           size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
