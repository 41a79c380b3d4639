/* sensor_stages.c: the stages of sensors, as the table that a world with sensors has; see
 * contact/sensors.h. */
#include "api/step.h"
#include "contact/sensors.h"
#include "detection/sensing.h"

static bool reserve(thud_world *w) {
    return td_sensed_reserve(w) && td_sensors_reserve(w) &&
           (!td_sensing_of(w) || td_sensing_reserve(w));
}

static void test(thud_world *w) {
    td_sensed_list(w);
    if (td_sensing_of(w)) {
        td_sensing_find_passed(w);
    }
    td_sensed_pairs(w);
    td_sensors_test(w);
}

const td_sensor_hooks td_sensor_stages = {reserve, td_sensing_note_held, test};
