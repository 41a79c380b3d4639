/* thud_joint.h: joints, constraints between two bodies, whether or not their shapes touch: rods,
 * ropes, springs, hinges, sliders, welds, wheels, targets and gears. A program that creates no
 * joint links none of this. Lengths are in the caller's unit; for bounds in
 * length scales see thud_limits.h.
 *
 * A joint has a frame in each body: an anchor and an x axis. It measures body b relative to body a
 * in three directions: along the x axis of frame a, across it (along its y axis), and in rotation
 * (turn). Each direction is locked, free, or driven (it may have limits, a spring and a motor),
 * depending on the kind:
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
 * (*) the distance between the positions of both frames: locked at `length`, or driven if it has
 * limits, a spring or a motor. A rope has limits (0, length); a spring has a frequency, and pulls
 * to `length` unless it has a target.
 *
 * Load. Joints are solved as soft constraints together with contacts, and open under a load. A
 * joint is overloaded if a contact of the same bodies with the same impulse would overlap by more
 * than thud_quality.overlap_limit, or if the joint is open by more than thud_world_def.max_error.
 * An island with an overloaded joint is solved directly, with its contacts, as long as
 * thud_quality.island_work lasts. If it is used up, or a contact of the island bounces in this
 * step, groups of up to 128 bodies that joints connect may be solved directly by themselves. The
 * conditions are that at least half of the group's joints are overloaded (a quarter, if all are
 * hinges and welds), at most 64 joints of the world are, and the group has no more contacts with
 * moving bodies than it has bodies. Its contacts then keep the impulses of the soft solver, and the
 * joints may not bring shapes closer together than in the soft solver's result. If joints and
 * contacts cannot both be satisfied so, a tree of hinges and welds is solved without regard to
 * contacts, which may then overlap more until the next step; of others, and where the result would
 * gain energy, the soft solver's result is kept. If closing gaps lifts bodies, which adds potential
 * energy, their kinetic energy is reduced by as much, so that a bridge or a rope that gives way
 * does not swing up by itself. This is not done in islands with motors or springs, or joined to a
 * body that the caller moves.
 *
 * Detection (thud_detection.h). If detection stops a body within a step, all bodies that locked
 * directions connect to it stop at the same fraction of their motions, and lose the speed that
 * gravity gave them for the rest of the step. So their joints open by little more than in the
 * solver's result; thud_stats.held_bodies counts such bodies. Under thud_detection_bisect and
 * thud_detection_swept such bodies stop where they hit something, and bounce as contacts do;
 * existing contacts are left to the contact solver, which may let them overlap as under
 * thud_detection_continuous.
 *
 * Static shapes are stronger than joints, at every quality and under every detection. If a joint
 * presses a body into a static body (a rope that is shortened, a motor without a maximum force),
 * the overlap at the end of a step is at most 0.4 of the body's smallest half extent, or of half
 * the thickness of the static shape if that is less; after it was reached, and as long as the joint
 * presses, it is at most a tenth. The body and all bodies that locked directions connect to it are
 * moved back, and their joints are closed as far as contacts allow: ropes stay too long, which
 * thud_step_error reports, and motors stall. A joint that has yielded in this way gives the body no
 * velocity, and starts the next step without an impulse: thud_joint_state.force is the force that
 * it reaches within one step. This does not apply to kinematic bodies, nor to a body that a joint
 * moves so fast that its detection misses the collision. A known defect: a rope that is shortened
 * further and further, although an obstacle holds its body, may in rare cases still pull the body
 * through a floor. */
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

/* The kinds of joints. The table at the head of this header says which directions each locks. */
typedef enum thud_joint_kind {
    THUD_JOINT_DISTANCE = 0, /* a rod; with limits a rope, with a spring a spring */
    THUD_JOINT_HINGE,        /* both bodies turn about a common point */
    THUD_JOINT_SLIDER,       /* b moves along an axis of a, and does not turn */
    THUD_JOINT_WELD,         /* b keeps its place and angle relative to a */
    THUD_JOINT_WHEEL,        /* b turns about a point that moves along an axis of a */
    THUD_JOINT_TARGET,       /* drives alone: springs or motors lead b to a place and an angle */
    THUD_JOINT_FILTER, /* excludes contacts between the bodies' shapes, and does nothing else */
    THUD_JOINT_GEAR,   /* couples the coordinates of two joints */
    THUD_JOINT_KIND_COUNT
} thud_joint_kind;

/* The directions in which a joint measures b relative to a. */
typedef enum thud_direction {
    THUD_DIRECTION_ALONG =
        0,                 /* along the x axis of frame a; for THUD_JOINT_DISTANCE the distance */
    THUD_DIRECTION_ACROSS, /* along the y axis of frame a */
    THUD_DIRECTION_TURN,   /* rotation */
    THUD_DIRECTION_COUNT
} thud_direction;

/* Limits, spring and motor of a direction that is not locked, in lengths and forces, or in radians
 * and torques. A drive may have a spring, a motor and limits at once. */
typedef struct thud_drive {
    bool limited;       /* whether it has limits; default false. A joint that is created
                           with limits but not with this is logged */
    float lower, upper; /* limits, lower <= upper; |.| at most THUD_JOINT_ANGLE_MAX (pi) for turn,
                           and THUD_JOINT_LENGTH_MAX length scales for lengths; >= 0 for a distance.
                           Equal limits lock the direction there. Default 0 */
    float frequency;    /* of the spring, Hz, [0, THUD_JOINT_FREQUENCY_MAX]; default 0: no spring.
                           It is the frequency of the effective mass of both bodies in this
                           direction. The phase in a substep is limited to a radian, so that no
                           spring adds energy by being stiff: above (substeps per second) / 2 pi the
                           spring acts as one of that frequency, which is 19, 38, 76 and 153 Hz at
                           draft, default, high and exact with 60 steps a second */
    float damping;      /* damping ratio of the spring, [0, THUD_JOINT_DAMPING_MAX]; default 0.7;
                           1: critical */
    float target;       /* coordinate to which the spring pulls, with the range of limits:
                           THUD_JOINT_ANGLE_MAX, THUD_JOINT_LENGTH_MAX. Default 0; for a distance
                           -INFINITY, which means its length, also after thud_joint_set_length */
    float spring_force; /* maximum force of the spring, [0, THUD_JOINT_FORCE_MAX]; default
                           THUD_JOINT_FORCE_MAX: no maximum. If springs act along and across,
                           neither exceeds its own maximum, and the resultant of both does not
                           exceed the greater maximum: with equal maxima, this is the maximum of the
                           force in any direction. It is split between both once in a step, in
                           proportion to the forces that they would have at the start of the step */
    float motor_speed;  /* target speed of b relative to a, |.| <= THUD_JOINT_LENGTH_MAX length
                           scales a second, or THUD_JOINT_ANGULAR_SPEED_MAX radians a second; default
                           0 */
    float motor_force;  /* maximum force of the motor, [0, THUD_JOINT_FORCE_MAX]; default 0: no
                           motor; a speed without a force is logged. Motors along and across share
                           the maximum as springs do: with speed 0 and equal maxima they act as
                           friction */
} thud_drive;

/* An anchor and an axis in a body. */
typedef struct thud_joint_frame {
    thud_vec2 position; /* from the body's origin, in its frame; |x|, |y| <= THUD_JOINT_LENGTH_MAX
                           length scales */
    double angle;       /* of the x axis, relative to the body's x axis, rad; |angle| <=
                           THUD_ANGLE_MAX */
} thud_joint_frame;

/* What a joint is created from. */
typedef struct thud_joint_def {
    thud_joint_kind kind;        /* as given to thud_default_joint_def */
    thud_body_id body_a, body_b; /* two bodies, at least one of them dynamic; for wheels and targets
                                    body_b must be dynamic */
    thud_joint_frame frame_a, frame_b; /* default: the bodies' own frames */
    /* By thud_direction. Limits, springs and motors in directions that the kind does not drive are
     * THUD_ERROR_INVALID. */
    thud_drive drive[THUD_DIRECTION_COUNT];
    /* Length of a distance, in the caller's unit, (0, THUD_JOINT_LENGTH_MAX] length scales; default
     * 1, at any length scale. For a driven distance it is the length to which the spring pulls,
     * unless the spring has a target. */
    float length;
    /* The two joints that a gear couples, each a hinge, a wheel, a slider or a distance between a
     * static body and a dynamic one. The dynamic bodies, which must be different, are the gear's
     * bodies; body_a, body_b and the frames of its def are not used. The gear keeps the sum q0 +
     * ratio * q1 of the joints' coordinates (turn of a hinge or a wheel, along of the others) at
     * its value when the gear was created, over any number of turns. While the gear, either joint
     * or either of its bodies is disabled, the gear does nothing; when all are enabled again, it
     * keeps the value that the sum has then. It is destroyed with either joint. Its directions are
     * those at the start of a step: a gear of distances has an error proportional to the square of
     * their rotation in a step. */
    thud_joint_id gear[2];
    float ratio;            /* of a gear, |ratio| in [THUD_GEAR_RATIO_MIN, THUD_GEAR_RATIO_MAX];
                               default 1: they turn in opposite directions, as two wheels that
                               mesh */
    bool collide_connected; /* the bodies' shapes may touch; default false, for a gear true */
    /* The joint breaks if its force or torque (thud_joint_state) exceeds these: it is destroyed at
     * the end of that step, or kept if `only_reports`. Either way there is a thud_joint_event. [0,
     * THUD_JOINT_FORCE_MAX]; default THUD_JOINT_FORCE_MAX: it never breaks. */
    float break_force, break_torque;
    bool only_reports;  /* default false */
    bool enabled;       /* default true */
    uint64_t user_data; /* the caller's own; default 0 */
    uint32_t cookie;    /* set by thud_default_joint_def */
} thud_joint_def;

/* A def of this kind with the defaults: the bodies are still to be named. */
THUD_API thud_joint_def thud_default_joint_def(thud_joint_kind kind);

/* Creates a joint. It takes effect with the next step, which wakes both bodies. It does nothing
 * while either body is disabled. When either body is destroyed, the joint is destroyed as the next
 * step begins. `out` may be null. THUD_ERROR_NULL for a null world or def; THUD_ERROR_STALE for a
 * body or, of a gear, a joint that does not exist; THUD_ERROR_INVALID for a def without cookie or
 * with a field out of range; THUD_ERROR_LOCKED inside a callback; THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_joint_create(thud_world *world, const thud_joint_def *def,
                                                      thud_joint_id *out);
/* Destroys a joint, which wakes its bodies. THUD_ERROR_NULL, THUD_ERROR_STALE; THUD_ERROR_LOCKED
 * inside a callback. */
THUD_API thud_result thud_joint_destroy(thud_world *world, thud_joint_id joint);
/* Whether the handle names a joint of this world. */
THUD_API bool thud_joint_is_valid(const thud_world *world, thud_joint_id joint);

/* Forces of a direction's drive in the last substep; torques for THUD_DIRECTION_TURN. A positive
 * force increases thud_joint_state.value of the direction. Magnitudes are at most
 * THUD_JOINT_FORCE_MAX, and 0 if the drive has no such part. */
typedef struct thud_drive_forces {
    float limit, spring, motor;
} thud_drive_forces;

/* All values of a joint. */
typedef struct thud_joint_state {
    thud_joint_kind kind;
    thud_body_id body_a, body_b;
    bool enabled;
    double value[THUD_DIRECTION_COUNT]; /* coordinates of b relative to a, lengths;
                                           value[THUD_DIRECTION_TURN] is an angle in (-pi, pi] */
    double gap;       /* length, >= 0, by which locked directions are open and limits exceeded: the
                         resultant of along and across; for a gear its error, if that is a length */
    double angle_gap; /* rad, >= 0: the same in direction turn */
    thud_vec2 force;  /* on b, in the world, in the last substep; it and the
                         torque are within THUD_JOINT_FORCE_MAX */
    float torque;     /* on b, from the direction turn alone: the moment of `force` is not
                         included */
    thud_drive_forces drive[THUD_DIRECTION_COUNT]; /* the parts of force and torque that drives
                                                      apply */
    uint64_t user_data;
} thud_joint_state;

/* All values of a joint. THUD_ERROR_NULL, THUD_ERROR_STALE; *out is then not written. */
THUD_API thud_result thud_joint_get_state(const thud_world *world, thud_joint_id joint,
                                          thud_joint_state *out);
/* A def of the joint's present settings, from which a copy can be created. Angles are in (-pi, pi];
 * fields that the kind does not use have their defaults. THUD_ERROR_NULL, THUD_ERROR_STALE. */
THUD_API thud_result thud_joint_get_def(const thud_world *world, thud_joint_id joint,
                                        thud_joint_def *out);
/* Replaces the drive of a direction; the kind must drive it. Wakes the bodies. THUD_ERROR_NULL,
 * THUD_ERROR_STALE, THUD_ERROR_INVALID, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_set_drive(thud_world *world, thud_joint_id joint,
                                          thud_direction direction, const thud_drive *drive);
/* Sets the length of a THUD_JOINT_DISTANCE, (0, THUD_JOINT_LENGTH_MAX] length scales. Wakes the
 * bodies. THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_INVALID, THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_set_length(thud_world *world, thud_joint_id joint, float length);
/* Whether the joint acts; a joint of any kind. A change wakes the bodies. THUD_ERROR_NULL,
 * THUD_ERROR_STALE, THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled);
/* Sets the frame in a body (side 0: body_a, 1: body_b). Not for gears and filters. Wakes the
 * bodies. THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_INVALID, THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_set_frame(thud_world *world, thud_joint_id joint, int side,
                                          thud_joint_frame frame);
/* Sets break_force, break_torque and only_reports of thud_joint_def. Wakes no body.
 * THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_INVALID, THUD_ERROR_LOCKED. */
THUD_API thud_result thud_joint_set_breaking(thud_world *world, thud_joint_id joint, float force,
                                             float torque, bool only_reports);
/* Wakes no body, and takes effect at once. THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_LOCKED. */
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

/* The events, within a step in the order of the joints' slots; valid until the next step.
 * *out_count is their number. THUD_ERROR_NULL. */
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

/* The joints of the world in the order of their slots, written as the lists of thud_lists.h.
 * *out_count is their number; at most `capacity` (>= 0) are written. THUD_ERROR_NULL,
 * THUD_ERROR_INVALID for a negative capacity. */
THUD_API thud_result thud_world_get_joints(const thud_world *world, thud_joint_id *out,
                                           int capacity, int *out_count);
/* The same with the joints of a body, in a deterministic order. THUD_ERROR_NULL, THUD_ERROR_STALE,
 * THUD_ERROR_INVALID for a negative capacity. */
THUD_API thud_result thud_body_get_joints(const thud_world *world, thud_body_id body,
                                          thud_joint_id *out, int capacity, int *out_count);

/* Prepares a world for joints, as creating one does. A world that never had a joint must be
 * prepared before it can be restored from a snapshot with joints. THUD_ERROR_NULL;
 * THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_use_joints(thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
