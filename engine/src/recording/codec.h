/* codec.h: the arguments of recorded calls as bytes, field by field, by tables that
 * tools/recorded.py makes of the public headers (recorded_calls.c). Padding, pointers and sizes of
 * the machine do not get into a recording. */
#ifndef TD_CODEC_H
#define TD_CODEC_H

#include "recording/stream.h"
#include "state/world.h"
#include "thud/thud_mover.h"
#include "thud/thud_recording.h"

/* The type of a field of a struct, or of an argument of a call. */
typedef enum td_code {
    TD_CODE_BOOL,
    TD_CODE_INT32, /* enums too */
    TD_CODE_UINT32,
    TD_CODE_INT64,
    TD_CODE_UINT64,
    TD_CODE_FLOAT,
    TD_CODE_DOUBLE,
    TD_CODE_HANDLE, /* of a body, shape or joint; without the tag of the world (td_tag) */
    TD_CODE_COOKIE, /* the cookie of a def. Not recorded, since only calls that were accepted are:
                       it was TD_COOKIE */
    TD_CODE_STRUCT,
    TD_CODE_POINTER,   /* to one struct, or null */
    TD_CODE_ARRAY,     /* of `count_at` elements, or null */
    TD_CODE_POINTS,    /* thud_terrain.points, which a flat line does not have */
    TD_CODE_NAME,      /* const char * */
    TD_CODE_DETECTION, /* const thud_detection *: 0 for null, else its rank plus 1 */
    TD_CODE_ISLANDS,   /* const thud_island_solver *: whether there is one; read as
                          thud_islands_direct */
    TD_CODE_PASS,      /* thud_mover_pass_fn *: whether there is one */
    TD_CODE_NOTHING,   /* not recorded: contexts */
    /* For arguments only: */
    TD_CODE_LISTENERS,   /* const thud_listeners *: the bits TD_CALLS_... of those that are set */
    TD_CODE_FILTER,      /* thud_filter_fn *: whether there is one */
    TD_CODE_STEP_CALLS,  /* const thud_step_calls *: the bits of those that are set */
    TD_CODE_CONTACT,     /* const thud_contact *: its index in the array that the prologue was given
                          */
    TD_CODE_OUT_HANDLE,  /* a handle that the call returns */
    TD_CODE_OUT_HANDLES, /* an array of `count_at` handles that the call returns */
    TD_CODE_OUT          /* anything else that the call writes to the caller's memory; not recorded
                          */
} td_code;

typedef struct td_codec_field td_codec_field;

/* The fields of a struct; for any other type one field, which is the value itself. */
typedef struct td_codec {
    const td_codec_field *fields;
    uint16_t count; /* of fields */
    uint16_t bytes; /* of the type */
} td_codec;

struct td_codec_field {
    uint8_t code;
    uint8_t repeat;        /* elements of an array in place; else 1 */
    uint16_t at;           /* offset in the struct; the argument's index */
    uint16_t count_at;     /* offset of the int, or index of the argument, that counts elements */
    const td_codec *codec; /* for a struct its type; for a pointer the type it points to */
};

/* The size of one element of a field that is an array in place. */
static inline size_t td_codec_element_bytes(const td_codec_field *f) {
    return f->codec ? f->codec->bytes : sizeof(thud_body_id);
}

/* A function of the API. */
typedef struct td_recorded_call {
    const char *name;
    const td_codec_field *arguments; /* those after the world */
    uint8_t count;
    bool query; /* it changes nothing: not made again by a player, which tells what was found */
} td_recorded_call;

/* Callbacks of a world that are set: bits of TD_RECORD_LISTENERS and of keyframes.
 * TD_CODE_LISTENERS has the first four only. */
enum {
    TD_CALLS_PROLOGUE = 1,
    TD_CALLS_EPILOGUE = 2,
    TD_CALLS_PROLOGUE_ALL = 4,
    TD_CALLS_EPILOGUE_ALL = 8,
    TD_CALLS_FILTER = 16,
    TD_CALLS_OBJECTS = 32 /* epilogues of bodies and categories */
};

/* Bits of TD_CODE_STEP_CALLS. */
enum { TD_CALLS_BEFORE = 1, TD_CALLS_AFTER = 2 };

/* Writes the arguments of a call: args[i] is the address of a variable that holds argument i,
 * counted after the world. */
void td_codec_write(const thud_world *w, td_writer *to, const td_recorded_call *call,
                    const void *const *args);
/* Writes the handles that the call has returned. */
void td_codec_write_outs(const thud_world *w, td_writer *to, const td_recorded_call *call,
                         const void *const *args);

enum { TD_ARGUMENTS_MAX = 6 }; /* of a call, after the world */

/* Decoded arguments, in memory of their own. */
typedef struct td_decoded {
    td_memory *memory;
    const void *args[TD_ARGUMENTS_MAX]; /* as td_codec_write takes them */
    union {
        const void *pointer;
        thud_body_id handle;
        double number;
        uint64_t bits;
    } values[TD_ARGUMENTS_MAX];      /* arguments that are no structs */
    struct td_decoded_block *blocks; /* memory of structs and of all that pointers point to */
    thud_mover_pass_fn *pass;        /* the callback that the player passes for a TD_CODE_PASS */
    unsigned calls;                  /* bits of TD_CODE_LISTENERS, _FILTER, _STEP_CALLS */
    uint32_t without;                /* thud_listeners.without */
    int listed;                      /* handles in the array of TD_CODE_OUT_HANDLES */
    bool short_of_memory;
} td_decoded;

/* Decodes the arguments of a call. False if the bytes cannot be arguments of this call, or memory
 * is short. The caller must call td_decoded_free in any case. */
bool td_codec_read(const thud_world *w, td_reader *from, const td_recorded_call *call,
                   td_decoded *out);
/* Reads the handles that the call returned when it was recorded. Returns whether it has returned
 * the same ones now. */
bool td_codec_same_outs(const thud_world *w, td_reader *from, const td_recorded_call *call,
                        const td_decoded *decoded);
void td_decoded_free(td_decoded *decoded);

/* ---- call_values.c ---- */

/* Writes the numbers and handles of decoded arguments (thud_played_call.values) to `out`, unless it
 * is null. Returns how many there are. */
int td_call_values(const td_recorded_call *call, const td_decoded *decoded, thud_call_value *out);
/* The handle that the call has returned, the first one if there are more: its index1, else 0. */
uint32_t td_call_returned(const td_recorded_call *call, const td_decoded *decoded);

#endif
