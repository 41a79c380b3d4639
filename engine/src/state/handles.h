/* handles.h: from handles to slots and back, and the one way to refuse a call. */
#ifndef TD_HANDLES_H
#define TD_HANDLES_H

#include "base/reason.h"
#include "state/world.h"

/* Tells the log hook, and returns `result`. The world may be null. */
thud_result td_refuse(const thud_world *w, thud_result result, const char *message);
/* THUD_OK where low <= x <= high, otherwise THUD_ERROR_INVALID, of which the log hears name, number
 * and range. Likewise where 0 < x <= high, and where three numbers are finite. */
thud_result td_check(const thud_world *w, const char *name, double x, double low, double high);
thud_result td_check_above_0(const thud_world *w, const char *name, double x, double high);
thud_result td_check_finite(const thud_world *w, const char *name, float x, float y, float z);

/* THUD_ERROR_NULL or THUD_ERROR_STALE through td_refuse; *index is the slot. */
thud_result td_find_body(const thud_world *w, thud_body_id id, td_body_index *index);
thud_result td_find_shape(const thud_world *w, thud_shape_id id, int *index);

/* The world's number in the generation keeps another world's handles out. Multiples of 2^32 over
 * the golden ratio stay as far from each other as so many can: of n worlds none is nearer than 2^32
 * / 2.24 n generations to another. */
static inline uint32_t td_tag(const thud_world *w, uint32_t generation) {
    return generation + w->number * 0x9e3779b9u;
}

static inline thud_body_id td_body_handle(const thud_world *w, td_body_index index) {
    return (thud_body_id){(uint32_t)index.at + 1, td_tag(w, td_body_at(w, index)->generation)};
}

static inline thud_shape_id td_shape_handle(const thud_world *w, int index) {
    return (thud_shape_id){(uint32_t)index + 1, td_tag(w, td_shape_at(w, index)->generation)};
}

#endif
