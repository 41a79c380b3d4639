/* thud_make.h: worlds and bodies in one expression each, for games that make many alike: a body of
 * one shape, by a struct in which zero is the default. Who wants more of a def, or several shapes,
 * takes thud_body_create_with_shapes (thud_edits.h). Included by whoever uses it; a program that
 * does not, does not link it.
 *
 *     thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
 *     thud_body_make(world, thud_aabb_at(0, -1, 20, 1), NULL);
 *     thud_body_options bouncy = {.kind = THUD_DYNAMIC, .restitution = 0.8f};
 *     thud_body_id ball = thud_body_make(world, thud_circle_at(0, 5, 0.5), &bouncy);
 *
 * Both return what they made: null, or the null handle, where they are refused, for the reasons
 * that thud_world_create and thud_body_create_with_shapes have; then nothing has changed, and the
 * world's log has heard why. A null handle may be handed on: every call refuses it. */
#ifndef THUD_MAKE_H
#define THUD_MAKE_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of this gravity (length/s^2) and quality (never null), all else as thud_default_world_def has it.
 * Its log is set by thud_world_set_log. */
THUD_NODISCARD THUD_API thud_world *thud_world_make(thud_vec2 gravity, const thud_quality *quality);

/* Of a body and its shape; those of a def, with its ranges, but that zero is the default, also
 * where the def has another one. What a zero cannot say has a flag. */
typedef struct thud_body_options {
    thud_body_kind kind; /* default static */
    thud_vec2 velocity;  /* length/s */
    float angular_velocity;
    float linear_damping, angular_damping;
    bool weightless; /* gravity does not draw it */
    bool fixed_rotation;
    const thud_detection *detection; /* default null: the world's */
    float density;                   /* [0, THUD_DENSITY_MAX]; default (0) 1 */
    float friction;                  /* [0, THUD_FRICTION_MAX]; default (0) 0.6 */
    bool frictionless;               /* in place of a friction */
    float restitution;               /* [0, THUD_RESTITUTION_MAX] */
    float surface_speed;             /* |.| <= THUD_SURFACE_SPEED_MAX length scales a second */
    uint32_t category, mask;         /* of the filter; default (0) 1 and all */
    int32_t group;
    bool sensor;
    uint64_t user_data; /* of the body, and of its shape */
} thud_body_options;

/* A body with a circle, AABB or OBB in the place that is given: its origin is the shape's centre,
 * and its angle that of the OBB. Null: the default options. */
THUD_API thud_body_id thud_body_make(thud_world *world, thud_shape_instance shape,
                                     const thud_body_options *options);

#ifdef __cplusplus
}
#endif

#endif
