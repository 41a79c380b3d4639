/* wind.c: thud_body_apply_wind: drag and lift of air on the circles and boxes of a body.
 *
 * With u the velocity of a point relative to the air, and n the outward normal of an edge with n u
 * > 0 (it faces the wind), a length L of the edge gets at that point
 *     drag:  -density / 2 * drag * L (n u) u
 *     lift:  -density / 2 * lift * L (n u) (|u| n - (n u) u / |u|),
 * so that lift is perpendicular to u and does no work. A circle of radius r counts as an edge as
 * long as its diameter, through its centre and perpendicular to u; its lift comes from its rotation
 * (Magnus effect): density / 2 * lift * 2 r * (r * angular velocity) * (-u.y, u.x). */
#include "fields/fields.h"

#include "state/handles.h"

/* Half the density times the coefficients of drag and of lift. */
typedef struct wind {
    double drag, lift;
} wind;

/* Adds the force on a length of an edge with outward normal n, at a point with velocity u; n u >=
 * 0. */
static void add_wind_force(const wind *air, thud_pos place, thud_pos u, thud_pos n, double length,
                           td_push *push) {
    double across = n.x * u.x + n.y * u.y, speed = __builtin_sqrt(u.x * u.x + u.y * u.y);
    if (!(speed > 0.0)) {
        return;
    }
    double drag = air->drag * length * across, lift = air->lift * length * across;
    double slant_x = speed * n.x - across / speed * u.x;
    double slant_y = speed * n.y - across / speed * u.y;
    td_push_add(push, place.x, place.y, -drag * u.x - lift * slant_x, -drag * u.y - lift * slant_y);
}

/* Adds the force on the part of an edge that faces the wind, n u > 0, by two-point Gauss
 * quadrature. It is exact for polynomials of degree three along the edge: each component of drag
 * has degree two, and its torque degree three. */
static void add_edge_force(const td_field_body *a, const wind *air, thud_pos from, thud_pos to,
                           td_push *push) {
    double x = to.x - from.x, y = to.y - from.y, length = __builtin_sqrt(x * x + y * y);
    thud_pos n = {y / length, -x / length};
    thud_pos u = td_field_velocity_at(a, from.x, from.y), v = td_field_velocity_at(a, to.x, to.y);
    double first = n.x * u.x + n.y * u.y, last = n.x * v.x + n.y * v.y;
    if (!(first > 0.0) && !(last > 0.0)) {
        return;
    }
    double begin = first > 0.0 ? 0.0 : first / (first - last);
    double end = last > 0.0 ? 1.0 : first / (first - last);
    double middle = 0.5 * (begin + end), half = 0.5 * (end - begin);
    for (int i = -1; i <= 1; i += 2) {
        double t = middle + i * half * 0.57735026918962576451; /* 1 / sqrt(3) */
        thud_pos place = {from.x + t * x, from.y + t * y};
        add_wind_force(air, place, td_field_velocity_at(a, place.x, place.y), n, half * length,
                       push);
    }
}

/* Adds the force on a circle. */
static void add_circle_force(const td_field_body *a, const wind *air, const thud_geometry *circle,
                             td_push *push) {
    thud_pos u = td_field_velocity_at(a, circle->x, circle->y);
    double drag = 2.0 * circle->hx * air->drag * __builtin_sqrt(u.x * u.x + u.y * u.y);
    double lift = 2.0 * circle->hx * air->lift * circle->hx * a->turn;
    td_push_add(push, circle->x, circle->y, -drag * u.x - lift * u.y, -drag * u.y + lift * u.x);
}

/* Adds the forces on the edges of a box. */
static void add_box_force(const td_field_body *a, const wind *air, const thud_geometry *box,
                          td_push *push) {
    thud_pos from, to;
    td_corner(box, 3, &from.x, &from.y);
    for (int i = 0; i < 4; i++) {
        td_corner(box, i, &to.x, &to.y);
        add_edge_force(a, air, from, to, push);
        from = to;
    }
}

thud_result thud_body_apply_wind(thud_world *w, thud_body_id id, thud_vec2 velocity, float density,
                                 float drag, float lift) {
    TD_IN_OWN_FLOAT_MODE;
    td_field_body a;
    thud_result result = td_field_body_find(w, id, &a);
    if (result != THUD_OK) {
        return result;
    }
    result = td_field_body_in_flow(w, "apply wind: x or y of wind", velocity, &a);
    if (result == THUD_OK) {
        result = td_check_field(w, "apply wind: density", density, THUD_FLUID_DENSITY_MAX);
    }
    if (result == THUD_OK) {
        result = td_check_field(w, "apply wind: drag", drag, THUD_DRAG_MAX);
    }
    if (result == THUD_OK) {
        result = td_check_field(w, "apply wind: lift", lift, THUD_DRAG_MAX);
    }
    if (result != THUD_OK) {
        return result;
    }
    if (!a.takes_force) {
        return THUD_OK;
    }
    wind air = {0.5 * (double)density * (double)drag, 0.5 * (double)density * (double)lift};
    td_push push = {0};
    for (int i = td_body_at(w, a.index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (td_field_meets(shape)) {
            thud_geometry placed = td_field_shape(w, &a, shape, 0.0);
            (placed.kind == THUD_SHAPE_CIRCLE ? add_circle_force : add_box_force)(&a, &air, &placed,
                                                                                  &push);
        }
    }
    return td_field_push(w, &a, td_push_dissipative(w, &a, push));
}
