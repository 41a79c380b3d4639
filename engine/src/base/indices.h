/* indices.h: indices that are types of their own, because each is a small number and what takes
 * one would take any other: the awake slot and the index of a body. */
#ifndef TD_INDICES_H
#define TD_INDICES_H

#include "base/memory.h"

/* The place of a body that moves in the dense arrays of awake_arrays.h. Slot 0 is a dummy at rest;
 * a body without a slot has TD_NONE. */
typedef struct td_awake_slot {
    int32_t at;
} td_awake_slot;

/* The place of a body's record in thud_world.bodies and of its pose: the same all its life, and
 * that of another body afterwards. */
typedef struct td_body_index {
    int32_t at;
} td_body_index;

static inline bool td_same_body(td_body_index a, td_body_index b) {
    return a.at == b.at;
}

static inline td_awake_slot td_slot_in(const td_array *list, int i) {
    return *TD_AT(td_awake_slot, list, i);
}

static inline td_body_index td_body_in(const td_array *list, int i) {
    return *TD_AT(td_body_index, list, i);
}

/* Both append to a list with room reserved. */
static inline void td_push_slot(td_array *list, td_awake_slot slot) {
    TD_PUSH(td_awake_slot, list) = slot;
}

static inline void td_push_body(td_array *list, td_body_index body) {
    TD_PUSH(td_body_index, list) = body;
}

#endif
