/* thud.h: rigid bodies in two dimensions, in a world that advances in fixed steps.
 *
 * Units are the caller's own (metres, pixels), with one length scale in the world def; y is up,
 * angles are radians counter-clockwise, masses are density times area. One world is used by one
 * thread at a time; different worlds share nothing.
 *
 * Every def starts from its thud_default_..., which fills in the defaults and leaves a cookie: a
 * def without it, zeroed for instance, is refused. Ranges are those of thud_limits.h, vectors as
 * thud_math.h says.
 *
 * Every call that can fail returns a thud_result; when it fails, nothing has changed and the log
 * hook has heard why. Output pointers may be null where the answer is not wanted, unless said
 * otherwise.
 *
 * A world computes, and calls back, in a floating-point mode of its own, whatever that of the
 * calling or a job system's thread is, and gives it back: on x86-64, AArch64 and wasm, elsewhere it
 * must be the thread's. */
#ifndef THUD_H
#define THUD_H

#include "thud_detection.h"
#include "thud_draw.h"
#include "thud_events.h"
#include "thud_hooks.h"
#include "thud_ids.h"
#include "thud_limits.h"
#include "thud_math.h"
#include "thud_quality.h"
#include "thud_queries.h"
#include "thud_shapes.h"
#include "thud_terrain.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- world ---- */

/* One touching pair, as callbacks see it: of a static and a moving shape, a is the static one. */
typedef struct thud_contact {
    thud_shape_id shape_a, shape_b;
    thud_body_id body_a, body_b;
    thud_vec2 normal;      /* from a to b */
    thud_pos point;        /* in the middle of the contact points */
    float separation;      /* of the deepest point; negative is penetration */
    float normal_impulse;  /* epilogue only: the sum really applied over the step */
    float tangent_impulse; /* ... and that of friction, along (normal.y, -normal.x), on b */
    int point_count;       /* 1 or 2 */
} thud_contact;

/* How the surfaces of a pair act on each other in this step: a prologue finds what the shapes' defs
 * make of it, and may write something else. Values that are not finite or out of range are refused
 * through the log hook, and the pair keeps its own. */
typedef struct thud_contact_settings {
    float friction;      /* [0, THUD_FRICTION_MAX]; 0: ice */
    float restitution;   /* [0, THUD_BOUNCE_MAX]; above 1 the pair leaves faster than it came */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX; at which friction would have b
                            slide over a, along (normal.y, -normal.x): on top of a, to +x */
} thud_contact_settings;

typedef struct thud_world_def {
    thud_vec2 gravity;  /* length/s^2; default (0, -10) */
    double time_step;   /* s, (0, THUD_TIME_STEP_MAX]; default 1/60 */
    float length_scale; /* size of a typical body in the caller's unit, [THUD_LENGTH_SCALE_MIN,
                           THUD_LENGTH_SCALE_MAX]; default 1 for metres; every tolerance is a
                           multiple of it */
    const thud_quality *quality; /* default &thud_quality_default; never null */
    /* For experts; 0 (default) takes the quality's: */
    int substeps;            /* 1 .. THUD_SUBSTEPS_MAX */
    float contact_stiffness; /* [THUD_CONTACT_STIFFNESS_MIN, THUD_CONTACT_STIFFNESS_MAX] */
    float contact_damping;   /* [0, THUD_CONTACT_DAMPING_MAX] */
    /* Speeds, in length scales a second: */
    float push_speed;            /* [0, THUD_SPEED_MAX], at most which overlap is pushed apart;
                                    default 3 */
    float restitution_threshold; /* [0, THUD_SPEED_MAX]; slower approaches do not bounce; default 1.
                                    At restitution 1 at most 4 * gravity * time_step, swept in free
                                    flight gravity * time_step / 8 */
    float hit_speed;     /* [0, THUD_SPEED_MAX]; faster approaches are hit events; default 1 */
    float maximum_speed; /* (0, THUD_SPEED_MAX]; default that. Steps hold x and y of a velocity to
                            it, each; an impact on the way may leave more to the next step */
    bool sleeping; /* default true: what is connected falls asleep once it has been slower than
                      0.05 length scales a second for 0.5 s, and no gap of a joint and no
                      overlap in it closes faster than that */
    bool contact_events; /* collect begin, end and hit events; default true. Sensors report
                            either way */
    bool baseline_simd;  /* never AVX2: the same bits, slower; for tests. Default false */
    thud_allocator allocator;
    thud_log_fn *log; /* null: silent, the default; where thud is built without NDEBUG the default
                         is thud_log_to_stderr */
    void *log_context;
    thud_clock_fn *clock; /* null: stages are not timed */
    void *clock_context;
    double max_error;   /* length, [0, THUD_MAX_ERROR_MAX]; default 0: none. Islands in which
                           something overlaps by   more, or is going to under its load, go to the
                           quality's island   solver, and back when they can. Needs a quality that has
                           one: take   the one you want and set its `islands` */
    double time_budget; /* s, [0, THUD_TIME_BUDGET_MAX]; default 0: none. Where steps take longer,
                           substeps are halved, down to 1, and doubled again when there is time, and
                           the quality's island_work with them: the clock then decides what happens,
                           and runs differ. Needs `clock` */
    const thud_detection *detection;   /* default null: the quality's */
    const thud_broadphase *broadphase; /* default (also null): &thud_broadphase_grid */
    thud_job_system job_system;        /* threads to work on; default: the calling one alone */
    uint32_t cookie;                   /* of thud_default_world_def */
} thud_world_def;

THUD_API thud_world_def thud_default_world_def(void);
/* The same with another quality. A program that never asks for the default one does not link what
 * that needs: at draft it goes without the island solver. */
THUD_API thud_world_def thud_world_def_of(const thud_quality *quality);

THUD_NODISCARD THUD_API thud_result thud_world_create(const thud_world_def *def, thud_world **out);
/* Null is fine. Inside a callback the log hook hears THUD_ERROR_LOCKED, and the world lives on. */
THUD_API void thud_world_destroy(thud_world *world);

/* Runs one step. On THUD_ERROR_MEMORY nothing has moved and no event is told; edits are in effect,
 * as after a query, and whom it was to wake may be awake. Made again it ends with the same bits and
 * events. */
THUD_API thud_result thud_world_step(thud_world *world);

/* The world keeps its own time: runs as many whole steps as `elapsed` seconds, in [0,
 * THUD_ADVANCE_MAX], allow, at most `max_steps` (>= 1; time beyond that is dropped), and gives in
 * *alpha, in [0, 1), how far the present lies between the last step and the next, for
 * thud_world_poses. Call it once a picture; what happens does not depend on how often that is:
 *
 * Events, meetings, broken joints and impulses (thud_world_events and so on) are then those of all
 * steps that it made, in their order; none where it made none.
 *
 * Forces that were applied since the last call act for all of `elapsed`: each step gets their mean
 * over its time, also where its time came with several calls. So a force that is applied before
 * each call acts all the time, whatever the rate; one that is applied once acts for the time of
 * one picture. What shall act in one step alone, or depends on where bodies are or how they move,
 * as the forces of thud_fields.h do, is for `before` below.
 *
 * Where a step runs out of memory, *steps, *alpha and the events are of those before it, and the
 * time left waits for the next call; if it was the first, all is as if it had not been called.
 * THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_advance(thud_world *world, double elapsed, int max_steps,
                                        int *steps, double *alpha);

typedef void thud_step_fn(thud_world *world, void *context);

/* What to call before and after each step; either may be null. There the world may be edited, asked
 * and taken a snapshot of as between two calls of thud_world_step, but steps, thud_world_restore
 * and thud_world_destroy are THUD_ERROR_LOCKED. Forces act in one step: those of `before` in the
 * one that follows, those of `after` in the next. Events are those of the last step alone: in
 * `after` the one just made. Of a step that runs out of memory `before` is not called again when it
 * is tried again. */
typedef struct thud_step_calls {
    thud_step_fn *before, *after;
    void *context; /* handed to both */
} thud_step_calls;

/* thud_world_advance with such calls, which may be null. */
THUD_API thud_result thud_world_advance_with(thud_world *world, double elapsed, int max_steps,
                                             const thud_step_calls *calls, int *steps,
                                             double *alpha);

/* In place of the world's own from now on, also inside a callback; null: silent. THUD_ERROR_NULL
 * without a world. */
THUD_API thud_result thud_world_set_log(thud_world *world, thud_log_fn *log, void *context);

/* Settings hold from the next step on. Inside a callback they are refused with THUD_ERROR_LOCKED,
 * since the step under way has begun with the old ones. */
/* Wakes everything. */
THUD_API thud_result thud_world_set_gravity(thud_world *world, thud_vec2 gravity);
/* (0, THUD_TIME_STEP_MAX]. */
THUD_API thud_result thud_world_set_time_step(thud_world *world, double time_step);
/* [0, THUD_MAX_ERROR_MAX]; see thud_world_def. */
THUD_API thud_result thud_world_set_max_error(thud_world *world, double max_error);
/* What the def itself named stays as it is. Wakes everything. */
THUD_API thud_result thud_world_set_quality(thud_world *world, const thud_quality *quality);
THUD_API thud_result thud_world_set_sleeping(thud_world *world, bool sleeping);

/* ---- bodies ---- */

typedef enum thud_body_kind {
    THUD_STATIC = 0, /* never moves by itself */
    THUD_KINEMATIC,  /* moves at its set velocity, heeds no force */
    THUD_DYNAMIC,
    THUD_BODY_KIND_COUNT
} thud_body_kind;

typedef struct thud_body_def {
    thud_body_kind kind;    /* default static */
    thud_pos position;      /* of the body's origin; |x|, |y| <= THUD_PLACE_MAX length scales */
    double angle;           /* |angle| <= THUD_ANGLE_MAX */
    thud_vec2 velocity;     /* of the centre of mass; 0 where static, which never moves */
    float angular_velocity; /* rad/s; likewise; a step holds it to |.| <= THUD_SPIN_MAX */
    float gravity_scale;    /* default 1 */
    float linear_damping;   /* 1/s, >= 0 */
    float angular_damping;  /* 1/s, >= 0 */
    bool fixed_rotation;
    bool may_sleep;                  /* default true */
    const thud_detection *detection; /* default null: the world's */
    uint64_t user_data;
    uint32_t cookie; /* of thud_default_body_def */
} thud_body_def;

THUD_API thud_body_def thud_default_body_def(void);

THUD_NODISCARD THUD_API thud_result thud_body_create(thud_world *world, const thud_body_def *def,
                                                     thud_body_id *out);
THUD_API thud_result thud_body_destroy(thud_world *world, thud_body_id body); /* and its shapes */
THUD_API bool thud_body_is_valid(const thud_world *world, thud_body_id body);

typedef struct thud_body_state {
    thud_body_kind kind;
    thud_pos position; /* of the origin */
    thud_pos center;   /* of mass */
    double angle;      /* in (-pi, pi] */
    float cosine, sine;
    thud_vec2 velocity;
    float angular_velocity;
    float mass, inertia; /* 0 for static and kinematic, and 1 for a dynamic body without any;
                            inertia 0 when rotation is fixed */
    float gravity_scale;
    bool awake, enabled, quarantined;
    uint64_t user_data;
    int shape_count;
} thud_body_state;

THUD_API thud_result thud_body_get(const thud_world *world, thud_body_id body,
                                   thud_body_state *out);

/* Edits wake the body, also the bodies that touch it; places and angles have the ranges of the def.
 * All take effect together, as the next step begins; queries see shapes where edits put them, and
 * change nothing. Inside a callback they wait for the start of the next step, and come after what
 * is edited in between: until then no query sees them, and a shape made there takes no part in
 * anything, its mass included. What is destroyed there is stale at once. */
THUD_API thud_result thud_body_set_transform(thud_world *world, thud_body_id body,
                                             thud_pos position, double angle);
THUD_API thud_result thud_body_set_velocity(thud_world *world, thud_body_id body,
                                            thud_vec2 velocity, float angular_velocity);
THUD_API thud_result thud_body_apply_impulse(thud_world *world, thud_body_id body,
                                             thud_vec2 impulse, thud_pos point);
/* Acts through the next step only, or the time of the next thud_world_advance. */
THUD_API thud_result thud_body_apply_force(thud_world *world, thud_body_id body, thud_vec2 force,
                                           float torque);
/* False: the body counts as at rest from now on, and sleeps as soon as its whole island does. */
THUD_API thud_result thud_body_set_awake(thud_world *world, thud_body_id body, bool awake);
/* False takes the body and its shapes out of the world, as if destroyed: its contacts end, nothing
 * moves, meets or finds them. True brings it back, where it is and at the velocity it had. */
THUD_API thud_result thud_body_set_enabled(thud_world *world, thud_body_id body, bool enabled);
THUD_API thud_result thud_body_set_user_data(thud_world *world, thud_body_id body,
                                             uint64_t user_data);
/* Writes up to `capacity` (>= 0) shape handles to `out`, unless it is null; *count (likewise) is
 * how many the body has. */
THUD_API thud_result thud_body_shapes(const thud_world *world, thud_body_id body,
                                      thud_shape_id *out, int capacity, int *count);

/* ---- shapes ---- */

typedef struct thud_filter {
    uint32_t category; /* what it is; default 1 */
    uint32_t mask;     /* what it meets; default all */
    int32_t group;     /* two of the same group: > 0 always meet, < 0 never; 0 no group */
} thud_filter;         /* all zero meets nothing, which the log hears */

typedef struct thud_shape_def {
    float density;       /* [0, THUD_DENSITY_MAX]; default 1 */
    float friction;      /* [0, THUD_FRICTION_MAX]; default 0.6; a pair's is the geometric mean */
    float restitution;   /* [0, THUD_RESTITUTION_MAX]; default 0; a pair's is the larger */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX; default 0; at which the surface
                            runs clockwise about the shape, to +x on its top, as a conveyor belt;
                            a pair's is the sum */
    thud_filter filter;
    bool sensor; /* reports overlaps, collides with nothing; see thud_events.h */
    bool events; /* default true; false: nothing that it does is told; see thud_events.h */
    uint64_t user_data;
    uint32_t cookie; /* of thud_default_shape_def */
} thud_shape_def;

THUD_API thud_shape_def thud_default_shape_def(void);

/* Offsets are in the body's frame, |x|, |y| <= THUD_SIZE_MAX length scales. Sizes (radius, half
 * extents) lie in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales, of static bodies in [THUD_SIZE_MIN,
 * THUD_STATIC_SIZE_MAX]; longer ground is a terrain, or boxes side by side. Where a large shape is
 * turned, or large both ways, its surface is told to 1e-7 of its size. |angle| <= THUD_ANGLE_MAX.
 */
THUD_NODISCARD THUD_API thud_result thud_shape_create_circle(thud_world *world, thud_body_id body,
                                                             const thud_shape_def *def,
                                                             thud_vec2 offset, float radius,
                                                             thud_shape_id *out);
/* An AABB keeps its axes: its body's rotation is fixed from then on, and its angle must be 0. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_aabb(thud_world *world, thud_body_id body,
                                                           const thud_shape_def *def,
                                                           thud_vec2 offset, thud_vec2 half_extents,
                                                           thud_shape_id *out);
THUD_NODISCARD THUD_API thud_result thud_shape_create_obb(thud_world *world, thud_body_id body,
                                                          const thud_shape_def *def,
                                                          thud_vec2 offset, thud_vec2 half_extents,
                                                          double angle, thud_shape_id *out);
/* Only on static bodies with angle 0; coordinates are relative to the body's origin; the points
 * are copied. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_terrain(thud_world *world, thud_body_id body,
                                                              const thud_shape_def *def,
                                                              const thud_terrain *terrain,
                                                              thud_shape_id *out);
THUD_API thud_result thud_shape_destroy(thud_world *world, thud_shape_id shape);
THUD_API bool thud_shape_is_valid(const thud_world *world, thud_shape_id shape);

typedef struct thud_shape_state {
    thud_shape_kind kind;
    thud_body_id body;
    thud_vec2 offset;       /* in the body's frame, from its origin */
    thud_vec2 half_extents; /* circle: radius, 0; terrain: 0, 0 */
    double angle;           /* in the body's frame */
    float density, friction, restitution, surface_speed;
    thud_filter filter;
    bool sensor, events;
    uint64_t user_data;
} thud_shape_state;

THUD_API thud_result thud_shape_get(const thud_world *world, thud_shape_id shape,
                                    thud_shape_state *out);
/* The world's own copy of a terrain; valid until the next edit of the world. Edits of the
 * line are in thud_terrain.h. */
THUD_API thud_result thud_shape_terrain(const thud_world *world, thud_shape_id shape,
                                        thud_terrain *out);

/* ---- reading all poses at once ---- */

/* Position relative to the given origin, and rotation, of one body's origin. */
typedef struct thud_pose {
    float x, y, c, s;
} thud_pose;

/* Every body's pose at alpha in [0, 1] between the last two steps (0: the one before, 1: the last),
 * by slot (thud_body_id.index1 - 1); slots without a body have x = y = NaN. Belongs to the world,
 * valid until its next call. Null and *count = 0 if memory is short, or |origin.x| or |origin.y| >
 * THUD_PLACE_MAX length scales. */
THUD_API const thud_pose *thud_world_poses(thud_world *world, thud_pos origin, double alpha,
                                           int *count);

/* ---- statistics ---- */

typedef enum thud_stage {
    THUD_STAGE_CHANGES = 0,
    THUD_STAGE_BROADPHASE,
    THUD_STAGE_NARROWPHASE,
    THUD_STAGE_CONTACTS, /* the prologue */
    THUD_STAGE_SOLVE,
    THUD_STAGE_FINALIZE,
    THUD_STAGE_CONTINUOUS,
    THUD_STAGE_EVENTS, /* the epilogue */
    THUD_STAGE_SLEEP,
    THUD_STAGE_COUNT
} thud_stage;

THUD_API const char *thud_stage_name(thud_stage stage);

typedef struct thud_stats {
    uint64_t steps;
    int bodies, shapes, awake_bodies, pairs, contacts; /* contacts: touching pairs */
    int colours, blocks;
    int substeps;                           /* of the last step; see time_budget */
    uint64_t bytes;                         /* memory held by the world */
    uint64_t step_allocations;              /* made by the last step */
    double stage_seconds[THUD_STAGE_COUNT]; /* of the last step; 0 without a clock */
    double step_seconds;
    /* Islands solved at once in the last step, and what joints tie, see thud_joint.h. */
    int direct_islands, direct_bodies;
    int soft_islands;    /* of them, that stayed as the soft solver had them */
    int factorings;      /* of matrices ... */
    int64_t island_work; /* ... and operations on blocks, see thud_quality.h */
    /* Detection in the last step. */
    int impacts;         /* collisions within the step, bisected or swept */
    int held_bodies;     /* stopped before its end ... */
    double held_seconds; /* ... and the time that they lost, together */
    int unbisectable;    /* bodies beyond the bisection limit, where any are bisected:
                            unless swept, they may have passed through something */
    int motion_pairs;    /* pairs whose motions were looked at, ... */
    int motion_circles, motion_boxes, motion_exact; /* ... whose circles met, whose boxes, and whose
                                             time of collision was worked out */
} thud_stats;

THUD_API thud_stats thud_world_stats(const thud_world *world);

/* The speed from which on bisection may miss something: the thickness of the thinnest shape, but
 * for terrain, a time step; infinite without. Bodies below it, with what turning adds, miss
 * nothing. */
THUD_API thud_result thud_world_bisection_limit(thud_world *world, double *speed);

/* What the last step got wrong, found as it was solved: costs nothing to ask, but in a step in
 * which detection held bodies back or resolved collisions a pass over contacts, and a pass over
 * joints, where there are any. Of contacts that are awake (thud_world_measure has those that sleep
 * as well), where detection left the bodies: one that it held back, or that met something within
 * the step, counts as it stands at the end. The same with any number of workers. */
typedef struct thud_step_error {
    double penetration_max, penetration_mean; /* lengths, at the end of the step, over the points of
                                    touching pairs, with turns taken as linear in their angle */
    double residual; /* length/s: fastest approach that the solver's last pass still met, before
                              it took it away; in a step that solved islands directly, what is
                              left */
    double energy_change; /* of kinetic and potential energy, mass length^2/s^2, to a millionth of
                             the kinetic: negative where friction, damping and restitution take
                                   some; positive is energy that nobody put in, or that forces,
                                   kinematic bodies and moving surfaces did */
    int overlaps;     /* points deeper than max_error, or without one than 0.005 length scales */
    double shortfall; /* length: how far the body that detection held back the most, of
                         thud_stats.held_bodies, ended from where its motion would have taken it; 0
                         where none was held */
    double joint_gap_max,
        joint_gap_mean;     /* lengths: by how much joints are open at the end of the
                               step, asleep or awake, as thud_joint_state.gap has it */
    double joint_angle_max; /* likewise, angle_gap, rad */
} thud_step_error;

/* All 0 before the first step. */
THUD_API thud_step_error thud_world_error(const thud_world *world);

/* Error and energy of the present state; costs a pass over contacts and bodies. */
typedef struct thud_measure {
    double penetration_max, penetration_mean; /* over touching points, lengths; where detection
                                    moved bodies on or held them, as in thud_step_error */
    double kinetic_energy, potential_energy;  /* potential against the world's height 0 */
} thud_measure;

THUD_API thud_measure thud_world_measure(const thud_world *world);

/* Hash of every body's exact position, angle and velocity, in slot order. */
THUD_API uint64_t thud_world_hash(const thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
