/* shape_size.c: setters of a shape's density, radius and half extents, which change the mass of its
 * body; see thud_edits.h. */
#include "thud/thud_edits.h"

#include "edits/edit.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* Recomputes the mass of the shape's body. */
static void update_mass(thud_world *w, int shape) {
    td_body_index body = td_shape_at(w, shape)->body;
    const td_body *before = td_body_at(w, body);
    td_edit_weigh(w, body, before->inv_mass, before->inv_inertia);
}

thud_result thud_shape_set_density(thud_world *w, thud_shape_id id, float density) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check(w, "set density: density", (double)density, 0.0, (double)THUD_DENSITY_MAX);
    if (result != THUD_OK) {
        return result;
    }
    td_shape_at(w, index)->density = density;
    update_mass(w, index);
    return THUD_OK;
}

/* Sets the size. Fat bounds are only recomputed when the shape leaves them, which a shape that
 * shrinks does not. So they are set to a point, which the shape leaves in any case. */
static void resize(thud_world *w, int index, float half_x, float half_y) {
    td_shape *shape = td_shape_at(w, index);
    shape->half_x = half_x;
    shape->half_y = half_y;
    w->thinnest_stale = true;
    if (!(*td_marks_at(w, index) & TD_MARK_FRESH)) {
        td_shape_mark_moved(w, index);
        *td_fat_at(w, index) = td_bounds_about(td_shape_proxy_at(w, index)->center, 0, 0);
    }
    update_mass(w, index);
}

thud_result thud_shape_set_radius(thud_world *w, thud_shape_id id, float radius) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_shape *shape = td_shape_at(w, index);
    if (!td_kind_is_round(shape->kind)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set radius: the shape is no circle");
    }
    td_reason why;
    if (!td_size_in(w, &why, "set radius: radius", td_body_at(w, shape->body)->kind, radius)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    resize(w, index, radius, 0.0f);
    return THUD_OK;
}

thud_result thud_shape_set_half_extents(thud_world *w, thud_shape_id id, thud_vec2 half) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_edit_shape(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_shape *shape = td_shape_at(w, index);
    int kind = td_body_at(w, shape->body)->kind;
    if (!td_kind_is_box(shape->kind)) {
        return td_refuse(w, THUD_ERROR_INVALID, "set half extents: the shape is no box");
    }
    td_reason why;
    const char *name = "set half extents: x or y of half";
    if (!td_size_in(w, &why, name, kind, half.x) || !td_size_in(w, &why, name, kind, half.y)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    resize(w, index, half.x, half.y);
    return THUD_OK;
}
