/* buoyancy.c: thud_body_apply_buoyancy: the forces of water below a line on a body.
 *
 * With A the area and c the centroid of the part of a shape below the line (submerged.h), and
 * m = density * A the mass of the displaced water, each shape gets
 *     lift at c:    -m * gravity                      (Archimedes)
 *     drag at c:    -m * linear_drag * u(c)           (u: velocity relative to the water)
 *     drag torque:  -m * A / (2 pi) * angular_drag * turn,
 * where m A / (2 pi) is the moment of inertia of a disc of mass m and area A. td_push_dissipative
 * limits the sum of the drags so that it does not add energy. */
#include "fields/submerged.h"

#include "state/body.h"
#include "state/handles.h"

thud_water thud_default_water(void) {
    return (thud_water){.normal = {0.0f, 1.0f},
                        .density = 1.0f,
                        .linear_drag = 2.0f,
                        .angular_drag = 2.0f,
                        .cookie = TD_COOKIE};
}

/* Refuses water whose point, density or drag is out of range. */
static thud_result check(const thud_world *w, const thud_water *water) {
    thud_result result =
        td_check_place(w, "water: x or y of point", water->point.x, water->point.y);
    if (result == THUD_OK) {
        result = td_check_field(w, "water: density", water->density, THUD_FLUID_DENSITY_MAX);
    }
    if (result == THUD_OK) {
        result = td_check_field(w, "water: linear_drag", water->linear_drag, THUD_DRAG_MAX);
    }
    return result != THUD_OK
               ? result
               : td_check_field(w, "water: angular_drag", water->angular_drag, THUD_DRAG_MAX);
}

/* The height of the centre of mass above the line, along its normal `up`. */
static double height_of(const thud_world *w, const td_field_body *a, const thud_water *water,
                        thud_pos up) {
    td_position line = td_place_from(w, water->point), center = td_pose_at(w, a->index)->center;
    return up.x * ((double)(center.x - line.x) / w->to_fixed) +
           up.y * ((double)(center.y - line.y) / w->to_fixed);
}

/* Adds the lift and drag of one shape. `height` is the height of the centre of mass half a time
 * step later, and the shape is rotated to the same time. The force acts throughout the step:
 * computed from the pose at the start of the step, it would add energy to a bobbing body; from the
 * pose in the middle of the step it does not, for any number of substeps. */
static void add_shape_forces(const thud_world *w, const td_field_body *a, const thud_water *water,
                             double height, thud_pos up, const td_shape *shape, td_push *lift,
                             td_push *drag) {
    double half_step = 0.5 * w->def.time_step;
    thud_geometry placed = td_field_shape(w, a, shape, half_step * a->turn);
    double above = height + up.x * placed.x + up.y * placed.y;
    td_submerged_part part = td_submerged_part_of(&placed, above, up);
    double mass = (double)water->density * part.area;
    td_push_add(lift, part.x, part.y, -mass * (double)w->def.gravity.x,
                -mass * (double)w->def.gravity.y);
    thud_pos u = td_field_velocity_at(a, part.x, part.y);
    double rate = mass * (double)water->linear_drag;
    td_push_add(drag, part.x, part.y, -rate * u.x, -rate * u.y);
    drag->turn -= mass * part.area / (2.0 * TD_PI) * (double)water->angular_drag * a->turn;
}

thud_result thud_body_apply_buoyancy(thud_world *w, thud_body_id id, const thud_water *water) {
    TD_IN_OWN_FLOAT_MODE;
    td_field_body a;
    thud_pos up;
    thud_result result = td_field_body_find(w, id, &a);
    if (result != THUD_OK) {
        return result;
    }
    if (!water) {
        return td_refuse(w, THUD_ERROR_NULL, "apply buoyancy: water is null");
    }
    if (water->cookie != TD_COOKIE) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "apply_buoyancy: the water does not start from thud_default_water()");
    }
    double fall_x = a.x, fall_y = a.y;
    result = check(w, water);
    if (result == THUD_OK) {
        result = td_field_body_in_flow(w, "water: x or y of flow", water->flow, &a);
    }
    if (result != THUD_OK) {
        return result;
    }
    if (!td_line_normal((double)water->normal.x, (double)water->normal.y, &up)) {
        return td_refuse(w, THUD_ERROR_INVALID, "water: normal is not of length 1");
    }
    if (!a.takes_force) {
        return THUD_OK;
    }
    double half_step = 0.5 * w->def.time_step;
    double height = height_of(w, &a, water, up) + half_step * (up.x * fall_x + up.y * fall_y);
    td_push lift = {0}, drag = {0};
    for (int i = td_body_at(w, a.index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        const td_shape *shape = td_shape_at(w, i);
        if (td_field_meets(shape)) {
            add_shape_forces(w, &a, water, height, up, shape, &lift, &drag);
        }
    }
    drag = td_push_dissipative(w, &a, drag);
    return td_field_push(w, &a, (td_push){lift.x + drag.x, lift.y + drag.y, lift.turn + drag.turn});
}
