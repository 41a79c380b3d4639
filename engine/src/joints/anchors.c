/* anchors.c: copies anchors and settings of a joint from its td_joint to its lanes. The copies are
 * valid until the joint or a body's centre of mass changes, which sets td_block.anchors_stale: then
 * td_joint_update_anchors copies all lanes of the block again. */
#include "joints/joint.h"

void td_joint_fill_lane(thud_world *w, td_block *block, int lane, int index) {
    (void)w, (void)index;
    block->shape_a[lane] = block->shape_b[lane] = TD_NONE;
    block->anchors_stale = 1;
}

void td_joint_renew_lane(thud_world *w, td_block *block, int lane, int index) {
    (void)w, (void)lane, (void)index;
    block->anchors_stale = 1;
}

void td_joint_clear_lane(thud_world *w, td_block *block, int lane, int index) {
    (void)w, (void)block, (void)lane, (void)index;
}

/* Anchors and axis of a lane, relative to the bodies' centres of mass, in the bodies' frames. */
static void set_anchors(const thud_world *w, const td_joint *joint, td_anchor_rows *rows,
                        int lane) {
    const td_body *a = td_body_at(w, joint->body[0]), *b = td_body_at(w, joint->body[1]);
    rows->body_a[lane] = joint->body[0].at;
    rows->body_b[lane] = joint->body[1].at;
    rows->a_x[lane] = joint->anchor[0][0] - a->center_x;
    rows->a_y[lane] = joint->anchor[0][1] - a->center_y;
    rows->b_x[lane] = joint->anchor[1][0] - b->center_x;
    rows->b_y[lane] = joint->anchor[1][1] - b->center_y;
    rows->axis_c[lane] = joint->axis_c;
    rows->axis_s[lane] = joint->axis_s;
    rows->turn[lane] = (int32_t)joint->turn;
}

/* The factor by which the coordinate of turn is multiplied: -1 where the joint's sides are swapped,
 * so that the coordinates are those of the caller's order of bodies (joint.h); else 1. */
static float sign_of(const td_joint *joint) {
    return joint->swapped ? -1.0f : 1.0f;
}

/* Sets a lane of locked directions. rows->frame_turns is 0 where both along and across are locked:
 * the frame then has the world's axes. So the impulse of a joint that carries a weight has the same
 * components in each step even if its bodies turn, and the impulse of the last step is a good first
 * guess (warm start) for this one. */
static void set_lock(const thud_world *w, td_block *block, int lane, const td_joint *joint) {
    td_lock_rows *rows = td_lock_rows_of(block);
    float sign = sign_of(joint);
    set_anchors(w, joint, &rows->anchor, lane);
    rows->locked[lane] = joint->locked;
    rows->frame_turns[lane] = (joint->locked & 3u) != 3u ? 1.0f : 0.0f;
    rows->turn_sign[lane] = sign;
    block->tangent_cross_a[lane] = block->tangent_cross_b[lane] =
        joint->locked >> THUD_DIRECTION_TURN & 1u ? sign : 0.0f;
}

/* Sets a lane of a locked distance. */
static void set_rod(const thud_world *w, td_block *block, int lane, const td_joint *joint) {
    td_lock_rows *rows = td_lock_rows_of(block);
    set_anchors(w, joint, &rows->anchor, lane);
    rows->rest_length[lane] = joint->length;
}

/* The direction (thud_direction) that this constraint drives. */
static int direction_of(const td_joint *joint, int constraint) {
    int direction = 0;
    while (joint->part[direction] != constraint) {
        direction++;
    }
    return direction;
}

/* Sets a lane of a driven direction. */
static void set_drive(const thud_world *w, td_block *block, int lane, const td_joint *joint) {
    td_drive_rows *rows = td_drive_rows_of(block);
    int direction = direction_of(joint, block->constraint[lane]);
    const td_drive *d = &joint->drive[direction];
    set_anchors(w, joint, &rows->anchor, lane);
    rows->across[lane] = direction == THUD_DIRECTION_ACROSS ? -1 : 0;
    rows->turn_sign[lane] = sign_of(joint);
    rows->limited[lane] = d->limited ? -1 : 0;
    rows->lower[lane] = d->lower;
    rows->upper[lane] = d->upper;
    rows->locked[lane] = d->limited && d->lower == d->upper ? 1.0f : 0.0f;
    rows->target[lane] = td_joint_target(joint, direction);
    rows->frequency[lane] = d->frequency;
    rows->damping[lane] = d->damping;
    rows->max_spring_force[lane] = d->spring_force;
    rows->motor_speed[lane] = d->motor_speed;
    rows->max_motor_force[lane] = d->motor_force;
}

void td_joint_update_anchors(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        const td_constraint *constraint = td_constraint_at(w, block->constraint[lane]);
        const td_joint *joint = td_joint_of(w, constraint);
        (constraint->kind == TD_CONSTRAINT_LOCK  ? set_lock
         : constraint->kind == TD_CONSTRAINT_ROD ? set_rod
                                                 : set_drive)(w, block, lane, joint);
    }
    block->anchors_stale = 0;
}
