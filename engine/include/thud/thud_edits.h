/* thud_edits.h: bodies that are made with their shapes in one call; and changing bodies and shapes
 * after they were made; places, velocities, awake and enabled have their setters in thud.h. A
 * program that uses none of this does not link it.
 *
 * Ranges are those of the defs of thud.h: friction in [0, THUD_FRICTION_MAX], restitution in [0,
 * THUD_RESTITUTION_MAX], |surface_speed| <= THUD_SURFACE_SPEED_MAX length scales a second, density
 * in [0, THUD_DENSITY_MAX], sizes in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales, of what is
 * static to THUD_STATIC_SIZE_MAX, dampings finite and not negative, gravity_scale finite. A change
 * holds from the next step on, and wakes the body and what touches it: also what sleeps on a static
 * body that changes. A static shape that is changed so that it now meets what sleeps in its place
 * is found by the sleeper when that wakes, as one that is made there. Contacts go on, with their
 * impulses, unless said otherwise; where a body gets lighter, impulses that bore its old weight
 * shrink with it.
 *
 * All changes return THUD_ERROR_NULL for a null world, THUD_ERROR_STALE for a handle that names
 * nothing, THUD_ERROR_INVALID for a value out of range, and THUD_ERROR_LOCKED inside a callback:
 * then nothing has changed. A snapshot that is taken after a change has it. */
#ifndef THUD_EDITS_H
#define THUD_EDITS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- a body with its shapes ---- */

/* A circle, AABB or OBB in the body's frame; its offset, size and angle have the ranges of
 * thud_shape_create_circle and its like. The angle is told to 1e-9 of what was asked for. */
typedef struct thud_body_shape {
    thud_shape_instance shape;
    const thud_shape_def *def; /* null: thud_default_shape_def */
} thud_body_shape;

/* A body and `count` (>= 0) shapes at once: if anything of it is refused, by the result that the
 * calls for each would have, nothing is made. The handles go to *body and, in the order of
 * `shapes`, to shape_ids, which has room for `count`; both may be null.
 *
 *     thud_body_create_with_shapes(world, &def, &(thud_body_shape){thud_circle_at(0, 0, 0.5)}, 1,
 *                                  &ball, NULL);
 *
 * Terrain has a call of its own: thud_shape_create_terrain. A program that uses this links circles,
 * AABBs and OBBs. THUD_ERROR_NULL where `shapes` is null and count is not 0. */
THUD_NODISCARD THUD_API thud_result thud_body_create_with_shapes(thud_world *world,
                                                                 const thud_body_def *def,
                                                                 const thud_body_shape *shapes,
                                                                 int count, thud_body_id *body,
                                                                 thud_shape_id *shape_ids);

/* ---- shapes ---- */

/* Contacts with what it meets no more end, with an event; those that it meets now begin with the
 * next step. THUD_ERROR_MEMORY. */
THUD_API thud_result thud_shape_set_filter(thud_world *world, thud_shape_id shape,
                                           thud_filter filter);
/* A prologue has the last word on these three. */
THUD_API thud_result thud_shape_set_friction(thud_world *world, thud_shape_id shape,
                                             float friction);
THUD_API thud_result thud_shape_set_restitution(thud_world *world, thud_shape_id shape,
                                                float restitution);
THUD_API thud_result thud_shape_set_surface_speed(thud_world *world, thud_shape_id shape,
                                                  float surface_speed);
/* Its body is weighed anew at once, and its centre of mass moves; the body's velocity, which is
 * that of the centre, stays the same number. */
THUD_API thud_result thud_shape_set_density(thud_world *world, thud_shape_id shape, float density);
/* Its contacts end, with events of what it was, and what it overlaps begins anew as what it is.
 * THUD_ERROR_MEMORY. */
THUD_API thud_result thud_shape_set_sensor(thud_world *world, thud_shape_id shape, bool sensor);
/* Of a circle, and of an AABB or OBB: about the same centre. Its body is weighed anew, see
 * thud_shape_set_density. What it then overlaps is pushed apart, no faster than the world's
 * push_speed. */
THUD_API thud_result thud_shape_set_radius(thud_world *world, thud_shape_id shape, float radius);
THUD_API thud_result thud_shape_set_half_extents(thud_world *world, thud_shape_id shape,
                                                 thud_vec2 half_extents);
/* Whether its pairs have events: thud_events.h. Wakes nobody. */
THUD_API thud_result thud_shape_set_events(thud_world *world, thud_shape_id shape, bool events);
/* Wakes nobody; inside a callback, too. */
THUD_API thud_result thud_shape_set_user_data(thud_world *world, thud_shape_id shape,
                                              uint64_t user_data);

/* ---- bodies ---- */

/* What becomes static stands still, and loses its velocity; what becomes kinematic keeps it, and
 * goes on so; what becomes dynamic is weighed by its shapes. All its contacts end, and those that
 * still touch begin with the next step; forces that wait for it are gone. The sizes of its shapes
 * must fit the new kind, and a body with terrain is static. THUD_ERROR_INVALID too for a body that
 * is quarantined, and for one with joints, unless it changes between kinematic and dynamic, and
 * each of them goes on joining what such a joint may (thud_joint.h). THUD_ERROR_MEMORY. */
THUD_API thud_result thud_body_set_kind(thud_world *world, thud_body_id body, thud_body_kind kind);
THUD_API thud_result thud_body_set_damping(thud_world *world, thud_body_id body, float linear,
                                           float angular);
THUD_API thud_result thud_body_set_gravity_scale(thud_world *world, thud_body_id body,
                                                 float gravity_scale);
/* True stops a dynamic body's turning at once; kinematic ones turn as they are told. */
THUD_API thud_result thud_body_set_fixed_rotation(thud_world *world, thud_body_id body, bool fixed);
/* Null: the world's, now and whenever that changes. */
THUD_API thud_result thud_body_set_detection(thud_world *world, thud_body_id body,
                                             const thud_detection *detection);
THUD_API thud_result thud_body_set_may_sleep(thud_world *world, thud_body_id body, bool may_sleep);

typedef struct thud_mass {
    float mass;    /* [THUD_MASS_MIN, THUD_MASS_MAX] */
    float inertia; /* mass length^2, about the centre; [THUD_MASS_MIN, THUD_MASS_MAX], or 0: it does
                      not turn */
    thud_vec2 center; /* of mass, from the origin, in the body's frame; |x|, |y| <=
                         THUD_SIZE_MAX length scales */
} thud_mass;

/* Of a dynamic body: these hold whatever shapes come, go and change, until they are set again, the
 * body changes its kind, or `mass` is null: then it is what its shapes weigh. While its rotation is
 * fixed the inertia waits; a body with an AABB never turns, and has none. The velocity, of the
 * centre, stays the same number. */
THUD_API thud_result thud_body_set_mass(thud_world *world, thud_body_id body,
                                        const thud_mass *mass);

#ifdef __cplusplus
}
#endif

#endif
