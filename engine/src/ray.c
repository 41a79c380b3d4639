/* ray.c: rays against circles and boxes. */
#include "placed.h"

static bool cast_circle(double ox, double oy, double dx, double dy, double r, double *fraction,
                        double *nx, double *ny)
{
    double a = dx * dx + dy * dy, b = ox * dx + oy * dy, c = ox * ox + oy * oy - r * r;
    double root = b * b - a * c;
    if (c < 0.0 || a == 0.0 || root < 0.0) {
        return false;
    }
    double t = (-b - __builtin_sqrt(root)) / a;
    if (!(t >= 0.0 && t <= 1.0)) {
        return false;
    }
    *fraction = t;
    *nx = (ox + t * dx) / r;
    *ny = (oy + t * dy) / r;
    return true;
}

/* Narrows [*enter, *leave] to where o + t d lies within the slab |x| <= h. */
static bool slab(double o, double d, double h, double *enter, double *leave, bool *entered)
{
    *entered = false;
    if (d == 0.0) {
        return td_abs(o) <= h;
    }
    double in = ((d > 0.0 ? -h : h) - o) / d, out = ((d > 0.0 ? h : -h) - o) / d;
    if (in > *enter) {
        *enter = in;
        *entered = true;
    }
    *leave = out < *leave ? out : *leave;
    return *enter <= *leave;
}

static bool cast_box(double ox, double oy, double dx, double dy, double hx, double hy,
                     double *fraction, double *nx, double *ny)
{
    double enter = -1e300, leave = 1.0;
    bool by_x, by_y;
    if (!slab(ox, dx, hx, &enter, &leave, &by_x) || !slab(oy, dy, hy, &enter, &leave, &by_y) ||
        enter < 0.0) {
        return false;
    }
    *fraction = enter;
    *nx = by_y ? 0.0 : dx > 0.0 ? -1.0 : 1.0;
    *ny = !by_y ? 0.0 : dy > 0.0 ? -1.0 : 1.0;
    return true;
}

bool thud_shape_cast_ray(const thud_placed *shape, double ox, double oy, double dx, double dy,
                         double *fraction, double *nx, double *ny)
{
    double f, u, v;
    if (thud_placed_check(shape) != THUD_OK ||
        !td_finite(ox + oy + dx + dy)) {
        return false;
    }
    if (shape->kind == THUD_CIRCLE) {
        if (!cast_circle(ox - shape->x, oy - shape->y, dx, dy, shape->hx, &f, &u, &v)) {
            return false;
        }
    } else {
        double lox, loy, ldx, ldy, lu, lv;
        td_to_frame(shape, ox - shape->x, oy - shape->y, &lox, &loy);
        td_to_frame(shape, dx, dy, &ldx, &ldy);
        if (!cast_box(lox, loy, ldx, ldy, shape->hx, shape->hy, &f, &lu, &lv)) {
            return false;
        }
        td_from_frame(shape, lu, lv, &u, &v);
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
