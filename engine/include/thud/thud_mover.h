/* thud_mover.h: moving a character. Included by whoever uses it; a program that does not, does
 * not link it.
 *
 * A mover is a circle, AABB or OBB that the caller keeps and moves by thud_mover_move, once a
 * step and after it: no force moves it and nothing pushes it over. It slides along what it
 * meets, walks on slopes, climbs steps, follows the ground downhill and rides on whatever it
 * stands on. Gravity and jumps are the caller's: a game's loop is
 *
 *     velocity.x = 5 * stick;
 *     velocity.y = mover.on_ground && jump ? 8 : velocity.y - 20 * dt;
 *     thud_mover_move(world, &mover, velocity, dt, &report);
 *     velocity = report.velocity;
 *
 * The same world and the same calls give the same places on every machine. Lengths are in the
 * caller's unit, speeds in it per second. To set a foot or a wheel on the height of a terrain
 * without a mover, see thud_terrain_sample_at and thud_terrain_place_foot. */
#ifndef THUD_MOVER_H
#define THUD_MOVER_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_queries.h"
#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { THUD_MOVER_HITS = 8, THUD_MOVER_SENSORS = 16 };

typedef struct thud_mover thud_mover;

/* What a mover met. */
typedef struct thud_mover_hit {
    thud_shape_id shape;
    thud_body_id body;
    thud_pos point;    /* on the shape's surface */
    thud_vec2 normal;  /* of it: unit, outward */
    double depth;      /* how deep the mover was in it before it moved; mostly 0 */
    uint32_t category; /* of its filter */
} thud_mover_hit;

/* Asked of whatever would stop the mover; true: it is passed through as if it were not there.
 * `velocity` is the one asked for. The world is locked meanwhile: edits wait until the move is
 * done, but what is destroyed is met no more; what cannot wait is refused with THUD_ERROR_LOCKED.
 */
typedef bool thud_mover_pass_fn(const thud_mover *mover, const thud_mover_hit *hit,
                                thud_vec2 velocity, void *context);

/* What thud_mover_passes_one_way wants for its context. */
typedef struct thud_one_way {
    uint32_t categories; /* bits of the platforms */
    bool drop;           /* also down through them */
} thud_one_way;

/* A thud_mover_pass_fn for platforms that are jumped through from below and stood on. */
THUD_API bool thud_mover_passes_one_way(const thud_mover *mover, const thud_mover_hit *hit,
                                        thud_vec2 velocity, void *context);

struct thud_mover {
    thud_shape_instance shape; /* in the world; what thud_mover_move moves, and the caller may */
    thud_vec2 up; /* of length 1, its square within THUD_UNIT_ERROR; default (0, 1); (0, 0) for a
                     game from above: no ground */
    double skin;  /* kept between the mover and what it meets, > 0, at most the smallest
                     half extent; default 2 % of that */
    double max_slope;   /* radians, [0, THUD_MOVER_SLOPE_MAX]; ground any steeper is a wall; default
                           0.9 (52   degrees) */
    double step_height; /* [0, THUD_MOVER_STEP_MAX]; default 60 % of the half height */
    double snap_distance; /* how far the ground may fall away under a step, [0,
                             THUD_MOVER_STEP_MAX]; default as
                             step_height */
    double push_force;    /* most force on a dynamic body in the way, [0, THUD_MOVER_FORCE_MAX];
                             default 0: none */
    thud_body_id body;    /* a kinematic body about the mover's centre that is to follow, so that
                             dynamic bodies and sensors meet the mover; its velocity is set so
                             that the next step takes it there; default null: none */
    thud_query_filter filter; /* what the mover meets; default everything but sensors. Those never
                                stop it: `sensors` has it report which it went through */
    thud_mover_pass_fn *pass; /* null: nothing is passed through */
    void *context;            /* handed to pass */

    /* Kept from one move to the next: the ground that it stands on, if any, and where that stood.
     * Nothing else is: who takes a world back to a snapshot (thud_snapshot.h) puts back a copy of
     * the struct made at the same time. */
    bool on_ground;
    thud_vec2 ground_normal;
    thud_shape_id ground_shape;
    thud_body_id ground_body;
    thud_pos ground_point, ground_place;
    float ground_cosine, ground_sine;
};

/* A mover of this shape, in the air. */
THUD_API thud_mover thud_default_mover(thud_shape_instance shape);

typedef struct thud_mover_report {
    thud_vec2 velocity;        /* what is left of the one asked for: on the ground the part across
                                  `up`, unless a wall stopped it; in the air without the parts into
                                  what was met. The ground's own motion is not in it */
    thud_vec2 ground_velocity; /* at the feet; add it to a jump to keep the platform's speed */
    double depth;              /* of the deepest overlap left where something closed in; mostly 0 */
    int hit_count;             /* in `hits`, in the order in which they were met */
    thud_mover_hit hits[THUD_MOVER_HITS];
    int sensor_count; /* in `sensors`: what it went through or stands in, each once, in the
                         order in which they were met; none without filter.sensors */
    thud_shape_id sensors[THUD_MOVER_SENSORS];
} thud_mover_report;

/* Moves by velocity * dt, |velocity| * dt <= THUD_MOVER_WAY_MAX, dt in (0,
 * THUD_TIME_STEP_MAX], and by what the ground moved
 * since the last move. A velocity with a part along `up` leaves the ground. It takes at most
 * four turns in the air and four on the ground.
 *
 * THUD_ERROR_NULL without a world or mover, THUD_ERROR_INVALID for a mover or motion out of
 * range, for one that might get further than THUD_PLACE_MAX length scales from the origin (by its
 * motion, the ground's, a step and a snap), or a body that is not kinematic, THUD_ERROR_STALE for a
 * body that is gone, THUD_ERROR_MEMORY: mover, report and world are then as they were. `report` may
 * be null. */
THUD_API thud_result thud_mover_move(thud_world *world, thud_mover *mover, thud_vec2 velocity,
                                     double dt, thud_mover_report *report);

#ifdef __cplusplus
}
#endif

#endif
