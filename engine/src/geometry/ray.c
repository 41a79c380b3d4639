/* ray.c: a ray against a circle or box, as the path of a point against the shape's Minkowski sum
 * with a point, which is the shape itself (minkowski.c). */
#include "geometry/minkowski.h"

bool thud_geometry_cast_ray(const thud_geometry *shape, thud_segment ray, double *out_fraction,
                            double *out_nx, double *out_ny) {
    thud_minkowski sum;
    double f, u, v;
    if (thud_geometry_check(shape) != THUD_OK || !td_finite(ray.x + ray.y + ray.dx + ray.dy)) {
        return false;
    }
    td_minkowski_of(shape, &sum);
    if (!td_minkowski_enter(&sum, ray.x - shape->x, ray.y - shape->y, ray.dx, ray.dy, &f, &u, &v)) {
        return false;
    }
    if (out_fraction) {
        *out_fraction = f;
    }
    if (out_nx) {
        *out_nx = u;
    }
    if (out_ny) {
        *out_ny = v;
    }
    return true;
}
