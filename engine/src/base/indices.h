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

static inline td_awake_slot td_slot_in(const td_array *list, int i) {
    return *TD_AT(td_awake_slot, list, i);
}

/* Appends to a list with room reserved. */
static inline void td_push_slot(td_array *list, td_awake_slot slot) {
    TD_PUSH(td_awake_slot, list) = slot;
}

#endif
