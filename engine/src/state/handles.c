/* handles.c: texts of results, refusals with a reason for the log, and lookup of handles; see
 * handles.h. */
#include "state/handles.h"

const char *thud_result_text(thud_result result) {
    switch (result) {
    case THUD_OK:
        return "no error";
    case THUD_ERROR_NULL:
        return "a pointer that must not be null is null";
    case THUD_ERROR_INVALID:
        return "a value is not finite or outside its range";
    case THUD_ERROR_STALE:
        return "a handle names nothing in this world";
    case THUD_ERROR_MEMORY:
        return "out of memory";
    case THUD_ERROR_LOCKED:
        return "not allowed inside a callback";
    }
    return "unknown result";
}

thud_result td_refuse(const thud_world *w, thud_result result, const char *message) {
    if (w && w->def.log) {
        w->def.log(result, message, w->def.log_context);
    }
    return result;
}

thud_result td_check(const thud_world *w, const char *name, double x, double low, double high) {
    td_reason why;
    return td_in(&why, name, x, low, high) ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, why.text);
}

thud_result td_check_above_0(const thud_world *w, const char *name, double x, double high) {
    td_reason why;
    return td_above_0(&why, name, x, high) ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, why.text);
}

thud_result td_check_finite(const thud_world *w, const char *name, float x, float y, float z) {
    td_reason why;
    return td_all_finite(&why, name, x, y, z) ? THUD_OK
                                              : td_refuse(w, THUD_ERROR_INVALID, why.text);
}

thud_result td_find_body(const thud_world *w, thud_body_id id, td_body_index *index) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (id.index1 == 0 || id.index1 > (uint32_t)w->bodies.count) {
        return td_refuse(w, THUD_ERROR_STALE, "this body handle was never made");
    }
    td_body_index named = {(int32_t)(id.index1 - 1)};
    const td_body *body = td_body_at(w, named);
    if (!(body->flags & TD_BODY_LIVE) || td_tag(w, body->generation) != id.generation) {
        return td_refuse(w, THUD_ERROR_STALE, "this body is destroyed, or of another world");
    }
    *index = named;
    return THUD_OK;
}

thud_result td_find_shape(const thud_world *w, thud_shape_id id, int *index) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (id.index1 == 0 || id.index1 > (uint32_t)w->shapes.count) {
        return td_refuse(w, THUD_ERROR_STALE, "this shape handle was never made");
    }
    const td_shape *shape = td_shape_at(w, (int)(id.index1 - 1));
    if (!(shape->flags & TD_SHAPE_LIVE) || td_tag(w, shape->generation) != id.generation) {
        return td_refuse(w, THUD_ERROR_STALE, "this shape is destroyed, or of another world");
    }
    *index = (int)(id.index1 - 1);
    return THUD_OK;
}
