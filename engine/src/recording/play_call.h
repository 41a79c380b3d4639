/* play_call.h: how a player makes recorded calls. play_call.c, which tools/recorded.py generates,
 * calls the function of a given number. */
#ifndef TD_PLAY_CALL_H
#define TD_PLAY_CALL_H

#include "recording/codec.h"
#include "recording/recording.h"

/* A call that is being played. */
typedef struct td_play_frame {
    struct td_play_frame *outer;
    uint64_t callbacks; /* number of callbacks of this call so far */
    uint64_t next;      /* number of the next callback that has a record; 0: there is none */
} td_play_frame;

/* The records that are played, and the world that they change. */
typedef struct td_play {
    thud_world *world;
    td_memory *memory;
    td_reader from;       /* the records of the segment under way */
    td_play_frame *frame; /* null: between calls */
    /* Plays the call whose record begins with the byte `record`. By this pointer callbacks play the
     * calls that were made within them. */
    void (*record)(struct td_play *p, unsigned record);
    bool differs; /* a call has another result than was recorded */
    bool short_of_memory;
} td_play;

/* Whether the next record can be played: no result differed, memory was not short, and the bytes
 * read so far were valid. */
static inline bool td_play_goes_on(const td_play *p) {
    return !p->differs && !p->short_of_memory && !p->from.broken;
}

/* Makes the call of this number. */
thud_result td_play_call(td_play *p, thud_world *w, int call, td_decoded *d);

/* ---- play_callbacks.c ---- */

/* Sets `next` of the frame by reading the number of callbacks from the record that comes next. */
void td_play_next_callback(td_play *p, td_play_frame *frame);
/* Sets the world's listeners and filter to functions of the player, without the effects that the
 * API calls for this have (which wake bodies). `calls`: the TD_CALLS_... that the recorded world
 * had. False when memory is short. */
bool td_play_set_callbacks(td_play *p, unsigned calls, uint32_t without);

thud_mover_pass_fn td_play_pass;
thud_result td_play_world_advance_with(td_play *p, thud_world *w, const td_decoded *d);
thud_result td_play_world_set_filter(td_play *p, thud_world *w, const td_decoded *d);
thud_result td_play_world_set_listeners(td_play *p, thud_world *w, const td_decoded *d);
thud_result td_play_mover_move(td_play *p, thud_world *w, const td_decoded *d);

#endif
