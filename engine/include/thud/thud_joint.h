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
 *     THUD_FILTER     free                free       free      does not count
 *     THUD_GEAR       ties two joints together: see `gear` of the def
 *
 * (*) the distance between both positions: locked at `length`, or driven where it has limits, a
 * spring or a motor: a rope has limits (0, length), a spring a frequency, and pulls to `length`
 * unless it has a target.
 *
 * Joints are solved softly with all else, and give way under a load; an island in which they would
 * by more than its quality allows, while it has work left for that, is solved directly, with its
 * contacts. Where it has none left, or something in the island bounces, and at least half of the
 * joints of up to 128 bodies that they tie give way, those are solved directly by themselves:
 * contacts give them what the soft solver has made of them, and close no further than it has them.
 * Where that cannot be, would gain energy, or contacts are more than the bodies, joints give way.
 *
 * Where its detection stops a body on its way through a step, all that locked directions tie to it
 * stop as far on their ways and lose the speed that gravity gave them for the rest of the step, so
 * that their joints open by little more than the solver leaves; the statistics tell. Under `bisect`
 * and `swept` such bodies stop at what they meet, and bounce off as contacts do; what touches them
 * already is left to the contacts, which may overlap by as much as those of `continuous`.
 *
 * A joint loses against static shapes, at every quality and under every detection. Where one
 * presses a body into what cannot move (a rope that is reeled in, a motor without a greatest
 * force), the body ends no step deeper than a tenth of its smallest half extent, or of half the
 * thickness of the shape where that is less; while the solver finds out, for some steps, than 0.4
 * of it. The body and all that locked directions tie to it are put back there, their joints closed
 * as far as contacts let them: ropes stay open, which thud_step_error tells, and motors stall. Such
 * a joint gives the body no speed; its force is what it reaches within a step from nothing.
 * Kinematic bodies are no static shapes, and a body that a joint has made faster than its detection
 * sees passes. */
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
    THUD_FILTER, /* their shapes do not meet, and that is all */
    THUD_GEAR,
    THUD_JOINT_KIND_COUNT
} thud_joint_kind;

typedef enum thud_direction {
    THUD_ALONG = 0, /* or the distance */
    THUD_ACROSS,
    THUD_TURN,
    THUD_DIRECTION_COUNT
} thud_direction;

/* What acts in a direction that is not locked: lengths and forces, or radians and torques. All at
 * once are fine: a spring towards a place, a motor up to its force, and limits that hold both. */
typedef struct thud_drive {
    bool limited;       /* default false */
    float lower, upper; /* lower <= upper; |.| of turn at most THUD_JOINT_TURN_MAX, of lengths
                           THUD_JOINT_LENGTH_MAX length scales; of a distance >= 0. Equal: locked
                           there */
    float frequency;    /* Hz, of the spring, [0, THUD_JOINT_FREQUENCY_MAX]; default 0: none. About
                           the mass that the bodies have there. A substep carries a radian of it:
                           of more than the rate of substeps / 2 pi it acts as one of that, which
                           is 19, 38, 76 and 153 Hz at draft, default, high and exact with 60 steps
                           a second, so that no spring adds energy by being stiff */
    float damping;      /* ratio, [0, THUD_JOINT_DAMPING_MAX]; default 0.7; 1: critical */
    float target;       /* where the spring pulls to; in the range of limits: THUD_JOINT_TURN_MAX,
                           THUD_JOINT_LENGTH_MAX. Default 0; of a distance -INFINITY, which stands
                           for its length, as set by thud_joint_set_length too */
    float spring_force; /* which the spring does not exceed, [0, THUD_JOINT_FORCE_MAX]; default
                           that: none. Where springs act along and across, each keeps its own cap,
                           and the force of both together is no longer than the greater one: with
                           the same cap for both it is that of the force, whichever way it points.
                           Once a step the direction that both want decides on their parts */
    float motor_speed;  /* of b seen from a, |.| <= THUD_JOINT_LENGTH_MAX length scales a second, or
                           THUD_JOINT_SPIN_MAX */
    float motor_force;  /* up to which the motor acts, [0, THUD_JOINT_FORCE_MAX]; default 0: none;
                           of a speed without force the log hears. Along and across together as
                           springs are: with speed 0 and the same cap it is friction */
} thud_drive;

/* A place and an axis in a body. */
typedef struct thud_joint_frame {
    thud_vec2 position; /* from the body's origin, in its frame; |x|, |y| <= THUD_JOINT_LENGTH_MAX
                           length scales */
    double angle;       /* of the x axis, against the body's; |angle| <= THUD_ANGLE_MAX */
} thud_joint_frame;

typedef struct thud_joint_def {
    thud_joint_kind kind;
    thud_body_id body_a, body_b; /* two, of which one is dynamic; of wheels and targets body b */
    thud_joint_frame frame_a, frame_b;
    /* Of directions that the kind drives; limits, a spring or a motor of another one are refused.
     */
    thud_drive drive[THUD_DIRECTION_COUNT];
    /* Of a distance, (0, THUD_JOINT_LENGTH_MAX] length scales; default 1. Of a driven one where its
     * spring pulls to, unless that has a target. */
    float length;
    /* Of a gear: two joints, each a hinge, a wheel, a slider or a distance between a static body
     * and a dynamic one; the dynamic ones, which must not be the same, are the gear's bodies, and
     * body_a, body_b and the frames do not count. It keeps the value of the first (turn of a hinge
     * or a wheel, along of the others) plus `ratio` times that of the second as it is when the gear
     * is made, over any number of turns. While either is disabled it lets go, and goes on from
     * where they are then; with either it is gone. Directions of rows are those at the start of a
     * step: what a gear of distances keeps is off by the square of their turn in it. */
    thud_joint_id gear[2];
    float ratio;            /* of a gear, |ratio| in [THUD_GEAR_RATIO_MIN, THUD_GEAR_RATIO_MAX];
                               default 1: they turn against each other, as two wheels that mesh */
    bool collide_connected; /* default false: the bodies' shapes do not meet; of a gear true */
    /* Beyond either the joint breaks: it is destroyed at the end of that step, or, where
     * `only_reports`, goes on. Either way there is an event. */
    float break_force, break_torque; /* [0, THUD_JOINT_FORCE_MAX]; default that: never */
    bool only_reports;               /* default false */
    bool disabled;                   /* default false */
    uint64_t user_data;
    uint32_t cookie; /* of thud_default_joint_def */
} thud_joint_def;

THUD_API thud_joint_def thud_default_joint_def(thud_joint_kind kind);

/* A joint takes effect with the next step, and wakes both bodies then; it is gone with either, when
 * the body leaves as a step begins, and lets go while either is disabled. None of these inside a
 * callback: THUD_ERROR_LOCKED. */
THUD_NODISCARD THUD_API thud_result thud_joint_create(thud_world *world, const thud_joint_def *def,
                                                      thud_joint_id *out);
THUD_API thud_result thud_joint_destroy(thud_world *world, thud_joint_id joint);
THUD_API bool thud_joint_is_valid(const thud_world *world, thud_joint_id joint);

/* What drives a direction: forces, of THUD_TURN torques, that push value[direction] up where they
 * are > 0; within THUD_JOINT_FORCE_MAX, and 0 where there is no such drive. */
typedef struct thud_drive_forces {
    float limit, spring, motor;
} thud_drive_forces;

typedef struct thud_joint_state {
    thud_joint_kind kind;
    thud_body_id body_a, body_b;
    bool enabled;
    double value[THUD_DIRECTION_COUNT]; /* where b is, seen from a; value[THUD_TURN] in (-pi, pi] */
    double gap;                         /* length by which locked directions are off */
    double angle_gap;                   /* likewise, rad; both >= 0 */
    thud_vec2 force;                    /* on b, in the world, as it was last solved; it and
                                           the torque are within THUD_JOINT_FORCE_MAX */
    float torque; /* on b, about its centre of mass less that of `force`: of turn alone */
    thud_drive_forces drive[THUD_DIRECTION_COUNT]; /* the parts of both that drives have */
    uint64_t user_data;
} thud_joint_state;

THUD_API thud_result thud_joint_get(const thud_world *world, thud_joint_id joint,
                                    thud_joint_state *out);
/* What makes another like it, as it is now. Angles are in (-pi, pi]; of directions that the kind
 * does not drive, and of what it has none of, the defaults. */
THUD_API thud_result thud_joint_get_def(const thud_world *world, thud_joint_id joint,
                                        thud_joint_def *out);
/* A direction that the kind drives; wakes the bodies, as the next two do. */
THUD_API thud_result thud_joint_set_drive(thud_world *world, thud_joint_id joint,
                                          thud_direction direction, const thud_drive *drive);
/* Of a distance. */
THUD_API thud_result thud_joint_set_length(thud_world *world, thud_joint_id joint, float length);
THUD_API thud_result thud_joint_set_enabled(thud_world *world, thud_joint_id joint, bool enabled);
/* Where it is in a body (0: body_a, 1: body_b). Not of gears and filters. */
THUD_API thud_result thud_joint_set_frame(thud_world *world, thud_joint_id joint, int side,
                                          thud_joint_frame frame);
THUD_API thud_result thud_joint_set_breaking(thud_world *world, thud_joint_id joint, float force,
                                             float torque, bool only_reports);
THUD_API thud_result thud_joint_set_user_data(thud_world *world, thud_joint_id joint,
                                              uint64_t user_data);

/* A joint whose force or torque went beyond what it bears, in the last step or thud_world_advance.
 */
typedef struct thud_joint_event {
    thud_joint_id joint;
    thud_body_id body_a, body_b;
    uint64_t user_data;
    float force, torque; /* magnitudes */
    bool broken;         /* it is gone */
} thud_joint_event;

/* In the order of their making; valid until the next step. *count may be null. */
THUD_API const thud_joint_event *thud_world_joint_events(const thud_world *world, int *count);

/* Joints of the world, or of a body, in a deterministic order. Writes no more than `capacity` of
 * them to `out` (which may be null where that is 0) and returns how many there are; 0 where the
 * body is stale. */
THUD_API int thud_world_joints(const thud_world *world, thud_joint_id *out, int capacity);
THUD_API int thud_body_joints(const thud_world *world, thud_body_id body, thud_joint_id *out,
                              int capacity);

/* A world that never made a joint refuses to be restored from a snapshot that has some: this makes
 * it ready, as making one does. */
THUD_API thud_result thud_world_use_joints(thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
