/* codec.c: see codec.h. */
#include "recording/codec.h"

#include "listeners/listeners.h"
#include "state/handles.h"
#include "thud/thud_all.h"

#include <string.h>

/* The byte that a pointer is recorded as: null, or not. What it points to follows, but not for
 * TD_CODE_ISLANDS, _PASS and _FILTER. */
enum { POINTS_NOWHERE, POINTS };

/* ---- single values ---- */

static uint64_t bits_at(const char *at, size_t bytes) {
    uint32_t four;
    uint64_t bits;
    if (bytes == sizeof four) {
        memcpy(&four, at, sizeof four);
        return four;
    }
    memcpy(&bits, at, sizeof bits);
    return bits;
}

static int int_at(const void *at) {
    int value;
    memcpy(&value, at, sizeof value);
    return value;
}

static const void *pointer_at(const void *at) {
    const void *pointer;
    memcpy(&pointer, at, sizeof pointer);
    return pointer;
}

/* Writes a handle. Its generation is written without the tag of the world (td_tag): it is then a
 * small number, which takes few bytes, and is the same when another world plays the recording. A
 * null handle has no tag. */
static void write_handle(const thud_world *w, td_writer *to, const char *at) {
    thud_body_id id;
    memcpy(&id, at, sizeof id);
    td_write_count(to, id.index1);
    td_write_count(to, id.index1 ? id.generation - td_tag(w, 0) : id.generation);
}

static thud_body_id read_handle(const thud_world *w, td_reader *from) {
    thud_body_id id = {(uint32_t)td_read_count(from), (uint32_t)td_read_count(from)};
    id.generation += id.index1 ? td_tag(w, 0) : 0;
    return id;
}

static const thud_detection *detection_of(unsigned number) {
    static const thud_detection *const all[] = {NULL, &thud_detection_overlap,
                                                &thud_detection_continuous, &thud_detection_bisect,
                                                &thud_detection_swept};
    return number < sizeof all / sizeof *all ? all[number] : NULL;
}

static unsigned number_of(const thud_detection *detection) {
    unsigned number = 0;
    while (detection && detection_of(number) != detection) {
        number++;
    }
    return number;
}

/* The bits TD_CALLS_... of the listeners that are set. */
static unsigned listener_bits(const thud_listeners *l) {
    return (l->prologue ? TD_CALLS_PROLOGUE : 0u) | (l->epilogue ? TD_CALLS_EPILOGUE : 0u) |
           (l->prologue_all ? TD_CALLS_PROLOGUE_ALL : 0u) |
           (l->epilogue_all ? TD_CALLS_EPILOGUE_ALL : 0u);
}

/* ---- writing ---- */

static void write_fields(const thud_world *w, td_writer *to, const td_codec *codec,
                         const char *struct_at);

/* A string, its length first; null is the empty one. */
static void write_name(td_writer *to, const char *name) {
    size_t length = name ? strlen(name) : 0;
    td_write_count(to, length);
    td_write_bytes(to, name, length);
}

/* Writes `count` elements that a pointer points to, or that the pointer is null. */
static void write_elements(const thud_world *w, td_writer *to, const td_codec *codec,
                           const char *elements, int count) {
    td_write_byte(to, elements ? POINTS : POINTS_NOWHERE);
    for (int i = 0; elements && i < count; i++) {
        write_fields(w, to, codec, elements + (size_t)i * codec->bytes);
    }
}

/* Writes the value of field `f`, which is at `at`. Of an array the number of elements is at
 * `count_at`. */
static void write_value(const thud_world *w, td_writer *to, const td_codec_field *f, const char *at,
                        const char *count_at) {
    switch ((td_code)f->code) {
    case TD_CODE_BOOL:
        td_write_byte(to, *at != 0);
        break;
    case TD_CODE_INT32:
        td_write_integer(to, int_at(at));
        break;
    case TD_CODE_UINT32:
        td_write_count(to, bits_at(at, sizeof(uint32_t)));
        break;
    case TD_CODE_INT64:
        td_write_integer(to, (int64_t)bits_at(at, sizeof(int64_t)));
        break;
    case TD_CODE_UINT64:
        td_write_count(to, bits_at(at, sizeof(uint64_t)));
        break;
    case TD_CODE_FLOAT:
        td_write_number(to, bits_at(at, sizeof(float)), sizeof(float));
        break;
    case TD_CODE_DOUBLE:
        td_write_number(to, bits_at(at, sizeof(double)), sizeof(double));
        break;
    case TD_CODE_HANDLE:
        write_handle(w, to, at);
        break;
    case TD_CODE_STRUCT:
        write_fields(w, to, f->codec, at);
        break;
    case TD_CODE_POINTER:
        write_elements(w, to, f->codec, pointer_at(at), 1);
        break;
    case TD_CODE_ARRAY:
    case TD_CODE_POINTS:
        write_elements(w, to, f->codec, pointer_at(at), int_at(count_at));
        break;
    case TD_CODE_NAME:
        write_name(to, pointer_at(at));
        break;
    case TD_CODE_DETECTION:
        td_write_byte(to, number_of(pointer_at(at)));
        break;
    case TD_CODE_ISLANDS:
    case TD_CODE_PASS:
    case TD_CODE_FILTER:
        td_write_byte(to, pointer_at(at) ? POINTS : POINTS_NOWHERE);
        break;
    case TD_CODE_LISTENERS: {
        const thud_listeners *listeners = pointer_at(at);
        td_write_byte(to, listeners ? listener_bits(listeners) : 0);
        td_write_count(to, listeners ? listeners->without : 0);
        break;
    }
    case TD_CODE_STEP_CALLS: {
        const thud_step_calls *calls = pointer_at(at);
        unsigned bits =
            calls ? (calls->before ? TD_CALLS_BEFORE : 0u) | (calls->after ? TD_CALLS_AFTER : 0u)
                  : 0;
        td_write_byte(to, bits);
        break;
    }
    case TD_CODE_CONTACT: {
        const thud_contact *contact = pointer_at(at);
        td_write_count(to, (uint64_t)(contact - w->listeners->asked.contacts));
        break;
    }
    case TD_CODE_COOKIE:
    case TD_CODE_NOTHING:
    case TD_CODE_OUT_HANDLE:
    case TD_CODE_OUT_HANDLES:
    case TD_CODE_OUT:
        break;
    }
}

static bool is_array(const td_codec_field *f) {
    return f->code == TD_CODE_ARRAY || f->code == TD_CODE_POINTS;
}

static void write_fields(const thud_world *w, td_writer *to, const td_codec *codec,
                         const char *struct_at) {
    for (int i = 0; i < codec->count; i++) {
        const td_codec_field *f = &codec->fields[i];
        const char *count_at = struct_at + f->count_at;
        for (int k = 0; k < f->repeat && !is_array(f); k++) {
            write_value(w, to, f, struct_at + f->at + (size_t)k * td_codec_element_bytes(f),
                        count_at);
        }
    }
    /* Arrays come after all other fields, so that a reader knows the number of their elements
     * before it reads them. */
    for (int i = 0; i < codec->count; i++) {
        const td_codec_field *f = &codec->fields[i];
        const char *count_at = struct_at + f->count_at;
        /* The points of a flat line are not read, and may be anything. */
        if (f->code == TD_CODE_POINTS &&
            ((const thud_terrain *)(const void *)struct_at)->kind == THUD_TERRAIN_FLAT) {
            td_write_byte(to, POINTS_NOWHERE);
        } else if (is_array(f)) {
            write_value(w, to, f, struct_at + f->at, count_at);
        }
    }
}

void td_codec_write(const thud_world *w, td_writer *to, const td_recorded_call *call,
                    const void *const *args) {
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        if (!is_array(f)) {
            write_value(w, to, f, args[i], args[f->count_at]);
        }
    }
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        if (is_array(f)) {
            write_value(w, to, f, args[i], args[f->count_at]);
        }
    }
}

void td_codec_write_outs(const thud_world *w, td_writer *to, const td_recorded_call *call,
                         const void *const *args) {
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        if (f->code == TD_CODE_OUT_HANDLE || f->code == TD_CODE_OUT_HANDLES) {
            const char *handles = pointer_at(args[i]);
            int count = f->code == TD_CODE_OUT_HANDLES ? int_at(args[f->count_at]) : 1;
            td_write_byte(to, handles ? POINTS : POINTS_NOWHERE);
            for (int k = 0; handles && k < count; k++) {
                write_handle(w, to, handles + (size_t)k * sizeof(thud_body_id));
            }
        }
    }
}

/* ---- reading ---- */

/* A block of decoded memory, with its head before it. */
typedef struct td_decoded_block {
    struct td_decoded_block *next;
    size_t bytes; /* of the block, this head included */
} td_decoded_block;

enum { BLOCK_HEAD = 64 }; /* bytes before a block, which keep it aligned */
_Static_assert(sizeof(td_decoded_block) <= BLOCK_HEAD, "the head has room");

/* Returns zeroed memory for decoded values, which td_decoded_free frees; null when memory is short.
 */
static char *take_block(td_decoded *d, size_t bytes) {
    td_decoded_block *block = td_memory_get(d->memory, BLOCK_HEAD + bytes);
    if (!block) {
        d->short_of_memory = true;
        return NULL;
    }
    *block = (td_decoded_block){d->blocks, BLOCK_HEAD + bytes};
    d->blocks = block;
    return (char *)block + BLOCK_HEAD;
}

void td_decoded_free(td_decoded *d) {
    while (d->blocks) {
        td_decoded_block *block = d->blocks;
        d->blocks = block->next;
        td_memory_put(d->memory, block, block->bytes);
    }
}

static bool read_fields(const thud_world *w, td_reader *from, const td_codec *codec,
                        char *struct_at, td_decoded *d);

/* Reads what write_elements has written, into new memory. Returns the elements; null for a null
 * pointer, and where they cannot be read. */
static char *read_elements(const thud_world *w, td_reader *from, const td_codec *codec,
                           int64_t count, td_decoded *d) {
    if (td_read_byte(from) != POINTS) {
        return NULL;
    }
    /* Every element takes at least one byte. So a count above the number of bytes left is damaged,
     * and no memory is reserved for it. */
    if (count < 0 || (uint64_t)count > from->end - from->at) {
        from->broken = true;
        return NULL;
    }
    char *elements = take_block(d, (size_t)count * codec->bytes + 1);
    for (int64_t i = 0; elements && i < count; i++) {
        if (!read_fields(w, from, codec, elements + (size_t)i * codec->bytes, d)) {
            return NULL;
        }
    }
    return elements;
}

/* Reads the name of a quality. A world keeps the pointer to this name, so only the names of the
 * engine's own qualities, which are constants, are restored. Any other name becomes "recorded": the
 * text in the recording may be freed before the world is. */
static const char *read_name(td_reader *from) {
    static const thud_quality *const known[] = {&thud_quality_draft, &thud_quality_default,
                                                &thud_quality_high, &thud_quality_exact};
    uint64_t length = td_read_count(from);
    const uint8_t *text = td_read_bytes(from, length);
    for (size_t i = 0; text && i < sizeof known / sizeof *known; i++) {
        const char *name = known[i]->name;
        if (length == strlen(name) && memcmp(text, name, (size_t)length) == 0) {
            return name;
        }
    }
    return "recorded";
}

static void put_pointer(char *at, const void *pointer) {
    memcpy(at, &pointer, sizeof pointer);
}

/* Reads a value to `at`. Arrays are left null: read_array reads them after all other fields, when
 * the number of their elements is known. */
static void read_value(const thud_world *w, td_reader *from, const td_codec_field *f, char *at,
                       td_decoded *d) {
    switch ((td_code)f->code) {
    case TD_CODE_BOOL: {
        bool value = td_read_byte(from) != 0;
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_INT32: {
        int32_t value = (int32_t)td_read_integer(from);
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_UINT32: {
        uint32_t value = (uint32_t)td_read_count(from);
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_INT64: {
        int64_t value = td_read_integer(from);
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_UINT64: {
        uint64_t value = td_read_count(from);
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_FLOAT: {
        uint32_t value = (uint32_t)td_read_number(from, sizeof(float));
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_DOUBLE: {
        uint64_t value = td_read_number(from, sizeof(double));
        memcpy(at, &value, sizeof value);
        break;
    }
    case TD_CODE_HANDLE: {
        thud_body_id id = read_handle(w, from);
        memcpy(at, &id, sizeof id);
        break;
    }
    case TD_CODE_COOKIE: {
        uint32_t cookie = TD_COOKIE;
        memcpy(at, &cookie, sizeof cookie);
        break;
    }
    case TD_CODE_STRUCT:
        read_fields(w, from, f->codec, at, d);
        break;
    case TD_CODE_POINTER:
        put_pointer(at, read_elements(w, from, f->codec, 1, d));
        break;
    case TD_CODE_NAME:
        put_pointer(at, read_name(from));
        break;
    case TD_CODE_DETECTION:
        put_pointer(at, detection_of(td_read_byte(from)));
        break;
    case TD_CODE_ISLANDS:
        put_pointer(at, td_read_byte(from) == POINTS ? &thud_islands_direct : NULL);
        break;
    case TD_CODE_PASS: {
        thud_mover_pass_fn *pass = td_read_byte(from) == POINTS ? d->pass : NULL;
        memcpy(at, &pass, sizeof pass);
        break;
    }
    case TD_CODE_LISTENERS:
        d->calls = td_read_byte(from);
        d->without = (uint32_t)td_read_count(from);
        break;
    case TD_CODE_FILTER:
    case TD_CODE_STEP_CALLS:
        d->calls = td_read_byte(from);
        break;
    case TD_CODE_CONTACT: {
        uint64_t number = td_read_count(from);
        const td_question *asked = w->listeners ? &w->listeners->asked : NULL;
        bool known = asked && number < (uint64_t)asked->count;
        put_pointer(at, known ? &asked->contacts[number] : NULL);
        break;
    }
    case TD_CODE_OUT_HANDLE:
        put_pointer(at, take_block(d, sizeof(thud_body_id)));
        break;
    case TD_CODE_ARRAY:
    case TD_CODE_POINTS:
    case TD_CODE_OUT_HANDLES:
    case TD_CODE_NOTHING:
    case TD_CODE_OUT:
        put_pointer(at, NULL);
        break;
    }
}

static bool read_fields(const thud_world *w, td_reader *from, const td_codec *codec,
                        char *struct_at, td_decoded *d) {
    for (int i = 0; i < codec->count; i++) {
        const td_codec_field *f = &codec->fields[i];
        for (int k = 0; k < f->repeat; k++) {
            read_value(w, from, f, struct_at + f->at + (size_t)k * td_codec_element_bytes(f), d);
        }
    }
    for (int i = 0; i < codec->count; i++) {
        const td_codec_field *f = &codec->fields[i];
        if (is_array(f)) {
            int count = int_at(struct_at + f->count_at);
            put_pointer(struct_at + f->at, read_elements(w, from, f->codec, count, d));
        }
    }
    return !from->broken && !d->short_of_memory;
}

bool td_codec_read(const thud_world *w, td_reader *from, const td_recorded_call *call,
                   td_decoded *out) {
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        bool is_struct = f->code == TD_CODE_STRUCT;
        char *at = is_struct ? take_block(out, f->codec->bytes) : (char *)&out->values[i];
        out->args[i] = at;
        if (at) {
            read_value(w, from, f, at, out);
        }
    }
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        int count =
            is_array(f) || f->code == TD_CODE_OUT_HANDLES ? int_at(out->args[f->count_at]) : 0;
        if (is_array(f)) {
            out->values[i].pointer = read_elements(w, from, f->codec, count, out);
        } else if (f->code == TD_CODE_OUT_HANDLES) {
            /* The call returns one handle for each shape that it was given; the number of shapes
             * has been read before. */
            out->listed = from->broken ? 0 : td_max_int(count, 0);
            out->values[i].pointer =
                take_block(out, (size_t)out->listed * sizeof(thud_body_id) + 1);
        }
    }
    return !from->broken && !out->short_of_memory;
}

bool td_codec_same_outs(const thud_world *w, td_reader *from, const td_recorded_call *call,
                        const td_decoded *d) {
    bool same = true;
    for (int i = 0; i < call->count; i++) {
        const td_codec_field *f = &call->arguments[i];
        if ((f->code != TD_CODE_OUT_HANDLE && f->code != TD_CODE_OUT_HANDLES) ||
            td_read_byte(from) != POINTS) {
            continue;
        }
        const thud_body_id *made = d->values[i].pointer;
        int count = f->code == TD_CODE_OUT_HANDLES ? d->listed : 1;
        for (int k = 0; k < count; k++) {
            thud_body_id id = read_handle(w, from);
            same &= id.index1 == made[k].index1 && id.generation == made[k].generation;
        }
    }
    return same && !from->broken;
}
