/* volumes.h: helpers of the files that fit bounding volumes: volumes.c and volumes_points.c. */
#ifndef TD_VOLUMES_H
#define TD_VOLUMES_H

#include "geometry/shape_instance.h"
#include "thud/thud_volumes.h"

/* The extent of points or shapes along a unit direction (u) and perpendicular to it (v), relative
 * to a nearby origin. */
typedef struct td_volume_span {
    double u_min, u_max, v_min, v_max;
} td_volume_span;

/* The unit vector along (x, y); (1, 0) for vectors shorter than 1e-150, whose squares are close to
 * underflow. */
static inline thud_pos td_volume_direction(double x, double y) {
    double length = __builtin_sqrt(x * x + y * y);
    return length > 1e-150 ? (thud_pos){x / length, y / length} : (thud_pos){1.0, 0.0};
}

/* The OBB of a span along the unit vector (c, s). */
thud_volume td_volume_of_span(thud_pos origin, double c, double s, td_volume_span span);

/* Replaces *best by the OBB of the span if that has a smaller area. */
void td_volume_keep_smaller(thud_volume *best, thud_pos origin, double c, double s,
                            td_volume_span span);

/* Grows the volume by a bound of its rounding errors, and stores it in *out with this kind.
 * THUD_ERROR_INVALID, with *out unchanged, if it is out of range. */
thud_result td_volume_store(thud_shape_kind kind, thud_volume volume, thud_volume *out);

#endif
