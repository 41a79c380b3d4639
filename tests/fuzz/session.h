/* session.h: a session is a world that a fuzzer's bytes play with, and what the checks remember of
 * it. The same bytes are played in two sessions, which differ in a property that must not change
 * any result (their kind of twins). */
#ifndef FUZZ_SESSION_H
#define FUZZ_SESSION_H

#include "decoder.h"

#include <thud/thud.h>
#include <thud/thud_approximate.h>
#include <thud/thud_capsule.h>
#include <thud/thud_casts.h>
#include <thud/thud_joint.h>
#include <thud/thud_listeners.h>
#include <thud/thud_lists.h>
#include <thud/thud_minkowski.h>
#include <thud/thud_mover.h>
#include <thud/thud_prediction.h>
#include <thud/thud_reads.h>
#include <thud/thud_rules.h>
#include <thud/thud_textured.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_terrain.h>

/* What distinguishes the second session from the first. */
typedef enum twin_kind {
    TWIN_NONE = 0, /* there is no second session; allocations may fail, and numbers are hostile */
    TWIN_BROADPHASE,
    TWIN_BASELINE,   /* it uses the baseline instruction set */
    TWIN_SHIFT,      /* all positions are shifted, by up to 10^7 units */
    TWIN_SNAPSHOT,   /* it goes on in new worlds, restored from snapshots of its last one */
    TWIN_WORKERS,    /* it has a job system with several workers */
    TWIN_MEMORY,     /* each call runs out of memory once, and is made again */
    TWIN_FLOAT_MODE, /* it has another floating-point mode */
    TWIN_COUNT
} twin_kind;

enum {
    SESSION_BODIES = 48, /* handles that operations choose from; the oldest ones are replaced */
    SESSION_SHAPES = 64,
    SESSION_JOINTS = 24,
    SESSION_GONE = 16,             /* stale handles that are kept */
    SESSION_WORLD_SHAPES_MAX = 64, /* shapes in the world at a time */
    /* Pairs of a ledger. 64 shapes make 2,016 pairs, all of which may end and begin again within a
     * step, so that 4,032 may be entered. */
    SESSION_OPEN_PAIRS_MAX = 4096,
    SESSION_OPERATIONS_MAX = 512, /* operations of an input */
    SESSION_SCRIPT = 24,          /* bytes that decide what callbacks do */
    SESSION_DEPTH = 2,            /* calls in progress: outside of callbacks, and inside of one */
    SESSION_KINDS = 4             /* categories of shapes, by the lowest bit set in their filter */
};

/* Pairs that have begun and not ended. */
typedef struct pair_ledger {
    thud_contact_event open[SESSION_OPEN_PAIRS_MAX];
    int count;
} pair_ledger;

/* State of the session that a restore sets back to that of the snapshot. */
typedef struct session_state {
    thud_body_id bodies[SESSION_BODIES];
    thud_shape_id shapes[SESSION_SHAPES];
    thud_joint_id joints[SESSION_JOINTS];
    int next_body, next_shape, next_joint;
    pair_ledger touches, sensed;
    thud_mover mover;
    thud_rule rules[SESSION_KINDS][SESSION_KINDS];
    bool ruled[SESSION_KINDS][SESSION_KINDS];
} session_state;

/* A call in progress, and the state of the world before it. */
typedef struct session_call {
    const char *text;
    uint64_t hash;
    thud_stats stats;
    int told;
    bool again;            /* it has run out of memory once */
    long outer;            /* memory_allowed of the call around it */
    size_t snapshot_bytes; /* of the snapshot before the call, in call_snapshots; 0 if none was
                              taken */
} session_call;

typedef struct fuzz_session {
    thud_world *world, *other; /* `other` is used for handles of another world only */
    thud_world_def def;
    thud_listeners listeners; /* the world's listeners, which worlds that replace it get too */
    uint32_t told_categories; /* those of the epilogue of categories, or 0; the same */
    bool filters;             /* the world has the pair filter; the same */
    bool sleeping;            /* bodies may fall asleep; the same */
    twin_kind twin;
    bool second, closing;
    bool asks; /* the second session makes queries after each operation */
    session_state now, kept;
    thud_body_id gone_bodies[SESSION_GONE], foreign_body;
    thud_shape_id gone_shapes[SESSION_GONE], foreign_shape;
    unsigned gone;
    char *snapshot; /* the snapshot to restore; `kept` is the state at its time */
    size_t snapshot_bytes;
    char *call_snapshots; /* first half: a snapshot before a call; second half: one after it, which
                             must be the same where the call is refused */
    size_t call_snapshots_room; /* bytes */
    double unit, shift_x, shift_y;
    thud_body_seen seen[SESSION_BODIES]; /* of thud_world_get_moved_bodies */

    fuzz_bytes bytes;
    uint8_t script[SESSION_SCRIPT];
    int mood;                     /* one in so many callbacks makes calls; 0: none */
    int depth;                    /* nested callbacks; 0: outside of them */
    const thud_contact *question; /* that a prologue is called about; null outside of it */
    unsigned asked;               /* callbacks so far */
    int destroyed_inside;         /* bodies and shapes destroyed in callbacks since the last step */

    session_call calls[SESSION_DEPTH]; /* by depth */
    thud_result result;                /* of the last call */
    int told;                          /* number of log messages ... */
    thud_result heard;                 /* ... and the result of the last one */
    long memory_allowed;               /* allocations until one fails; -1: none fails, -2: one has
                                          failed */
    long memory_held;
    unsigned memory_round;
    double clock;

    uint64_t digest;                            /* see calls.h */
    uint64_t trace[SESSION_OPERATIONS_MAX + 1]; /* the digest after each operation */
    int operations;
    const char *operation;
} fuzz_session;

/* Calls of the public API, in all sessions of the process. */
extern uint64_t fuzz_calls_made;

/* Prints a finding and aborts the process; a fuzzer keeps the input. */
__attribute__((format(printf, 2, 3))) _Noreturn void fuzz_fail(const fuzz_session *s,
                                                               const char *format, ...);

/* ---- session.c ---- */

/* Reads the settings from the first bytes, and creates the world. */
void session_open(fuzz_session *s, const uint8_t *data, size_t size, bool second);
/* Destroys everything, and checks that every begin event had its end and all memory was released.
 */
void session_close(fuzz_session *s);
/* Whether the bytes are used up, or SESSION_OPERATIONS_MAX operations were played. */
bool session_over(const fuzz_session *s);
/* Goes on in a new world, restored from a snapshot of the present one. */
void session_replace_world(fuzz_session *s);
/* Queries, reports and a snapshot, which must not change anything. */
void session_question(fuzz_session *s);

/* ---- population.c ---- */

/* Creates the bodies that the world has at the beginning. */
void session_populate(fuzz_session *s, int kind);

/* ---- script.c: callbacks ---- */

/* Sets the pair filter in another world that the session goes on with. */
void session_take_filter(fuzz_session *s, thud_world *world);
thud_filter_fn session_filter;
thud_prologue_fn session_prologue;
thud_epilogue_fn session_epilogue;
thud_object_epilogue_fn session_object_epilogue;
thud_prologue_all_fn session_prologue_all;
thud_epilogue_all_fn session_epilogue_all;
thud_overlap_fn session_overlap;
thud_cast_fn session_cast;
thud_mover_pass_fn session_pass;
/* Plays an operation within a callback, in one of `mood` callbacks. */
void session_ask(fuzz_session *s);

/* ---- operations.c ---- */

/* Plays the operation that the next byte means. */
void session_play(fuzz_session *s);

#endif
