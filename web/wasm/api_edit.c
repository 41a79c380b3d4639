/* api_edit.c: exports that change bodies and shapes: the setters of thud_edits.h and thud_locks.h.
 * api.h has the conventions. */
#include "api.h"

#include <thud/thud_edits.h>
#include <thud/thud_locks.h>

/* ---- shapes ---- */

int api_shape_set_filter(thud_world *world, uint32_t index1, uint32_t generation, double category,
                         double mask, double group) {
    const thud_filter filter = {api_to_u32(category), api_to_u32(mask), api_to_int(group)};
    return thud_shape_set_filter(world, api_shape(index1, generation), filter);
}

int api_shape_set_friction(thud_world *world, uint32_t index1, uint32_t generation,
                           double friction) {
    return thud_shape_set_friction(world, api_shape(index1, generation), (float)friction);
}

int api_shape_set_restitution(thud_world *world, uint32_t index1, uint32_t generation,
                              double restitution) {
    return thud_shape_set_restitution(world, api_shape(index1, generation), (float)restitution);
}

int api_shape_set_surface_speed(thud_world *world, uint32_t index1, uint32_t generation,
                                double speed) {
    return thud_shape_set_surface_speed(world, api_shape(index1, generation), (float)speed);
}

int api_shape_set_density(thud_world *world, uint32_t index1, uint32_t generation, double density) {
    return thud_shape_set_density(world, api_shape(index1, generation), (float)density);
}

int api_shape_set_sensor(thud_world *world, uint32_t index1, uint32_t generation, int sensor) {
    return thud_shape_set_sensor(world, api_shape(index1, generation), sensor != 0);
}

int api_shape_set_events(thud_world *world, uint32_t index1, uint32_t generation, int events) {
    return thud_shape_set_events(world, api_shape(index1, generation), events != 0);
}

int api_shape_set_radius(thud_world *world, uint32_t index1, uint32_t generation, double radius) {
    return thud_shape_set_radius(world, api_shape(index1, generation), (float)radius);
}

int api_shape_set_half_extents(thud_world *world, uint32_t index1, uint32_t generation, double x,
                               double y) {
    return thud_shape_set_half_extents(world, api_shape(index1, generation),
                                       (thud_vec2){(float)x, (float)y});
}

int api_shape_set_user_data(thud_world *world, uint32_t index1, uint32_t generation, double data) {
    return thud_shape_set_user_data(world, api_shape(index1, generation), (uint64_t)data);
}

/* ---- bodies ---- */

int api_body_set_kind(thud_world *world, uint32_t index1, uint32_t generation, int kind) {
    return thud_body_set_kind(world, api_body(index1, generation), (thud_body_kind)kind);
}

int api_body_set_damping(thud_world *world, uint32_t index1, uint32_t generation, double linear,
                         double angular) {
    return thud_body_set_damping(world, api_body(index1, generation), (float)linear,
                                 (float)angular);
}

int api_body_set_gravity_scale(thud_world *world, uint32_t index1, uint32_t generation,
                               double scale) {
    return thud_body_set_gravity_scale(world, api_body(index1, generation), (float)scale);
}

int api_body_set_fixed_rotation(thud_world *world, uint32_t index1, uint32_t generation,
                                int fixed) {
    return thud_body_set_fixed_rotation(world, api_body(index1, generation), fixed != 0);
}

/* A detection of -1: as the world's. */
int api_body_set_detection(thud_world *world, uint32_t index1, uint32_t generation,
                           double detection) {
    return thud_body_set_detection(world, api_body(index1, generation), api_detection(detection));
}

int api_body_set_may_sleep(thud_world *world, uint32_t index1, uint32_t generation, int may_sleep) {
    return thud_body_set_may_sleep(world, api_body(index1, generation), may_sleep != 0);
}

int api_body_set_mass(thud_world *world, uint32_t index1, uint32_t generation, double mass,
                      double inertia, double center_x, double center_y) {
    const thud_mass given = {(float)mass, (float)inertia, {(float)center_x, (float)center_y}};
    return thud_body_set_mass(world, api_body(index1, generation), &given);
}

int api_body_set_locks(thud_world *world, uint32_t index1, uint32_t generation, int x, int y) {
    return thud_body_set_locks(world, api_body(index1, generation), x != 0, y != 0);
}

/* Slots out: number, the sum of 1 where x is locked and 2 where y is. */
int api_body_locks(const thud_world *world, uint32_t index1, uint32_t generation) {
    bool x = false, y = false;
    thud_result result = thud_body_get_locks(world, api_body(index1, generation), &x, &y);
    api_slots.number.value = x + 2 * y;
    return result;
}

/* Sets the mass of a body to that of its shapes. */
int api_body_weigh(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_body_set_mass(world, api_body(index1, generation), NULL);
}
