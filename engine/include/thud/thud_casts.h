/* thud_casts.h: more queries: casts that call a function for each hit, many casts in one call, and
 * queries of a single shape. thud.h does not include this header; a program that does not use it
 * does not link it.
 *
 * The rules of thud_queries.h hold here too: queries see the edits made before them; origins and
 * ends of casts lie within THUD_PLACE_MAX length scales of the world's origin; hits are in the
 * order of their distance, and at equal distance in the order of slots; a call that fails changes
 * nothing. All calls return the same hit, bit for bit, for the same cast. */
#ifndef THUD_CASTS_H
#define THUD_CASTS_H

#include "thud_ids.h"
#include "thud_math.h"
#include "thud_queries.h"
#include "thud_geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- hit by hit: a callback that accepts, ignores, clips or ends ---- */

/* Called for each hit in order. It returns a limit, a fraction of the whole path: hits at the limit
 * or beyond are not reported. So returning hit->fraction makes this hit the last, as THUD_CAST_END
 * does; with a slightly larger limit, shapes close behind are still reported. The limit only
 * shrinks: a later, larger return value does not raise it. If the callback returns NaN the cast
 * continues, and the error is logged.
 *
 * The world is locked during the callback: edits wait for the next step, but shapes that it
 * destroys are no longer reported. Queries are allowed. */
typedef double thud_cast_fn(const thud_ray_hit *hit, void *context);

#define THUD_CAST_IGNORE (-1.0) /* below 0: the cast continues, as if this shape did not exist */
#define THUD_CAST_END 0.0       /* the cast ends */
#define THUD_CAST_ON 1.0        /* 1 or more: the cast continues */

/* Casts a ray, and searches no further than the limit. THUD_ERROR_NULL for a null world, ray or
 * callback; other errors as for thud_world_cast_ray. */
THUD_API thud_result thud_world_cast_ray_each(thud_world *world, const thud_ray *ray,
                                              thud_cast_fn *fn, void *context);

/* The same with a moving shape. */
THUD_API thud_result thud_world_cast_shape_each(thud_world *world, const thud_shape_cast *cast,
                                                thud_cast_fn *fn, void *context);

/* ---- many at once ---- */

/* Writes the first hit of each of `count` (>= 0) rays to hits[i], the one that thud_world_cast_ray
 * finds. If a ray has no hit, the shape of its hit is the null handle, its fraction 1, its point
 * the end of the ray and its normal (0, 0). If one ray is refused, the whole call fails. The
 * pointers may be null where count is 0.
 *
 * 64 casts or more are divided among the workers of the world's job system, which is called once;
 * inside a callback the calling thread does all of them. The number of workers does not change the
 * results. THUD_ERROR_NULL for null arrays with a count above 0; THUD_ERROR_INVALID for a negative
 * count; other errors as for thud_world_cast_ray. */
THUD_API thud_result thud_world_cast_rays(thud_world *world, const thud_ray *rays, int count,
                                          thud_ray_hit *out_hits);
/* The same with moving shapes, as thud_world_cast_shape finds their hits. */
THUD_API thud_result thud_world_cast_shapes(thud_world *world, const thud_shape_cast *casts,
                                            int count, thud_ray_hit *out_hits);

/* ---- one shape, whatever its filter is; also sensors and shapes of disabled bodies ---- */

/* All return THUD_ERROR_STALE for a handle that names no shape, and THUD_ERROR_LOCKED for a shape
 * that was made inside the callback that asks. Output pointers must not be null, except those of
 * thud_shape_cast_ray. */

/* The first hit of the ray on the shape. *out_hit: whether there is one; if not, *out is not
 * written. A ray that starts inside the shape does not hit it. */
THUD_API thud_result thud_shape_cast_ray(thud_world *world, thud_shape_id shape, thud_pos origin,
                                         double dx, double dy, bool *out_hit, thud_ray_hit *out);

/* Whether the point is in the shape or on its edge. A point below the line of a terrain is inside.
 */
THUD_API thud_result thud_shape_contains_point(thud_world *world, thud_shape_id shape,
                                               thud_pos point, bool *out_inside);

/* The closest point of the shape's surface, at any distance. */
THUD_API thud_result thud_shape_closest_point(thud_world *world, thud_shape_id shape,
                                              thud_pos point, thud_closest_hit *out);

/* The smallest axis-aligned box around the shape, or around the line of a terrain.
 * THUD_ERROR_INVALID for flat terrain, which has no ends. */
THUD_API thud_result thud_shape_get_bounds(thud_world *world, thud_shape_id shape,
                                           thud_pos *out_lower, thud_pos *out_upper);

#ifdef __cplusplus
}
#endif

#endif
