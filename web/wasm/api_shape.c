/* api_shape.c: shapes. */
#include "api.h"

/* Slots: 0 density  1 friction  2 restitution  3 category  4 mask  5 group  6 sensor
 * 7 user data  8 surface speed. */
void api_shape_defaults(void) {
    thud_shape_def def = thud_default_shape_def();
    double *s = api_slots;
    s[0] = def.density;
    s[1] = def.friction;
    s[2] = def.restitution;
    s[3] = def.filter.category;
    s[4] = def.filter.mask;
    s[5] = def.filter.group;
    s[6] = def.sensor;
    s[7] = (double)def.user_data;
    s[8] = def.surface_speed;
}

/* From the slots of api_shape_defaults. */
static thud_shape_def read_def(void) {
    const double *s = api_slots;
    thud_shape_def def = thud_default_shape_def();
    def.density = (float)s[0];
    def.friction = (float)s[1];
    def.restitution = (float)s[2];
    def.filter.category = api_to_u32(s[3]);
    def.filter.mask = api_to_u32(s[4]);
    def.filter.group = api_to_int(s[5]);
    def.sensor = s[6] != 0.0;
    def.user_data = (uint64_t)s[7];
    def.surface_speed = (float)s[8];
    return def;
}

/* The new handle goes to slots 0 and 1. */
static int created(thud_result result, thud_shape_id id) {
    api_slots[0] = id.index1;
    api_slots[1] = id.generation;
    return result;
}

int api_circle_create(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                      double radius) {
    thud_shape_def def = read_def();
    thud_shape_id id = {0};
    thud_result result =
        thud_shape_create_circle(world, api_body(index1, generation), &def,
                                 (thud_vec2){(float)x, (float)y}, (float)radius, &id);
    return created(result, id);
}

int api_aabb_create(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                    double half_width, double half_height) {
    thud_shape_def def = read_def();
    thud_shape_id id = {0};
    thud_result result =
        thud_shape_create_aabb(world, api_body(index1, generation), &def,
                               (thud_vec2){(float)x, (float)y},
                               (thud_vec2){(float)half_width, (float)half_height}, &id);
    return created(result, id);
}

int api_obb_create(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                   double half_width, double half_height, double angle) {
    thud_shape_def def = read_def();
    thud_shape_id id = {0};
    thud_result result =
        thud_shape_create_obb(world, api_body(index1, generation), &def,
                              (thud_vec2){(float)x, (float)y},
                              (thud_vec2){(float)half_width, (float)half_height}, angle, &id);
    return created(result, id);
}

/* `points` is an array of x, y pairs in wasm memory; null for flat terrain. */
int api_terrain_create(thud_world *world, uint32_t index1, uint32_t generation, int kind,
                       double slope, double x0, double spacing, const thud_pos *points, int count) {
    thud_shape_def def = read_def();
    thud_terrain terrain = {.kind = (thud_terrain_kind)kind,
                            .slope = slope,
                            .x0 = x0,
                            .spacing = spacing,
                            .points = points,
                            .count = count};
    thud_shape_id id = {0};
    thud_result result =
        thud_shape_create_terrain(world, api_body(index1, generation), &def, &terrain, &id);
    return created(result, id);
}

int api_shape_destroy(thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_shape_destroy(world, api_shape(index1, generation));
}

int api_shape_is_valid(const thud_world *world, uint32_t index1, uint32_t generation) {
    return thud_shape_is_valid(world, api_shape(index1, generation));
}

/* Slots out: 0 kind  1, 2 body  3, 4 offset  5, 6 half extents  7 angle  8 density  9 friction
 * 10 restitution  11 category  12 mask  13 group  14 sensor  15 user data  16 surface speed. */
int api_shape_get(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_shape_state state;
    thud_result result = thud_shape_get(world, api_shape(index1, generation), &state);
    if (result != THUD_OK)
        return result;
    double *s = api_slots;
    s[0] = state.kind;
    s[1] = state.body.index1;
    s[2] = state.body.generation;
    s[3] = state.offset.x;
    s[4] = state.offset.y;
    s[5] = state.half_extents.x;
    s[6] = state.half_extents.y;
    s[7] = state.angle;
    s[8] = state.density;
    s[9] = state.friction;
    s[10] = state.restitution;
    s[11] = state.filter.category;
    s[12] = state.filter.mask;
    s[13] = state.filter.group;
    s[14] = state.sensor;
    s[15] = (double)state.user_data;
    s[16] = state.surface_speed;
    return THUD_OK;
}

/* Slots out: 0 kind  1 slope  2 x0  3 spacing  4 address of the points  5 their count. */
int api_shape_terrain(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_terrain terrain;
    thud_result result = thud_shape_terrain(world, api_shape(index1, generation), &terrain);
    if (result != THUD_OK)
        return result;
    api_slots[0] = terrain.kind;
    api_slots[1] = terrain.slope;
    api_slots[2] = terrain.x0;
    api_slots[3] = terrain.spacing;
    api_slots[4] = (double)(uintptr_t)terrain.points;
    api_slots[5] = terrain.count;
    return THUD_OK;
}

int api_shape_set_heights(thud_world *world, uint32_t index1, uint32_t generation, int first,
                          const double *heights, int count) {
    return thud_shape_set_heights(world, api_shape(index1, generation), first, heights, count);
}
