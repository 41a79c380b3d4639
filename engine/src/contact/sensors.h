/* sensors.h: which shapes are in which sensors, by the poses at the end of the step. */
#ifndef TD_SENSORS_H
#define TD_SENSORS_H

#include "contact/contact.h"

/* Whether the two share a point where they stand. One of them may be a line. */
bool td_sensor_overlaps(const thud_world *w, int shape_a, int shape_b);

/* How many pairs of sensors and other shapes may come or be passed in a step, as far as there is
 * room for them: all that are possible, or where those are many, as many as are likely. It follows
 * from the state of the world alone. */
int td_sensors_expect(const thud_world *w);
/* Room to tell of so many pairs that they begin, and that they end. */
bool td_sensor_room(thud_world *w, int more);
/* Tells that a sensor came to overlap another shape, and ceased to, within this step. Of two
 * sensors each reports the other. Of more than td_sensors_expect has it asks for memory, and tells
 * nothing where that is short. */
void td_sensor_passed(thud_world *w, int shape_a, int shape_b, float from, float until);

#endif
