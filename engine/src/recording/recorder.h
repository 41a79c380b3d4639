/* recorder.h: the recording of a world (thud_recording.h), and the frames by which the functions of
 * thud_recorded.h add their calls to it. The format is in recording.h. */
#ifndef TD_RECORDER_H
#define TD_RECORDER_H

#include "recording/recorded_calls.h"
#include "recording/recording.h"
#include "thud/thud_listeners.h"
#include "thud/thud_mover.h"
#include "thud/thud_recording.h"
#include "thud/thud_rules.h"

/* A call that is being made. Calls within its callbacks have frames of their own. If its callbacks
 * make no records, the call is written as one record when it has returned. Otherwise the record is
 * opened (TD_RECORD_OPEN) at the first callback that has one. */
typedef struct td_record_frame {
    struct thud_recorder *recorder; /* null: the call is not recorded */
    struct td_record_frame *outer;  /* the call in one of whose callbacks it is; null: none */
    int call;                       /* number of its function, a td_call */
    const void *const *args;        /* td_codec_write */
    size_t start;       /* offset of its records in thud_recorder.records, if it is opened */
    bool opened;        /* TD_RECORD_OPEN is written */
    bool answering;     /* TD_RECORD_CALLBACK of the callback under way is written */
    bool locked;        /* TD_RECORD_LOCKED has to be written before it */
    uint64_t callbacks; /* number of callbacks of this call so far */
    uint64_t written;   /* number of the last callback with a record */
    const thud_step_calls *steps; /* the caller's own, of thud_world_advance_with */
    thud_mover_pass_fn *pass;     /* the caller's callback of thud_mover_move */
    void *pass_context;
    const thud_ray_hit *hits; /* of a query: what it found */
    int hit_count;
} td_record_frame;

typedef struct td_segment_place {
    size_t at;
    uint64_t steps; /* thud_recorder.time at its begin */
    bool keyframe;
} td_segment_place;

struct thud_recorder {
    thud_world *world; /* null once it has been destroyed */
    td_memory memory;  /* the world's hooks */
    thud_recorder_options options;
    td_writer whole;        /* the finished segments; with a sink those that it has not been given
                               yet */
    td_writer records;      /* the contents of the segment under way */
    td_writer shorter;      /* buffer for these contents without repeats, when the segment is
                               finished */
    td_array places;        /* td_segment_place, of the segments in `whole`; with a ring */
    uint64_t time;          /* steps that are recorded so far */
    uint64_t begun;         /* `time` as the segment under way began */
    uint32_t number;        /* of the next segment */
    td_record_frame *frame; /* the call under way; null: none */
    bool locked;            /* world.locked as the callback under way was called */
    bool stale;             /* calls that are not recorded have changed the world: a snapshot has to
                               be written */
    bool failed;            /* memory was short, or the sink has failed: nothing more is recorded */
    bool changed; /* since the last hash a call other than thud_world_step outside callbacks, or a
                     snapshot, was recorded */
    uint64_t waiting;   /* steps that are not in `records` yet */
    uint64_t steps;     /* thud_world.steps after the last recorded call */
    uint64_t hashed_at; /* `time` at the last hash */
    uint64_t keyed_at;  /* `time` at the last keyframe */
    /* The caller's own callbacks, which the recorder's functions have replaced and call. */
    unsigned calls; /* TD_CALLS_..., as recorded last */
    uint32_t without;
    thud_listeners listeners;
    thud_filter_fn *filter;
    void *filter_context;
    const struct td_object_hooks *object_hooks;
};

/* Begins the frame of a call; `args`: as for td_codec_write. The caller must call td_record_close
 * in any case. */
void td_record_open(td_record_frame *frame, thud_world *w, int call, const void *const *args);
/* Ends the frame. `result` is that of the call, and is returned. */
thud_result td_record_close(td_record_frame *frame, thud_result result);
/* Whether queries of the world are recorded; false for null. */
static inline bool td_records_queries(const thud_world *w) {
    return w && w->recorder && w->recorder->options.queries;
}
/* Records a query that has returned THUD_OK, and the `count` hits that it found, if queries are
 * recorded. */
void td_record_query(thud_world *w, int call, const void *const *args, const thud_ray_hit *hits,
                     int count);
/* Writes the steps that are not in the records yet (`waiting`). */
void td_record_flush_steps(thud_recorder *r);
/* Writes what has to stand before the frame's record: the begin of the callback within which it is,
 * or the steps so far. */
void td_record_place(thud_recorder *r, td_record_frame *frame);
/* To be called when the world gets a state that does not come from recorded calls, as by a restore.
 */
void td_record_restored(thud_world *w);
/* To be called before the world is destroyed: finishes its recording. */
void td_record_leave_world(thud_world *w);

/* The recorder's callbacks. */
thud_filter_fn td_record_filter;
thud_step_fn td_record_before, td_record_after;
thud_mover_pass_fn td_record_pass;

/* Returned by td_record_enter for td_record_leave. frame: the call that the callback belongs to;
 * null: it is not recorded. */
typedef struct td_record_callback {
    td_record_frame *frame;
    bool locked; /* thud_recorder.locked before */
} td_record_callback;

td_record_callback td_record_enter(thud_recorder *r, const thud_world *w);
/* Returns where the answer has to be written; null where it needs no record. */
td_writer *td_record_leave(thud_recorder *r, td_record_callback callback, bool usual);

/* td_record_take_callbacks sets the recorder's callbacks in place of the caller's, and records
 * which there are if that has changed. td_record_return_callbacks sets the caller's again. */
void td_record_take_callbacks(thud_recorder *r);
void td_record_return_callbacks(thud_recorder *r);

#endif
