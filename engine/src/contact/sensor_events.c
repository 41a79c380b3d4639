/* sensor_events.c: which shapes came to be in sensors in the step, and which went. Pairs of a
 * sensor have no lanes: they wait as long as their bounds overlap, and are tested exactly at the
 * end of each step, once where neither moves. */
#include "api/step.h"
#include "contact/sensors.h"
#include "detection/sensing.h"

/* The events from `first` on happened at that time. */
static void date(td_array *times, int first, float time) {
    for (int i = first; i < times->count; i++) {
        *TD_AT(float, times, i) = time;
    }
}

static float time_of(const thud_world *w, const td_contact *contact, bool begins) {
    const td_sensing *sensing = td_sensing_of(w);
    return sensing ? sensing->when(w, contact->shape_a, contact->shape_b, begins) : 1.0f;
}

static void begin(thud_world *w, int index) {
    int first = w->events.sensor_begin_time.count;
    td_contact_begin(w, index);
    if (w->events.sensor_begin_time.count > first) {
        date(&w->events.sensor_begin_time, first, time_of(w, td_contact_at(w, index), true));
    }
}

static void end(thud_world *w, int index) {
    int first = w->events.sensor_end_time.count;
    td_contact_end(w, index);
    if (w->events.sensor_end_time.count > first) {
        date(&w->events.sensor_end_time, first, time_of(w, td_contact_at(w, index), false));
    }
}

bool td_sensors_reserve(thud_world *w) {
    return td_sensor_room(w, w->waiting[TD_PAIR_SENSOR].count + w->scratch.sensed_room);
}

/* One that rests gives its place to the last. Where bounds have parted, the next narrowphase ends
 * the contact, after the broadphase that believes there is one. */
void td_sensors_test(thud_world *w) {
    const td_array *waiting = &w->waiting[TD_PAIR_SENSOR];
    if (!td_sensor_room(w, waiting->count)) {
        return;
    }
    for (int i = 0; i < waiting->count;) {
        int index = td_int_at(waiting, i);
        const td_contact *contact = td_contact_at(w, index);
        bool near_by = td_contact_bounds_meet(w, contact);
        bool overlaps = near_by && td_sensor_overlaps(w, contact->shape_a, contact->shape_b);
        bool rests = near_by && td_body_at(w, contact->body[0])->awake.at < 0 &&
                     td_body_at(w, contact->body[1])->awake.at < 0;
        if (overlaps != (contact->open != 0)) {
            (overlaps ? begin : end)(w, index);
        }
        if (rests) {
            td_constraint_rest(w, index);
        }
        i += !rests;
    }
}
