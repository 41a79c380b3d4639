/* handles.h: converts handles to indices of slots and back, and refuses calls: every refusal goes
 * through td_refuse, so that the world's log gets its reason.
 *
 * A handle consists of two numbers: the index of a slot plus 1, so that zero names nothing, and the
 * slot's generation plus a number of the world's own (td_tag). The generation rises when the slot
 * is freed, so that stale handles are recognised. */
#ifndef TD_HANDLES_H
#define TD_HANDLES_H

#include "base/reason.h"
#include "state/world.h"

/* Passes result and message to the world's log hook, and returns the result. The world may be null,
 * which has no log. */
thud_result td_refuse(const thud_world *w, thud_result result, const char *message);
/* THUD_OK where low <= x <= high; otherwise THUD_ERROR_INVALID, after the log has got name, number
 * and range. td_check_above_0 checks 0 < x <= high, td_check_finite that three numbers are finite.
 */
thud_result td_check(const thud_world *w, const char *name, double x, double low, double high);
thud_result td_check_above_0(const thud_world *w, const char *name, double x, double high);
thud_result td_check_finite(const thud_world *w, const char *name, float x, float y, float z);

/* Sets *index to the slot of a live body or shape. THUD_ERROR_NULL for a null world;
 * THUD_ERROR_STALE, refused, for a handle that names nothing. */
thud_result td_find_body(const thud_world *w, thud_body_id id, td_body_index *index);
thud_result td_find_shape(const thud_world *w, thud_shape_id id, int *index);

/* The generation in handles: the slot's, plus the world's number times 2^32 over the golden ratio,
 * modulo 2^32, so that handles of another world are stale here. Such multiples spread evenly
 * (Fibonacci hashing; D. Knuth, "The Art of Computer Programming", vol. 3, 6.4): any two of n
 * worlds are at least 2^32 / (2.24 n) generations apart (2.24: about the square root of 5). */
static inline uint32_t td_tag(const thud_world *w, uint32_t generation) {
    return generation + w->number * 0x9e3779b9u;
}

static inline thud_body_id td_body_handle(const thud_world *w, td_body_index index) {
    return (thud_body_id){(uint32_t)index.at + 1, td_tag(w, td_body_at(w, index)->generation)};
}

static inline thud_shape_id td_shape_handle(const thud_world *w, int index) {
    return (thud_shape_id){(uint32_t)index + 1, td_tag(w, td_shape_at(w, index)->generation)};
}

/* Checks the arguments of a list: refuses null pointers and a negative capacity. `out` may be null
 * where capacity is 0. */
static inline thud_result td_list_check(const thud_world *w, const void *out, int capacity,
                                        const int *count) {
    if (!w || !count || (!out && capacity > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "list: world, out or count is null");
    }
    return capacity >= 0 ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, "list: capacity is negative");
}

#endif
