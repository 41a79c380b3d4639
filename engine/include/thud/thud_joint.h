/* thud_joint.h: what ties two bodies together, without a shape touching: rods, ropes, springs,
 * hinges, sliders, welds, wheels and targets. A program that makes no joint links none of this.
 *
 * A joint looks at body b from body a, in three directions: along the x axis of frame a, across it
 * (its y axis), and by turning. Each is locked, free, or driven, as its kind has it:
 *
 *     kind            along               across     turn      frame b
 *     THUD_DISTANCE   the distance (*)    free       free      its position counts
 *     THUD_HINGE      locked              locked     driven    its position, and the angle's zero
 *     THUD_SLIDER     driven              locked     locked    likewise
 *     THUD_WELD       locked, or driven where it has a spring, each by itself
 *     THUD_WHEEL      driven              locked     driven    likewise
 *     THUD_TARGET     driven              driven     driven    likewise
 *
 * (*) the distance between both positions: locked at `length`, or driven where it has limits, a
 * spring or a motor: a rope has limits (0, length), a spring a frequency and its rest as target.
 *
 * Joints are solved softly with all else, and give way under a load; an island in which they would
 * by more than its quality allows, while it has work left for that, is solved directly, with its
 * contacts. A body that its detection stops on its way opens its joints by as much, until the next
 * step closes them. */
#ifndef THUD_JOINT_H
#define THUD_JOINT_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Index and generation, as of other handles: thud_ids.h. */
typedef struct thud_joint_id {
    uint32_t index1;
    uint32_t generation;
} thud_joint_id;

typedef enum thud_joint_kind {
    THUD_DISTANCE = 0,
    THUD_HINGE,
    THUD_SLIDER,
    THUD_WELD,
    THUD_WHEEL,
    THUD_TARGET,
    THUD_JOINT_KIND_COUNT
} thud_joint_kind;

typedef enum thud_direction {
    THUD_ALONG = 0, /* or the distance */
    THUD_ACROSS,
    THUD_TURN,
    THUD_DIRECTION_COUNT
} thud_direction;

#define THUD_JOINT_FORCE_MAX 1e30f

/* What acts in a direction that is not locked: lengths and forces, or radians and torques. All at
 * once are fine: a spring towards a place, a motor up to its force, and limits that hold both. */
typedef struct thud_drive {
    bool limited;       /* default false */
    float lower, upper; /* lower <= upper; of turn within (-pi, pi), of a distance >= 0; |.| of
                           lengths at most 1e6 length scales. Equal: locked there */
    float frequency;    /* Hz, of the spring, [0, 1e4]; default 0: none. About the mass that the
                           bodies have there */
    float damping;      /* ratio, >= 0, <= 1e3; default 0.7; 1: critical */
    float target;       /* where the spring pulls to; within the range of limits */
    float spring_force; /* which the spring does not exceed, [0, THUD_JOINT_FORCE_MAX]; default
                           that */
    float motor_speed;  /* of b seen from a; |.| at most 1e6 length scales, or radians, a second */
    float motor_force;  /* up to which the motor acts, likewise; default 0: none */
} thud_drive;

/* A place and an axis in a body. */
typedef struct thud_joint_frame {
    thud_vec2 position; /* from the body's origin, in its frame; |.| at most 1e6 length scales */
    double angle;       /* of the x axis, against the body's; |angle| <= 1e6 */
} thud_joint_frame;

typedef struct thud_joint_def {
    thud_joint_kind kind;
    thud_body_id body_a, body_b; /* two, of which one is dynamic; of wheels and targets body b */
    thud_joint_frame frame_a, frame_b;
    thud_drive drive[THUD_DIRECTION_COUNT]; /* those that the kind drives */
    float length;           /* of a distance, > 0, at most 1e6 length scales; default 1 */
    bool collide_connected; /* default false: the bodies' shapes do not meet */
    bool disabled;          /* default false */
    uint64_t user_data;
} thud_joint_def;

THUD_API thud_joint_def thud_default_joint_def(thud_joint_kind kind);

/* A joint takes effect with the next step, and wakes both bodies then; it is gone with either, and
 * lets go while either is disabled. None of these inside a callback: THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_create(thud_world *world, const thud_joint_def *def,
                                       thud_joint_id *out);
THUD_API thud_result thud_joint_destroy(thud_world *world, thud_joint_id joint);
THUD_API bool thud_joint_is_valid(const thud_world *world, thud_joint_id joint);

typedef struct thud_joint_state {
    thud_joint_kind kind;
    thud_body_id body_a, body_b;
    bool enabled;
    double value[THUD_DIRECTION_COUNT]; /* where b is, seen from a; value[THUD_TURN] in (-pi, pi] */
    double gap;                         /* length by which locked directions are off */
    double angle_gap;                   /* likewise, rad; both >= 0 */
    thud_vec2 force;                    /* on b, in the world, as it was last solved */
    float torque; /* on b, about its centre of mass less that of `force`: of turn alone */
    uint64_t user_data;
} thud_joint_state;

THUD_API thud_result thud_joint_get(const thud_world *world, thud_joint_id joint,
                                    thud_joint_state *out);
/* A direction that the kind drives; wakes the bodies, as the next two do. */
THUD_API thud_result thud_joint_set_drive(thud_world *world, thud_joint_id joint,
                                          thud_direction direction, const thud_drive *drive);
/* Of a distance. */
THUD_API thud_result thud_joint_set_length(thud_world *world, thud_joint_id joint, float length);
THUD_API thud_result thud_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled);
THUD_API thud_result thud_joint_set_user_data(thud_world *world, thud_joint_id joint,
                                              uint64_t user_data);

/* A world that never made a joint refuses to be restored from a snapshot that has some: this makes
 * it ready, as making one does. */
THUD_API thud_result thud_world_use_joints(thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
