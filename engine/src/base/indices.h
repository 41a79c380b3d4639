/* indices.h: the two indices of a body, its awake slot and its body index, as types of their own,
 * so that the compiler refuses one in place of the other. */
#ifndef TD_INDICES_H
#define TD_INDICES_H

#include "base/memory.h"

/* The index of an awake body in the dense arrays of state/awake_arrays.h. It changes as bodies fall
 * asleep. Slot 0 is a dummy at rest; a body without a slot has TD_NONE. */
typedef struct td_awake_slot {
    int32_t at;
} td_awake_slot;

/* The index of a body's record in thud_world.bodies, and of its pose. It does not change during the
 * body's life, and is used again for another body afterwards. */
typedef struct td_body_index {
    int32_t at;
} td_body_index;

static inline bool td_same_body(td_body_index a, td_body_index b) {
    return a.at == b.at;
}

/* Element i of a list of awake slots, and of a list of body indices. */
static inline td_awake_slot td_slot_in(const td_array *list, int i) {
    return *TD_AT(td_awake_slot, list, i);
}

static inline td_body_index td_body_in(const td_array *list, int i) {
    return *TD_AT(td_body_index, list, i);
}

/* td_push_slot and td_push_body append to a list that has room. */
static inline void td_push_slot(td_array *list, td_awake_slot slot) {
    TD_PUSH(td_awake_slot, list) = slot;
}

static inline void td_push_body(td_array *list, td_body_index body) {
    TD_PUSH(td_body_index, list) = body;
}

#endif
