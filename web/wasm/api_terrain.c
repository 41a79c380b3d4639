/* api_terrain.c: exports that read the ground of a terrain at x, place feet on it, and edit its
 * line. Places are in the world, except in api_shape_replace_range. api.h has the conventions. */
#include "api.h"

/* The line of a terrain shape, whose coordinates are relative to its body's origin, and that
 * origin. */
static thud_result find_ground(const thud_world *world, thud_shape_id shape, thud_terrain *line,
                               thud_pos *origin) {
    thud_shape_state state;
    thud_body_state body;
    thud_result result = thud_shape_get_terrain(world, shape, line);
    if (result == THUD_OK)
        result = thud_shape_get_state(world, shape, &state);
    if (result == THUD_OK)
        result = thud_body_get_state(world, state.body, &body);
    if (result == THUD_OK)
        *origin = body.position;
    return result;
}

/* Slots out: ground. */
int api_ground_at(const thud_world *world, uint32_t index1, uint32_t generation, double x) {
    thud_terrain line;
    thud_pos origin;
    thud_terrain_sample sample;
    thud_result result = find_ground(world, api_shape(index1, generation), &line, &origin);
    if (result == THUD_OK)
        result = thud_terrain_sample_at(&line, x - origin.x, &sample);
    if (result != THUD_OK)
        return result;
    struct ground *s = &api_slots.ground;
    s->height = sample.height + origin.y;
    s->normal[0] = sample.nx;
    s->normal[1] = sample.ny;
    s->segment = sample.segment;
    s->weights[0] = sample.weight[0];
    s->weights[1] = sample.weight[1];
    return THUD_OK;
}

/* Slots out: foot. */
int api_place_foot(const thud_world *world, uint32_t index1, uint32_t generation, double x,
                   double width) {
    thud_terrain line;
    thud_pos origin;
    thud_foot foot;
    thud_result result = find_ground(world, api_shape(index1, generation), &line, &origin);
    if (result == THUD_OK)
        result = thud_terrain_place_foot(&line, x - origin.x, width, &foot);
    if (result != THUD_OK)
        return result;
    struct foot *s = &api_slots.foot;
    s->height = foot.height + origin.y;
    s->x = foot.x + origin.x;
    s->normal[0] = foot.nx;
    s->normal[1] = foot.ny;
    return THUD_OK;
}

int api_shape_dig(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                  double radius) {
    return thud_shape_dig(world, api_shape(index1, generation), (thud_pos){x, y}, radius);
}

int api_shape_raise(thud_world *world, uint32_t index1, uint32_t generation, double x,
                    double radius, double height) {
    return thud_shape_raise(world, api_shape(index1, generation), x, radius, height);
}

/* x0, x1 and `points` (as in api_terrain_create) are relative to the body's origin. */
int api_shape_replace_range(thud_world *world, uint32_t index1, uint32_t generation, double x0,
                            double x1, const thud_pos *points, int count) {
    return thud_shape_replace_range(world, api_shape(index1, generation), x0, x1, points, count);
}
