/* thud_forces.h: further forces and impulses, and the position and velocity of points of bodies.
 * Force and torque at the centre of mass, and an impulse at a point, are in thud.h. A program that
 * does not use this header does not link it.
 *
 * A force acts during the whole next step, equally in all substeps, and changes the velocity by
 * force * time_step / mass. A force that depends on the position, such as a planet's gravity or a
 * spring, should be computed for the position in the middle of the step, position + velocity *
 * time_step / 2: an orbit then keeps its energy, while a force for the position before the step
 * adds energy in each step. A force applied between two calls of thud_world_advance acts over the
 * `elapsed` of the second, and changes the velocity by force * elapsed / mass. An impulse changes
 * the velocity at once; inside a callback an impulse of this header acts as a force during the next
 * step, with the same effect, while thud_body_apply_impulse of thud.h changes the velocity as that
 * step begins. Both wake the body, and the bodies that it touches, if it sleeps. A disabled body
 * keeps the velocity that an impulse gave it; forces on it are dropped. A static or kinematic body
 * is THUD_ERROR_INVALID.
 *
 * All return THUD_ERROR_NULL for a null world, THUD_ERROR_STALE, THUD_ERROR_INVALID for a value
 * that is not finite, a force or impulse above THUD_FORCE_MAX, or a position beyond THUD_PLACE_MAX
 * length scales, and, inside a callback, THUD_ERROR_MEMORY; then nothing has changed. */
#ifndef THUD_FORCES_H
#define THUD_FORCES_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A force, mass * length / s^2, at a point in world coordinates. Its torque about the centre of
 * mass is computed once, from the present pose of the body. */
THUD_API thud_result thud_body_apply_force(thud_world *world, thud_body_id body, thud_vec2 force,
                                           thud_pos point);
/* An impulse, mass * length / s, at the centre of mass. */
THUD_API thud_result thud_body_apply_center_impulse(thud_world *world, thud_body_id body,
                                                    thud_vec2 impulse);
/* An angular impulse, mass * length^2 / s. No effect on a body whose rotation is fixed. */
THUD_API thud_result thud_body_apply_angular_impulse(thud_world *world, thud_body_id body,
                                                     float impulse);

/* Sets the velocity by which a kinematic body reaches a pose at the end of the next step, to single
 * precision; it rotates the shorter way. Damping is taken into account, but not a time budget that
 * changes the substeps. The body keeps the velocity afterwards, so call this before each step.
 * Wakes the bodies that it touches, unless it is at rest in that pose. angle: rad, |angle| <=
 * THUD_ANGLE_MAX. THUD_ERROR_INVALID also for a body that is not kinematic, an AABB that would
 * turn, and a velocity beyond the world's maximum_speed. Inside a callback the motion starts from
 * the body's pose at the time of the call. */
THUD_API thud_result thud_body_set_target(thud_world *world, thud_body_id body, thud_pos position,
                                          double angle);

/* ---- points of a body, of any kind; `out` must not be null ---- */

/* The velocity, length/s, of the body's point at this world position: v + w x r. */
THUD_API thud_result thud_body_get_velocity_at(const thud_world *world, thud_body_id body,
                                               thud_pos point, thud_vec2 *out);
/* All four calls: points and vectors from the body's frame (its origin and axes) to the world's,
 * and back. Points in the body's frame are in single precision. Components beyond the largest float
 * become that float. */
THUD_API thud_result thud_body_get_world_point(const thud_world *world, thud_body_id body,
                                               thud_vec2 point, thud_pos *out);
THUD_API thud_result thud_body_get_local_point(const thud_world *world, thud_body_id body,
                                               thud_pos point, thud_vec2 *out);
THUD_API thud_result thud_body_get_world_vector(const thud_world *world, thud_body_id body,
                                                thud_vec2 vector, thud_vec2 *out);
THUD_API thud_result thud_body_get_local_vector(const thud_world *world, thud_body_id body,
                                                thud_vec2 vector, thud_vec2 *out);

#ifdef __cplusplus
}
#endif

#endif
