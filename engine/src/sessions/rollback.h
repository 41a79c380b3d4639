/* rollback.h: a rollback's rings, for the files that implement thud_rollback.h.
 *
 * Two ring buffers are indexed by the step's number: `saved` has the snapshot before each of the
 * last depth + 1 steps, and the inputs that the step was played with; and each player has the known
 * inputs of 2 depth + 2 steps: depth + 1 steps before the next one, the next one, and depth after
 * it. An input that is not known yet is predicted to be that of the step before. */
#ifndef TD_ROLLBACK_H
#define TD_ROLLBACK_H

#include "state/handles.h"
#include "thud/thud_rollback.h"

/* The step number that means: no step. */
#define TD_NO_STEP INT64_MAX

/* The world and state before a step, and what the step was played with. */
typedef struct td_saved_step {
    char *image;        /* the world's snapshot, followed by the caller's state */
    size_t room, bytes; /* size of the memory at image; of the snapshot in it */
    uint64_t hash;      /* thud_hash_of before the step */
    uint64_t *inputs;   /* by player */
} td_saved_step;

/* The known inputs of a player. */
typedef struct td_player_inputs {
    uint64_t *inputs;           /* ring of input_count */
    bool *is_known;             /* ring of input_count: whether the input of the step is known */
    int64_t known_before;       /* every input before this step is known */
    int64_t told_before;        /* inputs have been given for steps before this one only */
    int64_t gone_from, back_at; /* absent from step gone_from to step back_at - 1; TD_NO_STEP: never
                                   gone, or not back yet */
    bool is_timed;              /* both leads have values */
    double lead, their_lead;    /* smoothed, steps: of thud_rollback_get_lead, and what the player's
                                   messages told */
} td_player_inputs;

struct thud_rollback {
    thud_world *world;
    thud_rollback_options options;
    size_t bytes;              /* of the memory block of this struct and its rings */
    td_saved_step *saved;      /* ring of saved_count */
    td_player_inputs *players; /* by player */
    int64_t first;             /* the step with which this peer began: 0, unless it has joined */
    int64_t steps;             /* made so far: the number of the next one */
    int64_t at; /* world and state are those before this step; -1: options.step is running, or has
                   failed and the restore failed too */
    int64_t replayed;    /* steps that were played again, in all */
    int64_t first_wrong; /* the first step that has to be played again, or TD_NO_STEP */
    bool playing;        /* inside options.step */
};

/* Refuses calls from inside a step or callback. */
thud_result td_rollback_check(const thud_rollback *r);

/* Settles (thud_rollback_settle) before bytes are written to a buffer of the caller's, and refuses
 * one that is null but said to have room, and a null out_bytes. */
thud_result td_rollback_settle_for(thud_rollback *r, const void *buffer, size_t capacity,
                                   const size_t *out_bytes);

/* The place of a step in the ring `saved`. Step -1, before the first, is allowed: its inputs
 * predict those of step 0. */
td_saved_step *td_rollback_saved(const thud_rollback *r, int64_t step);

/* The earliest step that can be restored: the state before it is stored. */
int64_t td_rollback_oldest(const thud_rollback *r);

/* Restores world and state to what they were before a saved step. */
thud_result td_rollback_restore_step(thud_rollback *r, int64_t step);

/* Saves world and state, as they are before a step, in its place in the ring. */
thud_result td_rollback_save_step(thud_rollback *r, int64_t step);

/* Begins anew with the present world and state, as those before `step`. Forgets all inputs, but not
 * which players are absent. `inputs`: those of the step before, by player. */
void td_rollback_begin(thud_rollback *r, int64_t step, const uint64_t *inputs);

/* Writes a number, its low bytes first; returns the place after it. */
static inline uint8_t *td_put_number(uint8_t *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        at[i] = (uint8_t)(value >> (8 * i));
    }
    return at + bytes;
}

/* Reads a number that td_put_number has written. */
static inline uint64_t td_number_at(const uint8_t *at, int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value |= (uint64_t)at[i] << (8 * i);
    }
    return value;
}

#endif
