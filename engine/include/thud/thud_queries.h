/* thud_queries.h: asking a world what is where. Included by thud.h.
 *
 * Every query heeds the edits made before it, also those that no step has seen yet, but for those
 * of callbacks, which wait for it. It meets every kind of shape, and answers in an order that
 * depends on neither broadphase nor history: the nearer hit first, and among equals the lower slot
 * (thud_shape_id.index1 - 1).
 *
 * Places lie within THUD_PLACE_MAX length scales of the origin, and so do the ends of rays and
 * casts; sizes are as thud_placed_check wants them. Anything else is THUD_ERROR_INVALID, a world
 * that is null THUD_ERROR_NULL, and memory that runs short THUD_ERROR_MEMORY: outputs are then as
 * they were, and no callback has been called. A filter of null meets everything but sensors. */
#ifndef THUD_QUERIES_H
#define THUD_QUERIES_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_shapes.h"
#include "thud_volumes.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct thud_query_filter {
    uint32_t category, mask; /* as in thud_filter; all ones by default. Both zero, without a
                                group above 0, would meet nothing, and are refused */
    bool sensors;            /* sensors too; default false */
    int32_t group;           /* as in thud_filter: shapes of the same group are met always (> 0) or
                                never (< 0); default 0: no group */
    thud_body_id ignore;     /* meets none of its shapes; default null: nobody's. One that is gone,
                                or of another world, has none */
} thud_query_filter;

THUD_API thud_query_filter thud_default_query_filter(void);

/* ---- rays and casts: what a point or a shape meets along a straight way ---- */

typedef struct thud_ray_hit {
    thud_shape_id shape; /* what was met */
    thud_pos point;      /* on its surface */
    thud_vec2 normal;    /* of its surface there: unit, outward */
    double fraction;     /* of the way, in [0, 1] */
    double depth;        /* of the overlap with a shape that is met at 0; else, and of rays, 0 */
} thud_ray_hit;

/* The first shape along the ray; *hit = false if none, and *out is then as it was. A ray that
 * starts inside a shape does not meet it. */
THUD_API thud_result thud_world_cast_ray(thud_world *world, thud_pos origin, double dx, double dy,
                                         const thud_query_filter *filter, bool *hit,
                                         thud_ray_hit *out);

/* Every shape along the ray, each where it is first met. *count is how many there are; the nearest
 * `capacity` (>= 0) are written, in order. `out` may be null where capacity is 0. */
THUD_API thud_result thud_world_cast_ray_all(thud_world *world, thud_pos origin, double dx,
                                             double dy, const thud_query_filter *filter,
                                             thud_ray_hit *out, int capacity, int *count);

/* The first shape that the circle, AABB or OBB `shape`, placed about `center` (shape->x, y are an
 * offset from it), meets while it is moved by (dx, dy) without turning. Touching counts. A shape
 * that it overlaps from the start is met at 0, with the normal of least penetration. */
THUD_API thud_result thud_world_cast_shape(thud_world *world, thud_pos center,
                                           const thud_shape_instance *shape, double dx, double dy,
                                           const thud_query_filter *filter, bool *hit,
                                           thud_ray_hit *out);
THUD_API thud_result thud_world_cast_shape_all(thud_world *world, thud_pos center,
                                               const thud_shape_instance *shape, double dx,
                                               double dy, const thud_query_filter *filter,
                                               thud_ray_hit *out, int capacity, int *count);

THUD_API thud_result thud_world_cast_circle(thud_world *world, thud_pos center, double radius,
                                            double dx, double dy, const thud_query_filter *filter,
                                            bool *hit, thud_ray_hit *out);
THUD_API thud_result thud_world_cast_circle_all(thud_world *world, thud_pos center, double radius,
                                                double dx, double dy,
                                                const thud_query_filter *filter, thud_ray_hit *out,
                                                int capacity, int *count);

/* A box of the given half extents, turned by `angle` radians, |angle| <= THUD_ANGLE_MAX; upright at
 * 0. */
THUD_API thud_result thud_world_cast_box(thud_world *world, thud_pos center, double half_x,
                                         double half_y, double angle, double dx, double dy,
                                         const thud_query_filter *filter, bool *hit,
                                         thud_ray_hit *out);
THUD_API thud_result thud_world_cast_box_all(thud_world *world, thud_pos center, double half_x,
                                             double half_y, double angle, double dx, double dy,
                                             const thud_query_filter *filter, thud_ray_hit *out,
                                             int capacity, int *count);

/* ---- overlaps: every shape in a place, in the order of their slots; touching counts ---- */

/* Return false to stop. The world is locked meanwhile: edits wait for the next step. */
typedef bool thud_overlap_fn(thud_shape_id shape, void *context);

/* The circle, AABB or OBB `shape`, placed about `center` as above. */
THUD_API thud_result thud_world_overlap_shape(thud_world *world, thud_pos center,
                                              const thud_shape_instance *shape,
                                              const thud_query_filter *filter, thud_overlap_fn *fn,
                                              void *context);
THUD_API thud_result thud_world_overlap_circle(thud_world *world, thud_pos center, double radius,
                                               const thud_query_filter *filter, thud_overlap_fn *fn,
                                               void *context);
THUD_API thud_result thud_world_overlap_aabb(thud_world *world, thud_pos lower, thud_pos upper,
                                             const thud_query_filter *filter, thud_overlap_fn *fn,
                                             void *context);
THUD_API thud_result thud_world_overlap_obb(thud_world *world, thud_pos center, double half_x,
                                            double half_y, double angle,
                                            const thud_query_filter *filter, thud_overlap_fn *fn,
                                            void *context);

/* ---- the closest shape to a point ---- */

typedef struct thud_closest_hit {
    thud_shape_id shape;
    thud_pos point;   /* of the shape's surface, the closest to the one asked about */
    thud_vec2 normal; /* unit, outward: from the surface to a point outside */
    double distance;  /* negative: so deep inside, by the shortest way out */
} thud_closest_hit;

/* The shape whose surface is at the least signed distance, if that is at most `max_distance`
 * ([0, THUD_PLACE_MAX length scales]); *found = false if none, and *out is then as it was. */
THUD_API thud_result thud_world_closest(thud_world *world, thud_pos point, double max_distance,
                                        const thud_query_filter *filter, bool *found,
                                        thud_closest_hit *out);

/* The bounding volume of the wanted kind around all shapes of a body as they stand now, relative to
 * `origin`; see thud_volumes.h. THUD_ERROR_INVALID for a body without shapes or with flat terrain,
 * which has no end. */
THUD_API thud_result thud_body_volume(thud_world *world, thud_body_id body, thud_shape_kind kind,
                                      thud_pos origin, thud_volume *out);

/* ---- the contacts of one body ---- */

/* A touching pair as the last step left it; of a static and a moving shape, a is the static one. */
typedef struct thud_manifold {
    thud_shape_id shape_a, shape_b;
    thud_body_id body_a, body_b;
    thud_vec2 normal; /* from a to b */
    int point_count;  /* 0 to 2: what is about to touch again may have none */
    thud_pos point[2];
    float separation[2];     /* lengths; negative is penetration */
    float normal_impulse[2]; /* mass length/s, >= 0: the last substep's, times the substeps */
    float tangent_impulse;   /* ... and that of friction, along (normal.y, -normal.x), on b */
    bool direct;             /* its island was solved directly, see thud_quality.h */
} thud_manifold;

/* *count is how many there are; as many as there is room for (`capacity` >= 0) are written, the
 * latest to touch first. `out` may be null where capacity is 0. THUD_ERROR_STALE for a body that is
 * gone, THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_body_contacts(thud_world *world, thud_body_id body, thud_manifold *out,
                                        int capacity, int *count);

#ifdef __cplusplus
}
#endif

#endif
