/* api_base.c: the slots, growing buffers, and conversions of numbers; api.h describes them. */
#include "api.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

union api_slots api_slots;

/* The address at which JavaScript finds the slots. */
double *api_slots_address(void) {
    return api_slots.all;
}

/* The text of a thud_result. */
const char *api_result_text(int result) {
    return thud_result_text((thud_result)result);
}

/* The name of a stage of a step, by its number. */
const char *api_stage_name(int stage) {
    return thud_stage_name((thud_stage)stage);
}

void api_buffer_clear(api_buffer *buffer) {
    buffer->bytes = 0;
    buffer->failed = false;
}

void api_buffer_push(api_buffer *buffer, const void *item, size_t bytes) {
    if (buffer->bytes + bytes > buffer->capacity) {
        size_t capacity = 2 * buffer->capacity + bytes + 1024;
        char *data = realloc(buffer->data, capacity);
        if (data == NULL) {
            buffer->failed = true;
            return;
        }
        buffer->data = data;
        buffer->capacity = capacity;
    }
    memcpy(buffer->data + buffer->bytes, item, bytes);
    buffer->bytes += bytes;
}

thud_result api_buffer_result(const api_buffer *buffer) {
    return buffer->failed ? THUD_ERROR_MEMORY : THUD_OK;
}

int api_to_int(double value) {
    if (!(value >= -2147483648.0)) /* also true for NaN */
        return INT32_MIN;
    return value >= 2147483647.0 ? INT32_MAX : (int)value;
}

uint32_t api_to_u32(double value) {
    if (value < 0.0 && value >= -2147483648.0)
        return (uint32_t)(int32_t)value;
    if (!(value > 0.0))
        return 0;
    return value >= 4294967295.0 ? UINT32_MAX : (uint32_t)value;
}

void api_sincos(double angle, double *s, double *c) {
    if (thud_sincos(angle, s, c) != THUD_OK)
        *s = *c = NAN;
}
