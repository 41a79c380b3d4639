/* sensing_awake.c: the part of sensing.c for detections that test the paths of both bodies:
 * overlaps of fast bodies with sensors of awake bodies, and of fast sensors with awake bodies. */
#include "detection/sensing.h"
#include "state/body.h"
#include "state/shape.h"

/* Tests all pairs of shapes of two bodies. */
static void test_bodies(thud_world *w, td_awake_slot slot, td_awake_slot other) {
    int a = td_body_at(w, td_body_of(w, slot))->first_shape;
    for (; a != TD_NONE; a = td_shape_at(w, a)->next) {
        int b = td_body_at(w, td_body_of(w, other))->first_shape;
        for (; b != TD_NONE; b = td_shape_at(w, b)->next) {
            td_sensing_test_pair(w, a, b);
        }
    }
}

/* Puts the paths of the bodies that have sensors into the grid. Returns whether one is fast. */
static bool fill_grid(thud_world *w) {
    const td_array *sensing = &w->scratch.sensing;
    bool any_fast = false;
    w->scratch.sensed.boxes.count = 0;
    for (int i = 0; i < sensing->count; i++) {
        td_bounds bounds;
        bool bounded = td_sensing_path_bounds(w, td_slot_in(sensing, i), &bounds);
        td_bounds_grid_add(&w->scratch.sensed, bounded ? &bounds : NULL, td_slot_in(sensing, i).at);
        any_fast = any_fast || td_sensing_is_fast(w, td_slot_in(sensing, i));
    }
    td_bounds_grid_build(&w->scratch.sensed);
    return any_fast;
}

/* Tests an awake body against those bodies with sensors whose paths come near its own. `senses`: it
 * has a sensor itself; `fast`: it is fast. Pairs of which neither is fast are left to
 * contact/sensor_events.c. If both have sensors, each finds the other, and the call for the one in
 * the lower slot tests the pair. */
static void test_near(thud_world *w, td_awake_slot slot, bool senses, bool fast) {
    td_array *found = &w->scratch.found_shapes;
    td_bounds bounds;
    found->count = 0;
    bool bounded = td_sensing_path_bounds(w, slot, &bounds);
    td_bounds_grid_find(&w->scratch.sensed, bounded ? &bounds : NULL, found);
    for (int i = 0; i < found->count; i++) {
        td_awake_slot other = td_slot_in(found, i);
        if (other.at != slot.at && !(senses && other.at < slot.at) &&
            (fast || td_sensing_is_fast(w, other))) {
            test_bodies(w, slot, other);
        }
    }
}

void td_sensing_test_awake(thud_world *w) {
    const td_array *sensing = &w->scratch.sensing;
    if (sensing->count == 0) {
        return;
    }
    int next = 0; /* in `sensing`, which is in the order of slots */
    bool any_fast = fill_grid(w);
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        bool senses = next < sensing->count && td_slot_in(sensing, next).at == slot.at;
        next += senses;
        bool fast = td_sensing_is_fast(w, slot);
        if (fast || any_fast) {
            test_near(w, slot, senses, fast);
        }
    }
}
