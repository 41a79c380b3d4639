/* sensors.h: which shapes are in which sensors, by the poses at the end of the step. */
#ifndef TD_SENSORS_H
#define TD_SENSORS_H

#include "contact/contact.h"

/* Whether the two share a point where they stand. One of them may be a line. */
bool td_sensor_overlaps(const thud_world *w, int shape_a, int shape_b);

/* Room to tell of so many pairs that they begin, and that they end. */
bool td_sensor_room(thud_world *w, int more);
/* Tells that a sensor came to overlap another shape, and ceased to, within this step; nothing where
 * memory is short. Of two sensors each reports the other. */
void td_sensor_passed(thud_world *w, int shape_a, int shape_b, float from, float until);

#endif
