/* api.h: the C layer between JavaScript and the public API of thud. Its functions api_... are the
 * exports of the wasm module, which web/package/src calls.
 *
 * JavaScript passes and receives numbers. What does not fit into the arguments and the return value
 * goes through `api_slots`, a union of the structs in slots.h, which names the numbers for both
 * sides. The comment "Slots in: x" or "Slots out: x" of a function names the member of `api_slots`
 * that it reads or writes. A function whose name ends in _defaults writes the default options
 * there; JavaScript changes some and then calls the function that reads them. Options are doubles,
 * which may have any value.
 *
 * api_body_set_kind calls thud_body_set_kind, and a reader such as thud_body_get_shapes has the
 * export api_body_shapes, without get.
 *
 * A function that returns int and can fail returns a thud_result. A handle is two numbers, index1
 * and generation; thud itself refuses stale handles. Lists of any length go through growing buffers
 * of this layer, and are valid until the next call that fills the same buffer. */
#ifndef API_H
#define API_H

#include <thud/thud.h>
#include <thud/thud_textured.h>

#include "slots.h"

extern union api_slots api_slots;

/* A list of bytes that grows. `failed`: memory was short, and items are missing. */
typedef struct api_buffer {
    char *data;
    size_t bytes, capacity;
    bool failed;
} api_buffer;

/* Empties a list, and keeps its memory. */
void api_buffer_clear(api_buffer *buffer);
/* Appends `bytes` bytes, or sets `failed`. */
void api_buffer_push(api_buffer *buffer, const void *item, size_t bytes);
/* THUD_ERROR_MEMORY where items are missing, else THUD_OK. */
thud_result api_buffer_result(const api_buffer *buffer);

/* Keeps a message that says why the call is refused, as if thud had logged it. Returns
 * THUD_ERROR_INVALID. */
int api_refuse(const char *message);

/* A world def from the world_options in the slots, with this layer's log and clock. */
thud_world_def api_world_def(void);

#ifdef API_THREADS
/* The job system of all worlds of thud-threads.wasm. */
thud_job_system api_job_system(void);
#endif

/* The detection of an index into DETECTIONS of web/package/src/types.ts; null, which stands for the
 * default, for other numbers. */
const thud_detection *api_detection(double number);

/* Conversions of doubles of any value, on which a plain cast would trap: values out of range give
 * the nearest bound, NaN the smallest int, or 0. api_to_u32 takes negative numbers down to -2^31 as
 * their bits, since ~4 is negative in JavaScript. */
int api_to_int(double value);
uint32_t api_to_u32(double value);

/* Sine and cosine of the engine (thud_sincos): those of the C library would double the bytes of
 * this layer that an angle costs. NaN for |angle| > THUD_ANGLE_MAX, which every call of thud
 * refuses. */
void api_sincos(double angle, double *s, double *c);

/* The filter of a query or a mover. */
thud_query_filter api_filter(const struct filter_options *options);

/* The shape of a query or mover, with its centre at the origin. `hx`: the radius of a circle, or
 * half the width; `hy`: half the height; `angle`: radians, of an OBB. */
thud_geometry api_placed(int kind, double hx, double hy, double angle);

/* The texture of `count` values at `numbers` with the `table_count` entries of its table behind
 * them, as doubles, which become floats in place. `has_table` 0: it has none. */
thud_texture api_texture(double *numbers, int count, int table_count, int has_table, int repeats);

static inline thud_body_id api_body(uint32_t index1, uint32_t generation) {
    return (thud_body_id){index1, generation};
}

static inline thud_shape_id api_shape(uint32_t index1, uint32_t generation) {
    return (thud_shape_id){index1, generation};
}

#endif
