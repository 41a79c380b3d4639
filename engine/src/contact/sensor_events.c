/* sensor_events.c: begin and end events of sensors, at the end of a step.
 *
 * Contacts of kind TD_PAIR_SENSOR have no lanes: they wait as long as their bounds overlap. Each
 * step tests all that wait for exact overlap at the poses at its end; a contact of two bodies that
 * do not move is tested once, and then leaves the waiting list (TD_RESTING). */
#include "api/step.h"
#include "contact/sensors.h"
#include "detection/sensing.h"

/* Sets the time of the events from `first` on. */
static void set_times(td_array *times, int first, float time) {
    for (int i = first; i < times->count; i++) {
        *TD_AT(float, times, i) = time;
    }
}

/* The time within the step, 0 to 1, at which the pair began or ended to overlap: 1 unless a
 * detection that follows motions knows it. */
static float time_of(const thud_world *w, const td_contact *contact, bool begins) {
    return td_sensing_of(w) ? td_sensing_time(w, contact->shape_a, contact->shape_b, begins) : 1.0f;
}

/* Begins a contact, and sets the time of the events that this adds: none, one or two. */
static void begin(thud_world *w, int index) {
    int first = w->events.sensor_begin_time.count;
    td_contact_begin(w, index);
    if (w->events.sensor_begin_time.count > first) {
        set_times(&w->events.sensor_begin_time, first, time_of(w, td_contact_at(w, index), true));
    }
}

/* Ends a contact, and sets the time of the events that this adds. */
static void end(thud_world *w, int index) {
    int first = w->events.sensor_end_time.count;
    td_contact_end(w, index);
    if (w->events.sensor_end_time.count > first) {
        set_times(&w->events.sensor_end_time, first, time_of(w, td_contact_at(w, index), false));
    }
}

/* Reserves room for all events of td_sensors_test. False when memory is short. */
bool td_sensors_reserve(thud_world *w) {
    return td_sensor_room(w, w->waiting[TD_PAIR_SENSOR].count + w->scratch.sensed_room);
}

/* The step after the solver (api/step.h). A contact whose bodies both rest leaves the waiting list,
 * in which the last one takes its place, so that `i` stays. Where bounds no longer overlap, the
 * contact ends here, but the next narrowphase destroys it: the broadphase still counts on it until
 * then. */
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
