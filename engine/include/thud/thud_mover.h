/* thud_mover.h: a character controller. thud.h does not include this header; a program that does
 * not use it does not link it.
 *
 * A mover is a circle, AABB or OBB that belongs to the caller, who moves it by thud_mover_move,
 * once for each step. If that is called after the step, the mover follows a moving platform at
 * once, and its `body` is a step late; if before the step, the mover is a step late, and its `body`
 * reaches it in that step. It is
 * not a body: no force or contact moves it, and it does not turn. It slides along shapes that it
 * hits (collide and slide), walks on slopes, climbs steps, follows the ground downhill, and moves
 * with the body that it stands on. Gravity and jumps are up to the caller:
 *
 *     velocity.x = 5 * stick;
 *     velocity.y = mover.on_ground && jump ? 8 : velocity.y - 20 * dt;
 *     thud_mover_move(world, &mover, velocity, dt, &report);
 *     velocity = report.velocity;
 *
 * The same world and the same calls give the same positions, bit for bit, on every machine. To
 * place a foot or a wheel on a terrain without a mover, see thud_terrain_sample_at and
 * thud_terrain_place_foot. */
#ifndef THUD_MOVER_H
#define THUD_MOVER_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_queries.h"
#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Maximum numbers of hits and sensors in a report; further ones are left out. */
enum { THUD_MOVER_HITS = 8, THUD_MOVER_SENSORS = 16 };

/* Declared here for thud_mover_pass_fn. */
typedef struct thud_mover thud_mover;

/* A shape that a mover hit. */
typedef struct thud_mover_hit {
    thud_shape_id shape;
    thud_body_id body;
    thud_pos point;   /* on the shape's surface */
    thud_vec2 normal; /* of the surface: unit, outward */
    double depth; /* length of the overlap before the move; 0 for a mover that did not overlap */
    uint32_t category; /* of the shape's filter */
} thud_mover_hit;

/* Called for each shape that would stop the mover; if it returns true, the mover passes through the
 * shape. Of each part of the way only the nearest 16 shapes are looked at. `velocity` is the
 * argument of thud_mover_move. The world is locked meanwhile: edits wait until the move is done,
 * but shapes that are destroyed no longer stop the mover; calls that cannot wait return
 * THUD_ERROR_LOCKED. */
typedef bool thud_mover_pass_fn(const thud_mover *mover, const thud_mover_hit *hit,
                                thud_vec2 velocity, void *context);

/* The context of thud_mover_passes_one_way. */
typedef struct thud_one_way {
    uint32_t categories; /* category bits of the platforms */
    bool drop;           /* the mover also falls through the platforms */
} thud_one_way;

/* A thud_mover_pass_fn for one-way platforms: the mover passes them from below and stands on them
 * from above. `context` points to a thud_one_way. */
THUD_API bool thud_mover_passes_one_way(const thud_mover *mover, const thud_mover_hit *hit,
                                        thud_vec2 velocity, void *context);

/* A character that belongs to the caller; the fields up to `context` are its settings. */
struct thud_mover {
    thud_geometry shape; /* the mover's pose and size in the world; the caller may also change it */
    thud_vec2 up; /* opposite to gravity; its squared length is 1 within THUD_UNIT_ERROR; default
                     (0, 1). (0, 0) for games seen from above, without ground */
    double skin;  /* length: the gap that the mover keeps from shapes, > 0, at most its smallest
                     half extent; default 2 % of that */
    double max_slope;   /* rad, [0, THUD_MOVER_SLOPE_MAX]: steeper ground is a wall; default 0.9 (52
                           degrees) */
    double step_height; /* length, [0, THUD_MOVER_STEP_MAX]: the highest step that the mover climbs;
                           default 60 % of the half height */
    double snap_distance; /* length, [0, THUD_MOVER_STEP_MAX]: a walking mover follows ground down
                             that is at most this far below it; default as step_height */
    double push_force;    /* mass * length / s^2, [0, THUD_MOVER_FORCE_MAX]: the maximum force on a
                             dynamic body in the way; default 0: dynamic bodies stop the mover
                             like walls */
    thud_body_id body;    /* a kinematic body that follows the mover's centre, so that dynamic
                             bodies and sensors react to it: each move sets the velocity by which
                             a step of length dt brings the body to the mover, if it has no damping
                             and that is not beyond maximum_speed. It does not stop the
                             mover, and is not in its report. Default null: none */
    thud_query_filter filter; /* which shapes stop the mover; default all except sensors. Sensors
                                 never stop it; with `sensors` the report lists those that it
                                 passes, if `category` and `mask` allow them too */
    thud_mover_pass_fn *pass; /* default null: the mover passes through no shape */
    void *context;            /* passed to pass */

    /* State between moves: the ground on which the mover stands, and the ground's pose. There is no
     * other state: a program that restores a world from a snapshot (thud_snapshot.h) must also
     * restore a copy of this struct from the same time. */
    bool on_ground;             /* the fields below are valid only if it is set */
    thud_vec2 ground_normal;    /* unit, out of the ground */
    thud_shape_id ground_shape; /* the shape and the body that the mover stands on */
    thud_body_id ground_body;
    thud_pos ground_point, ground_place; /* the point of contact; the origin of the body, ... */
    float ground_cosine, ground_sine;    /* ... and its rotation at the last move */
};

/* A mover of this shape, not on ground, with the defaults. */
THUD_API thud_mover thud_default_mover(thud_geometry shape);

/* The results of a move. */
typedef struct thud_mover_report {
    thud_vec2 velocity; /* length/s: the remaining velocity: on the ground, the component of the
                           given velocity at a right angle to `up`, or 0 if a wall stopped the
                           mover; in the air, the given velocity without its components into the
                           surfaces that were hit. The ground's velocity is not included */
    thud_vec2 ground_velocity; /* length/s, of the ground at the mover's feet; add it to a jump to
                                  keep the speed of a moving platform */
    double depth;  /* length of the deepest overlap that could not be resolved, if moving shapes
                      squeeze the mover; else 0 */
    int hit_count; /* number of `hits`, in their order */
    thud_mover_hit hits[THUD_MOVER_HITS];
    int sensor_count; /* number of `sensors`: those that the mover passed or overlaps, each once, in
                         their order; 0 without filter.sensors */
    thud_shape_id sensors[THUD_MOVER_SENSORS];
} thud_mover_report;

/* Moves the mover by velocity * dt (length/s and s), |velocity| * dt <= THUD_MOVER_DISTANCE_MAX, dt
 * in (0, THUD_TIME_STEP_MAX], and by the motion of the ground since the last move. With a velocity
 * that has a positive component along `up` the mover leaves the ground. A move ends after four hits
 * in the air and four on the ground.
 *
 * THUD_ERROR_NULL for a null world or mover, THUD_ERROR_INVALID for a mover or motion out of range,
 * for a mover that might get further than THUD_PLACE_MAX length scales from the origin (by its
 * motion, the ground's, a step and a snap), or a body that is not kinematic, THUD_ERROR_STALE for a
 * body that has been destroyed, THUD_ERROR_MEMORY: mover, report and world are then unchanged.
 * `out_report` may be null. */
THUD_API thud_result thud_mover_move(thud_world *world, thud_mover *mover, thud_vec2 velocity,
                                     double dt, thud_mover_report *out_report);

#ifdef __cplusplus
}
#endif

#endif
