/* thud_forces.h: pushing bodies, and asking where their points are and how they move; force and
 * torque at the centre of mass, and an impulse at a point, are in thud.h. A program that uses none
 * of this does not link it.
 *
 * A force acts through the next step, all of its substeps alike, and is gone then: what it gives in
 * velocity is force * time_step / mass. Applied between two calls of thud_world_advance it acts for
 * the time that the second is given, and gives force * elapsed / mass. An impulse changes the
 * velocity at once; inside a callback it is the force through the next step that gives the same.
 * Either wakes the body, and with it what it touches, where it sleeps; a disabled body keeps what
 * an impulse gave it and forgets forces; a static or kinematic one is refused, by
 * THUD_ERROR_INVALID.
 *
 * All return THUD_ERROR_NULL for a null world, THUD_ERROR_STALE, THUD_ERROR_INVALID for a value
 * that is not finite, a push beyond THUD_PUSH_MAX, or a place beyond THUD_PLACE_MAX length scales,
 * and, inside a callback, THUD_ERROR_MEMORY; then nothing has changed. */
#ifndef THUD_FORCES_H
#define THUD_FORCES_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* At a point of the world: it also turns the body about its centre of mass, by its torque now. */
THUD_API thud_result thud_body_apply_force_at(thud_world *world, thud_body_id body, thud_vec2 force,
                                              thud_pos point);
/* At the centre of mass. */
THUD_API thud_result thud_body_apply_center_impulse(thud_world *world, thud_body_id body,
                                                    thud_vec2 impulse);
/* Mass length^2 / s. Does nothing to a body whose rotation is fixed. */
THUD_API thud_result thud_body_apply_angular_impulse(thud_world *world, thud_body_id body,
                                                     float impulse);

/* Gives a kinematic body the velocity by which the next step brings it to a pose, the shorter way
 * round, as near as single precision tells; with damping, too, but for a time budget that changes
 * the substeps. It keeps that velocity: ask before each step. Wakes what it touches, unless it
 * stands there already. |angle| <= THUD_ANGLE_MAX. THUD_ERROR_INVALID too where the body is not
 * kinematic, would have to turn an AABB, or be faster than the world's maximum_speed. Inside a
 * callback it goes from where the body is at the time of the call. */
THUD_API thud_result thud_body_set_target(thud_world *world, thud_body_id body, thud_pos position,
                                          double angle);

/* ---- points of a body, of any kind; `out` must not be null ---- */

/* Of the point of the body that is there: length/s. */
THUD_API thud_result thud_body_velocity_at(const thud_world *world, thud_body_id body,
                                           thud_pos point, thud_vec2 *out);
/* From the origin and axes of the body to those of the world, and back. Points in the body's frame
 * are told in single precision. */
THUD_API thud_result thud_body_world_point(const thud_world *world, thud_body_id body,
                                           thud_vec2 point, thud_pos *out);
THUD_API thud_result thud_body_local_point(const thud_world *world, thud_body_id body,
                                           thud_pos point, thud_vec2 *out);
THUD_API thud_result thud_body_world_vector(const thud_world *world, thud_body_id body,
                                            thud_vec2 vector, thud_vec2 *out);
THUD_API thud_result thud_body_local_vector(const thud_world *world, thud_body_id body,
                                            thud_vec2 vector, thud_vec2 *out);

#ifdef __cplusplus
}
#endif

#endif
