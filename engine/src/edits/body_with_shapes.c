/* body_with_shapes.c: thud_body_create_with_shapes. All checks are done and all memory is reserved
 * before the body is made, so that the call makes everything or nothing. */
#include "thud/thud_edits.h"

#include "base/rotation.h"
#include "base/trig.h"
#include "geometry/shape_instance.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* Why a shape of the body to be made is refused, or null: the checks of thud_shape_create_circle
 * and so on, against the def in place of a body. */
static const char *shape_error(const thud_world *w, const thud_body_def *def,
                               const thud_body_shape *one, td_reason *why) {
    const char *half = "body create with shapes: radius or half extent of a shape";
    const thud_geometry *at = &one->shape;
    if (thud_geometry_check(at) != THUD_OK) {
        return "body create with shapes: a shape is no circle, AABB or OBB, or its place, radius or half extents are not finite, or below 0";
    }
    if (!td_offset_in(w, why, "body create with shapes: x or y of a shape",
                      (thud_vec2){(float)at->x, (float)at->y}) ||
        !td_size_in(w, why, half, (int)def->kind, (float)at->hx) ||
        !(td_kind_is_round(at->kind) || td_size_in(w, why, half, (int)def->kind, (float)at->hy))) {
        return why->text;
    }
    bool turns = def->kind == THUD_BODY_KINEMATIC && def->angular_velocity != 0.0f;
    if (at->kind == THUD_SHAPE_AABB && (turns || td_angle_from(def->angle) != 0)) {
        return "body create with shapes: with an AABB its angle must be 0, and it must not turn";
    }
    return one->def ? td_shape_def_error(w, one->def, why) : NULL;
}

/* Creates one shape that has been checked. */
static thud_result create(thud_world *w, thud_body_id body, const thud_body_shape *one,
                          thud_shape_id *out) {
    const thud_geometry *at = &one->shape;
    thud_shape_def usual = thud_default_shape_def();
    const thud_shape_def *def = one->def ? one->def : &usual;
    thud_vec2 offset = {(float)at->x, (float)at->y}, half = {(float)at->hx, (float)at->hy};
    switch (at->kind) {
    case THUD_SHAPE_CIRCLE:
        return thud_shape_create_circle(w, body, def, offset, half.x, out);
    case THUD_SHAPE_AABB:
        return thud_shape_create_aabb(w, body, def, offset, half, out);
    case THUD_SHAPE_OBB:
        return thud_shape_create_obb(w, body, def, offset, half, td_angle_of(at->c, at->s), out);
    case THUD_SHAPE_TERRAIN:
        break;
    }
    return THUD_ERROR_INVALID;
}

thud_result thud_body_create_with_shapes(thud_world *w, const thud_body_def *def,
                                         const thud_body_shape *shapes, int count,
                                         thud_body_id *out_body, thud_shape_id *out_shape_ids) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !def || (!shapes && count > 0)) {
        return td_refuse(w, THUD_ERROR_NULL,
                         "body create with shapes: world, def or shapes is null");
    }
    td_reason why;
    const char *error =
        count < 0 ? "body create with shapes: count is negative" : td_body_def_error(w, def, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    for (int i = 0; i < count; i++) {
        error = shape_error(w, def, &shapes[i], &why);
        if (error) {
            return td_refuse(w, THUD_ERROR_INVALID, error);
        }
    }
    if (!td_shape_reserve(w, count)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "body create with shapes: out of memory");
    }
    thud_body_id made = {0};
    thud_result result = thud_body_create(w, def, &made);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        result = create(w, made, &shapes[i], out_shape_ids ? &out_shape_ids[i] : NULL);
        assert(result == THUD_OK);
    }
    if (out_body && result == THUD_OK) {
        *out_body = made;
    }
    return result;
}
