/* make_body.c: thud_body_make, a body of one shape: translates thud_body_options, where 0 is the
 * default, into the defs of thud_body_create_with_shapes. */
#include "thud/thud_make.h"

#include "base/trig.h"
#include "state/handles.h"
#include "thud/thud_edits.h"

static thud_body_def body_def(const thud_body_options *options, const thud_geometry *at) {
    thud_body_def def = thud_default_body_def();
    def.kind = options->kind;
    def.position = (thud_pos){at->x, at->y};
    def.angle = at->kind == THUD_SHAPE_OBB ? td_angle_of(at->c, at->s) : 0.0;
    def.velocity = options->velocity;
    def.angular_velocity = options->angular_velocity;
    def.gravity_scale = options->weightless ? 0.0f : def.gravity_scale;
    def.linear_damping = options->linear_damping;
    def.angular_damping = options->angular_damping;
    def.fixed_rotation = options->fixed_rotation;
    def.detection = options->detection;
    def.user_data = options->user_data;
    return def;
}

static thud_shape_def shape_def(const thud_body_options *options) {
    thud_shape_def def = thud_default_shape_def();
    def.density = options->density != 0.0f ? options->density : def.density;
    def.friction = options->friction != 0.0f ? options->friction
                   : options->frictionless   ? 0.0f
                                             : def.friction;
    def.restitution = options->restitution;
    def.surface_speed = options->surface_speed;
    def.filter.category = options->category ? options->category : def.filter.category;
    def.filter.mask = options->mask ? options->mask : def.filter.mask;
    def.filter.group = options->group;
    def.sensor = options->sensor;
    def.user_data = options->user_data;
    return def;
}

thud_body_id thud_body_make(thud_world *w, thud_geometry at, const thud_body_options *options) {
    TD_IN_OWN_FLOAT_MODE;
    thud_body_options usual = {0};
    thud_body_id made = {0, 0};
    options = options ? options : &usual;
    if (thud_geometry_check(&at) != THUD_OK) {
        td_refuse(
            w, THUD_ERROR_INVALID,
            "body make: the shape is no circle, AABB or OBB, or its place, radius or half extents are not finite, or below 0");
        return made;
    }
    if (options->frictionless && options->friction != 0.0f) {
        td_refuse(w, THUD_ERROR_INVALID, "body make: frictionless, and with friction");
        return made;
    }
    thud_body_def body = body_def(options, &at);
    thud_shape_def shape = shape_def(options);
    thud_body_shape one = {{at.kind, 0.0, 0.0, 1.0, 0.0, at.hx, at.hy}, &shape};
    return thud_body_create_with_shapes(w, &body, &one, 1, &made, NULL) == THUD_OK
               ? made
               : (thud_body_id){0, 0};
}
