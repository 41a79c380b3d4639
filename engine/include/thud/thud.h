/* thud.h: rigid bodies in two dimensions, in a world that advances in fixed time steps.
 *
 * Units: lengths are in a unit of the caller's choice (metres, pixels), and
 * thud_world_def.length_scale tells the engine the size of a typical body in it. Time is in
 * seconds, angles are in radians counter-clockwise, y points up. A mass is density times area.
 *
 * Threads: one world may be used by one thread at a time. Different worlds share nothing.
 *
 * Names: a function is named thud_, its object, and what it does: thud_body_set_velocity. Its
 * arguments are the object (the world first), inputs, and last the outputs, named out or out_...
 * A thud_geometry is a shape without a world, and thud_geometry_... are its functions;
 * thud_shape_... act on the shape of a body, by its handle. An enumerator begins with the name of
 * its type.
 *
 * Reads: thud_X_get_Y(..., out) writes the value and returns a thud_result. For use in expressions
 * some have an inline variant thud_Y_of(...), which returns the value, or zero if the read fails.
 * Lists end with (out, capacity, out_count): at most `capacity` (>= 0) elements are written, and
 * *out_count is the number of all; `out` may be null where capacity is 0.
 *
 * Structs: every def (thud_..._def) must be initialised by its thud_default_... function, which
 * sets the defaults and a cookie. A def without the cookie, for example a zeroed one, is
 * THUD_ERROR_INVALID. The other structs with such a function (query filter, rule, mover, explosion,
 * water) are refused likewise if they are zeroed. In options (thud_..._options) zero is the default
 * of every field. The ranges of all values are in thud_limits.h; thud_math.h says which vector type
 * is used where.
 *
 * Errors: calls that can fail return a thud_result, except for some that return a handle or a bool.
 * Unless its comment says otherwise, a call that fails has changed nothing and written no output,
 * and the log hook of its world has been told the reason, but for some calls that lack a pointer.
 * Where comments say nothing, functions of one body, shape or joint accept null outputs, and
 * functions of a whole world refuse them (THUD_ERROR_NULL).
 *
 * Callbacks: "inside a callback" means in a function that the engine calls during a step, query,
 * cast, move or drawing. The functions of thud_step_calls are called between steps, and do not
 * count.
 *
 * Floating-point mode: a world computes, and calls callbacks, in a mode of its own (rounding to
 * nearest, denormals kept), whatever the mode of the calling thread or a thread of the job system
 * is, and restores the thread's mode afterwards. This holds on x86-64, AArch64 and wasm; on other
 * platforms the thread must be in that mode. */
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
#include "thud_geometry.h"
#include "thud_terrain.h"

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- world ---- */

/* A pair of touching shapes, as callbacks get it. Of a static and a moving shape, a is the static
 * one. */
typedef struct thud_contact {
    thud_shape_id shape_a, shape_b;
    thud_body_id body_a, body_b;
    thud_vec2 normal;      /* unit, from a to b */
    thud_pos point;        /* the middle of the contact points */
    float separation;      /* length, of the deepest point; negative: penetration */
    float normal_impulse;  /* epilogue only: sum over the step, mass * length / s */
    float tangent_impulse; /* epilogue only: friction impulse on b over the step, along (normal.y,
                              -normal.x) */
    int point_count;       /* 1 or 2 */
} thud_contact;

/* The surface of a pair of shapes in this step. A prologue (pre-solve callback) gets the values
 * that follow from the two shapes, and may change them. A value that is not finite or out of range
 * is logged, and the pair keeps the values of its shapes. */
typedef struct thud_contact_settings {
    float friction;      /* coefficient, [0, THUD_FRICTION_MAX] */
    float restitution;   /* ratio of the speed after a bounce to the speed before, [0,
                            THUD_PAIR_RESTITUTION_MAX]; above 1 a bounce adds energy */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX length scales a second: the
                            speed of b over a at which friction is zero, along (normal.y,
                            -normal.x), which is +x if b lies on top of a */
} thud_contact_settings;

/* The optional parts of the engine that a world has from the start; see
 * thud_default_small_world_def. */
typedef struct thud_parts thud_parts;

/* What a world is created from. */
typedef struct thud_world_def {
    thud_vec2 gravity;  /* length/s^2; default (0, -10) */
    double time_step;   /* s, (0, THUD_TIME_STEP_MAX]; default 1/60 */
    float length_scale; /* size of a typical body in the caller's unit, [THUD_LENGTH_SCALE_MIN,
                           THUD_LENGTH_SCALE_MAX]; default 1, for metres. A "length scale" is
                           this, rounded down to a power of two (100: 64); every tolerance of the
                           engine is a multiple of that */
    const thud_quality *quality; /* default &thud_quality_default; never null */
    /* Overrides of the quality; the default 0 takes the value of the quality. */
    int substeps;            /* number of substeps in a step, 1 .. THUD_SUBSTEPS_MAX */
    float contact_stiffness; /* see thud_quality; [THUD_CONTACT_STIFFNESS_MIN,
                                THUD_CONTACT_STIFFNESS_MAX] */
    float contact_damping;   /* see thud_quality; [0, THUD_CONTACT_DAMPING_MAX] */
    /* Speeds, in length scales a second: */
    float push_speed; /* [0, THUD_SPEED_MAX]: the largest speed at which overlapping shapes
                         are separated; default 3 */
    float restitution_threshold; /* [0, THUD_SPEED_MAX]: pairs that approach more slowly do not
                                    bounce; default 1. With restitution 1 or more it is at most
                                    4 * gravity * time_step, length/s, and for swept bodies in free
                                    flight at most gravity * time_step / 8, of gravity along the
                                    normal. Those with less restitution use the larger of both */
    float
        hit_speed; /* [0, THUD_SPEED_MAX]: pairs that approach faster make hit events; default 1 */
    float maximum_speed; /* (0, THUD_SPEED_MAX]; default THUD_SPEED_MAX. A step clamps the
                            components x and y of a velocity to it; after an impact within a step a
                            body may be faster until the next step */
    bool sleeping; /* default true. An island (bodies that constraints connect) falls asleep once
                      each of its bodies has been slower than 0.05 length scales a second for 0.5 s,
                      and no gap of a joint and no overlap in it closes faster than that */
    bool contact_events;      /* collect begin, end and hit events; default true. Sensor events are
                                 collected in any case */
    thud_allocator allocator; /* default (all zero): the C library's */
    thud_log_fn *log;     /* default null: no log; where thud is built without NDEBUG the default is
                             thud_log_to_stderr */
    void *log_context;    /* passed to log */
    thud_clock_fn *clock; /* default null: stages are not timed */
    void *clock_context;  /* passed to clock */
    double max_error;     /* length, [0, THUD_MAX_ERROR_MAX]; default 0: no limit. An island with a
                             contact that overlaps by more, or will do so under its load, or with a
                             joint that is open by more, is solved by the quality's island solver
                             until the soft solver, which solves all other islands, keeps to the
                             limit again. Needs a quality with an island solver
                             (thud_quality.islands) */
    double time_budget;   /* s a step, [0, THUD_TIME_BUDGET_MAX]; default 0: no budget. If steps
                             take longer, substeps and the quality's island_work are halved, down to
                             one substep, and doubled again when time allows. Results then depend on
                             the clock, and differ from run to run. Needs `clock` */
    const thud_detection *detection;   /* default null: the quality's */
    const thud_broadphase *broadphase; /* default, also for null: &thud_broadphase_grid; another one
                                          in thud_default_small_world_def */
    float cell_size; /* length, [0, THUD_SIZE_MAX length scales]: the width of the cells of
                        thud_broadphase_grid for all shapes whose bounds fit into one; larger shapes
                        get larger cells. Default 0: chosen by the sizes of the shapes, which is
                        faster in nearly all worlds. Results are the same, bit for bit */
    thud_job_system job_system; /* default (all zero): the calling thread alone */
    const thud_parts
        *parts;      /* set by thud_default_world_def; null in thud_default_small_world_def */
    uint32_t cookie; /* set by thud_default_world_def */
} thud_world_def;

/* The defaults, with quality thud_quality_default. */
THUD_API thud_world_def thud_default_world_def(void);
/* The defaults with another quality. A program that only uses qualities without an island solver,
 * such as thud_quality_draft, and this call, does not link the island solver. */
THUD_API thud_world_def thud_default_world_def_of(const thud_quality *quality);
/* The same for small programs: the parts that follow are linked only if the program calls a
 * function that needs them. Everything else behaves the same, bit for bit.
 *
 * Sensors: a thud_shape_def whose `sensor` is true is refused (THUD_ERROR_INVALID) until
 * thud_shape_set_sensor has made a shape of the world a sensor, or a snapshot of one with sensors
 * restored into it; both link sensors.
 *
 * Restitution: a thud_shape_def or thud_rule whose `restitution` is above 0 is refused likewise,
 * and the settings of a prologue stay as they were, until thud_shape_set_restitution has been
 * called in the world, with 0 too, or a snapshot of one in which it was restored into it.
 *
 * Sleep: `sleeping` is false, and refused as true, until thud_world_set_sleeping has been called
 * with true, or a snapshot of a world in which it was restored into it.
 *
 * Errors of steps: thud_world_get_step_error is refused until thud_world_use_step_error has been
 * called, or a snapshot of a world in which it was restored into it.
 *
 * A `time_budget` above 0 is refused.
 *
 * The grid: `broadphase` is &thud_broadphase_all, which costs the least where shapes are few. Where
 * they are hundreds, name another one, which links it; null is refused. */
THUD_API thud_world_def thud_default_small_world_def(const thud_quality *quality);

/* Creates a world, *out. THUD_ERROR_NULL for a null def or out, THUD_ERROR_INVALID for a def
 * without cookie or with a field out of range, THUD_ERROR_MEMORY; *out is then not written. */
THUD_NODISCARD THUD_API thud_result thud_world_create(const thud_world_def *def, thud_world **out);
/* Destroys a world with all its bodies, shapes and joints. Null does nothing. Inside a callback of
 * the world the call does nothing either, and the log hook is told THUD_ERROR_LOCKED. */
THUD_API void thud_world_destroy(thud_world *world);

/* Runs one step of time_step seconds. A dynamic body without contacts and joints follows the exact
 * path of its acceleration and damping, at every quality, to the rounding of its velocity to a
 * float. On THUD_ERROR_MEMORY no body has moved and no event is reported, but edits have taken
 * effect, and bodies that the step was going to wake may be awake. If the step is run again, it has
 * the same results, bit for bit, and the same events. There is one exception. Under bisect and
 * swept, bodies may meet shapes on their paths that the broadphase did not expect, for example
 * where they cross thousands of length scales in a step. If there are more such pairs than 256,
 * plus one for each body and one for each body and line of ground, the step allocates memory while
 * bodies move. If that fails, the step succeeds, but stops these bodies on their paths
 * (thud_stats.held_bodies), and so has other results than with enough memory. THUD_ERROR_NULL;
 * THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_step(thud_world *world);

/* Advances the world by `elapsed` seconds, in [0, THUD_ADVANCE_MAX]: runs the whole steps that fit
 * into this time plus the remainder of earlier calls, but at most `max_steps` (>= 1), and drops the
 * time of further steps. *out_steps: the number of steps run. *out_alpha, in [0, 1): the time left
 * over as a fraction of a step, for thud_world_get_poses. Call it once a frame; the motion does not
 * depend on the frame rate.
 *
 * Events, meetings, broken joints and impulses (thud_events_of and so on) are afterwards those
 * of all steps of the call, in order; none if it ran no step.
 *
 * Forces that were applied since the last call act during all of `elapsed`: each step applies their
 * mean over its time, even if its time comes from several calls. So a force that is applied before
 * each call acts continuously at any frame rate, and a force that is applied once acts for one
 * frame. For forces that act in a single step, or that depend on positions or velocities of bodies,
 * such as those of thud_fields.h, use `before` of thud_world_advance_with.
 *
 * If a step runs out of memory the call returns THUD_ERROR_MEMORY; *out_steps, *out_alpha and the
 * events are those of the steps before it, and the rest of the time waits for the next call. If it
 * was the first step, it is as if thud_world_step had failed: no body has moved and no time has
 * passed, but edits have taken effect. THUD_ERROR_NULL; THUD_ERROR_INVALID for a value out of
 * range; THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_advance(thud_world *world, double elapsed, int max_steps,
                                        int *out_steps, double *out_alpha);

/* A callback of thud_step_calls. */
typedef void thud_step_fn(thud_world *world, void *context);

/* Callbacks before and after each step. Inside them the world may be edited, queried and saved to a
 * snapshot as between two calls of thud_world_step; only stepping, thud_world_restore,
 * thud_world_load, thud_world_destroy and calls of a recorder are THUD_ERROR_LOCKED. Forces applied
 * inside them act in one step: those of `before` in the step that follows, those of `after` in the
 * one after it. Events are those of the last step alone; in `after` these are the events of the
 * step just run. When a step that ran out of memory is tried again, `before` is not called again.
 */
typedef struct thud_step_calls {
    thud_step_fn *before, *after; /* null: not called */
    void *context;                /* passed to both */
} thud_step_calls;

/* As thud_world_advance, with these callbacks and the same errors; `calls` may be null. With
 * max_steps < 1 or `elapsed` out of range the result is THUD_ERROR_INVALID. */
THUD_API thud_result thud_world_advance_with(thud_world *world, double elapsed, int max_steps,
                                             const thud_step_calls *calls, int *out_steps,
                                             double *out_alpha);

/* Replaces the world's log from now on; null: no log. Allowed inside a callback. THUD_ERROR_NULL
 * for a null world. */
THUD_API thud_result thud_world_set_log(thud_world *world, thud_log_fn *log, void *context);

/* Settings take effect with the next step. All return THUD_ERROR_NULL for a null world,
 * THUD_ERROR_INVALID for a value out of range, and THUD_ERROR_LOCKED inside a callback, because the
 * present step has begun with the old value. */
/* length/s^2, finite. Wakes all bodies. */
THUD_API thud_result thud_world_set_gravity(thud_world *world, thud_vec2 gravity);
/* The length of a step, s, (0, THUD_TIME_STEP_MAX]. */
THUD_API thud_result thud_world_set_time_step(thud_world *world, double time_step);
/* length, [0, THUD_MAX_ERROR_MAX]; see thud_world_def.max_error. THUD_ERROR_INVALID also above 0 in
 * a world without island solver. Wakes all bodies. */
THUD_API thud_result thud_world_set_max_error(thud_world *world, double max_error);
/* Substeps, contact_stiffness, contact_damping and detection keep their values if the def of the
 * world set them. `quality` is copied; THUD_ERROR_NULL if it is null, THUD_ERROR_INVALID also if it
 * has no island solver and max_error is above 0. Wakes all bodies. */
THUD_API thud_result thud_world_set_quality(thud_world *world, const thud_quality *quality);
/* Whether islands fall asleep; false wakes all bodies. */
THUD_API thud_result thud_world_set_sleeping(thud_world *world, bool sleeping);

/* ---- bodies ---- */

/* How a body moves. */
typedef enum thud_body_kind {
    THUD_BODY_STATIC = 0, /* has no velocity; moves only by thud_body_set_transform */
    THUD_BODY_KINEMATIC,  /* moves at the velocity that is set; no force or contact changes it */
    THUD_BODY_DYNAMIC,    /* moves by forces and contacts */
    THUD_BODY_KIND_COUNT
} thud_body_kind;

/* What a body is created from. */
typedef struct thud_body_def {
    thud_body_kind kind; /* default static */
    thud_pos position;   /* of the body's origin, |x|, |y| <= THUD_PLACE_MAX length scales; default
                            (0, 0) */
    double angle;        /* rad, |angle| <= THUD_ANGLE_MAX; default 0 */
    thud_vec2 velocity;  /* of the centre of mass, length/s; default (0, 0); must be (0, 0) for
                            static bodies */
    float angular_velocity; /* rad/s; default 0; must be 0 for static bodies. A step clamps it to
                               |.| <= THUD_ANGULAR_SPEED_MAX */
    float gravity_scale;    /* factor of the world's gravity, finite; default 1 */
    float linear_damping;   /* 1/s, >= 0; default 0. After t seconds a velocity is multiplied by
                               exp(-damping * t) */
    float angular_damping;  /* 1/s, >= 0; default 0; the same for the angular velocity */
    bool fixed_rotation; /* no torque turns the body; default false. It keeps the angular_velocity
                            of this def; thud_body_set_velocity does not give a dynamic body another
                            one */
    bool may_sleep;      /* default true */
    const thud_detection *detection; /* default null: the world's */
    uint64_t user_data;              /* the caller's own; default 0 */
    uint32_t cookie;                 /* set by thud_default_body_def */
} thud_body_def;

/* A def with the defaults: a static body at (0, 0). */
THUD_API thud_body_def thud_default_body_def(void);

/* Creates a body without shapes; *out (may be null) is its handle. THUD_ERROR_NULL for a null world
 * or def, THUD_ERROR_INVALID for a def without cookie or with a field out of range,
 * THUD_ERROR_MEMORY. A body that is created inside a callback is added to the world in the next
 * step. */
THUD_NODISCARD THUD_API thud_result thud_body_create(thud_world *world, const thud_body_def *def,
                                                     thud_body_id *out);
/* Destroys a body with its shapes and joints. THUD_ERROR_NULL, THUD_ERROR_STALE. */
THUD_API thud_result thud_body_destroy(thud_world *world, thud_body_id body);
/* Whether the handle names a body of this world. */
THUD_API bool thud_body_is_valid(const thud_world *world, thud_body_id body);

/* All values of a body. */
typedef struct thud_body_state {
    thud_body_kind kind;
    thud_pos position;      /* of the origin */
    thud_pos center;        /* centre of mass, in the world */
    double angle;           /* rad, in (-pi, pi] */
    float cosine, sine;     /* of the angle */
    thud_vec2 velocity;     /* of the centre of mass, length/s */
    float angular_velocity; /* rad/s */
    float mass; /* 0 for static and kinematic bodies; a dynamic body whose shapes have no mass has
                   mass 1. Shapes for which sqrt(mass * inertia) (the mass where rotation is fixed)
                   would leave 2^-90..2^90, about 1e-27..1e27, get a mass and an inertia that are
                   scaled into this range, as if the shapes had another density */
    float inertia; /* about the centre of mass, mass * length^2; 0 for static and kinematic bodies,
                      and where rotation is fixed */
    float gravity_scale;
    bool awake, enabled;
    bool quarantined; /* its velocity or motion became non-finite: it has no contacts any more, and
                         stays where it was. Edits of its pose, velocity, forces, awake and enabled
                         have no effect; it can be destroyed */
    uint64_t user_data;
    int shape_count;
} thud_body_state;

/* All values of a body. THUD_ERROR_NULL, THUD_ERROR_STALE; *out is then not written. */
THUD_API thud_result thud_body_get_state(const thud_world *world, thud_body_id body,
                                         thud_body_state *out);

/* Edits. An edit wakes the body and the bodies that touch it. Positions and angles have the ranges
 * of the def. All edits take effect together when the next step begins; queries before it already
 * see shapes at the poses that edits gave them. Edits inside a callback wait for the start of the
 * next step, and are applied after the edits that are made between the steps: until then no query
 * sees them, and a shape that was created inside a callback has no contacts and no mass. Handles of
 * objects that are destroyed inside a callback are stale at once. All return THUD_ERROR_NULL for a
 * null world, THUD_ERROR_STALE, THUD_ERROR_INVALID for a value out of range, and, inside a
 * callback, THUD_ERROR_MEMORY. */
/* Sets the position of the body's origin, and the body's angle, rad. The angle of a body with an
 * AABB or terrain must be 0. */
THUD_API thud_result thud_body_set_transform(thud_world *world, thud_body_id body,
                                             thud_pos position, double angle);
/* Sets the velocity of the centre of mass, length/s, and the angular velocity, rad/s; both finite.
 * THUD_ERROR_INVALID for a static body, and for a kinematic body with an AABB that would turn. */
THUD_API thud_result thud_body_set_velocity(thud_world *world, thud_body_id body,
                                            thud_vec2 velocity, float angular_velocity);
/* Changes the velocities of a dynamic body by an impulse, mass * length / s, finite, at a point in
 * world coordinates, |x|, |y| <= THUD_PLACE_MAX length scales. */
THUD_API thud_result thud_body_apply_impulse(thud_world *world, thud_body_id body,
                                             thud_vec2 impulse, thud_pos point);
/* Applies a force, mass * length / s^2, finite, at the centre of mass of a dynamic body during the
 * next step, or during `elapsed` of the next thud_world_advance. Forces add up. At a point of the
 * body: thud_forces.h. */
THUD_API thud_result thud_body_apply_center_force(thud_world *world, thud_body_id body,
                                                  thud_vec2 force);
/* The same with a torque, mass * length^2 / s^2, finite. */
THUD_API thud_result thud_body_apply_torque(thud_world *world, thud_body_id body, float torque);
/* For a dynamic body, else THUD_ERROR_INVALID: true wakes it. False: the body counts as if it had
 * been at rest for 0.5 s already, so that its island falls asleep as soon as all bodies of it, this
 * one too, are at rest. This has no effect on a body that moves faster than the speed at
 * thud_world_def.sleeping, on one with may_sleep false, or if another edit of the body follows
 * before the step. */
THUD_API thud_result thud_body_set_awake(thud_world *world, thud_body_id body, bool awake);
/* False removes the body and its shapes from the simulation, as if it were destroyed: its contacts
 * end, and no body, query or joint acts on it. True brings it back at its pose, with the velocity
 * that it had. */
THUD_API thud_result thud_body_set_enabled(thud_world *world, thud_body_id body, bool enabled);
/* Does not wake the body, and takes effect at once. */
THUD_API thud_result thud_body_set_user_data(thud_world *world, thud_body_id body,
                                             uint64_t user_data);
/* Writes up to `capacity` (>= 0) handles of the body's shapes to `out`, unless it is null.
 * *out_count, unless `out_count` is null, is the number of shapes of the body. THUD_ERROR_NULL,
 * THUD_ERROR_STALE, THUD_ERROR_INVALID for a negative capacity. */
THUD_API thud_result thud_body_get_shapes(const thud_world *world, thud_body_id body,
                                          thud_shape_id *out, int capacity, int *out_count);

/* ---- shapes ---- */

/* Which shapes collide: two shapes collide if the category of each is in the mask of the other. */
typedef struct thud_filter {
    uint32_t category; /* bits: what the shape is; default 1 */
    uint32_t mask;     /* bits: the categories that it collides with; default all */
    int32_t group; /* two shapes of the same group > 0 always collide, of the same group < 0 never,
                      whatever category and mask are; default 0: no group */
} thud_filter;     /* an all-zero filter collides with nothing, which is logged */

/* What a shape is created from, apart from its size and position. */
typedef struct thud_shape_def {
    float density;     /* mass / length^2, [0, THUD_DENSITY_MAX]; default 1 */
    float friction;    /* coefficient, [0, THUD_FRICTION_MAX]; default 0.6. A pair has the geometric
                          mean of both values */
    float restitution; /* [0, THUD_RESTITUTION_MAX]; default 0. A pair has the larger of both
                          values */
    float surface_speed; /* length/s, |.| <= THUD_SURFACE_SPEED_MAX length scales a second; default
                            0. The surface moves clockwise about the shape at this speed, to +x on
                            its top, like a conveyor belt. A pair has the sum of both values */
    thud_filter filter;  /* default: category 1, mask all, no group */
    bool sensor; /* the shape reports overlaps and collides with nothing, see thud_events.h; default
                    false */
    bool events; /* default true; false: no contact of the shape makes events, see thud_events.h */
    uint64_t user_data; /* the caller's own; default 0 */
    uint32_t cookie;    /* set by thud_default_shape_def */
} thud_shape_def;

/* A def with the defaults. */
THUD_API thud_shape_def thud_default_shape_def(void);

/* Creating shapes. The offset is the shape's centre in the body's frame, |x|, |y| <= THUD_SIZE_MAX
 * length scales. Sizes (radius, half extents) lie in [THUD_SIZE_MIN, THUD_SIZE_MAX] length scales,
 * on static bodies in [THUD_SIZE_MIN, THUD_STATIC_SIZE_MAX]; for longer ground use a terrain or
 * several boxes. If a large shape is rotated, or large in both directions, the position of its
 * surface is rounded to 1e-7 of its size. |angle| <= THUD_ANGLE_MAX. *out (may be null) is the
 * shape's handle. All return THUD_ERROR_NULL for a null world or def, THUD_ERROR_STALE for the
 * body, THUD_ERROR_INVALID for a value out of range, and THUD_ERROR_MEMORY. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_circle(thud_world *world, thud_body_id body,
                                                             const thud_shape_def *def,
                                                             thud_vec2 offset, float radius,
                                                             thud_shape_id *out);
/* A box that stays parallel to the axes: the rotation of its body is fixed while it has one, and
 * the body's angle must be 0. Once its last AABB was destroyed, the body takes an angle again, and
 * turns from the next step on. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_aabb(thud_world *world, thud_body_id body,
                                                           const thud_shape_def *def,
                                                           thud_vec2 offset, thud_vec2 half_extents,
                                                           thud_shape_id *out);
/* A box that turns with its body; `angle` is relative to the body, rad. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_obb(thud_world *world, thud_body_id body,
                                                          const thud_shape_def *def,
                                                          thud_vec2 offset, thud_vec2 half_extents,
                                                          double angle, thud_shape_id *out);
/* A ground line; only on a static body with angle 0. Its coordinates are relative to the body's
 * origin. The points are copied. */
THUD_NODISCARD THUD_API thud_result thud_shape_create_terrain(thud_world *world, thud_body_id body,
                                                              const thud_shape_def *def,
                                                              const thud_terrain *terrain,
                                                              thud_shape_id *out);
/* THUD_ERROR_NULL, THUD_ERROR_STALE. */
THUD_API thud_result thud_shape_destroy(thud_world *world, thud_shape_id shape);
/* Whether the handle names a shape of this world. */
THUD_API bool thud_shape_is_valid(const thud_world *world, thud_shape_id shape);

/* All values of a shape. */
typedef struct thud_shape_state {
    thud_shape_kind kind;
    thud_body_id body;
    thud_vec2 offset;                                    /* in the body's frame, from its origin */
    thud_vec2 half_extents;                              /* circle: (radius, 0); terrain: (0, 0) */
    double angle;                                        /* in the body's frame, rad */
    float density, friction, restitution, surface_speed; /* as in thud_shape_def */
    thud_filter filter;
    bool sensor, events;
    uint64_t user_data;
} thud_shape_state;

/* All values of a shape. THUD_ERROR_NULL, THUD_ERROR_STALE; *out is then not written. */
THUD_API thud_result thud_shape_get_state(const thud_world *world, thud_shape_id shape,
                                          thud_shape_state *out);
/* The world's own copy of a terrain's line; its points are valid until the next edit of the world.
 * THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_INVALID for another kind of shape. Edits of the
 * line are in thud_terrain.h. */
THUD_API thud_result thud_shape_get_terrain(const thud_world *world, thud_shape_id shape,
                                            thud_terrain *out);

/* ---- reading all poses at once ---- */

/* The pose of a body. */
typedef struct thud_pose {
    float x, y; /* the body's origin, relative to the origin of the call */
    float c, s; /* cosine and sine of the body's angle */
} thud_pose;

/* The poses of all bodies between the last two steps, interpolated by alpha in [0, 1] (0: the step
 * before, 1: the last step). The array *out is indexed by slot (thud_body_id.index1 - 1) and has
 * *out_count elements; slots without a body have x = y = NaN, but not those of anchors
 * (thud_locks.h), which thud_world_get_body_at does not name. It belongs to the world, and is valid
 * until the next thud_world_get_poses, thud_world_restore or thud_world_destroy. THUD_ERROR_NULL,
 * THUD_ERROR_INVALID if alpha is out of range or |origin.x| or |origin.y| > THUD_PLACE_MAX length
 * scales, THUD_ERROR_MEMORY. */
THUD_API thud_result thud_world_get_poses(thud_world *world, thud_pos origin, double alpha,
                                          const thud_pose **out, int *out_count);

/* Returns the same array, and its size in *out_count; null and 0 if the call fails. */
static inline const thud_pose *thud_poses_of(thud_world *world, thud_pos origin, double alpha,
                                             int *out_count) {
    const thud_pose *poses = NULL;
    int count = 0;
    thud_world_get_poses(world, origin, alpha, &poses, &count);
    if (out_count) {
        *out_count = count;
    }
    return poses;
}

/* ---- statistics ---- */

/* Stages of a step, in their order. */
typedef enum thud_stage {
    THUD_STAGE_CHANGES = 0, /* edits take effect */
    THUD_STAGE_BROADPHASE,  /* new pairs of shapes whose bounds overlap */
    THUD_STAGE_NARROWPHASE, /* contact points; memory for the rest of the step */
    THUD_STAGE_CONTACTS,    /* rules and prologue (pre-solve) */
    THUD_STAGE_SOLVE,       /* substeps and directly solved islands */
    THUD_STAGE_FINALIZE,    /* motion is added to poses and bounds */
    THUD_STAGE_CONTINUOUS,  /* detection of what bodies meet within the step */
    THUD_STAGE_EVENTS,      /* sensors, epilogue (post-solve), breaking joints */
    THUD_STAGE_SLEEP,       /* islands fall asleep */
    THUD_STAGE_COUNT
} thud_stage;

/* A name in lower case, "unknown" for another value; a static string. */
THUD_API const char *thud_stage_name(thud_stage stage);

/* Counts and times of a world and of its last step. */
typedef struct thud_stats {
    uint64_t steps;     /* steps that the world has run */
    int bodies, shapes; /* created and not destroyed */
    int awake_bodies;   /* dynamic and kinematic ones */
    int pairs;          /* pairs of shapes whose bounds, extended by a margin, overlap */
    int contacts;       /* pairs of shapes that touch */
    int colours;        /* groups into which the solver sorts constraints, so that no two
                           constraints of a group share a moving body */
    int blocks;     /* blocks of up to eight constraints, which the solver solves side by side */
    int substeps;   /* of the last step; see time_budget */
    uint64_t bytes; /* memory that the world holds */
    uint64_t step_allocations;              /* allocations of the last step */
    double stage_seconds[THUD_STAGE_COUNT]; /* of the last step; 0 without a clock */
    double step_seconds;                    /* of the whole step; 0 without a clock */
    /* Islands solved directly in the last step, also because of joints, see thud_joint.h. */
    int direct_islands, direct_bodies;
    int soft_islands;    /* of these, islands that kept the result of the soft solver */
    int factorings;      /* matrix factorisations */
    int64_t island_work; /* operations on 3 x 3 blocks, see thud_quality.island_work */
    /* Detection in the last step. */
    int impacts;         /* collisions that were resolved within the step, bisected or swept */
    int held_bodies;     /* bodies that were stopped before the end of the step */
    double held_seconds; /* sum of the times that these bodies lost */
    int unbisectable;    /* bodies faster than the bisection limit, counted if any body is bisected:
                            unless they are swept, they may have passed through a shape */
    int motion_pairs;    /* pairs of moving shapes that were tested */
    /* Of these, the pairs whose swept circles met, whose swept boxes met, and whose time of
     * collision was computed. */
    int motion_circles, motion_boxes, motion_exact;
} thud_stats;

/* Counts and times of the world. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_stats(const thud_world *world, thud_stats *out);

/* The same as a return value; all 0 for a null world. */
static inline thud_stats thud_stats_of(const thud_world *world) {
    thud_stats stats;
    memset(&stats, 0, sizeof stats);
    thud_world_get_stats(world, &stats);
    return stats;
}

/* *out_speed: the thickness of the thinnest shape (except terrain) divided by the time step,
 * length/s; infinite without shapes. A body that moves faster, counted with its rotation, may pass
 * through a shape between two steps, so that thud_detection_bisect misses the collision; no
 * collision of slower bodies is missed. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_bisection_limit(thud_world *world, double *out_speed);

/* The errors of the last step. They are collected while it is solved, so that the call only costs a
 * pass over joints; after a step in which detection held bodies back or resolved collisions, also a
 * pass over contacts. Only contacts of awake bodies count (thud_measure_of also counts those of
 * sleeping bodies), at the poses that detection left at the end of the step. The values do not
 * depend on the number of workers. */
typedef struct thud_step_error {
    /* Length, at the end of the step, over the points of touching pairs; rotations are linearised.
     */
    double penetration_max, penetration_mean;
    double residual; /* length/s: the largest approach speed of a contact, or speed along a locked
                        direction or distance of a joint or of a gear, before the last pass of the
                        soft solver corrected it; in a step that solved islands directly, after that
                        pass */
    double energy_change;  /* change of kinetic plus potential energy, mass * length^2 / s^2, to a
                              millionth of the kinetic energy. Friction, damping and restitution make
                              it negative; forces, kinematic bodies, moving surfaces and errors of
                              the solver make it positive */
    double energy_decided; /* mass * length^2 / s^2: the part of energy_change that prologues
                              decided (thud_contact_decide) */
    int overlaps; /* points deeper than max_error, or deeper than 0.005 length scales if max_error
                     is 0 */
    double shortfall; /* length: the largest distance between the final position of a held body
                         (thud_stats.held_bodies) and the position to which its motion would have
                         taken it; 0 if none was held */
    /* Length: the gaps of all joints, asleep or awake, at the end of the step:
     * thud_joint_state.gap. */
    double joint_gap_max, joint_gap_mean;
    double joint_angle_max; /* rad: the maximum of thud_joint_state.angle_gap */
} thud_step_error;

/* In worlds of thud_default_small_world_def: collects the errors of the steps that follow. In
 * others they are collected from the start, and the call does nothing. THUD_ERROR_NULL;
 * THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_world_use_step_error(thud_world *world);
/* All 0 before the first step. THUD_ERROR_NULL; THUD_ERROR_INVALID where they are not collected.
 */
THUD_API thud_result thud_world_get_step_error(const thud_world *world, thud_step_error *out);

/* The same as a return value; all 0 for a null world, and where they are not collected. */
static inline thud_step_error thud_step_error_of(const thud_world *world) {
    thud_step_error error;
    memset(&error, 0, sizeof error);
    thud_world_get_step_error(world, &error);
    return error;
}

/* Penetration as the last step left it, and the present energy. */
typedef struct thud_measure {
    /* Length, over the points of touching pairs, asleep or awake; if detection moved or held bodies
     * in the last step, as in thud_step_error. */
    double penetration_max, penetration_mean;
    /* mass * length^2 / s^2, of dynamic bodies; the potential energy is 0 at the world's origin. */
    double kinetic_energy, potential_energy;
} thud_measure;

/* Costs a pass over contacts and bodies. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_measure(const thud_world *world, thud_measure *out);

/* The same as a return value; all 0 for a null world. */
static inline thud_measure thud_measure_of(const thud_world *world) {
    thud_measure measure;
    memset(&measure, 0, sizeof measure);
    thud_world_get_measure(world, &measure);
    return measure;
}

/* A hash of the exact position, angle and velocity of every body, in the order of slots, to compare
 * two runs. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_hash(const thud_world *world, uint64_t *out);

/* The same as a return value; 0 for a null world. */
static inline uint64_t thud_hash_of(const thud_world *world) {
    uint64_t hash = 0;
    thud_world_get_hash(world, &hash);
    return hash;
}

#ifdef __cplusplus
}
#endif

#endif
