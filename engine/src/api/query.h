/* query.h: what all queries share. A query checks its arguments, calls td_query_prepare, lists
 * candidates in thud_world.scratch.found_shapes (td_query_list, td_query_list_terrains), and tests
 * each candidate that passes its filter (td_query_passes) exactly, by td_query_instance. `shape` is
 * a shape's slot. */
#ifndef TD_QUERY_H
#define TD_QUERY_H

#include "geometry/shape_instance.h"
#include "state/world.h"

/* Whether a query with this filter sees the shape: it exists, its body is enabled, and category,
 * mask, group, sensors and ignore let it. A null filter sees everything but sensors. */
bool td_query_passes(const thud_world *w, int shape, const thud_query_filter *filter);

/* Refuses a filter that no shape can pass, such as one that is all zeros. */
thud_result td_query_check_filter(const thud_world *w, const thud_query_filter *filter);

/* THUD_OK if a query's own shape is valid, and it and `center`, relative to which its place is
 * given, are within the world; else THUD_ERROR_INVALID, without a message to the log. */
thud_result td_query_check(const thud_world *w, thud_pos center, const thud_geometry *shape);

/* The shape relative to `origin`, at the place where the edits made so far put it. Its rotation is
 * scaled to length 1 in double precision: at the end of a long cast the error of single precision
 * would be visible. */
thud_geometry td_query_instance(const thud_world *w, int shape, td_position origin);

/* The bounding box of a shape that lies about `center`. */
void td_query_bounds(thud_pos center, const thud_geometry *shape, thud_pos *lower, thud_pos *upper);

/* Brings the preview (preview.h) and the broadphase up to date: the query sees shapes where the
 * edits made so far put them, while the edits themselves wait for the next step. Inside a callback
 * the preview stays as it is. False when memory is short. */
bool td_query_prepare(thud_world *w);

/* Lists in scratch.found_shapes, in any order, every shape but terrain whose fat bounds overlap the
 * box; after td_query_prepare. False when memory is short. */
bool td_query_list(thud_world *w, thud_pos lower, thud_pos upper);

/* query_cast.c: as thud_world_cast_shape_all, but finds only sensors; for movers. cast->filter must
 * let sensors pass. The caller has set the engine's floating-point mode, and has room for
 * `capacity` hits in `out`. */
thud_result td_query_cast_sensors(thud_world *w, const thud_shape_cast *cast, thud_ray_hit *out,
                                  int capacity, int *out_count);

/* query_closest.c: signed distance, normal and closest point from a shape to the point `origin`. */
void td_query_measure(const thud_world *w, int shape, td_position origin, thud_closest *out);
/* Converts such a result to the caller's type. `point`: the position of `origin` in the caller's
 * coordinates. */
thud_closest_hit td_query_closest_hit(const thud_world *w, int shape, thud_pos point,
                                      const thud_closest *c);

/* Appends every terrain to scratch.found_shapes. False when memory is short. */
bool td_query_list_terrains(thud_world *w);

#endif
