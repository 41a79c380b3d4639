/* body.h: what the engine does with bodies from the inside. */
#ifndef TD_BODY_H
#define TD_BODY_H

#include "base/reason.h"
#include "state/world.h"

/* Why there can be no such body; null where there can. */
const char *td_body_def_error(const thud_world *w, const thud_body_def *def, td_reason *why);

/* Puts the body on the change list; `change` is a td_change_kind. */
void td_body_mark(thud_world *w, td_body_index body, td_change_kind change);

/* Finite, and no farther out than a body may be. */
bool td_place_valid(const thud_world *w, double x, double y);
/* The same, with the reason; and refused, with the log told. */
bool td_in_world(const thud_world *w, td_reason *why, const char *name, double x, double y);
thud_result td_check_place(const thud_world *w, const char *name, double x, double y);

/* A new setting changes what every resting body would do. */
void td_wake_all(thud_world *w);

/* Mass, centre of mass and reach from the shapes that it has now. */
void td_body_weigh(thud_world *w, td_body_index body);

/* Where the body's origin stands. */
td_position td_body_origin(const thud_world *w, td_body_index body);

/* Puts the body's shapes where its pose says; their bounds move when they leave the fat ones. */
void td_body_place_shapes(thud_world *w, td_body_index body);

static inline td_position td_place_from(const thud_world *w, thud_pos p) {
    return (td_position){td_round64(p.x * w->to_fixed), td_round64(p.y * w->to_fixed)};
}

static inline thud_pos td_place_to(const thud_world *w, td_position p) {
    return (thud_pos){(double)p.x / w->to_fixed, (double)p.y / w->to_fixed};
}

/* A relative length in position quanta. */
static inline int64_t td_length_from(const thud_world *w, float length) {
    double quanta = (double)length * w->to_fixed;
    return quanta < 0x1p51 && quanta > -0x1p51 ? td_round_increment(quanta) : (int64_t)quanta;
}

/* As callers have it: also where it takes its awake slot with the next step. */
static inline bool td_body_is_awake(const td_body *body) {
    return body->kind != THUD_STATIC && !(body->flags & TD_BODY_DISABLED) &&
           (body->awake.at > 0 || (body->changes & (TD_CHANGE_ENTER | TD_CHANGE_WAKE)));
}

/* The velocity as it is now, awake or not. */
static inline float *td_body_velocity(const thud_world *w, const td_body *body) {
    return body->awake.at > 0 ? td_row(&w->velocity, body->awake) : (float *)body->velocity;
}

/* ---- edits deferred by callbacks ---- */

typedef enum td_deferred_kind {
    TD_PUT_TRANSFORM,
    TD_PUT_VELOCITY,
    TD_PUT_IMPULSE,
    TD_PUT_FORCE,
    TD_PUT_AWAKE,
    TD_PUT_ENABLED,
    TD_PUT_SHAPE /* value[0]: it has been made, and counts from now on */
} td_deferred_kind;

/* Room for one more, where there are any: inside a callback. */
bool td_deferred_reserve(thud_world *w, int count);
void td_deferred_add(thud_world *w, td_body_index body, td_deferred_kind what,
                     const double value[4]);

/* Does what callbacks asked for during the last step, in the order they asked. */
void td_deferred_apply(thud_world *w);

/* Whether one of them puts the body at an angle, or has one that heeds no force turn. */
bool td_deferred_turns(const thud_world *w, td_body_index body);

#endif
