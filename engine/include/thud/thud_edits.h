/* thud_edits.h: creating a body with its shapes in one call, and setters of bodies and shapes.
 * Position, velocity, awake and enabled have their setters in thud.h. A program that does not use
 * this header does not link it.
 *
 * Ranges are those of the defs of thud.h: friction in [0, THUD_FRICTION_MAX], restitution in [0,
 * THUD_RESTITUTION_MAX], |surface_speed| <= THUD_SURFACE_SPEED_MAX length scales a second, density
 * in [0, THUD_DENSITY_MAX], sizes in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales and on static
 * bodies up to THUD_STATIC_SIZE_MAX, dampings finite and >= 0, gravity_scale finite.
 *
 * A change takes effect with the next step. It wakes the body and the bodies that touch it,
 * including those that sleep on a static body. If a changed static shape now collides with a
 * sleeping body that already overlaps it, the contact begins when that body wakes, as with a new
 * static shape. Contacts and their impulses persist, unless the comment says otherwise; if a body
 * becomes lighter, the impulses that carried its old weight are scaled down.
 *
 * All setters return THUD_ERROR_NULL for a null world, THUD_ERROR_STALE for a handle that names
 * nothing, THUD_ERROR_INVALID for a value out of range, and THUD_ERROR_LOCKED inside a callback:
 * then nothing has changed. A snapshot that is taken after a change contains it. */
#ifndef THUD_EDITS_H
#define THUD_EDITS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- a body with its shapes ---- */

/* A circle, AABB or OBB in the body's frame; its offset, size and angle have the ranges of
 * thud_shape_create_circle and so on. The angle is exact to 1e-9. */
typedef struct thud_body_shape {
    thud_geometry shape;       /* relative to the body's origin */
    const thud_shape_def *def; /* null: thud_default_shape_def */
} thud_body_shape;

/* Creates a body and `count` (>= 0) shapes. If any part is refused, nothing is created, and the
 * result is that of the call for this part alone. The handles are written to *out_body and, in the
 * order of `shapes`, to shape_ids, which has room for `count`; both may be null.
 *
 *     thud_body_create_with_shapes(world, &def, &(thud_body_shape){thud_circle_at(0, 0, 0.5)}, 1,
 *                                  &ball, NULL);
 *
 * Terrain is made by thud_shape_create_terrain. A program that uses this call links circles, AABBs
 * and OBBs. THUD_ERROR_NULL also if `shapes` is null and count is not 0; THUD_ERROR_INVALID, also
 * for a negative count; THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_body_create_with_shapes(thud_world *world,
                                                                 const thud_body_def *def,
                                                                 const thud_body_shape *shapes,
                                                                 int count, thud_body_id *out_body,
                                                                 thud_shape_id *out_shape_ids);

/* ---- shapes ---- */

/* Contacts that the new filter does not allow end, with an end event; those that it newly allows
 * begin with the next step. THUD_ERROR_MEMORY. */
THUD_API thud_result thud_shape_set_filter(thud_world *world, thud_shape_id shape,
                                           thud_filter filter);
/* The coefficient of friction. That of a pair is computed from those of its two shapes
 * (thud_shape_def), then replaced by a rule for the two (thud_rules.h), and last by a prologue
 * (pre-solve callback). */
THUD_API thud_result thud_shape_set_friction(thud_world *world, thud_shape_id shape,
                                             float friction);
/* The restitution; a pair has the larger of both values, which a rule and then a prologue may
 * replace. */
THUD_API thud_result thud_shape_set_restitution(thud_world *world, thud_shape_id shape,
                                                float restitution);
/* The speed of the surface, length/s; a pair has the sum of both, which a rule and then a prologue
 * may replace. */
THUD_API thud_result thud_shape_set_surface_speed(thud_world *world, thud_shape_id shape,
                                                  float surface_speed);
/* Recomputes the mass of the body at once; its centre of mass moves. The velocity keeps its value,
 * as the velocity of the new centre. */
THUD_API thud_result thud_shape_set_density(thud_world *world, thud_shape_id shape, float density);
/* Makes a shape a sensor, or a sensor a shape that collides. Its contacts end, with end events (or
 * sensor_end events, if it was a sensor), and begin again as those of the other kind.
 * THUD_ERROR_MEMORY. */
THUD_API thud_result thud_shape_set_sensor(thud_world *world, thud_shape_id shape, bool sensor);
/* The radius of a circle, about the same centre; THUD_ERROR_INVALID for another kind. Recomputes
 * the body's mass as thud_shape_set_density does. Shapes that the larger shape overlaps are
 * separated at no more than the world's push_speed. */
THUD_API thud_result thud_shape_set_radius(thud_world *world, thud_shape_id shape, float radius);
/* The same with the half extents of an AABB or OBB. THUD_ERROR_INVALID for another kind. */
THUD_API thud_result thud_shape_set_half_extents(thud_world *world, thud_shape_id shape,
                                                 thud_vec2 half_extents);
/* Whether contacts of the shape make events, see thud_events.h. Wakes no body. */
THUD_API thud_result thud_shape_set_events(thud_world *world, thud_shape_id shape, bool events);
/* Wakes no body; allowed inside a callback. */
THUD_API thud_result thud_shape_set_user_data(thud_world *world, thud_shape_id shape,
                                              uint64_t user_data);

/* ---- bodies ---- */

/* Changes the kind of a body. A body that becomes static loses its velocity; one that becomes
 * kinematic keeps it; one that becomes dynamic gets the mass of its shapes. All its contacts end,
 * and those that still touch begin again with the next step; forces that were applied for the next
 * step are dropped. The sizes of its shapes must fit the new kind, and a body with terrain stays
 * static. THUD_ERROR_INVALID also for a quarantined body, and for a body with joints, unless it
 * changes between kinematic and dynamic and each joint allows the new kind (thud_joint.h).
 * THUD_ERROR_MEMORY. */
THUD_API thud_result thud_body_set_kind(thud_world *world, thud_body_id body, thud_body_kind kind);
/* 1/s, both >= 0; see thud_body_def. */
THUD_API thud_result thud_body_set_damping(thud_world *world, thud_body_id body, float linear,
                                           float angular);
/* A factor of the world's gravity, finite. */
THUD_API thud_result thud_body_set_gravity_scale(thud_world *world, thud_body_id body,
                                                 float gravity_scale);
/* True: no torque turns the body, and the angular velocity of a dynamic body becomes 0 at once. A
 * kinematic body always turns at the angular velocity that is set. */
THUD_API thud_result thud_body_set_fixed_rotation(thud_world *world, thud_body_id body, bool fixed);
/* Null: the body uses the world's detection, including later changes of it. */
THUD_API thud_result thud_body_set_detection(thud_world *world, thud_body_id body,
                                             const thud_detection *detection);
/* False: the body, and its island with it, does not fall asleep. */
THUD_API thud_result thud_body_set_may_sleep(thud_world *world, thud_body_id body, bool may_sleep);

/* A mass that is set instead of computed from shapes. */
typedef struct thud_mass {
    float mass;    /* [THUD_MASS_MIN, THUD_MASS_MAX] */
    float inertia; /* about the centre of mass, mass * length^2, [THUD_MASS_MIN, THUD_MASS_MAX], or
                      0: no torque turns the body */
    thud_vec2 center; /* the centre of mass in the body's frame, |x|, |y| <= THUD_SIZE_MAX length
                         scales */
} thud_mass;

/* Sets the mass of a dynamic body. It stays, even if shapes are added, removed or changed, until it
 * is set again or the body changes its kind. `mass` null: the mass is computed from the shapes
 * again. While the rotation is fixed the inertia has no effect; a body with an AABB never turns.
 * The velocity keeps its value, as the velocity of the new centre of mass. */
THUD_API thud_result thud_body_set_mass(thud_world *world, thud_body_id body,
                                        const thud_mass *mass);

#ifdef __cplusplus
}
#endif

#endif
