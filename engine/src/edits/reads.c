/* reads.c: getters of single values of bodies and shapes, and of the settings that steps use; see
 * thud_reads.h. */
#include "thud/thud_reads.h"

#include "base/rotation.h"
#include "state/body.h"
#include "state/handles.h"

thud_result thud_body_get_position(const thud_world *w, thud_body_id id, thud_pos *out_position) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result == THUD_OK && out_position) {
        *out_position = td_place_to(w, td_body_origin(w, index));
    }
    return result;
}

thud_result thud_body_get_rotation(const thud_world *w, thud_body_id id, double *out_angle,
                                   float *out_cosine, float *out_sine) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_pose *pose = td_pose_at(w, index);
    if (out_angle) {
        *out_angle = td_angle_radians(pose->angle);
    }
    if (out_cosine) {
        *out_cosine = pose->c;
    }
    if (out_sine) {
        *out_sine = pose->s;
    }
    return THUD_OK;
}

thud_result thud_body_get_velocity(const thud_world *w, thud_body_id id, thud_vec2 *out_velocity,
                                   float *out_angular_velocity) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    const float *now = td_body_velocity(w, td_body_at(w, index));
    if (out_velocity) {
        *out_velocity = (thud_vec2){now[0], now[1]};
    }
    if (out_angular_velocity) {
        *out_angular_velocity = now[2];
    }
    return THUD_OK;
}

thud_result thud_body_get_user_data(const thud_world *w, thud_body_id id, uint64_t *out_user_data) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result == THUD_OK && out_user_data) {
        *out_user_data = td_body_at(w, index)->user_data;
    }
    return result;
}

thud_result thud_shape_get_user_data(const thud_world *w, thud_shape_id id,
                                     uint64_t *out_user_data) {
    int index = 0;
    thud_result result = td_find_shape(w, id, &index);
    if (result == THUD_OK && out_user_data) {
        *out_user_data = td_shape_at(w, index)->user_data;
    }
    return result;
}

thud_result thud_shape_get_body(const thud_world *w, thud_shape_id id, thud_body_id *out_body) {
    int index = 0;
    thud_result result = td_find_shape(w, id, &index);
    if (result == THUD_OK && out_body) {
        *out_body = td_body_handle(w, td_shape_at(w, index)->body);
    }
    return result;
}

thud_result thud_world_get_step_settings(const thud_world *w, thud_step_settings *out) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (out) {
        *out = (thud_step_settings){.gravity = w->def.gravity,
                                    .time_step = w->def.time_step,
                                    .max_error = w->def.max_error,
                                    .substeps = w->substeps,
                                    .sleeping = w->def.sleeping,
                                    .quality = w->quality};
    }
    return THUD_OK;
}
