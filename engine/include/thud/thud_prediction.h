/* thud_prediction.h: where bodies will be in a while, for games over a network that show another
 * player's bodies before news of them has arrived. thud.h does not include this header; a program
 * that does not use it does not link it.
 *
 * Three ways to bridge the delay, each dearer and closer than the one before:
 * - thud_world_extrapolate, dead reckoning: free flight, through whatever stands in its way;
 * - thud_world_predict: the same, up to the first shape that is met;
 * - a rollback (thud_rollback.h): the steps themselves, run again as inputs arrive.
 *
 * Free flight is the exact solution of dv/dt = g - c v, with g the world's gravity times the body's
 * gravity scale (none for a kinematic body) and c its linear damping; without damping it is the
 * parabola x + v t + g t^2 / 2. The rotation follows the same equation, with no g and the angular
 * damping. Speeds are clamped as steps clamp them, to the world's maximum_speed. Contacts, joints,
 * locks, and forces that wait for the next step have no part in it. A dynamic body that nothing
 * touches is after k steps where it was predicted to be, but for the rounding of k steps in single
 * precision: some 1e-7 of its speed times k time steps. Steps move a kinematic body with damping by
 * substeps, which go less far by up to damping times the length of a substep, as a share.
 *
 * The calls change nothing in the world, and see the edits made before them; edits made inside a
 * callback not before the next step. They are allowed inside callbacks.
 *
 * Errors: THUD_ERROR_NULL for a null world, or null lists where their count or capacity is above 0;
 * THUD_ERROR_INVALID for a negative count or capacity, and for seconds that are outside [0,
 * THUD_AHEAD_MAX] or no number: contacts of the past are not known, snapshots are the way back;
 * THUD_ERROR_STALE for a handle that names no body. The lists are then not written. */
#ifndef THUD_PREDICTION_H
#define THUD_PREDICTION_H

#include "thud_ids.h"
#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A body some time ahead. */
typedef struct thud_prediction {
    thud_body_id body;
    thud_pos position;      /* of the origin */
    double angle;           /* rad, in (-pi, pi] */
    thud_vec2 velocity;     /* of the centre of mass, length/s */
    float angular_velocity; /* rad/s */
    double seconds;    /* how far ahead this is, s: all that was asked, or the time at which the
                          body meets `met` */
    thud_shape_id met; /* the shape that it meets; null: none */
} thud_prediction;

/* The bodies bodies[i] in `seconds`, s, [0, THUD_AHEAD_MAX], to out[i], for i in [0, count). A body
 * that is static, asleep, disabled or quarantined stays where it is, with its velocity. */
THUD_API thud_result thud_world_extrapolate(const thud_world *world, const thud_body_id *bodies,
                                            int count, double seconds, thud_prediction *out);

/* The same for all awake bodies, in `seconds`, s, [0, THUD_AHEAD_MAX], in the order of slots.
 * *out_count is their number; at most `capacity` (>= 0) are written. THUD_ERROR_NULL also for a
 * null out_count. */
THUD_API thud_result thud_world_extrapolate_awake(const thud_world *world, double seconds,
                                                  thud_prediction *out, int capacity,
                                                  int *out_count);

/* As thud_world_extrapolate, with `seconds` in [0, THUD_AHEAD_MAX], but a body stops where one of
 * its shapes meets the first shape in its way, by the filters of both; its velocity is that before
 * the impact. All other shapes stand where they are now. A shape that it touches at the start stops
 * it only where it goes on towards it; so what lies, rolls or slides on the ground under gravity is
 * stopped at once. Sensors stop nothing, and are not stopped; nor does anything outside the world.
 * Rules, listeners and joints are not asked: a body meets another one that a joint ties to it.
 *
 * The way is cast as chords of a time step each, or of 1/THUD_PREDICTION_CHORDS_MAX of the whole
 * where there would be more: it leaves a parabola by g h^2 / 8 in a chord of h seconds, and a body
 * that turns does so between chords. The cost is that of one cast (thud_world_cast_shape) for each
 * chord and shape of the body up to the impact. THUD_ERROR_MEMORY. */
#define THUD_PREDICTION_CHORDS_MAX 256
THUD_API thud_result thud_world_predict(thud_world *world, const thud_body_id *bodies, int count,
                                        double seconds, thud_prediction *out);

#ifdef __cplusplus
}
#endif

#endif
