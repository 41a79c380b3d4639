/* call_values.c: the arguments of a recorded call as numbers, for people to read. */
#include "recording/codec.h"

#include <string.h>

/* The list of values that is being written. */
typedef struct values {
    thud_call_value *out; /* null: values are only counted */
    int count;
} values;

static void add(values *v, double number, bool handle) {
    if (v->out) {
        v->out[v->count] = (thud_call_value){number, handle};
    }
    v->count++;
}

static const char *pointer_at(const char *at) {
    const char *pointer;
    memcpy(&pointer, at, sizeof pointer);
    return pointer;
}

static void add_fields(values *v, const td_codec *codec, const char *struct_at);

static void add_elements(values *v, const td_codec *codec, const char *elements, int count) {
    for (int i = 0; elements && i < count; i++) {
        add_fields(v, codec, elements + (size_t)i * codec->bytes);
    }
}

/* The value of arithmetic type `type` at the address `at`. */
#define NUMBER_AT(type, at) ((double)*(const type *)(const void *)(at))

/* Adds the value of field `f`, which is at `at`. Of an array the number of elements is at
 * `count_at`. */
static void add_value(values *v, const td_codec_field *f, const char *at, const char *count_at) {
    switch ((td_code)f->code) {
    case TD_CODE_BOOL:
        add(v, *at != 0, false);
        break;
    case TD_CODE_INT32:
        add(v, NUMBER_AT(int32_t, at), false);
        break;
    case TD_CODE_UINT32:
        add(v, NUMBER_AT(uint32_t, at), false);
        break;
    case TD_CODE_INT64:
        add(v, NUMBER_AT(int64_t, at), false);
        break;
    case TD_CODE_UINT64:
        add(v, NUMBER_AT(uint64_t, at), false);
        break;
    case TD_CODE_FLOAT:
        add(v, NUMBER_AT(float, at), false);
        break;
    case TD_CODE_DOUBLE:
        add(v, NUMBER_AT(double, at), false);
        break;
    case TD_CODE_HANDLE: /* handles of all kinds have index1 as their first member */
        add(v, NUMBER_AT(uint32_t, at), true);
        break;
    case TD_CODE_STRUCT:
        add_fields(v, f->codec, at);
        break;
    case TD_CODE_POINTER:
        add_elements(v, f->codec, pointer_at(at), 1);
        break;
    case TD_CODE_ARRAY:
    case TD_CODE_POINTS:
        add_elements(v, f->codec, pointer_at(at), *(const int *)(const void *)count_at);
        break;
    case TD_CODE_COOKIE:
    case TD_CODE_NAME:
    case TD_CODE_DETECTION:
    case TD_CODE_ISLANDS:
    case TD_CODE_PASS:
    case TD_CODE_NOTHING:
    case TD_CODE_LISTENERS:
    case TD_CODE_FILTER:
    case TD_CODE_STEP_CALLS:
    case TD_CODE_CONTACT:
    case TD_CODE_OUT_HANDLE:
    case TD_CODE_OUT_HANDLES:
    case TD_CODE_OUT:
        break;
    }
}

static void add_fields(values *v, const td_codec *codec, const char *struct_at) {
    for (int i = 0; i < codec->count; i++) {
        const td_codec_field *f = &codec->fields[i];
        for (int k = 0; k < f->repeat; k++) {
            add_value(v, f, struct_at + f->at + (size_t)k * td_codec_element_bytes(f),
                      struct_at + f->count_at);
        }
    }
}

int td_call_values(const td_recorded_call *call, const td_decoded *d, thud_call_value *out) {
    values v = {.out = out};
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        add_value(&v, f, d->args[i], d->args[f->count_at]);
    }
    return v.count;
}

uint32_t td_call_returned(const td_recorded_call *call, const td_decoded *d) {
    for (int i = 0; i < call->count; i++) {
        unsigned code = call->arguments[i].code;
        if (code == TD_CODE_OUT_HANDLE || (code == TD_CODE_OUT_HANDLES && d->listed > 0)) {
            return ((const thud_body_id *)d->values[i].pointer)->index1;
        }
    }
    return 0;
}
