/* sensors.h: overlaps of sensors with other shapes, and room for their events.
 *
 * A sensor and another shape whose bounds overlap are a contact of kind TD_PAIR_SENSOR, which has
 * no lane. It begins and ends by the exact overlap of the two at the end of a step
 * (sensor_events.c). A pair that overlaps only within a step, because one of them is fast, is found
 * by detection/sensing.c, and gets both events at once (td_sensor_passed). */
#ifndef TD_SENSORS_H
#define TD_SENSORS_H

#include "contact/contact.h"

/* The part of a step that only worlds with sensors need. A world has it by its def
 * (thud_parts), or is given it by thud_shape_set_sensor or a snapshot, so that a program without
 * sensors does not link it. */
typedef struct td_sensor_hooks {
    /* Reserves memory for a step of a world that has sensors, and sets scratch.sensed_room, the
     * number of pairs that have room. In a world without sensors that number is 0, so that a sensor
     * that a callback makes within a step waits for the next one. False when memory is short. */
    bool (*reserve)(thud_world *w);
    void (*note_held)(thud_world *w); /* td_sensing_note_held */
    /* Makes the events of sensors: first for shapes that passed through a sensor within the step,
     * then for the poses at the end of the step. */
    void (*test)(thud_world *w);
} td_sensor_hooks;

/* api/sensor_stages.c */
extern const td_sensor_hooks td_sensor_stages;

/* Whether the two share a point at their present poses. One of them may be a terrain. */
bool td_sensor_overlaps(const thud_world *w, int shape_a, int shape_b);

/* The number of pairs of a sensor and another shape for which a step reserves room before bodies
 * move: pairs that begin to overlap in the step, or overlap only within it. It is the number of all
 * possible pairs, or an estimate where that is large. It depends on the state of the world alone,
 * so that runs stay deterministic. */
int td_sensors_expect(const thud_world *w);
/* Reserves room for the begin and the end events of `more` pairs. False when memory is short. */
bool td_sensor_room(thud_world *w, int more);
/* Adds the begin and the end event of a sensor's pair that overlaps only within this step, from
 * time `from` to `until` (0: start of the step, 1: end). Of two sensors each gets both events.
 * Beyond the td_sensors_expect pairs it allocates, and adds nothing when memory is short. */
void td_sensor_passed(thud_world *w, int shape_a, int shape_b, float from, float until);

#endif
