/* joint_state.c: finds joints by their handles, and reads them; see thud_joint.h. */
#include "joints/gear.h"
#include "state/handles.h"

/* Whether a slot holds a joint that a caller may see. A gear one of whose joints was destroyed is
 * itself destroyed when the next step begins, and already counts as destroyed. */
static bool slot_has_joint(const thud_world *w, int index) {
    const td_joint *joint = td_joint_at(w, index);
    return joint->live && (joint->kind != THUD_JOINT_GEAR || td_gear_has_joints(w, joint));
}

/* Whether a handle names a joint of this world. */
static bool names_joint(const thud_world *w, thud_joint_id id) {
    return id.index1 > 0 && id.index1 <= (uint32_t)w->joints.count &&
           slot_has_joint(w, (int)(id.index1 - 1)) &&
           td_tag(w, td_joint_at(w, (int)(id.index1 - 1))->generation) == id.generation;
}

thud_result td_find_joint(const thud_world *w, thud_joint_id id, bool edits, int *index) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (!names_joint(w, id)) {
        return td_refuse(w, THUD_ERROR_STALE, "this joint is destroyed, or of another world");
    }
    if (edits && w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "joint: not inside a callback");
    }
    *index = (int)(id.index1 - 1);
    return THUD_OK;
}

bool thud_joint_is_valid(const thud_world *w, thud_joint_id id) {
    return w && names_joint(w, id);
}

thud_result thud_joint_get_state(const thud_world *w, thud_joint_id id, thud_joint_state *out) {
    TD_IN_OWN_FLOAT_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, false, &index);
    if (result != THUD_OK || !out) {
        return result != THUD_OK ? result : td_refuse(w, THUD_ERROR_NULL, "joint get: out is null");
    }
    const td_joint *joint = td_joint_at(w, index);
    td_joint_reading r = td_joint_read(w, joint);
    td_joint_load load = td_joint_load_of(w, joint);
    /* body[0] is the caller's b where the sides are swapped (joint.h). */
    *out = (thud_joint_state){.kind = (thud_joint_kind)joint->kind,
                              .body_a = td_body_handle(w, joint->body[joint->swapped]),
                              .body_b = td_body_handle(w, joint->body[!joint->swapped]),
                              .enabled = !joint->disabled,
                              .value = {r.value[0], r.value[1], r.value[2]},
                              .gap = r.gap,
                              .angle_gap = r.angle_gap,
                              .force = load.force,
                              .torque = load.torque,
                              .user_data = joint->user_data};
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        out->drive[i] = td_joint_drive_forces(w, joint, i);
    }
    return THUD_OK;
}

/* ---- lists ---- */

thud_joint_id td_joint_handle(const thud_world *w, int index) {
    return (thud_joint_id){(uint32_t)index + 1, td_tag(w, td_joint_at(w, index)->generation)};
}

/* Counts the joint of a slot, if there is one, and writes its handle if the list has room. Returns
 * the number of joints so far, including those for which there was no room. */
static int append_handle(const thud_world *w, int index, thud_joint_id *out, int capacity,
                         int count) {
    if (!slot_has_joint(w, index)) {
        return count;
    }
    if (count < capacity && out) {
        out[count] = td_joint_handle(w, index);
    }
    return count + 1;
}

thud_result thud_world_get_joints(const thud_world *w, thud_joint_id *out, int capacity,
                                  int *out_count) {
    thud_result result = td_list_check(w, out, capacity, out_count);
    if (result != THUD_OK) {
        return result;
    }
    int count = 0;
    for (int i = 0; i < w->joints.count; i++) {
        count = append_handle(w, i, out, capacity, count);
    }
    *out_count = count;
    return THUD_OK;
}

/* The first part (constraint) of a joint. All parts of a joint, up to TD_JOINT_PARTS, are in the
 * edge lists of both its bodies (of a gear: of the dynamic bodies of its two joints), also while it
 * is disabled; counting only the first one lists each joint once. Elements of `part` that the joint
 * does not need are TD_NONE; at least one is in use. */
static int first_part(const td_joint *joint) {
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        if (joint->part[i] != TD_NONE) {
            return joint->part[i];
        }
    }
    return TD_NONE;
}

thud_result thud_body_get_joints(const thud_world *w, thud_body_id body, thud_joint_id *out,
                                 int capacity, int *out_count) {
    td_body_index index;
    thud_result result = td_list_check(w, out, capacity, out_count);
    result = result != THUD_OK ? result : td_find_body(w, body, &index);
    if (result != THUD_OK) {
        return result;
    }
    int count = 0;
    for (int e = td_body_at(w, index)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *part = td_constraint_at(w, td_edge_constraint(e));
        if (!td_is_contact(part) && first_part(td_joint_of(w, part)) == td_edge_constraint(e)) {
            count = append_handle(w, part->joint, out, capacity, count);
        }
    }
    *out_count = count;
    return THUD_OK;
}
