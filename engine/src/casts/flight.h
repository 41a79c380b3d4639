/* flight.h: the free flight of a body, in closed form; see thud_prediction.h. */
#ifndef TD_FLIGHT_H
#define TD_FLIGHT_H

#include "state/world.h"
#include "thud/thud_prediction.h"

/* The flight of one body from where it is now. Coordinates are x, y and the rotation. */
typedef struct td_flight {
    bool moves; /* false: the body is not awake and stays where it is; then only `velocity` and
                   `body` are used */
    double velocity[3];  /* at the start, length/s, rad/s */
    double gain[3];      /* acceleration, length/s^2 */
    double damping[3];   /* 1/s */
    double speed_max[3]; /* length/s, rad/s */
    td_body_index body;
} td_flight;

/* The body on its way. */
typedef struct td_flight_point {
    double moved[3];    /* since the start: of the centre of mass, length, and the rotation, rad */
    double velocity[3]; /* length/s, rad/s */
} td_flight_point;

td_flight td_flight_of(const thud_world *w, td_body_index body);
/* The point of the flight after `seconds`, s. */
td_flight_point td_flight_at(const td_flight *f, double seconds);
/* That point as a thud_prediction: the pose and velocity of the body, with `seconds` and without a
 * shape that it meets. */
thud_prediction td_flight_tell(const thud_world *w, const td_flight *f, const td_flight_point *at,
                               double seconds);

/* Refuses lists and a time as thud_prediction.h says, and handles that name no body. */
thud_result td_flight_check(const thud_world *w, const thud_body_id *bodies, int count,
                            double seconds, const thud_prediction *out);

#endif
