/* ray.c: rays against circles and boxes. */
#include "placed.h"

bool td_ray_enters_circle(double ox, double oy, double dx, double dy, double r, double *fraction)
{
    double length = __builtin_sqrt(dx * dx + dy * dy);
    if (!(length > 0.0) || ox * ox + oy * oy < r * r) {
        return false;
    }
    double ux = dx / length, uy = dy / length;
    double ahead = -(ox * ux + oy * uy);
    /* From the centre's distance to the line: a discriminant would cancel for rays from afar. */
    double side = ux * oy - uy * ox, root = r * r - side * side;
    if (!(ahead > 0.0 && root >= 0.0)) {
        return false;
    }
    double enter = ahead - __builtin_sqrt(root);
    *fraction = enter > 0.0 ? enter / length : 0.0;
    return enter <= length;
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
        double px = ox - shape->x, py = oy - shape->y;
        if (!td_ray_enters_circle(px, py, dx, dy, shape->hx, &f)) {
            return false;
        }
        u = px + f * dx;
        v = py + f * dy;
        double length = __builtin_sqrt(u * u + v * v);
        u /= length;
        v /= length;
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
