/* thud_recording.h: records a world: a snapshot, and then every call that changes the world, with
 * hashes of its state; and plays such a recording, to the same bits, on every platform. For bug
 * reports, replays of games, and tests. thud.h does not include this header; a program that uses it
 * links what thud_snapshot.h names, and a player links every function that can be recorded.
 *
 *     #include <thud/thud_recording.h>
 *     #include <thud/thud_recorded.h>     last: the calls of this file are recorded
 *     ...
 *     thud_recorder_begin(world, NULL, &recorder);
 *     ... steps and calls, as ever
 *     thud_recorder_get_bytes(recorder, &bytes);      to be written to a file
 *     thud_recorder_end(recorder);
 *
 *     thud_player_create(bytes, NULL, &player);
 *     for (bool stepped = true; stepped;) {
 *         thud_player_step(player, &stepped);
 *     }
 *
 * What is recorded are the calls of source files that include thud_recorded.h. Those of other files
 * are not recorded, and cost nothing. If one of them is a step, restore or rollback, the recorder
 * notices it by the number of steps, and adds a snapshot of the world as it is then. Any other such
 * call makes the played world differ from the recorded one, which a hash in the recording shows. A
 * refused call is recorded as refused, without its arguments.
 *
 * Listeners and filters of the world are recorded by their answers, and by the calls that they
 * make, and are not needed to play the recording. Not recorded: the log, the clock, the allocator,
 * the job system, which change no results; the names of qualities that are not the engine's, which
 * are "recorded" in the world that is played. Queries, which change nothing, are recorded where
 * thud_recorder_options.queries is set, with what they found: to be listed and drawn. A world with
 * a time_budget cannot be recorded, since it depends on the clock.
 *
 * A recording is bytes with a version and checksums, the same on every platform for the same calls,
 * except for the snapshots in it, which thud_packed.h describes: 64-bit machines with the byte
 * order of x86-64 and WebAssembly can play the recordings of each other. */
#ifndef THUD_RECORDING_H
#define THUD_RECORDING_H

#include "thud_hooks.h"
#include "thud_ids.h"
#include "thud_limits.h"
#include "thud_packed.h"
#include "thud_queries.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- recording ---- */

/* The recording of one world. It uses the world's allocator. */
typedef struct thud_recorder thud_recorder;

/* Receives the next bytes of a recording; false: they could not be kept, and the recording ends
 * there. It must not call any function of the world. */
typedef bool thud_recording_sink_fn(const void *bytes, size_t count, void *context);

/* Hits that are recorded of a query with a callback, at most. */
enum { THUD_RECORDED_FOUND_MAX = 64 };

/* All zero selects the defaults. */
typedef struct thud_recorder_options {
    int hash_steps;     /* steps from one hash to the next, [0, THUD_RECORDING_STEPS_MAX]; default
                           (0) 60. A hash is a pass over all bodies; none is written while nothing
                           is awake and nothing is called */
    bool body_hashes;   /* with each hash 16 bits for every body, by which a player names the body
                           that differs */
    int keyframe_steps; /* steps from one keyframe to the next, [0, THUD_RECORDING_STEPS_MAX]: a
                           packed snapshot, from which a player can start; default (0) none but the
                           first, or with ring_steps a quarter of it */
    int ring_steps; /* [0, THUD_RECORDING_STEPS_MAX]: keeps only the last steps: at least this many,
                       and at most those from one keyframe to the next more; default (0) all */
    thud_recording_sink_fn *sink; /* receives the recording, piece by piece, at every hash, and
                                     keeps no memory for it; not with ring_steps. Default null: the
                                     recording is kept in memory */
    void *context;                /* passed to sink */
    bool queries;                 /* the casts and overlaps of thud_queries.h and thud_casts.h, and
                                     thud_world_closest, are recorded with what they found: of those with a callback
                                     the first THUD_RECORDED_FOUND_MAX hits. Default false */
} thud_recorder_options;

/* Begins to record a world, from its present state. `options` null: the defaults. THUD_ERROR_NULL;
 * THUD_ERROR_INVALID for an option out of range, a ring with a sink, a world with a time_budget,
 * and one that is being recorded; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_recorder_begin(thud_world *world,
                                                        const thud_recorder_options *options,
                                                        thud_recorder **out);
/* Ends the recording, and frees it; a sink receives its last bytes. Null does nothing. Inside a
 * callback of the world the call does nothing either, and the log is told THUD_ERROR_LOCKED. The
 * world stays usable. Where thud_world_destroy is a recorded call, the world may be destroyed
 * before; otherwise the recorder must be ended first. */
THUD_API void thud_recorder_end(thud_recorder *recorder);

/* Gets the recording so far, whole: bytes that can be played. They are valid until the next
 * recorded call. The recording goes on. THUD_ERROR_NULL; THUD_ERROR_INVALID for a recorder with a
 * sink; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY, also if memory was short at an
 * earlier call: the recording has then ended at that call, and is lost. */
THUD_API thud_result thud_recorder_get_bytes(thud_recorder *recorder, thud_bytes *out);

/* For a program that crashes, as in a handler of a signal: gets the recording so far, with the
 * step under way as its last one, so that playing it crashes as well. It has no hash at its end.
 * The world is not used, whose state may be broken; memory is allocated. Nothing more is recorded,
 * and nothing else may be done with the recorder. THUD_ERROR_NULL; THUD_ERROR_INVALID for a
 * recorder with a sink; THUD_ERROR_MEMORY, also if memory was short before. */
THUD_API thud_result thud_recorder_salvage(thud_recorder *recorder, thud_bytes *out);

/* Adds bytes of the caller to the recording, under a name, after the calls so far: inputs, a
 * message, the state of a game. THUD_ERROR_NULL for a null recorder or name, or null bytes of a
 * count; THUD_ERROR_LOCKED inside a recorded call; THUD_ERROR_MEMORY as above. */
THUD_API thud_result thud_recorder_add_chunk(thud_recorder *recorder, const char *name,
                                             thud_bytes bytes);

/* ---- playing ---- */

/* A recording that is played, with a world of its own. */
typedef struct thud_player thud_player;

/* Receives a chunk of the recording as it is played. `name` is valid during the call. */
typedef void thud_chunk_fn(const char *name, thud_bytes bytes, void *context);

/* A value among the arguments of a call. */
typedef struct thud_call_value {
    double number; /* of a handle its index1; of a bool 0 or 1; integers of 64 bits are rounded */
    bool handle;   /* it is the handle of a body, shape or joint */
} thud_call_value;

/* A call of a recording. */
typedef struct thud_played_call {
    const char *name;              /* of the function; "thud_world_restore" also for what was not
                                      recorded, and whose result is in the recording as a snapshot */
    thud_result result;            /* that it had when it was recorded */
    const thud_call_value *values; /* the numbers and handles of its arguments, without the world,
                                      those in structs and arrays included, in the order of the
                                      headers. Names, pointers to functions and what the call
                                      returns are left out. Empty for a refused call */
    int value_count;
    uint32_t returned; /* index1 of the handle that it returned; else 0 */
    bool query;        /* the call was a query: the player reports it, and does not make it again */
    const thud_ray_hit *hits; /* what a query found, in its order; of overlaps the shape alone, and
                                 the rest 0; of thud_world_closest shape, point and normal. Of
                                 thud_world_cast_rays and _shapes one for each cast */
    int hit_count;
} thud_played_call;

/* Called with each call that has been played. A call made by a callback comes before the call in
 * which the callback was. What `call` points to is valid during the call. The function must not
 * change the world, nor use the player. */
typedef void thud_played_call_fn(const thud_played_call *call, void *context);

/* All zero selects the defaults. */
typedef struct thud_player_options {
    thud_allocator allocator;   /* of the player and its world */
    thud_log_fn *log;           /* of its world; is told why a recording is refused, too */
    void *log_context;          /* passed to log */
    thud_job_system job_system; /* of its world */
    thud_chunk_fn *chunk;       /* default null: chunks are skipped */
    thud_played_call_fn *call;  /* default null: calls are not reported, which costs nothing */
    void *context;              /* passed to chunk and call */
    thud_clock_fn *clock;       /* of its world; default null: thud_stats has no times */
    void *clock_context;        /* passed to clock */
} thud_player_options;

/* Opens a recording, at its first step. All of its checksums are tested. The bytes are not copied,
 * and must exist as long as the player; `options` null: the defaults. THUD_ERROR_NULL;
 * THUD_ERROR_INVALID for bytes that are cut short, damaged, no recording, or of another version or
 * build of thud, with the reason in the log; THUD_ERROR_MEMORY. As with snapshots, the checksums
 * are no protection against forged bytes: play only recordings that you trust. */
THUD_NODISCARD THUD_API thud_result thud_player_create(thud_bytes recording,
                                                       const thud_player_options *options,
                                                       thud_player **out);
/* Destroys a player and its world. Null does nothing. */
THUD_API void thud_player_destroy(thud_player *player);

/* Plays the calls up to the next step, and this step; or all steps of the next
 * thud_world_advance. *out_stepped (may be null) is false at the end of the recording, where
 * nothing is done. THUD_ERROR_NULL; THUD_ERROR_MEMORY; THUD_ERROR_INVALID where the recording
 * differs from what happens (thud_player_progress.differs), or contradicts itself: only
 * thud_player_seek goes on from there. */
THUD_API thud_result thud_player_step(thud_player *player, bool *out_stepped);

/* Goes to a step, [first, end] of thud_player_progress: forwards by playing, backwards from the
 * last keyframe before it. Errors as for thud_player_step; THUD_ERROR_INVALID for another step. */
THUD_API thud_result thud_player_seek(thud_player *player, int64_t step);

/* The last keyframe at or before a step: there a seek that goes back begins to play. A program that
 * must not wait for long seeks to it, and then steps. THUD_ERROR_NULL; THUD_ERROR_INVALID for a
 * step outside of [first, end]. */
THUD_API thud_result thud_player_get_keyframe(const thud_player *player, int64_t step,
                                              int64_t *out_step);

/* The world of the player: for reads, queries and drawing; handles are those of the world that was
 * recorded. It belongs to the player; a change of it makes the recording differ, until a seek goes
 * back. THUD_ERROR_NULL. */
THUD_API thud_result thud_player_get_world(thud_player *player, thud_world **out);

/* Where a player stands. */
typedef struct thud_player_progress {
    int64_t first;  /* steps are counted from the begin of the recording: this is the first one that
                       a ring has kept, else 0 */
    int64_t end;    /* steps in all: where it ends */
    int64_t steps;  /* steps made so far: where it stands */
    int64_t hashes; /* hashes that were compared so far, and were equal */
    bool differs; /* the state is not the one that was recorded: it first differs at some step after
                     differs_after, up to differs_at */
    int64_t differs_after; /* the step up to which all was equal */
    int64_t differs_at;    /* the step at which a difference was found */
    thud_body_id body; /* the first body that differs; null where that is not known, or where a call
                          has another result than was recorded */
} thud_player_progress;

/* THUD_ERROR_NULL. */
THUD_API thud_result thud_player_get_progress(const thud_player *player, thud_player_progress *out);

#ifdef __cplusplus
}
#endif

#endif
