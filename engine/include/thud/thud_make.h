/* thud_make.h: creates a world, or a body of one shape, in one expression. Options are a struct in
 * which zero is the default. For all fields of a def, or for several shapes, use
 * thud_body_create_with_shapes (thud_edits.h). thud.h does not include this header; a program that
 * does not use it does not link it.
 *
 *     thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
 *     thud_body_make(world, thud_aabb_at(0, -1, 20, 1), NULL);
 *     thud_body_options bouncy = {.kind = THUD_BODY_DYNAMIC, .restitution = 0.8f};
 *     thud_body_id ball = thud_body_make(world, thud_circle_at(0, 5, 0.5), &bouncy);
 *
 * Both return the created object; null, or the null handle, if they fail, for the reasons of
 * thud_world_create and thud_body_create_with_shapes. Nothing has changed then. Why a body was
 * refused is in the world's log. A world that was refused has no log of its own: the reason goes to
 * the default log, which release builds do not have (thud_world_def.log). A null handle may be
 * passed to any call, which then fails. */
#ifndef THUD_MAKE_H
#define THUD_MAKE_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A world with this gravity (length/s^2) and quality (not null), and the other values of
 * thud_default_world_def. thud_world_set_log gives it a log. */
THUD_NODISCARD THUD_API thud_world *thud_world_make(thud_vec2 gravity, const thud_quality *quality);

/* Options of a body and its shape, with the meaning and ranges of the fields of thud_body_def and
 * thud_shape_def. Zero selects the default, even if the default of the def is not zero; if zero
 * itself is a useful value, a flag selects it. */
typedef struct thud_body_options {
    thud_body_kind kind;                   /* default static */
    thud_vec2 velocity;                    /* length/s */
    float angular_velocity;                /* rad/s */
    float linear_damping, angular_damping; /* 1/s, >= 0 */
    bool weightless;                       /* gravity_scale 0 */
    bool fixed_rotation;                   /* no torque turns the body */
    const thud_detection *detection;       /* default null: the world's */
    float density;                         /* [0, THUD_DENSITY_MAX]; default (0) 1 */
    float friction;                        /* [0, THUD_FRICTION_MAX]; default (0) 0.6 */
    bool frictionless;                     /* friction 0; `friction` must be 0 then */
    float restitution;                     /* [0, THUD_RESTITUTION_MAX] */
    float surface_speed;     /* length/s, |.| <= THUD_SURFACE_SPEED_MAX length scales a second */
    uint32_t category, mask; /* of the filter; default (0) 1 and all bits */
    int32_t group;           /* of the filter */
    bool sensor;             /* the shape reports overlaps and collides with nothing */
    uint64_t user_data;      /* of the body, and of its shape */
} thud_body_options;

/* A body with one circle, AABB or OBB at the pose of `shape`: the body's origin is the shape's
 * centre, and its angle that of the OBB. `options` null: the defaults. */
THUD_API thud_body_id thud_body_make(thud_world *world, thud_geometry shape,
                                     const thud_body_options *options);

#ifdef __cplusplus
}
#endif

#endif
