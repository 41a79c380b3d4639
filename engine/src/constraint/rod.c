/* rod.c: the lanes of distances that are locked. */
#include "constraint/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_rod);

static void prepare_lane(const thud_world *w, td_block *block, int lane) {
    const td_joint *joint = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
    td_joint_place place = td_joint_place_of(w, joint);
    td_point *p = &block->point[0];
    float length = __builtin_sqrtf(place.x * place.x + place.y * place.y);
    /* Where both ends meet any direction will do. */
    float x = length > 0.0f ? place.x / length : 0.0f, y = length > 0.0f ? place.y / length : 1.0f;
    td_joint_set_frame(block, lane, &place, x, y);
    float k = td_joint_inverse_mass(w, block, lane, 1.0f, p->cross_a[lane], p->cross_b[lane]);
    p->normal_mass[lane] = k > 0.0f ? 1.0f / k : 0.0f;
    p->base[lane] = p->separation[lane] = length - joint->length;
    td_hold_rows_of(block)->turn_base[lane] = joint->length;
}

static void prepare(thud_world *w, td_block *const *blocks, int count,
                    const td_collide_context *context) {
    (void)context;
    td_joint_prepare(w, blocks, count, prepare_lane);
}

static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = &block->point[0];
    float mass = td_joint_lighter(w, block, lane);
    (void)size;
    *off = td_joint_size(p->separation[lane]);
    return td_joint_size(p->normal_impulse[lane]) * mass;
}

static void count(thud_world *w, const td_block *block) {
    const td_point *p = &block->point[0];
    for (int lane = 0; lane < block->used; lane++) {
        double a[3], b[3];
        double length = (double)(p->base[lane] + td_hold_rows_at(block)->turn_base[lane]);
        td_joint_motion(w, block, lane, a, b);
        td_joint_frame f = td_joint_line_after(block, lane, length, 0.0, a, b);
        float speed = td_joint_speed(w, block, lane, f.x, f.y, f.a_u, f.b_u);
        w->errors.residual = td_max_float(td_joint_size(speed), w->errors.residual);
    }
}

static const td_lane_ops lanes = {.fill = td_joint_fill,
                                  .clear = td_joint_let_be,
                                  .renew = td_joint_let_be,
                                  .count = count,
                                  .load = load,
                                  .take_rows = td_rod_take_rows,
                                  .turn_rows = td_rod_turn_rows};

const td_constraint_ops *td_rod_ops(const thud_world *w) {
    static const td_constraint_ops base =
        TD_JOINT_OPS(TD_FORM_HOLD, lanes, prepare, td_solve_rod_base);
#if defined(TD_HAS_AVX2)
    static const td_constraint_ops avx2 =
        TD_JOINT_OPS(TD_FORM_HOLD, lanes, prepare, td_solve_rod_avx2);
    return w->wide ? &avx2 : &base;
#else
    (void)w;
    return &base;
#endif
}
