/* joint_end.c: destroys joints, and wakes their bodies. */
#include "joints/joint.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

void td_joint_wake(thud_world *w, const td_joint *joint) {
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        int part = joint->part[i];
        if (part != TD_NONE && td_constraint_at(w, part)->state == TD_TOUCHING) {
            td_lane_renew(w, part);
        }
    }
    td_body_mark(w, joint->body[0], TD_CHANGE_WAKE);
    td_body_mark(w, joint->body[1], TD_CHANGE_WAKE);
}

/* Makes the broadphase query the shapes of both bodies again, since the contacts between them,
 * which the joint excluded, become possible. */
static void mark_shapes_moved(thud_world *w, const td_joint *joint) {
    for (int side = 0; side < 2 && !joint->collides; side++) {
        int i = td_body_at(w, joint->body[side])->first_shape;
        for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
            td_shape_mark_moved(w, i);
            *td_marks_at(w, i) |= TD_MARK_WOKEN;
        }
    }
}

void td_joint_end(thud_world *w, int index) {
    td_joint *joint = td_joint_at(w, index);
    int part[TD_JOINT_PARTS];
    __builtin_memcpy(part, joint->part, sizeof part);
    td_joint_wake(w, joint);
    mark_shapes_moved(w, joint);
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        if (part[i] != TD_NONE) {
            td_constraint_destroy(w, part[i]);
        }
    }
}

thud_result thud_joint_destroy(thud_world *w, thud_joint_id id) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_joint_end(w, index);
    return THUD_OK;
}
