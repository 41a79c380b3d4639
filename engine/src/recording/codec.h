/* codec.h: the arguments of recorded calls as bytes, field by field, by tables that
 * tools/recorded.py makes of the public headers (recorded_calls.c). Padding, pointers and sizes of
 * the machine do not get into a recording. */
#ifndef TD_CODEC_H
#define TD_CODEC_H

#include "recording/stream.h"
#include "state/world.h"
#include "thud/thud_mover.h"
#include "thud/thud_recording.h"

/* What a field or an argument is. */
typedef enum td_code {
    TD_CODE_BOOL,
    TD_CODE_INT32, /* enums too */
    TD_CODE_UINT32,
    TD_CODE_INT64,
    TD_CODE_UINT64,
    TD_CODE_FLOAT,
    TD_CODE_DOUBLE,
    TD_CODE_HANDLE, /* of a body, shape or joint; without the tag of the world (td_tag) */
    TD_CODE_COOKIE, /* that of a def, which the call has accepted */
    TD_CODE_STRUCT,
    TD_CODE_POINTER,   /* to one struct, or null */
    TD_CODE_ARRAY,     /* of `count_at` elements, or null */
    TD_CODE_POINTS,    /* thud_terrain.points, which a flat line does not have */
    TD_CODE_NAME,      /* const char * */
    TD_CODE_DETECTION, /* const thud_detection *, by its rank */
    TD_CODE_ISLANDS,   /* const thud_island_solver * */
    TD_CODE_PASS,      /* thud_mover_pass_fn *: whether there is one */
    TD_CODE_NOTHING,   /* not recorded: contexts */
    /* Arguments alone. */
    TD_CODE_LISTENERS,   /* const thud_listeners *: which there are */
    TD_CODE_FILTER,      /* thud_filter_fn *: whether there is one */
    TD_CODE_STEP_CALLS,  /* const thud_step_calls *: which there are */
    TD_CODE_CONTACT,     /* const thud_contact *: its place among those asked about */
    TD_CODE_OUT_HANDLE,  /* a handle that the call returns */
    TD_CODE_OUT_HANDLES, /* an array of `count_at` of them */
    TD_CODE_OUT          /* what else it returns */
} td_code;

typedef struct td_codec_field td_codec_field;

/* A type: its fields, or one field for a type without. */
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
    const td_codec *codec; /* of structs, and of what is pointed to */
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
} td_recorded_call;

/* Which callbacks there are: bits of TD_CODE_LISTENERS, and what else a world calls. */
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

/* Arguments that are passed by pointer to the variable that holds them: args[i] is the address of
 * argument i after the world. */
void td_codec_write(const thud_world *w, td_writer *to, const td_recorded_call *call,
                    const void *const *args);
/* What the call has returned: its handles. */
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
    struct td_decoded_block *blocks; /* structs, and what pointers point to */
    thud_mover_pass_fn *pass;        /* what TD_CODE_PASS becomes */
    unsigned calls;                  /* bits of TD_CODE_LISTENERS, _FILTER, _STEP_CALLS */
    uint32_t without;                /* thud_listeners.without */
    int listed;                      /* handles in the array of TD_CODE_OUT_HANDLES */
    bool short_of_memory;
} td_decoded;

/* Decodes the arguments of a call. False where the bytes are no arguments of it, or memory is
 * short; td_decoded_free is due in any case. */
bool td_codec_read(const thud_world *w, td_reader *from, const td_recorded_call *call,
                   td_decoded *out);
/* Reads the handles that the call returned when it was recorded; whether they are those that it
 * has returned now. */
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
