/* lock.c: the operations of the constraint kind of locked directions. */
#include "joints/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_lock);

/* td_lane_ops.load: the impulses of a substep, divided by the mass of the lighter of the joint's
 * two bodies: a speed. *off: the gap, a length. Angles are multiplied by `size` to become lengths.
 */
static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = block->point;
    const td_lock_rows *rows = td_lock_rows_at(block);
    float turn = td_max_float(block->inv_inertia_a[lane], block->inv_inertia_b[lane]);
    float linear =
        td_joint_abs(p[0].normal_impulse[lane]) + td_joint_abs(p[1].normal_impulse[lane]);
    float gap = td_joint_abs(p[0].separation[lane]) + td_joint_abs(p[1].separation[lane]);
    float apart =
        block->tangent_mass[lane] > 0.0f ? td_joint_abs(rows->turn_gap[lane]) * size : 0.0f;
    *off = td_max_float(gap, apart);
    return linear * td_joint_max_inverse_mass(w, block, lane) +
           td_joint_abs(block->tangent_impulse[lane]) * turn * size;
}

/* td_lane_ops.count: the residual of a locked direction is its speed, in lengths/s; turn is not
 * counted, nor are lanes of islands that were solved before the soft solver
 * (td_islands.trees_residual). */
static void count(thud_world *w, const td_block *block) {
    uint32_t counted_already = w->islands.passes_over ? block->solved : 0;
    const td_lock_rows *rows = td_lock_rows_at(block);
    const td_point *p = block->point;
    for (int lane = 0; lane < block->used; lane++) {
        if (counted_already >> lane & 1u) {
            continue;
        }
        double a[3], b[3], sign = (double)rows->turn_sign[lane];
        td_joint_motion(w, block, lane, a, b);
        td_joint_frame f = td_joint_frame_after(block, lane, (double)p[0].start_separation[lane],
                                                (double)p[1].start_separation[lane],
                                                rows->frame_turns[lane] > 0.0f, a, b);
        float missed[] = {td_joint_speed(w, block, lane, f.x, f.y, f.a_u, f.b_u),
                          td_joint_speed(w, block, lane, -f.y, f.x, f.a_v, f.b_v),
                          td_joint_speed(w, block, lane, 0.0, 0.0, sign, sign)};
        bool locked[] = {p[0].normal_mass[lane] > 0.0f, p[1].normal_mass[lane] > 0.0f, false};
        for (int k = 0; k < 3; k++) {
            float speed = locked[k] ? td_joint_abs(missed[k]) : 0.0f;
            w->errors.residual = td_max_float(speed, w->errors.residual);
        }
    }
}

TD_DEFINE_JOINT_LANES(td_lock_take_rows, td_lock_update_rows)
TD_DEFINE_JOINT_OPS(ops, TD_FORM_LOCK, td_place_joints, td_solve_lock)

const td_constraint_ops *td_lock_ops(const thud_world *w) {
    (void)w;
    return &TD_PICK_WIDE(w, ops);
}
