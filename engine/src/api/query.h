/* query.h: what all queries share. */
#ifndef TD_QUERY_H
#define TD_QUERY_H

#include "geometry/shape_instance.h"
#include "state/world.h"

bool td_query_passes(const thud_world *w, int shape, const thud_query_filter *filter);

/* Refuses a filter that meets nothing, as a zeroed one does. */
thud_result td_query_check_filter(const thud_world *w, const thud_query_filter *filter);

/* Refuses the angle of a query's box. */
thud_result td_query_check_angle(const thud_world *w, double angle);

/* THUD_OK if a query's own shape, about `center`, is one that the world can meet. */
thud_result td_query_check(const thud_world *w, thud_pos center, const thud_shape_instance *shape);

/* As td_shape_instance, but where the edits made so far put it, and with a rotation whose length is
 * 1 in double precision: over a long way, what single precision leaves would be seen. */
thud_shape_instance td_query_instance(const thud_world *w, int shape, td_position origin);

/* The bounding box of a shape about `center`. */
void td_query_bounds(thud_pos center, const thud_shape_instance *shape, thud_pos *lower,
                     thud_pos *upper);

/* An AABB or OBB about the origin, or one that no check accepts where the angle is out of range. */
thud_shape_instance td_query_box(double half_x, double half_y, double angle);

/* Has a query see shapes where the edits made so far put them, which go on waiting for the next
 * step: preview.h. False when memory is short. Inside a callback nothing changes: the query sees
 * the step as it stands. */
bool td_query_prepare(thud_world *w);

/* Lists in scratch.hits every shape but terrain whose bounds overlap the box, in any order, after
 * td_query_prepare. False when memory is short. */
bool td_query_list(thud_world *w, thud_pos lower, thud_pos upper);

/* As thud_world_cast_shape_all, but meets nothing but sensors, whatever the filter says of them. */
thud_result td_query_cast_sensors(thud_world *w, thud_pos center, const thud_shape_instance *shape,
                                  double dx, double dy, const thud_query_filter *filter,
                                  thud_ray_hit *out, int capacity, int *count);

/* From a shape to a point, which is the origin; query_closest.c. */
void td_query_measure(const thud_world *w, int shape, td_position origin, thud_closest *out);
thud_closest_hit td_query_closest_hit(const thud_world *w, int shape, thud_pos point,
                                      const thud_closest *c);

/* Appends every terrain. */
bool td_query_list_terrains(thud_world *w);

#endif
