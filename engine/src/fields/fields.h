/* fields.h: what forces from a body's surroundings share: whom they push, where its shapes are, and
 * how far a push may go. */
#ifndef TD_FIELDS_H
#define TD_FIELDS_H

#include "geometry/shape_instance.h"
#include "state/handles.h"
#include "state/world.h"
#include "thud/thud_fields.h"

/* A force and its torque about the centre of mass; or impulses. */
typedef struct td_push {
    double x, y, turn;
} td_push;

/* A body, and how it moves against what flows about it. */
typedef struct td_adrift {
    td_body_index index;
    double x, y, turn; /* velocity, against the flow */
    bool heeds;        /* false: the body is to be left alone */
} td_adrift;

/* A force at a place, from the centre of mass. */
static inline void td_push_add(td_push *push, double x, double y, double fx, double fy) {
    push->x += fx;
    push->y += fy;
    push->turn += x * fy - y * fx;
}

static inline bool td_push_valid(td_push push) {
    double most = (double)THUD_PUSH_MAX;
    return td_abs(push.x) <= most && td_abs(push.y) <= most && td_abs(push.turn) <= most;
}

/* Refuses what cannot be pushed, and any call inside a callback. */
thud_result td_adrift_find(const thud_world *w, thud_body_id id, td_adrift *out);

/* Refuses what no air or water may flow at; otherwise the body's velocity is against it. */
thud_result td_adrift_in_flow(const thud_world *w, const char *name, thud_vec2 flow, td_adrift *a);

/* What the log hears of density or drag: td_check from 0 on. */
static inline thud_result td_check_field(const thud_world *w, const char *name, float x,
                                         float most) {
    return td_check(w, name, (double)x, 0.0, (double)most);
}

/* Velocity of a place, from the centre of mass, against the flow. */
static inline thud_pos td_adrift_at(const td_adrift *a, double x, double y) {
    return (thud_pos){a->x - a->turn * y, a->y + a->turn * x};
}

/* The body's shape from its centre of mass, when it has turned by `turn` more; edits that have just
 * been made included. */
thud_shape_instance td_field_shape(const thud_world *w, const td_adrift *a, const td_shape *shape,
                                   double turn);

/* Whether a shape of a body feels anything. */
static inline bool td_field_meets(const td_shape *shape) {
    return !(shape->flags & TD_SHAPE_HOLLOW);
}

/* So much of a force as takes energy from the motion against the flow in one step: the most that
 * the force's direction can take, and no more than all of the force. */
td_push td_push_braking(const thud_world *w, const td_adrift *a, td_push force);

/* Through the next step; wakes nobody. */
thud_result td_field_push(thud_world *w, const td_adrift *a, td_push force);

#endif
