/* places.c: the velocity at a point of a body, and points and vectors between the frames of body
 * and world; see thud_forces.h. */
#include "thud/thud_forces.h"

#include "state/body.h"
#include "state/handles.h"

#include <float.h>

/* Finds a body; refuses a null `out`. */
static thud_result find(const thud_world *w, thud_body_id id, const void *out,
                        td_body_index *index) {
    thud_result result = td_find_body(w, id, index);
    return result == THUD_OK && !out ? td_refuse(w, THUD_ERROR_NULL, "point of a body: out is null")
                                     : result;
}

/* As `find`; also refuses a point (x, y), in the world or in the body's frame, that is out of
 * range. */
static thud_result find_at(const thud_world *w, thud_body_id id, double x, double y,
                           const void *out, td_body_index *index) {
    thud_result result = find(w, id, out, index);
    return result != THUD_OK ? result : td_check_place(w, "point of a body: x or y of point", x, y);
}

thud_result thud_body_get_velocity_at(const thud_world *w, thud_body_id id, thud_pos point,
                                      thud_vec2 *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = find_at(w, id, point.x, point.y, out, &index);
    if (result != THUD_OK) {
        return result;
    }
    const float *velocity = td_body_velocity(w, td_body_at(w, index));
    const td_pose *pose = td_pose_at(w, index);
    td_position place = td_place_from(w, point);
    double x = (double)(place.x - pose->center.x) / w->to_fixed;
    double y = (double)(place.y - pose->center.y) / w->to_fixed;
    out->x = (float)((double)velocity[0] - (double)velocity[2] * y);
    out->y = (float)((double)velocity[1] + (double)velocity[2] * x);
    return THUD_OK;
}

/* Converts x to the nearest finite float. A rotation can make a component of a vector of the
 * greatest floats up to sqrt(2) times as large, which would be infinite. */
static float finite_float(double x) {
    return (float)td_min_double(td_max_double(x, (double)-FLT_MAX), (double)FLT_MAX);
}

/* (x, y) turned by the rotation of the pose (sign 1) or by its inverse (sign -1). */
static thud_vec2 rotated(const td_pose *pose, double x, double y, double sign) {
    double c = (double)pose->c, s = sign * (double)pose->s;
    return (thud_vec2){finite_float(c * x - s * y), finite_float(s * x + c * y)};
}

thud_result thud_body_get_world_point(const thud_world *w, thud_body_id id, thud_vec2 point,
                                      thud_pos *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = find_at(w, id, (double)point.x, (double)point.y, out, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_position at = td_body_origin(w, index);
    thud_vec2 arm = rotated(td_pose_at(w, index), (double)point.x, (double)point.y, 1.0);
    at.x += td_length_from(w, arm.x);
    at.y += td_length_from(w, arm.y);
    *out = td_place_to(w, at);
    return THUD_OK;
}

thud_result thud_body_get_local_point(const thud_world *w, thud_body_id id, thud_pos point,
                                      thud_vec2 *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = find_at(w, id, point.x, point.y, out, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_position origin = td_body_origin(w, index), at = td_place_from(w, point);
    *out = rotated(td_pose_at(w, index), (double)(at.x - origin.x) / w->to_fixed,
                   (double)(at.y - origin.y) / w->to_fixed, -1.0);
    return THUD_OK;
}

/* Turns a vector by the body's rotation (sign 1), or by its inverse (-1). */
static thud_result rotate_vector(const thud_world *w, thud_body_id id, thud_vec2 vector,
                                 double sign, thud_vec2 *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = find(w, id, out, &index);
    if (result != THUD_OK) {
        return result;
    }
    result = td_check_finite(w, "vector of a body: vector", vector.x, vector.y, 0.0f);
    if (result != THUD_OK) {
        return result;
    }
    *out = rotated(td_pose_at(w, index), (double)vector.x, (double)vector.y, sign);
    return THUD_OK;
}

thud_result thud_body_get_world_vector(const thud_world *w, thud_body_id id, thud_vec2 vector,
                                       thud_vec2 *out) {
    return rotate_vector(w, id, vector, 1.0, out);
}

thud_result thud_body_get_local_vector(const thud_world *w, thud_body_id id, thud_vec2 vector,
                                       thud_vec2 *out) {
    return rotate_vector(w, id, vector, -1.0, out);
}
