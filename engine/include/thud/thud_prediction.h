/* thud_prediction.h: predicts the poses of bodies some time ahead, for networked games that show
 * another player's bodies before their data has arrived. thud.h does not include this header; a
 * program that does not use it does not link it.
 *
 * There are three ways to bridge the delay, each more expensive and more accurate than the one
 * before:
 * - thud_world_extrapolate, dead reckoning: free flight, which passes through other shapes;
 * - thud_world_predict: the same, but a body stops at the first shape that it meets;
 * - a rollback (thud_rollback.h): the steps themselves, run again as inputs arrive.
 *
 * Free flight is the exact solution of dv/dt = g - c v, with g the world's gravity times the body's
 * gravity scale (none for a kinematic body) and c its linear damping; without damping it is the
 * parabola x + v t + g t^2 / 2. The rotation follows the same equation, with no g and the angular
 * damping. Speeds are clamped as steps clamp them, to the world's maximum_speed. Contacts, joints,
 * locks, and forces applied for the next step are ignored. A dynamic body that nothing touches is
 * at the predicted pose after k steps, except for the rounding of k steps in single precision: some
 * 1e-7 of its speed times k time steps. A kinematic body with damping moves by substeps, and falls
 * behind the prediction by a fraction of its motion of up to damping * (length of a substep).
 *
 * The calls change nothing in the world, and see the edits made before them, but edits made inside
 * a callback only after the next step. They are allowed inside callbacks.
 *
 * Errors: THUD_ERROR_NULL for a null world, or null lists where their count or capacity is above 0;
 * THUD_ERROR_INVALID for a negative count or capacity, and for seconds outside [0, THUD_AHEAD_MAX]
 * or NaN (to go back in time use snapshots, since past contacts are not known); THUD_ERROR_STALE
 * for a handle that names no body. The lists are then not written. */
#ifndef THUD_PREDICTION_H
#define THUD_PREDICTION_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The predicted state of a body. */
typedef struct thud_prediction {
    thud_body_id body;
    thud_pos position;      /* of the origin */
    double angle;           /* rad, in (-pi, pi] */
    thud_vec2 velocity;     /* of the centre of mass, length/s */
    float angular_velocity; /* rad/s */
    double seconds;    /* time of this state from now, s: the argument of the call, or the time at
                          which the body meets `met` */
    thud_shape_id met; /* the shape that it meets; null: none */
} thud_prediction;

/* Writes the state of bodies[i] in `seconds`, s, [0, THUD_AHEAD_MAX], to out[i], for i in [0,
 * count). A body that is static, asleep, disabled or quarantined keeps its pose and velocity. */
THUD_API thud_result thud_world_extrapolate(const thud_world *world, const thud_body_id *bodies,
                                            int count, double seconds, thud_prediction *out);

/* The same for all awake bodies, in `seconds`, s, [0, THUD_AHEAD_MAX], in the order of slots.
 * *out_count is their number; at most `capacity` (>= 0) are written. THUD_ERROR_NULL also for a
 * null out_count. */
THUD_API thud_result thud_world_extrapolate_awake(const thud_world *world, double seconds,
                                                  thud_prediction *out, int capacity,
                                                  int *out_count);

/* The maximum number of chords of the path of a prediction. */
#define THUD_PREDICTION_CHORDS_MAX 256

/* As thud_world_extrapolate, with `seconds` in [0, THUD_AHEAD_MAX], but a body stops where one of
 * its shapes meets the first shape in its way with which it collides by the filters of both; its
 * velocity is that before the impact. All other shapes are taken at their present poses. A shape
 * that the body touches at the start stops it only if the body moves towards it; so a body that
 * lies, rolls or slides on the ground under gravity is stopped at once. Sensors and disabled bodies
 * stop nothing, and are not stopped. Rules, listeners and joints have no effect: a body also stops
 * at another one to which a joint connects it.
 *
 * The path is cast as chords, one for each time step, or THUD_PREDICTION_CHORDS_MAX chords if there
 * would be more. A chord of h seconds deviates from the parabola by up to g h^2 / 8, and a body
 * rotates between chords only. The cost is that of one cast (thud_world_cast_shape) for each chord
 * and shape of the body up to the impact. THUD_ERROR_MEMORY, and the errors of the head. */
THUD_API thud_result thud_world_predict(thud_world *world, const thud_body_id *bodies, int count,
                                        double seconds, thud_prediction *out);

#ifdef __cplusplus
}
#endif

#endif
