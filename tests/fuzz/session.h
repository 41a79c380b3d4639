/* session.h: a world that a fuzzer plays with, and all that it keeps of it. The same bytes are
 * played by two sessions, which differ in what must change nothing (their twin kind). */
#ifndef FUZZ_SESSION_H
#define FUZZ_SESSION_H

#include "decoder.h"

#include <thud/thud.h>
#include <thud/thud_casts.h>
#include <thud/thud_joint.h>
#include <thud/thud_listeners.h>
#include <thud/thud_lists.h>
#include <thud/thud_minkowski.h>
#include <thud/thud_mover.h>
#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_terrain.h>

/* What the second session has otherwise. */
typedef enum twin_kind {
    TWIN_NONE = 0, /* there is no second one; memory may fail, and numbers are hostile */
    TWIN_BROADPHASE,
    TWIN_BASELINE,   /* the instruction set */
    TWIN_SHIFT,      /* all places, by 10^7 units */
    TWIN_SNAPSHOT,   /* it goes on in new worlds, restored from snapshots of the last one */
    TWIN_WORKERS,    /* of a job system */
    TWIN_MEMORY,     /* each call is refused memory before it is made again */
    TWIN_FLOAT_MODE, /* the caller's */
    TWIN_COUNT
} twin_kind;

enum {
    SESSION_BODIES = 48,
    SESSION_SHAPES = 64,
    SESSION_JOINTS = 24,
    SESSION_GONE = 16,
    SESSION_SHAPES_MOST = 64, /* in the world */
    SESSION_OPEN = 4096,      /* pairs, all of which may end and begin again in a step */
    SESSION_MOST = 512,       /* operations of one input */
    SESSION_SCRIPT = 24,      /* bytes that callbacks play */
    SESSION_DEPTH = 2,
    SESSION_KINDS = 4 /* of shapes, by their filter's lowest bit */
};

/* Pairs that have begun and not ended. */
typedef struct pair_ledger {
    thud_contact_event open[SESSION_OPEN];
    int count;
} pair_ledger;

/* What goes back with a snapshot. */
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

/* A call under way, and how the world was before it. */
typedef struct session_call {
    const char *text;
    uint64_t hash;
    thud_stats stats;
    int told;
    bool again;   /* memory was refused to it once */
    long outer;   /* memory that the call around it is allowed */
    size_t image; /* bytes of the session's image that are the world before it; 0: none was taken */
} session_call;

typedef struct fuzz_session {
    thud_world *world, *other; /* the other one only gives handles */
    thud_world_def def;
    thud_listeners listeners; /* the world's, of which another one has the same */
    bool filters;             /* likewise */
    twin_kind twin;
    bool second, closing;
    bool asks; /* the second one is asked about the world after each operation */
    session_state now, kept;
    thud_body_id gone_bodies[SESSION_GONE], foreign_body;
    thud_shape_id gone_shapes[SESSION_GONE], foreign_shape;
    unsigned gone;
    char *snapshot; /* `kept` belongs to it */
    size_t snapshot_bytes;
    char *image; /* of the world before a call, now and then, in the first half */
    size_t image_room;
    double unit, shift_x, shift_y;
    thud_body_seen seen[SESSION_BODIES]; /* what it was told of bodies that moved */

    fuzz_bytes bytes;
    uint8_t script[SESSION_SCRIPT];
    int mood;             /* one in so many callbacks does something; 0: none */
    int depth;            /* of callbacks */
    unsigned asked;       /* callbacks so far */
    int destroyed_inside; /* callbacks, since the last step */

    session_call calls[SESSION_DEPTH]; /* by depth */
    thud_result result;                /* of the last call */
    int told;                          /* messages of the log ... */
    thud_result heard;                 /* ... and what the last one was of */
    long memory_allowed;               /* allocations until one fails; negative: no end */
    long memory_held;
    unsigned memory_round;
    double clock;

    uint64_t digest, trace[SESSION_MOST + 1]; /* after each operation */
    int operations;
    const char *operation;
} fuzz_session;

/* Calls of the public API, in all sessions of the process. */
extern uint64_t fuzz_calls_made;

/* Says what is wrong, and ends the process: a fuzzer keeps the input. */
__attribute__((format(printf, 2, 3))) _Noreturn void fuzz_fail(const fuzz_session *s,
                                                               const char *format, ...);

/* ---- session.c ---- */

/* Takes the settings from the first bytes, and makes the world. */
void session_open(fuzz_session *s, const uint8_t *data, size_t size, bool second);
/* Ends all that is left, and asks whether every begin had its end and all memory came back. */
void session_close(fuzz_session *s);
/* The bytes are used up, or enough was played. */
bool session_over(const fuzz_session *s);
/* Goes on in another world, restored from a snapshot of the present one. */
void session_replace_world(fuzz_session *s);
/* Queries, reports and a snapshot, which change nothing. */
void session_question(fuzz_session *s);

/* ---- population.c ---- */

/* What stands in the world from the start. */
void session_populate(fuzz_session *s, int kind);

/* ---- script.c: callbacks ---- */

/* Rules and filter of the session's worlds, for another one. */
void session_take_filter(fuzz_session *s, thud_world *world);
thud_filter_fn session_filter;
thud_prologue_fn session_prologue;
thud_epilogue_fn session_epilogue;
thud_prologue_all_fn session_prologue_all;
thud_epilogue_all_fn session_epilogue_all;
thud_overlap_fn session_overlap;
thud_cast_fn session_cast;
thud_mover_pass_fn session_pass;
/* Plays something of the table within a callback, now and then. */
void session_ask(fuzz_session *s);

/* ---- operations.c ---- */

/* Plays the operation that the next byte means. */
void session_play(fuzz_session *s);

#endif
