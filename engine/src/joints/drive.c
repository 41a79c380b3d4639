/* drive.c: the operations of the constraint kinds of driven directions: limits, springs, motors. */
#include "joints/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_line);
TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_axis);
TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_turn);

/* td_lane_ops.load: the impulse of the limit in a substep, divided by the mass of the lighter of
 * its two bodies: a speed. *off: by how much the limit is exceeded, a length. Impulses of springs
 * and motors do not count as load, since it is no error that a spring is displaced, or that a motor
 * whose force is too small misses its target speed. Angles are multiplied by `size` to become
 * lengths. */
static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = &block->point[0];
    bool turns = td_constraint_at(w, block->constraint[lane])->kind == TD_CONSTRAINT_DRIVE_TURN;
    float mass = td_joint_max_inverse_mass(w, block, lane);
    float turn = td_max_float(block->inv_inertia_a[lane], block->inv_inertia_b[lane]);
    float beyond = td_max_float(-p->separation[lane], 0.0f);
    float impulse = td_joint_abs(p->normal_impulse[lane]);
    *off = turns ? beyond * size : beyond;
    return impulse * (turns ? turn * size : mass);
}

/* td_lane_ops.count: a drive adds nothing to the residual: springs and motors may miss a target
 * speed by any amount, and limits are measured by their gaps. */
static void count(thud_world *w, const td_block *block) {
    (void)w, (void)block;
}

TD_DEFINE_JOINT_LANES(td_drive_take_rows, td_drive_update_rows)
TD_DEFINE_JOINT_OPS(line, TD_FORM_DRIVE, td_place_joints, td_solve_drive_line)
TD_DEFINE_JOINT_OPS(axis, TD_FORM_DRIVE, td_place_joints, td_solve_drive_axis)
TD_DEFINE_JOINT_OPS(turn, TD_FORM_DRIVE, td_place_joints, td_solve_drive_turn)

const td_constraint_ops *td_drive_ops(const thud_world *w, int kind) {
    (void)w;
    return kind == TD_CONSTRAINT_DRIVE_LINE   ? &TD_PICK_WIDE(w, line)
           : kind == TD_CONSTRAINT_DRIVE_AXIS ? &TD_PICK_WIDE(w, axis)
                                              : &TD_PICK_WIDE(w, turn);
}
