/* rod.c: the operations of the constraint kind of locked distances. */
#include "joints/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_rod);

/* td_lane_ops.load: the impulse of a substep, divided by the mass of the lighter of the rod's two
 * bodies: a speed. *off: the gap, a length. */
static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = &block->point[0];
    float mass = td_joint_max_inverse_mass(w, block, lane);
    (void)size;
    *off = td_joint_abs(p->separation[lane]);
    return td_joint_abs(p->normal_impulse[lane]) * mass;
}

/* td_lane_ops.count: the residual is the speed along the line between the anchors. */
static void count(thud_world *w, const td_block *block) {
    const td_point *p = &block->point[0];
    for (int lane = 0; lane < block->used; lane++) {
        double a[3], b[3];
        double length =
            (double)(p->start_separation[lane] + td_lock_rows_at(block)->rest_length[lane]);
        td_joint_motion(w, block, lane, a, b);
        td_joint_frame f = td_joint_line_after(block, lane, length, 0.0, a, b);
        float speed = td_joint_speed(w, block, lane, f.x, f.y, f.a_u, f.b_u);
        w->errors.residual = td_max_float(td_joint_abs(speed), w->errors.residual);
    }
}

TD_DEFINE_JOINT_LANES(td_rod_take_rows, td_rod_update_rows)
TD_DEFINE_JOINT_OPS(ops, TD_FORM_LOCK, td_place_joints, td_solve_rod)

const td_constraint_ops *td_rod_ops(const thud_world *w) {
    (void)w;
    return &TD_PICK_WIDE(w, ops);
}
