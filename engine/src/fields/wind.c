/* wind.c: drag and lift of air on circles and boxes. */
#include "fields/fields.h"

#include "state/handles.h"

/* Half the density times either coefficient. */
typedef struct wind {
    double drag, lift;
} wind;

/* Of a length of an edge, at a place in its wind: n is its outward normal, across = n . u >= 0. */
static void blow(const wind *air, thud_pos place, thud_pos u, thud_pos n, double length,
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

/* The part of an edge that goes into the wind, by two points after Gauss, which are exact up to the
 * third power of the way along the edge: drag has the second, its torque the third. */
static void blow_at_edge(const td_adrift *a, const wind *air, thud_pos from, thud_pos to,
                         td_push *push) {
    double x = to.x - from.x, y = to.y - from.y, length = __builtin_sqrt(x * x + y * y);
    thud_pos n = {y / length, -x / length};
    thud_pos u = td_adrift_at(a, from.x, from.y), v = td_adrift_at(a, to.x, to.y);
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
        blow(air, place, td_adrift_at(a, place.x, place.y), n, half * length, push);
    }
}

static void blow_at_circle(const td_adrift *a, const wind *air, const thud_shape_instance *circle,
                           td_push *push) {
    thud_pos u = td_adrift_at(a, circle->x, circle->y);
    double drag = 2.0 * circle->hx * air->drag * __builtin_sqrt(u.x * u.x + u.y * u.y);
    double lift = 2.0 * circle->hx * air->lift * circle->hx * a->turn;
    td_push_add(push, circle->x, circle->y, -drag * u.x - lift * u.y, -drag * u.y + lift * u.x);
}

static void blow_at_box(const td_adrift *a, const wind *air, const thud_shape_instance *box,
                        td_push *push) {
    thud_pos from, to;
    td_corner(box, 3, &from.x, &from.y);
    for (int i = 0; i < 4; i++) {
        td_corner(box, i, &to.x, &to.y);
        blow_at_edge(a, air, from, to, push);
        from = to;
    }
}

thud_result thud_body_apply_wind(thud_world *w, thud_body_id id, thud_vec2 velocity, float density,
                                 float drag, float lift) {
    TD_IN_OWN_MODE;
    td_adrift a;
    thud_result result = td_adrift_find(w, id, &a);
    if (result != THUD_OK) {
        return result;
    }
    result = td_adrift_in_flow(w, "apply wind: x or y of wind", velocity, &a);
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
    if (!a.heeds) {
        return THUD_OK;
    }
    wind air = {0.5 * (double)density * (double)drag, 0.5 * (double)density * (double)lift};
    td_push push = {0};
    for (int i = td_body_at(w, a.index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (td_field_meets(shape)) {
            thud_shape_instance placed = td_field_shape(w, &a, shape, 0.0);
            (placed.kind == THUD_CIRCLE ? blow_at_circle : blow_at_box)(&a, &air, &placed, &push);
        }
    }
    return td_field_push(w, &a, td_push_braking(w, &a, push));
}
