/* sensors.c: see sensors.h. */
#include "contact/sensors.h"

#include "state/kinds.h"
#include "state/shape.h"

bool td_sensor_overlaps(const thud_world *w, int shape_a, int shape_b) {
    bool b_is_line = td_kind_is_line(td_shape_at(w, shape_b)->kind);
    int a = b_is_line ? shape_b : shape_a, b = b_is_line ? shape_a : shape_b;
    td_position origin = td_shape_proxy_at(w, a)->center;
    thud_geometry placed_b = td_shape_instance(w, b, origin);
    if (td_kind_is_line(td_shape_at(w, a)->kind)) {
        return w->ground->overlap(w, a, &placed_b);
    }
    thud_geometry placed_a = td_shape_instance(w, a, origin);
    return w->instances->overlap(&placed_a, &placed_b);
}

/* Bounds of td_sensors_expect. EXPECTED_PAIRS_MIN is reserved in any world with sensors;
 * EXPECTED_PAIRS_BASE is the estimate for a world of many, beside one pair for each awake body and
 * as many as exist already. Both chosen: a pair takes about 250 bytes. */
enum { EXPECTED_PAIRS_MIN = 256, EXPECTED_PAIRS_BASE = 512 };

/* The number of sensors times that of shapes is an upper bound only without terrains: a shape may
 * be near several segments of a terrain, each of which makes a pair. */
int td_sensors_expect(const thud_world *w) {
    int64_t likely =
        (int64_t)EXPECTED_PAIRS_BASE + w->body_of.count + w->constraint_count[TD_PAIR_SENSOR];
    int64_t possible = (int64_t)w->sensors * w->shapes.live;
    int64_t pairs = w->terrains.live == 0 && possible < likely ? possible : likely;
    return pairs > EXPECTED_PAIRS_MIN ? (int)pairs : EXPECTED_PAIRS_MIN;
}

bool td_sensor_room(thud_world *w, int more) {
    td_event_lists *e = &w->events;
    int begins = e->sensor_begin.count + 2 * more, ends = e->sensor_end.count + 2 * more;
    return td_array_reserve(&w->memory, &e->sensor_begin, begins) &&
           td_array_reserve(&w->memory, &e->sensor_begin_time, begins) &&
           td_array_reserve(&w->memory, &e->sensor_end, ends) &&
           td_array_reserve(&w->memory, &e->sensor_end_time, ends);
}

void td_sensor_passed(thud_world *w, int shape_a, int shape_b, float from, float until) {
    if (td_sensor_room(w, 1)) {
        td_event_lists *e = &w->events;
        w->scratch.sensed_room--;
        td_sensor_tell(w, &e->sensor_begin, &e->sensor_begin_time, shape_a, shape_b, from);
        td_sensor_tell(w, &e->sensor_end, &e->sensor_end_time, shape_a, shape_b, until);
    }
}
