/* locks.c: locks of a body's x or y (thud_locks.h). A lock is a joint between the body's centre of
 * mass and an anchor, a static body without shapes (TD_BODY_ANCHOR): a hinge locks x and y, a wheel
 * without a spring locks one of them and leaves the other and the rotation free. Anchors are shared
 * by the locks of bodies near them. */
#include "thud/thud_locks.h"

#include "constraint/joint_hooks.h"
#include "edits/edit.h"
#include "joints/joint.h"
#include "state/body.h"
#include "state/handles.h"

/* Largest distance along x or y of a body from its anchor, length scales. Joint frames are in
 * single precision (24 bits), so that the locked place is rounded to 1024 / 2^24 = 6e-5 length
 * scales at most. Chosen: with half of it worlds have more anchors; with twice as much the rounding
 * error doubles. */
#define ANCHOR_DISTANCE_MAX 1024.0

/* The joint that locks a body, or TD_NONE. */
static int lock_of(const thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *part = td_constraint_at(w, td_edge_constraint(e));
        if (!td_is_contact(part) && td_joint_is_lock(w, td_joint_of(w, part), body)) {
            return part->joint;
        }
    }
    return TD_NONE;
}

/* The body index of an anchor near a place, or TD_NONE. */
static int find_anchor(const thud_world *w, td_position near) {
    double max = ANCHOR_DISTANCE_MAX * (double)w->length_scale * w->to_fixed;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        const td_position *at = &td_pose_at(w, i)->center;
        int flags = td_body_at(w, i)->flags, required = TD_BODY_LIVE | TD_BODY_ANCHOR;
        if ((flags & required) == required && td_abs((double)(at->x - near.x)) <= max &&
            td_abs((double)(at->y - near.y)) <= max) {
            return i.at;
        }
    }
    return TD_NONE;
}

/* Creates an anchor exactly at `near`. Its centre is set in fixed point afterwards, since the
 * double-precision position of a def loses low bits far from the origin. */
static thud_result make_anchor(thud_world *w, td_position near, thud_body_id *id) {
    thud_body_def def = thud_default_body_def();
    def.position = td_place_to(w, near);
    thud_result result = thud_body_create(w, &def, id);
    if (result == THUD_OK) {
        td_body_index index = {(int32_t)id->index1 - 1};
        td_body_at(w, index)->flags |= TD_BODY_ANCHOR;
        td_pose_at(w, index)->center = near;
    }
    return result;
}

/* Sets *x and *y to whether a lock (a joint, or TD_NONE) locks these axes. A wheel leaves the axis
 * of its frame free. */
static void read_locks(const thud_world *w, int lock, bool *x, bool *y) {
    const td_joint *joint = lock == TD_NONE ? NULL : td_joint_at(w, lock);
    bool both = joint && joint->kind == THUD_JOINT_HINGE;
    *x = joint && (both || td_abs((double)joint->axis_s) > 0.5);
    *y = joint && (both || !*x);
}

/* Makes the lock of x, y or both, in place of the one that the body has. Room for the joint is
 * reserved before the anchor is made. */
static thud_result make_lock(thud_world *w, td_body_index index, bool x, bool y) {
    thud_joint_def def = thud_default_joint_def(x && y ? THUD_JOINT_HINGE : THUD_JOINT_WHEEL);
    if (!td_slots_reserve(&w->memory, &w->joints, 1) || !td_joint_reserve(w, (int)def.kind)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "set locks: out of memory");
    }
    td_position near = td_body_origin(w, index);
    int anchor = find_anchor(w, near);
    thud_result result = THUD_OK;
    if (anchor == TD_NONE) {
        result = make_anchor(w, near, &def.body_a);
    } else {
        def.body_a = td_body_handle(w, (td_body_index){anchor});
    }
    def.body_b = td_body_handle(w, index);
    def.frame_a.angle =
        x ? TD_PI / 2
          : 0.0; /* the axis along which a wheel lets the body move: y if x is locked, else x */
    def.collide_connected = true;
    int old = lock_of(w, index);
    result = result == THUD_OK ? thud_joint_create(w, &def, NULL) : result;
    if (result == THUD_OK && old != TD_NONE) {
        td_joint_end(w, old);
    }
    if (result == THUD_OK) {
        td_joints_move_locks(w, index);
    }
    return result;
}

thud_result thud_body_set_locks(thud_world *w, thud_body_id id, bool x, bool y) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index index;
    thud_result result = td_edit_body(w, id, &index);
    if (result != THUD_OK) {
        return result;
    }
    if (td_body_at(w, index)->kind != THUD_BODY_DYNAMIC) {
        return td_refuse(w, THUD_ERROR_INVALID, "set locks: the body is not dynamic");
    }
    int lock = lock_of(w, index);
    bool has_x, has_y;
    read_locks(w, lock, &has_x, &has_y);
    if (x == has_x && y == has_y) {
        return THUD_OK;
    }
    if (x || y) {
        return make_lock(w, index, x, y);
    }
    td_joint_end(w, lock);
    return THUD_OK;
}

thud_result thud_body_get_locks(const thud_world *w, thud_body_id id, bool *out_x, bool *out_y) {
    td_body_index index;
    thud_result result = td_find_body(w, id, &index);
    if (result == THUD_OK) {
        bool has_x, has_y;
        read_locks(w, lock_of(w, index), &has_x, &has_y);
        if (out_x) {
            *out_x = has_x;
        }
        if (out_y) {
            *out_y = has_y;
        }
    }
    return result;
}
