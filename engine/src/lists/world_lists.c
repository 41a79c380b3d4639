/* world_lists.c: lists of all bodies, of the awake bodies and of all shapes of a world, and the
 * handle of the body or shape in a slot. */
#include "lists/lists.h"
#include "state/body.h"

#include "thud/thud_lists.h"

/* Whether a list contains the body. */
typedef bool body_filter_fn(const thud_world *w, td_body_index body);

/* As thud_body_state.awake. */
static bool is_awake(const thud_world *w, td_body_index index) {
    return td_body_lives(w, index) && td_body_is_awake(td_body_at(w, index));
}

/* Lists the bodies for which `contains` is true, in the order of slots. */
static thud_result list_bodies(const thud_world *w, body_filter_fn *contains, thud_body_id *out,
                               int capacity, int *count) {
    thud_result result = td_list_check(w, out, capacity, count);
    if (result != THUD_OK) {
        return result;
    }
    int n = 0;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        if (!contains(w, i)) {
            continue;
        }
        if (n < capacity) {
            out[n] = td_body_handle(w, i);
        }
        n++;
    }
    *count = n;
    return THUD_OK;
}

thud_result thud_world_get_bodies(const thud_world *w, thud_body_id *out, int capacity,
                                  int *out_count) {
    return list_bodies(w, td_body_lives, out, capacity, out_count);
}

thud_result thud_world_get_awake_bodies(const thud_world *w, thud_body_id *out, int capacity,
                                        int *out_count) {
    return list_bodies(w, is_awake, out, capacity, out_count);
}

thud_result thud_world_get_shapes(const thud_world *w, thud_shape_id *out, int capacity,
                                  int *out_count) {
    thud_result result = td_list_check(w, out, capacity, out_count);
    if (result != THUD_OK) {
        return result;
    }
    int n = 0;
    for (int i = 0; i < w->shapes.count; i++) {
        if (!td_shape_lives(w, i)) {
            continue;
        }
        if (n < capacity) {
            out[n] = td_shape_handle(w, i);
        }
        n++;
    }
    *out_count = n;
    return THUD_OK;
}

/* ---- slots ---- */

thud_result thud_world_get_slot_counts(const thud_world *w, int *out_bodies, int *out_shapes) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (out_bodies) {
        *out_bodies = w->bodies.count;
    }
    if (out_shapes) {
        *out_shapes = w->shapes.count;
    }
    return THUD_OK;
}

/* Refuses a null `out`, and a slot that was never used. */
static thud_result check_slot(const thud_world *w, const td_slots *slots, int slot,
                              const void *out) {
    if (!out) {
        return td_refuse(w, THUD_ERROR_NULL, "slot: out is null");
    }
    return slot >= 0 && slot < slots->count
               ? THUD_OK
               : td_refuse(w, THUD_ERROR_INVALID, "slot: negative, or never used");
}

thud_result thud_world_get_body_at(const thud_world *w, int slot, thud_body_id *out) {
    thud_result result = w ? check_slot(w, &w->bodies, slot, out) : THUD_ERROR_NULL;
    if (result == THUD_OK) {
        td_body_index index = {slot};
        *out = td_body_lives(w, index) ? td_body_handle(w, index) : (thud_body_id){0, 0};
    }
    return result;
}

thud_result thud_world_get_shape_at(const thud_world *w, int slot, thud_shape_id *out) {
    thud_result result = w ? check_slot(w, &w->shapes, slot, out) : THUD_ERROR_NULL;
    if (result == THUD_OK) {
        *out = td_shape_lives(w, slot) ? td_shape_handle(w, slot) : (thud_shape_id){0, 0};
    }
    return result;
}
