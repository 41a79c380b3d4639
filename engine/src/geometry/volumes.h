/* volumes.h: what the files that fit bounding volumes share. */
#ifndef TD_VOLUMES_H
#define TD_VOLUMES_H

#include "geometry/shape_instance.h"
#include "thud/thud_volumes.h"

/* What something takes up along a direction of length 1 and across, seen from an origin nearby. */
typedef struct td_span {
    double u_min, u_max, v_min, v_max;
} td_span;

/* The direction of (x, y), of length 1; (1, 0) if that is too short to have one. */
static inline thud_pos td_volume_direction(double x, double y) {
    double length = __builtin_sqrt(x * x + y * y);
    return length > 1e-150 ? (thud_pos){x / length, y / length} : (thud_pos){1.0, 0.0};
}

/* The box of a span along (c, s), as an OBB. */
thud_volume td_volume_of_span(thud_pos origin, double c, double s, td_span span);

/* The same, if it is smaller than *best. */
void td_volume_keep_smaller(thud_volume *best, thud_pos origin, double c, double s, td_span span);

/* Grows the volume by its rounding and stores it as one of that kind, if it is in range. */
thud_result td_volume_store(thud_shape_kind kind, thud_volume volume, thud_volume *out);

#endif
