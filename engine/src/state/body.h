/* body.h: what other stages of the engine need of bodies: checks of defs and places, the change
 * list, mass, poses in fixed point, and edits deferred by callbacks. */
#ifndef TD_BODY_H
#define TD_BODY_H

#include "base/reason.h"
#include "state/world.h"

/* The reason why the def is refused, in `why` or a literal; null where it is valid. */
const char *td_body_def_error(const thud_world *w, const thud_body_def *def, td_reason *why);

/* Puts the body on the change list, if it is not there, and adds the change to td_body.changes. */
void td_body_mark(thud_world *w, td_body_index body, td_change_kind change);

/* Whether both coordinates, in the caller's unit, are finite and within THUD_PLACE_MAX. */
bool td_place_valid(const thud_world *w, double x, double y);
/* td_place_valid for a caller's argument that is called `name`: td_in_world writes the reason of a
 * refusal to *why; td_check_place sends it to the log, and returns THUD_OK or THUD_ERROR_INVALID.
 */
bool td_in_world(const thud_world *w, td_reason *why, const char *name, double x, double y);
thud_result td_check_place(const thud_world *w, const char *name, double x, double y);

/* Wakes every body in the next step. For edits of settings, such as gravity, by which a body at
 * rest may begin to move. */
void td_wake_all(thud_world *w);

/* Computes mass, inertia and centre of mass (unless the caller has given them) and both extents
 * from the body's present shapes. */
void td_body_weigh(thud_world *w, td_body_index body);

/* The position of the body's origin, which is computed from the centre of mass: td_body_origin at
 * the body's own pose, td_origin_at at another one. */
td_position td_origin_at(const thud_world *w, td_body_index body, const td_pose *pose);
td_position td_body_origin(const thud_world *w, td_body_index body);

/* Updates the proxies of the body's shapes from its pose: td_shape_place. */
void td_body_place_shapes(thud_world *w, td_body_index body);

/* From the caller's unit to position quanta, rounded to nearest, and back. */
static inline td_position td_place_from(const thud_world *w, thud_pos p) {
    return (td_position){td_round64(p.x * w->to_fixed), td_round64(p.y * w->to_fixed)};
}

static inline thud_pos td_place_to(const thud_world *w, td_position p) {
    return (thud_pos){(double)p.x / w->to_fixed, (double)p.y / w->to_fixed};
}

/* A relative length, in the caller's unit, in position quanta: rounded like the wide kernels do
 * where it is below 2^51 quanta, and truncated beyond. */
static inline int64_t td_length_from(const thud_world *w, float length) {
    double quanta = (double)length * w->to_fixed;
    return quanta < 0x1p51 && quanta > -0x1p51 ? td_round_increment(quanta) : (int64_t)quanta;
}

/* Whether the body is awake, as callers see it: it has an awake slot, or gets one as the next step
 * begins. */
static inline bool td_body_is_awake(const td_body *body) {
    return body->kind != THUD_BODY_STATIC && !(body->flags & TD_BODY_DISABLED) &&
           (body->awake.at > 0 || (body->changes & (TD_CHANGE_ENTER | TD_CHANGE_WAKE)));
}

/* The body's present velocity (x, y, turn): its awake slot's, or its record's. */
static inline float *td_body_velocity(const thud_world *w, const td_body *body) {
    return body->awake.at > 0 ? td_row(&w->velocity, body->awake) : (float *)body->velocity;
}

/* ---- edits deferred by callbacks ---- */

/* Inside a callback, makes room for `count` more deferred edits; outside, does nothing. False when
 * memory is short. */
bool td_deferred_reserve(thud_world *w, int count);
/* Appends a deferred edit of the body; room must be reserved. */
void td_deferred_add(thud_world *w, td_body_index body, td_deferred_kind what,
                     const double value[4]);

/* Applies a force at the centre of mass and a torque through the next step, after their checks; the
 * caller is in the world's own floating-point mode. */
thud_result td_body_apply_force(thud_world *w, thud_body_id id, thud_vec2 force, float torque);

/* Applies an edit at once, of any kind but TD_PUT_SHAPE. A quarantined body stays as it is. A world
 * is given it with its first deferred edit, as edit_apply, so that a program that never edits a
 * body does not link it. */
void td_edit_apply(thud_world *w, td_body_index body, td_deferred_kind what, const double value[4]);

/* Applies the deferred edits in the order in which they were made. Those of destroyed bodies are
 * dropped; forces wait until a step has begun. */
void td_deferred_apply(thud_world *w);

/* Whether a deferred edit will rotate the body: sets its angle, or the angular velocity of a
 * kinematic body. Shapes that must not rotate (AABBs, terrain) are refused for such a body. */
bool td_deferred_turns(const thud_world *w, td_body_index body);

/* Whether the slot has a body that the caller made. The anchor of a lock (edits/locks.c) is a body
 * that the engine made: it is not counted, and is destroyed in the step after its lock was. */
static inline bool td_body_lives(const thud_world *w, td_body_index body) {
    return (td_body_at(w, body)->flags & (TD_BODY_LIVE | TD_BODY_ANCHOR)) == TD_BODY_LIVE;
}

#endif
