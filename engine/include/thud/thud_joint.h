/* thud_joint.h: joints, constraints between two bodies, whether or not their shapes touch: rods,
 * ropes, springs, hinges, sliders, welds, wheels, targets and gears. A program that makes no joint
 * links none of this. Lengths are in the caller's unit; a bound in length scales is a multiple of
 * thud_world_def.length_scale.
 *
 * A joint has a frame in each body: an anchor and an x axis. It measures body b relative to body a
 * in three directions: along the x axis of frame a, across it (along its y axis), and in rotation
 * (turn). Each direction is locked, free, or driven, depending on the kind:
 *
 *     kind      along              across    turn     what of frame b is used
 *     DISTANCE  the distance (*)   free      free     position
 *     HINGE     locked             locked    driven   position; angle, the zero of turn
 *     SLIDER    driven             locked    locked   position; angle
 *     WELD      each locked, or driven where it       position; angle
 *               has a drive
 *     WHEEL     driven             locked    driven   position; angle
 *     TARGET    driven             driven    driven   position; angle
 *     FILTER    free               free      free     nothing
 *     GEAR      couples two joints: see `gear` of the def
 *
 * A driven direction without limits, spring and motor is free.
 *
 * (*) the distance between both positions: locked at `length`, or driven where it has limits, a
 * spring or a motor. A rope has limits (0, length); a spring has a frequency, and pulls to `length`
 * unless it has a target.
 *
 * Load. Joints are solved as soft constraints together with contacts, and open under a load. A
 * joint is overloaded where a contact of the same bodies, with the joint's impulse, would overlap
 * by more than thud_quality.overlap_limit, or where the joint is open by more than
 * thud_world_def.max_error. An island with an overloaded joint is solved directly, with its
 * contacts, as long as thud_quality.island_work lasts. Where that is used up, or a contact of the
 * island bounces in this step, a part of it may be solved directly instead: up to 128 bodies that
 * joints connect, if at least half of these joints are overloaded, in all of the world at most 64,
 * and the bodies have no more contacts with moving bodies than there are bodies. Their contacts
 * then keep the impulses of the soft solver, and the joints may not bring shapes closer together
 * than it has. Where joints and contacts cannot both be satisfied so, or the result would gain
 * energy, joints stay soft.
 *
 * Detection (thud_detection.h). Where detection stops a body on its way through a step, all bodies
 * that locked directions connect to it stop at the same share of their motions, and lose the speed
 * that gravity gave them for the rest of the step. Their joints thus open by little more than the
 * solver leaves; thud_stats.held_bodies counts such bodies. Under thud_detection_bisect and
 * thud_detection_swept such bodies stop where they hit something, and bounce as contacts do;
 * contacts that touch already are left to the contact solver, which may let them overlap as under
 * thud_detection_continuous.
 *
 * Static shapes are stronger than joints, at every quality and under every detection. Where a joint
 * presses a body into a body that cannot move (a rope that is shortened, a motor without a maximum
 * force), the body ends no step deeper than 0.4 of its smallest half extent, or of half the
 * thickness of the shape where that is less; once it has been that deep, and as long as the joint
 * presses, no deeper than a tenth. The body and all that locked directions connect to it are put
 * back there, and their joints are closed as far as contacts allow: ropes stay too long, which
 * thud_step_error reports, and motors stall. A joint that has yielded so gives the body no speed,
 * and starts the next step without an impulse: thud_joint_state.force is what it reaches within one
 * step. This does not apply to kinematic bodies, nor to a body that a joint moves so fast that its
 * detection misses the collision. A known fault: a rope that is shortened without end, far beyond
 * what stands in its way, may in rare cases draw a body through a floor all the same. */
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
    THUD_JOINT_DISTANCE = 0,
    THUD_JOINT_HINGE,
    THUD_JOINT_SLIDER,
    THUD_JOINT_WELD,
    THUD_JOINT_WHEEL,
    THUD_JOINT_TARGET,
    THUD_JOINT_FILTER, /* excludes contacts between the bodies' shapes, and does nothing else */
    THUD_JOINT_GEAR,
    THUD_JOINT_KIND_COUNT
} thud_joint_kind;

typedef enum thud_direction {
    THUD_DIRECTION_ALONG = 0, /* of THUD_JOINT_DISTANCE the distance */
    THUD_DIRECTION_ACROSS,
    THUD_DIRECTION_TURN,
    THUD_DIRECTION_COUNT
} thud_direction;

/* What acts in a direction that is not locked, in lengths and forces, or in radians and torques. A
 * drive may have a spring, a motor and limits at once. */
typedef struct thud_drive {
    bool limited;       /* whether it has limits; default false */
    float lower, upper; /* limits, lower <= upper; |.| of turn at most THUD_JOINT_ANGLE_MAX (pi), of
                           lengths THUD_JOINT_LENGTH_MAX length scales; of a distance >= 0. Equal
                           limits lock the direction there. Default 0 */
    float frequency;    /* of the spring, Hz, [0, THUD_JOINT_FREQUENCY_MAX]; default 0: no spring.
                           It is that of the effective mass of both bodies in this direction. The
                           phase in a substep is limited to a radian: above the rate of
                           substeps / 2 pi the spring acts as one of that frequency, which is
                           19, 38, 76 and 153 Hz at draft, default, high and exact with 60
                           steps a second, so that no spring adds energy by being stiff */
    float damping;      /* damping ratio of the spring, [0, THUD_JOINT_DAMPING_MAX]; default 0.7;
                           1: critical */
    float target;       /* coordinate to which the spring pulls, with the range of limits:
                           THUD_JOINT_ANGLE_MAX, THUD_JOINT_LENGTH_MAX. Default 0; of a distance
                           -INFINITY, which stands for its length, also after
                           thud_joint_set_length */
    float spring_force; /* maximum force of the spring, [0, THUD_JOINT_FORCE_MAX]; default that: no
                           maximum. Where springs act along and across, neither exceeds its own
                           maximum, nor the resultant of both the greater one: with the same
                           maximum for both, it is the maximum of the force in any direction. It
                           is split between both once a step, by the forces that they would have
                           as the step begins */
    float motor_speed;  /* target speed of b relative to a, |.| <= THUD_JOINT_LENGTH_MAX length
                           scales a second, or THUD_JOINT_ANGULAR_SPEED_MAX radians a second; default
                           0 */
    float motor_force;  /* maximum force of the motor, [0, THUD_JOINT_FORCE_MAX]; default 0: no
                           motor; a speed without a force is logged. Along and across together as
                           for springs: with speed 0 and the same maximum it acts as friction */
} thud_drive;

/* An anchor and an axis in a body. */
typedef struct thud_joint_frame {
    thud_vec2 position; /* from the body's origin, in its frame; |x|, |y| <= THUD_JOINT_LENGTH_MAX
                           length scales */
    double angle;       /* of the x axis against the body's, rad; |angle| <= THUD_ANGLE_MAX */
} thud_joint_frame;

typedef struct thud_joint_def {
    thud_joint_kind kind;
    thud_body_id body_a, body_b; /* two bodies, at least one of them dynamic; of wheels and targets
                                    body_b is dynamic */
    thud_joint_frame frame_a, frame_b; /* default: the bodies' own frames */
    /* By thud_direction. Limits, springs and motors in directions that the kind does not drive are
     * refused. */
    thud_drive drive[THUD_DIRECTION_COUNT];
    /* Length of a distance, in the caller's unit, (0, THUD_JOINT_LENGTH_MAX] length scales; default
     * 1, whatever the length scale. Of a driven distance it is where the spring pulls to, unless
     * that has a target. */
    float length;
    /* Two joints that a gear couples, each a hinge, a wheel, a slider or a distance between a
     * static body and a dynamic one. The dynamic bodies, which must not be the same, are the gear's
     * bodies; body_a, body_b and the frames of its def are not used. The gear keeps the coordinate
     * of the first joint (turn of a hinge or a wheel, along of the others) plus `ratio` times that
     * of the second as it is when the gear is made, over any number of turns. While either joint is
     * disabled the gear does nothing, and then keeps the coordinates that it finds; it is destroyed
     * with either joint. Directions are those at the start of a step: a gear of distances has an
     * error of the square of their rotation in a step. */
    thud_joint_id gear[2];
    float ratio;            /* of a gear, |ratio| in [THUD_GEAR_RATIO_MIN, THUD_GEAR_RATIO_MAX];
                               default 1: they turn against each other, as two wheels that mesh */
    bool collide_connected; /* the bodies' shapes may touch; default false, of a gear true */
    /* Force and torque, as of thud_joint_state, beyond which the joint breaks: it is destroyed at
     * the end of that step, or stays if `only_reports`. Either way there is a thud_joint_event. [0,
     * THUD_JOINT_FORCE_MAX]; default that: never. */
    float break_force, break_torque;
    bool only_reports; /* default false */
    bool enabled;      /* default true */
    uint64_t user_data;
    uint32_t cookie; /* of thud_default_joint_def */
} thud_joint_def;

THUD_API thud_joint_def thud_default_joint_def(thud_joint_kind kind);

/* A joint takes effect with the next step, and wakes both bodies then. It does nothing while either
 * body is disabled, and is destroyed with either, as the next step begins. `out` may be null.
 * All calls that create, change or destroy a joint return THUD_ERROR_LOCKED inside a callback. */
THUD_NODISCARD THUD_API thud_result thud_joint_create(thud_world *world, const thud_joint_def *def,
                                                      thud_joint_id *out);
THUD_API thud_result thud_joint_destroy(thud_world *world, thud_joint_id joint);
THUD_API bool thud_joint_is_valid(const thud_world *world, thud_joint_id joint);

/* Forces of a direction's drive in the last substep; torques for THUD_DIRECTION_TURN. Positive ones
 * increase thud_joint_state.value of the direction; they are within THUD_JOINT_FORCE_MAX, and 0
 * where the drive has no such part. */
typedef struct thud_drive_forces {
    float limit, spring, motor;
} thud_drive_forces;

typedef struct thud_joint_state {
    thud_joint_kind kind;
    thud_body_id body_a, body_b;
    bool enabled;
    double value[THUD_DIRECTION_COUNT]; /* coordinates of b relative to a, lengths;
                                           value[THUD_DIRECTION_TURN] in (-pi, pi] */
    double gap; /* length, >= 0, by which locked directions are open and limits exceeded: along and
                   across together, as a distance; of a gear its error, where that is a length */
    double angle_gap; /* rad, >= 0: likewise in direction turn */
    thud_vec2 force;  /* on b, in the world, in the last substep; it and the
                         torque are within THUD_JOINT_FORCE_MAX */
    float torque;     /* on b, of the direction turn alone: the moment of `force` is not included */
    thud_drive_forces drive[THUD_DIRECTION_COUNT]; /* parts of force and torque that drives apply */
    uint64_t user_data;
} thud_joint_state;

THUD_API thud_result thud_joint_get_state(const thud_world *world, thud_joint_id joint,
                                          thud_joint_state *out);
/* A def of the joint as it is now, from which another like it can be made. Angles are in (-pi, pi];
 * what the kind does not use has its default. */
THUD_API thud_result thud_joint_get_def(const thud_world *world, thud_joint_id joint,
                                        thud_joint_def *out);
/* Replaces the drive of a direction; the kind must drive it. Wakes the bodies, as the next two
 * calls do. */
THUD_API thud_result thud_joint_set_drive(thud_world *world, thud_joint_id joint,
                                          thud_direction direction, const thud_drive *drive);
/* Of a THUD_JOINT_DISTANCE only. */
THUD_API thud_result thud_joint_set_length(thud_world *world, thud_joint_id joint, float length);
THUD_API thud_result thud_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled);
/* Sets the frame in a body (side 0: body_a, 1: body_b). Not of gears and filters. Wakes the bodies.
 */
THUD_API thud_result thud_joint_set_frame(thud_world *world, thud_joint_id joint, int side,
                                          thud_joint_frame frame);
THUD_API thud_result thud_joint_set_breaking(thud_world *world, thud_joint_id joint, float force,
                                             float torque, bool only_reports);
THUD_API thud_result thud_joint_set_user_data(thud_world *world, thud_joint_id joint,
                                              uint64_t user_data);

/* A joint whose force or torque exceeded break_force or break_torque, in the last step or
 * thud_world_advance. */
typedef struct thud_joint_event {
    thud_joint_id joint;
    thud_body_id body_a, body_b;
    uint64_t user_data;
    float force, torque; /* magnitudes */
    bool broken;         /* the joint was destroyed */
} thud_joint_event;

/* Events, within a step in the order of the joints' slots; valid until the next step. *out_count is
 * their number. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_joint_events(const thud_world *world,
                                                 const thud_joint_event **out, int *out_count);

/* The same array, and its size in *out_count; null and 0 for a null world. */
static inline const thud_joint_event *thud_joint_events_of(const thud_world *world,
                                                           int *out_count) {
    const thud_joint_event *events = NULL;
    int count = 0;
    thud_world_get_joint_events(world, &events, &count);
    if (out_count) {
        *out_count = count;
    }
    return events;
}

/* Joints of the world, or of a body, in a deterministic order: lists as those of thud_lists.h.
 * *out_count is their number; at most `capacity` (>= 0) are written. THUD_ERROR_NULL,
 * THUD_ERROR_STALE, THUD_ERROR_INVALID for a negative capacity. */
THUD_API thud_result thud_world_get_joints(const thud_world *world, thud_joint_id *out,
                                           int capacity, int *out_count);
THUD_API thud_result thud_body_get_joints(const thud_world *world, thud_body_id body,
                                          thud_joint_id *out, int capacity, int *out_count);

/* Makes a world ready for joints, as creating one does. A world that never had a joint cannot be
 * restored from a snapshot with joints unless this was called. */
THUD_API thud_result thud_world_use_joints(thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
