/* api_shape.c: exports that create and read shapes. The options of a new shape are the slots
 * shape_options; api.h has the conventions. */
#include "api.h"

/* Slots out: shape_options. */
void api_shape_defaults(void) {
    thud_shape_def def = thud_default_shape_def();
    struct shape_options *s = &api_slots.shape_options;
    s->density = def.density;
    s->friction = def.friction;
    s->restitution = def.restitution;
    s->category = def.filter.category;
    s->mask = def.filter.mask;
    s->group = def.filter.group;
    s->sensor = def.sensor;
    s->user_data = (double)def.user_data;
    s->surface_speed = def.surface_speed;
    s->events = def.events;
}

/* Slots in: shape_options. */
static thud_shape_def read_def(void) {
    const struct shape_options *s = &api_slots.shape_options;
    thud_shape_def def = thud_default_shape_def();
    def.density = (float)s->density;
    def.friction = (float)s->friction;
    def.restitution = (float)s->restitution;
    def.filter.category = api_to_u32(s->category);
    def.filter.mask = api_to_u32(s->mask);
    def.filter.group = api_to_int(s->group);
    def.sensor = s->sensor != 0.0;
    def.user_data = (uint64_t)s->user_data;
    def.surface_speed = (float)s->surface_speed;
    def.events = s->events != 0.0;
    return def;
}

/* Slots out: handle. Returns `result`. */
static int created(thud_result result, thud_shape_id id) {
    api_slots.handle.index1 = id.index1;
    api_slots.handle.generation = id.generation;
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

/* `points`: an array of x, y pairs in wasm memory; null for flat terrain. */
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

/* Slots out: shape_state. */
int api_shape_state(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_shape_state state;
    thud_result result = thud_shape_get_state(world, api_shape(index1, generation), &state);
    if (result != THUD_OK)
        return result;
    struct shape_state *s = &api_slots.shape_state;
    s->kind = state.kind;
    s->body[0] = state.body.index1;
    s->body[1] = state.body.generation;
    s->offset[0] = state.offset.x;
    s->offset[1] = state.offset.y;
    s->half_extents[0] = state.half_extents.x;
    s->half_extents[1] = state.half_extents.y;
    s->angle = state.angle;
    s->density = state.density;
    s->friction = state.friction;
    s->restitution = state.restitution;
    s->category = state.filter.category;
    s->mask = state.filter.mask;
    s->group = state.filter.group;
    s->sensor = state.sensor;
    s->user_data = (double)state.user_data;
    s->surface_speed = state.surface_speed;
    s->events = state.events;
    return THUD_OK;
}

/* Slots out: terrain; its points are valid until the next edit of the world. */
int api_shape_terrain(const thud_world *world, uint32_t index1, uint32_t generation) {
    thud_terrain terrain;
    thud_result result = thud_shape_get_terrain(world, api_shape(index1, generation), &terrain);
    if (result != THUD_OK)
        return result;
    api_slots.terrain.kind = terrain.kind;
    api_slots.terrain.slope = terrain.slope;
    api_slots.terrain.x0 = terrain.x0;
    api_slots.terrain.spacing = terrain.spacing;
    api_slots.terrain.points.address = (double)(uintptr_t)terrain.points;
    api_slots.terrain.points.count = terrain.count;
    return THUD_OK;
}

int api_shape_set_heights(thud_world *world, uint32_t index1, uint32_t generation, int first,
                          const double *heights, int count) {
    return thud_shape_set_heights(world, api_shape(index1, generation), first, heights, count);
}
