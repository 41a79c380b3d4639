/* thud_casts.h: more ways of asking a world what is where: hit by hit, many at once, and one shape
 * alone. Included by whoever uses it; a program that does not, does not link it.
 *
 * What thud_queries.h says holds here too: edits made before are heeded, places and ends of ways
 * lie within THUD_PLACE_MAX length scales of the origin, hits come the nearer first and among
 * equals the lower slot first, and what is refused changes nothing. A way is told to the same bits
 * by every call. */
#ifndef THUD_CASTS_H
#define THUD_CASTS_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_queries.h"
#include "thud_shapes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- hit by hit: a callback that takes, ignores, clips or ends ---- */

/* Hears of each hit, in order, and answers how much of the way still counts, as a fraction of the
 * whole: of what lies there or beyond, nothing more is told. So hit->fraction makes this hit the
 * last, as THUD_CAST_END does, and a little more than it tells what stands close behind. What goes
 * on never takes a clip back. An answer that is not a number goes on, and the log hook hears of it.
 *
 * The world is locked meanwhile: edits wait for the next step, but what is destroyed is told of no
 * more; queries are served. */
typedef double thud_cast_fn(const thud_ray_hit *hit, void *context);

#define THUD_CAST_IGNORE (-1.0) /* below 0: goes on, as if this shape were not there */
#define THUD_CAST_END 0.0
#define THUD_CAST_ON 1.0 /* or more: goes on */

/* Looks no further along the way than it is told to. THUD_ERROR_NULL also without a callback. */
THUD_API thud_result thud_world_cast_ray_each(thud_world *world, thud_pos origin, double dx,
                                              double dy, const thud_query_filter *filter,
                                              thud_cast_fn *fn, void *context);

/* `shape` as in thud_world_cast_shape. */
THUD_API thud_result thud_world_cast_shape_each(thud_world *world, thud_pos center,
                                                const thud_shape_instance *shape, double dx,
                                                double dy, const thud_query_filter *filter,
                                                thud_cast_fn *fn, void *context);

/* ---- many at once ---- */

typedef struct thud_ray {
    thud_pos origin;
    double dx, dy;
    const thud_query_filter *filter; /* its own, or one for all; null as in other queries */
} thud_ray;

typedef struct thud_shape_cast {
    thud_pos center;
    const thud_shape_instance *shape; /* as in thud_world_cast_shape; never null */
    double dx, dy;
    const thud_query_filter *filter;
} thud_shape_cast;

/* The first hit of each of `count` (>= 0) rays, to hits[i]: the same as thud_world_cast_ray has.
 * Where nothing is met its shape is null, its fraction 1, its point the end of the way and its
 * normal (0, 0). If one ray is refused, all are. The pointers may be null where count is 0.
 *
 * 64 and more are shared among the workers of the world's job system, which is asked once a call;
 * inside a callback the calling thread does them alone. Any number of workers gives the same bits.
 */
THUD_API thud_result thud_world_cast_rays(thud_world *world, const thud_ray *rays, int count,
                                          thud_ray_hit *hits);
THUD_API thud_result thud_world_cast_shapes(thud_world *world, const thud_shape_cast *casts,
                                            int count, thud_ray_hit *hits);

/* ---- one shape, whatever its filter; sensors and shapes of disabled bodies too ---- */

/* THUD_ERROR_STALE for a shape that is gone, THUD_ERROR_LOCKED for one that was made inside the
 * callback that asks. Of what is asked for, nothing may be null but in thud_shape_meets_ray. */

/* Where the ray first meets the shape; *hit = false if it does not, and *out is then as it was. A
 * ray that starts inside does not meet it. */
THUD_API thud_result thud_shape_meets_ray(thud_world *world, thud_shape_id shape, thud_pos origin,
                                          double dx, double dy, bool *hit, thud_ray_hit *out);

/* Whether the point is in the shape, or on its edge; below the line of a terrain it is. */
THUD_API thud_result thud_shape_contains_point(thud_world *world, thud_shape_id shape,
                                               thud_pos point, bool *inside);

/* The closest point of the shape's surface, however far. */
THUD_API thud_result thud_shape_closest_point(thud_world *world, thud_shape_id shape,
                                              thud_pos point, thud_closest_hit *out);

/* The least box around the shape as it stands; of a terrain, around its line. THUD_ERROR_INVALID
 * for a flat one, which has no end. */
THUD_API thud_result thud_shape_bounds(thud_world *world, thud_shape_id shape, thud_pos *lower,
                                       thud_pos *upper);

#ifdef __cplusplus
}
#endif

#endif
