/* fields.h: functions that the force fields of thud_fields.h share: they look up bodies, give the
 * poses of a body's shapes, and bound braking forces so that they add no energy.
 *
 * Lengths, masses and times are in the caller's units. Points are relative to the body's centre of
 * mass, in world axes. */
#ifndef TD_FIELDS_H
#define TD_FIELDS_H

#include "geometry/shape_instance.h"
#include "state/handles.h"
#include "state/world.h"
#include "thud/thud_fields.h"

/* A force and its torque about the centre of mass; or an impulse and its angular impulse. */
typedef struct td_push {
    double x, y, turn;
} td_push;

/* A body in a field. */
typedef struct td_field_body {
    td_body_index index;
    double x, y; /* velocity, length/s, in the world; td_field_body_in_flow makes it relative to
                    the medium */
    double turn; /* angular velocity, rad/s; 0 if the body cannot rotate */
    bool takes_force; /* false: asleep, disabled or quarantined: no force acts */
} td_field_body;

/* Adds a force (fx, fy) that acts at the point (x, y). */
static inline void td_push_add(td_push *push, double x, double y, double fx, double fy) {
    push->x += fx;
    push->y += fy;
    push->turn += x * fy - y * fx;
}

/* Whether all components are within THUD_FORCE_MAX. False if one is NaN. */
static inline bool td_push_valid(td_push push) {
    double max = (double)THUD_FORCE_MAX;
    return td_abs(push.x) <= max && td_abs(push.y) <= max && td_abs(push.turn) <= max;
}

/* Looks up a body. Refuses bodies that are not dynamic, and any call inside a callback. */
thud_result td_field_body_find(const thud_world *w, thud_body_id id, td_field_body *out);

/* Subtracts a flow from the body's velocity. Refuses a flow out of range; `name` is for the log. */
thud_result td_field_body_in_flow(const thud_world *w, const char *name, thud_vec2 flow,
                                  td_field_body *a);

/* Refuses a density or drag that is not in [0, max]. */
static inline thud_result td_check_field(const thud_world *w, const char *name, float x,
                                         float max) {
    return td_check(w, name, (double)x, 0.0, (double)max);
}

/* Velocity of a point of the body relative to the flow. */
static inline thud_pos td_field_velocity_at(const td_field_body *a, double x, double y) {
    return (thud_pos){a->x - a->turn * y, a->y + a->turn * x};
}

/* A shape at its pose after the body has rotated by a further `turn` radians. It is computed from
 * the body's present pose, pending edits included, and not from the shape proxies, which may be
 * older. */
thud_geometry td_field_shape(const thud_world *w, const td_field_body *a, const td_shape *shape,
                             double turn);

/* Whether fields act on the shape: it is no sensor, and was not made inside a callback. */
static inline bool td_field_meets(const td_shape *shape) {
    return !(shape->flags & TD_SHAPE_HOLLOW);
}

/* Scales a braking force by the share in [0, 1] that removes the most energy from the motion
 * relative to the flow in one step. */
td_push td_push_dissipative(const thud_world *w, const td_field_body *a, td_push force);

/* Adds a force that acts throughout the next step; wakes no body. Refuses a force out of range. */
thud_result td_field_push(thud_world *w, const td_field_body *a, td_push force);

#endif
