/* thud_joint_at.h: joints by positions in the world: functions that return the def of a joint,
 * whose frames are computed from the present poses of its bodies, and one that creates a joint in
 * an expression. thud.h does not include this header; a program that does not use it does not link
 * it.
 *
 *     thud_joint_id door = thud_joint_make(world, thud_hinge_at(world, wall, leaf, hinge));
 *
 *     thud_joint_def axle = thud_wheel_at(world, car, wheel, hub, (thud_vec2){0, 1});
 *     axle.drive[THUD_DIRECTION_ALONG].frequency = 4;
 *     axle.drive[THUD_DIRECTION_TURN].motor_speed = -20;
 *     axle.drive[THUD_DIRECTION_TURN].motor_force = 50;
 *     thud_joint_create(world, &axle, &joint);
 *
 * If body_a or body_b names no body, or a position, an axis or a length is not valid, the functions
 * return a def that thud_joint_create refuses, with the reason in the log. Positions in a body's
 * frame are in single precision. At the present poses the joint's turn is 0. */
#ifndef THUD_JOINT_AT_H
#define THUD_JOINT_AT_H

#include "thud_joint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Both bodies turn about `point`. */
THUD_API thud_joint_def thud_hinge_at(const thud_world *world, thud_body_id body_a,
                                      thud_body_id body_b, thud_pos point);
/* The bodies keep their poses relative to each other; `point` is the point at which the weld
 * transmits forces. */
THUD_API thud_joint_def thud_weld_at(const thud_world *world, thud_body_id body_a,
                                     thud_body_id body_b, thud_pos point);
/* b moves along `axis` relative to a, and does not turn. The axis is a direction in the world, of
 * any length but 0. */
THUD_API thud_joint_def thud_slider_at(const thud_world *world, thud_body_id body_a,
                                       thud_body_id body_b, thud_pos point, thud_vec2 axis);
/* The wheel b turns about `point`, which moves along `axis`, the suspension, relative to a. Without
 * a spring along it the wheel moves freely there. */
THUD_API thud_joint_def thud_wheel_at(const thud_world *world, thud_body_id body_a,
                                      thud_body_id body_b, thud_pos point, thud_vec2 axis);
/* A target: once a drive has a spring, it pulls `point` of b to its present position relative to a.
 * thud_joint_set_frame of side 0 moves that position. The joint's x axis is that of the world. */
THUD_API thud_joint_def thud_target_at(const thud_world *world, thud_body_id body_a,
                                       thud_body_id body_b, thud_pos point);
/* A rod: keeps `from` on a and `to` on b at their present distance, which is more than 0. */
THUD_API thud_joint_def thud_rod_at(const thud_world *world, thud_body_id body_a,
                                    thud_body_id body_b, thud_pos from, thud_pos to);
/* A rope: keeps these points at most `length` apart, (0, THUD_JOINT_LENGTH_MAX] length scales. */
THUD_API thud_joint_def thud_rope_at(const thud_world *world, thud_body_id body_a,
                                     thud_body_id body_b, thud_pos from, thud_pos to, float length);

/* Creates the joint, and returns its handle; the null handle if it fails, for the reasons of
 * thud_joint_create, which are logged. */
THUD_API thud_joint_id thud_joint_make(thud_world *world, thud_joint_def def);

#ifdef __cplusplus
}
#endif

#endif
