/* api.h: the flat C layer between JavaScript and the public API of thud.
 *
 * JavaScript passes and receives numbers. Whatever does not fit into arguments and one return
 * value goes through `api_slots`; slots.h names them for both sides. Handles travel as two numbers,
 * index1 and generation, and thud itself refuses stale ones. Lists of any length go through growing
 * buffers that belong to this layer and stay valid until the next call that fills the same buffer.
 */
#ifndef API_H
#define API_H

#include <thud/thud.h>

#include "slots.h"

extern union api_slots api_slots;

/* A list that grows; `failed` says that memory was short and items are missing. */
typedef struct api_buffer {
    char *data;
    size_t bytes, capacity;
    bool failed;
} api_buffer;

void api_buffer_clear(api_buffer *buffer);
void api_buffer_push(api_buffer *buffer, const void *item, size_t bytes);
thud_result api_buffer_result(const api_buffer *buffer);

/* A world def from the world_options in the slots, with this layer's log and clock. */
thud_world_def api_world_def(void);

/* In the order of the package's names; null, which is the default, for other numbers. */
const thud_detection *api_detection(double number);

/* Doubles from JavaScript may be anything; a plain cast traps on what does not fit. Bits may be
 * those of a negative number, such as ~4 is there. */
int api_to_int(double value);
uint32_t api_to_u32(double value);

/* The engine's own, as the C library's would double the bytes for it. Angles beyond its range give
 * not-a-number, which every call of thud refuses. */
void api_sincos(double angle, double *s, double *c);

thud_query_filter api_filter(const struct filter_options *options);

/* A query's or mover's shape about the origin. */
thud_shape_instance api_placed(int kind, double hx, double hy, double angle);

static inline thud_body_id api_body(uint32_t index1, uint32_t generation) {
    return (thud_body_id){index1, generation};
}

static inline thud_shape_id api_shape(uint32_t index1, uint32_t generation) {
    return (thud_shape_id){index1, generation};
}

#endif
