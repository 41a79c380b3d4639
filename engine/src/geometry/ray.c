/* ray.c: a ray against a circle or box, as the path of a point against the shape's Minkowski sum
 * with a point, which is the shape itself (minkowski.c). */
#include "geometry/minkowski.h"

bool thud_geometry_cast_ray(const thud_geometry *shape, double ox, double oy, double dx,
                         double dy, double *fraction, double *nx, double *ny) {
    thud_minkowski sum;
    double f, u, v;
    if (thud_geometry_check(shape) != THUD_OK || !td_finite(ox + oy + dx + dy)) {
        return false;
    }
    td_minkowski_of(shape, &sum);
    if (!td_minkowski_enter(&sum, ox - shape->x, oy - shape->y, dx, dy, &f, &u, &v)) {
        return false;
    }
    if (fraction) {
        *fraction = f;
    }
    if (nx) {
        *nx = u;
    }
    if (ny) {
        *ny = v;
    }
    return true;
}
