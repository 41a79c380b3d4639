/* circles.c: geometry of two circles, in closed form: a world that has no boxes is given this table
 * (td_instance_ops), so that a program without boxes does not link theirs. */
#include "geometry/shape_instance.h"

void td_circles_closest(const thud_geometry *a, const thud_geometry *b, thud_closest *out) {
    double dx = b->x - a->x, dy = b->y - a->y;
    double length = __builtin_sqrt(dx * dx + dy * dy);
    out->nx = length > 0.0 ? dx / length : 0.0;
    out->ny = length > 0.0 ? dy / length : 1.0;
    out->distance = length - a->hx - b->hx;
    out->ax = a->x + out->nx * a->hx;
    out->ay = a->y + out->ny * a->hx;
    out->bx = b->x - out->nx * b->hx;
    out->by = b->y - out->ny * b->hx;
}

bool td_circle_enter(thud_pos centre, double radius, double x, double y, double dx, double dy,
                     double *fraction, double *nx, double *ny) {
    double ox = x - centre.x, oy = y - centre.y, length = __builtin_sqrt(dx * dx + dy * dy);
    if (!(length > 0.0) || ox * ox + oy * oy < radius * radius) {
        return false;
    }
    double ux = dx / length, uy = dy / length;
    double ahead = -(ox * ux + oy * uy);
    /* Uses the distance from the centre to the line: the discriminant of a quadratic equation would
     * suffer cancellation for points that start far away. */
    double side = ux * oy - uy * ox, root = radius * radius - side * side;
    if (!(ahead > 0.0 && root >= 0.0)) {
        return false;
    }
    double half_chord = __builtin_sqrt(root), enter = ahead - half_chord;
    if (enter > length) {
        return false;
    }
    *fraction = enter > 0.0 ? enter / length : 0.0;
    *nx = -(uy * side + ux * half_chord) / radius;
    *ny = (ux * side - uy * half_chord) / radius;
    return true;
}

static bool are_valid(const thud_geometry *a, const thud_geometry *b) {
    return td_circle_valid(a) && td_circle_valid(b);
}

static bool overlap(const thud_geometry *a, const thud_geometry *b) {
    thud_closest closest;
    td_circles_closest(a, b, &closest);
    return are_valid(a, b) && closest.distance <= 0.0;
}

/* The circles meet when the centre of b, on its path relative to a, enters the circle about a's
 * centre whose radius is the sum of both: their Minkowski sum. */
static thud_result time_of_impact(const thud_geometry *a, thud_motion ma, const thud_geometry *b,
                                  thud_motion mb, double target, bool *hit, double *time) {
    double x = b->x - a->x, y = b->y - a->y, radius = a->hx + b->hx + target, nx, ny;
    if (!are_valid(a, b) || !td_motion_valid(ma) || !td_motion_valid(mb)) {
        return THUD_ERROR_INVALID;
    }
    *time = 0.0;
    *hit = x * x + y * y <= radius * radius;
    if (!*hit) {
        *time = 1.0;
        *hit = td_circle_enter((thud_pos){0.0, 0.0}, radius, x, y, mb.dx - ma.dx, mb.dy - ma.dy,
                               time, &nx, &ny);
    }
    return THUD_OK;
}

const td_instance_ops td_circle_instances = {overlap, time_of_impact, td_circles_closest};
