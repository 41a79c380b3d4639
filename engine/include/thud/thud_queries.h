/* thud_queries.h: queries: rays and shape casts, overlaps, the closest shape, and the contacts of a
 * body. Included by thud.h.
 *
 * A query sees all edits made before it, including those that take effect with the next step,
 * except edits made inside callbacks, which wait for the next step. It finds shapes of every kind.
 * The order of hits depends neither on the broadphase nor on history: rays and casts give nearer
 * hits first, and at equal distance the lower slot (thud_shape_id.index1 - 1); overlaps are in the
 * order of slots.
 *
 * Positions, and the ends of rays and casts, must lie within THUD_PLACE_MAX length scales of the
 * origin; shapes must be valid by thud_geometry_check. Otherwise a query returns
 * THUD_ERROR_INVALID; THUD_ERROR_NULL for a null world, and THUD_ERROR_MEMORY where memory is
 * short: outputs are then not written, and no callback has been called. With a null filter all
 * shapes except sensors are found. */
#ifndef THUD_QUERIES_H
#define THUD_QUERIES_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_geometry.h"
#include "thud_volumes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A query finds the shapes with which a shape of this filter would collide. */
typedef struct thud_query_filter {
    uint32_t category, mask; /* as in thud_filter; default all ones. Both zero, without a group
                                above 0, would find nothing, and are refused */
    bool sensors;            /* sensors are also found; default false */
    int32_t group;       /* as in thud_filter: shapes of the same group are always found (> 0) or
                            never (< 0); default 0: no group */
    thud_body_id ignore; /* a body whose shapes are not found; default null: none. A handle that
                            names no body has no effect */
} thud_query_filter;

/* A filter that finds every shape but sensors. */
THUD_API thud_query_filter thud_default_query_filter(void);

/* ---- rays and casts: shapes along the straight path of a point or of a moving shape ---- */

/* A ray from a point to another. */
typedef struct thud_ray {
    thud_pos origin;
    double dx, dy;                   /* from the origin to the end */
    const thud_query_filter *filter; /* null: everything but sensors */
} thud_ray;

/* A circle, AABB or OBB that moves without rotation. */
typedef struct thud_shape_cast {
    thud_pos center;
    thud_geometry shape;             /* about `center`: its x, y are an offset from it */
    double dx, dy;                   /* the displacement of the shape */
    const thud_query_filter *filter; /* null: everything but sensors */
} thud_shape_cast;

/* A shape that a ray or a cast shape hit. */
typedef struct thud_ray_hit {
    thud_shape_id shape; /* the shape that was hit */
    thud_pos point;      /* on its surface, in the world */
    thud_vec2 normal;    /* of its surface at the point: unit, outward */
    double fraction;     /* the fraction of the path before the hit, in [0, 1] */
    double depth; /* depth of the overlap, length, if the shape is hit at fraction 0; otherwise, and
                     for rays, 0 */
} thud_ray_hit;

/* The first shape on the ray. *out_hit: whether there is one; if not, *out is not written. A ray
 * that starts inside a shape does not hit it.
 *
 *     thud_world_cast_ray(world, &(thud_ray){.origin = {0, 5}, .dy = -10}, &hit, &out);
 */
THUD_API thud_result thud_world_cast_ray(thud_world *world, const thud_ray *ray, bool *out_hit,
                                         thud_ray_hit *out);

/* All shapes on the ray, each with its first hit. *out_count is their number; the nearest
 * `capacity` (>= 0) are written, in order. `out` may be null where capacity is 0. */
THUD_API thud_result thud_world_cast_ray_all(thud_world *world, const thud_ray *ray,
                                             thud_ray_hit *out, int capacity, int *out_count);

/* The first shape that a moving circle, AABB or OBB hits. Touching counts. A shape that overlaps it
 * at the start is hit at fraction 0, with the normal of least penetration. *out_hit and *out as
 * above.
 *
 *     thud_shape_cast ball = {.center = {0, 5}, .shape = thud_circle_at(0, 0, 0.5), .dy = -10};
 *     thud_world_cast_shape(world, &ball, &hit, &out);
 */
THUD_API thud_result thud_world_cast_shape(thud_world *world, const thud_shape_cast *cast,
                                           bool *out_hit, thud_ray_hit *out);
/* All shapes that it hits, as thud_world_cast_ray_all. */
THUD_API thud_result thud_world_cast_shape_all(thud_world *world, const thud_shape_cast *cast,
                                               thud_ray_hit *out, int capacity, int *out_count);

/* ---- overlaps: all shapes that overlap a given shape, in the order of their slots; touching
 * counts ---- */

/* Called for each shape; returns false to stop. The world is locked meanwhile: edits wait for the
 * next step. */
typedef bool thud_overlap_fn(thud_shape_id shape, void *context);

/* Calls `fn` for each shape that overlaps the circle, AABB or OBB `shape`, whose x, y are an offset
 * from `center`. THUD_ERROR_NULL also for a null callback. */
THUD_API thud_result thud_world_overlap_shape(thud_world *world, thud_pos center,
                                              thud_geometry shape, const thud_query_filter *filter,
                                              thud_overlap_fn *fn, void *context);
/* The same for the box from `lower` to `upper`, which must be greater in x and in y
 * (THUD_ERROR_INVALID). THUD_ERROR_NULL also for a null callback. */
THUD_API thud_result thud_world_overlap_aabb(thud_world *world, thud_pos lower, thud_pos upper,
                                             const thud_query_filter *filter, thud_overlap_fn *fn,
                                             void *context);

/* ---- the closest shape to a point ---- */

/* The point of a shape that is closest to another point. */
typedef struct thud_closest_hit {
    thud_shape_id shape;
    thud_pos point;   /* on the shape's surface, the closest to the point of the call */
    thud_vec2 normal; /* of the surface: unit, outward */
    double distance;  /* signed, length; negative inside: minus the length of the shortest way
                         out */
} thud_closest_hit;

/* The shape at the smallest signed distance from the point, if that is at most `max_distance` ([0,
 * THUD_PLACE_MAX length scales]). *out_found: whether there is one; if not, *out is not written. */
THUD_API thud_result thud_world_closest(thud_world *world, thud_pos point, double max_distance,
                                        const thud_query_filter *filter, bool *out_found,
                                        thud_closest_hit *out);

/* A bounding volume of this kind around all shapes of a body at their present poses, relative to
 * `origin`; see thud_volumes.h. THUD_ERROR_STALE; THUD_ERROR_INVALID also for a body without shapes
 * or with flat terrain, which has no ends. */
THUD_API thud_result thud_body_get_volume(thud_world *world, thud_body_id body,
                                          thud_shape_kind kind, thud_pos origin, thud_volume *out);

/* ---- the contacts of one body ---- */

/* A touching pair of shapes as the last step left it. Of a static and a moving shape, a is the
 * static one. */
typedef struct thud_manifold {
    thud_shape_id shape_a, shape_b;
    thud_body_id body_a, body_b;
    thud_vec2 normal;        /* unit, from a to b */
    int point_count;         /* 0 to 2; 0 is possible if the pair is about to touch again */
    thud_pos point[2];       /* in the world */
    float separation[2];     /* length; negative: penetration */
    float normal_impulse[2]; /* mass * length / s, >= 0: the impulse of the last substep, multiplied
                                by the number of substeps */
    float tangent_impulse;   /* the same for friction on b, along (normal.y, -normal.x) */
    bool direct;             /* the pair's island was solved directly, see thud_quality.h */
} thud_manifold;

/* The touching pairs of a body. *out_count is their number; at most `capacity` (>= 0) are written,
 * those that began to touch last come first. `out` may be null where capacity is 0.
 * THUD_ERROR_STALE, THUD_ERROR_LOCKED inside a callback. */
THUD_API thud_result thud_body_get_contacts(thud_world *world, thud_body_id body,
                                            thud_manifold *out, int capacity, int *out_count);

#ifdef __cplusplus
}
#endif

#endif
