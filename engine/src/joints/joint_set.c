/* joint_set.c: the calls that change joints; see thud_joint.h. */
#include "joints/joint.h"
#include "state/handles.h"

thud_result thud_joint_set_drive(thud_world *w, thud_joint_id id, thud_direction direction,
                                 const thud_drive *drive) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (!drive) {
        return td_refuse(w, THUD_ERROR_NULL, "joint set drive: drive is null");
    }
    td_joint *joint = td_joint_at(w, index);
    if ((int)direction < 0 || direction >= THUD_DIRECTION_COUNT ||
        !(td_joint_drivable(joint->kind) >> direction & 1u)) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "joint set drive: this kind of joint drives no such direction");
    }
    td_reason why;
    const char *error =
        td_joint_drive_error(w, (thud_joint_kind)joint->kind, (int)direction, drive, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (!td_joint_reserve(w, joint->kind)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "joint set drive: out of memory");
    }
    joint->drive[direction] = td_drive_of(drive);
    td_joint_update_parts(w, index);
    td_joint_warn_of_drive(w, drive);
    return THUD_OK;
}

thud_result thud_joint_set_length(thud_world *w, thud_joint_id id, float length) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    if (joint->kind != THUD_JOINT_DISTANCE) {
        return td_refuse(w, THUD_ERROR_INVALID, "joint set length: the joint is no distance");
    }
    result = td_check_above_0(w, "joint set length: length", (double)length,
                              (double)(THUD_JOINT_LENGTH_MAX * w->length_scale));
    if (result != THUD_OK) {
        return result;
    }
    joint->length = length;
    td_joint_wake(w, joint);
    return THUD_OK;
}

thud_result thud_joint_set_enabled(thud_world *w, thud_joint_id id, bool enabled) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    if (joint->disabled == !enabled) {
        return THUD_OK;
    }
    joint->disabled = !enabled;
    if (joint->kind == THUD_JOINT_GEAR) {
        joint->gear.apart = 1;
    }
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        int part = joint->part[i];
        if (!enabled && part != TD_NONE && td_constraint_at(w, part)->state == TD_TOUCHING) {
            td_lane_remove(w, part);
            td_constraint_wait(w, part);
        }
    }
    td_joint_wake(w, joint);
    return THUD_OK;
}

thud_result thud_joint_set_frame(thud_world *w, thud_joint_id id, int side,
                                 thud_joint_frame frame) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint *joint = td_joint_at(w, index);
    if (joint->kind >= THUD_JOINT_FILTER || side < 0 || side > 1) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "joint set frame: the joint has none, or side is neither 0 nor 1");
    }
    td_reason why;
    if (!td_joint_frame_valid(w, &why, &frame)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    td_joint_set_place(joint, side != (int)joint->swapped, &frame);
    td_joint_wake(w, joint);
    return THUD_OK;
}

thud_result thud_joint_set_user_data(thud_world *w, thud_joint_id id, uint64_t user_data) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result == THUD_OK) {
        td_joint_at(w, index)->user_data = user_data;
    }
    return result;
}
