/* recording.h: the format of a recording (thud_recording.h), which recorder.c writes and player.c
 * reads:
 *
 *     head      MAGIC, version (4 bytes)
 *     segment   kind (1 byte), number (4), steps recorded before it (8), length (8),
 *               contents, checksum of all of these (8: td_stream_sum)
 *     ...       numbers rise by one. The first segment is a TD_SEGMENT_KEYFRAME, the last one is
 *               the TD_SEGMENT_END, with the hash of the world (8), or empty (salvaged)
 *
 * A keyframe is the def of the world, the listeners that it has, and its snapshot, packed: nothing
 * before it is needed to play on from there. A TD_SEGMENT_CALLS has the length of its records and
 * then the records, compressed (repeats.h), each of which begins with a byte: a td_record, or
 * TD_RECORD_CALL plus the number of a call (recorded_calls.h), after which its arguments and the
 * handles that it returned follow, or what it found if it is a query. A call within which callbacks
 * made calls, or gave answers that are not the usual ones, is
 *
 *     TD_RECORD_OPEN, number of the call, arguments
 *         TD_RECORD_CALLBACK, how many callbacks after the last one that has a record
 *             records of the calls that it made
 *         TD_RECORD_ANSWER, the answer (record_callbacks.c)
 *         ...
 *     TD_RECORD_CLOSE, handles that the call returned
 *
 * so that callbacks that change nothing take no bytes. */
#ifndef TD_RECORDING_H
#define TD_RECORDING_H

#include "recording/codec.h"
#include "recording/stream.h"

#define TD_RECORDING_MAGIC "thudrec"

enum {
    TD_RECORDING_VERSION = 1, /* to be raised whenever the meaning of the bytes changes */
    TD_RECORDING_HEAD = 12,   /* bytes of the head */
    TD_SEGMENT_HEAD = 21,     /* bytes before the contents of a segment */
    TD_SEGMENT_SUM = 8        /* bytes after them */
};

/* Kinds of segments. */
enum { TD_SEGMENT_KEYFRAME = 'K', TD_SEGMENT_CALLS = 'C', TD_SEGMENT_END = 'E' };

typedef enum td_record {
    TD_RECORD_STEPS,     /* a number of steps, with no other calls between them */
    TD_RECORD_HASH,      /* the hash of the world */
    TD_RECORD_BODIES,    /* as TD_RECORD_HASH, then the number of body slots, and 16 bits for each
                            (td_recording_body_hash) */
    TD_RECORD_STATE,     /* the world was restored: a snapshot, packed */
    TD_RECORD_LISTENERS, /* the world has these callbacks from now on: TD_CALLS_...,
                            thud_listeners.without */
    TD_RECORD_CHUNK,     /* name and bytes of the caller */
    TD_RECORD_REFUSED,   /* a call that was refused, and its result */
    TD_RECORD_LOCKED,    /* the call that follows was made inside a callback of a call that is not
                            recorded: a query, cast or drawing */
    TD_RECORD_OPEN,
    TD_RECORD_CALLBACK,
    TD_RECORD_ANSWER,
    TD_RECORD_CLOSE,
    TD_RECORD_CALL = 16
} td_record;

/* Bits of the answer of a prologue about a contact: whether the pair collides, and whether
 * friction, restitution and surface speed follow. */
enum { TD_ANSWER_YES = 1, TD_ANSWER_SETTINGS = 2 };

/* A hash of a body's pose and velocity, 16 bits; 0 for a free slot. */
uint16_t td_recording_body_hash(const thud_world *w, td_body_index body);
/* Writes and reads the fields of a world's def that a keyframe contains: those without a setter,
 * which snapshot and world must agree on. Reading replaces these fields in *def, which begins as
 * the default def. */
void td_recording_write_def(td_writer *to, const thud_world *w);
bool td_recording_read_def(td_reader *from, thud_world_def *def);

#endif
