/* break_thud.c: see break_thud.h. */
#include "break_thud.h"

#include <thud/thud_forces.h>
#include <thud/thud_rules.h>

/* Creates one piece with its centre at `place`, a point in the frame of the body `whole`. */
static thud_result add_piece(const scene_fields *fields, thud_world *world, thud_body_id whole,
                             const thud_body_state *body, const thud_shape_state *box,
                             thud_vec2 place) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.angle = body->angle;
    def.angular_velocity = body->angular_velocity;
    thud_result result = thud_body_get_world_point(world, whole, place, &def.position);
    if (result == THUD_OK)
        result = thud_body_get_velocity_at(world, whole, def.position, &def.velocity);
    thud_body_id piece;
    if (result == THUD_OK)
        result = thud_body_create(world, &def, &piece);
    if (result != THUD_OK)
        return result;
    thud_shape_def shape = thud_default_shape_def();
    shape.density = box->density;
    shape.friction = box->friction;
    shape.filter.category = fields->pieces;
    thud_vec2 half = {0.5f * box->half_extents.x, 0.5f * box->half_extents.y};
    return thud_shape_create_obb(world, piece, &shape, (thud_vec2){0, 0}, half, 0, NULL);
}

/* Breaks the body of a shape into four pieces. A shape that no longer exists, as its body broke
 * earlier in the list of events, or that is of another kind, is left as it is. */
static thud_result break_shape(const scene_fields *fields, thud_world *world, thud_shape_id id) {
    thud_shape_state box;
    thud_body_state body;
    if (!thud_shape_is_valid(world, id) || thud_shape_get_state(world, id, &box) != THUD_OK ||
        box.filter.category != fields->breaks ||
        thud_body_get_state(world, box.body, &body) != THUD_OK)
        return THUD_OK;
    thud_result result = THUD_OK;
    for (int i = 0; i < 4 && result == THUD_OK; i++) {
        thud_vec2 place = {(i % 2 == 0 ? -0.5f : 0.5f) * box.half_extents.x,
                           (i < 2 ? -0.5f : 0.5f) * box.half_extents.y};
        result = add_piece(fields, world, box.body, &body, &box, place);
    }
    return result == THUD_OK ? thud_body_destroy(world, box.body) : result;
}

thud_result scene_break_thud(const scene_fields *fields, thud_world *world) {
    int count = 0;
    const thud_impulse_event *events =
        fields->breaks != 0 ? thud_impulse_events_of(world, &count) : NULL;
    thud_result result = THUD_OK;
    for (int i = 0; i < count && result == THUD_OK; i++) {
        result = break_shape(fields, world, events[i].shape_a);
        if (result == THUD_OK)
            result = break_shape(fields, world, events[i].shape_b);
    }
    return result;
}
