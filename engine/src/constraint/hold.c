/* hold.c: the lanes of what joints lock. */
#include "constraint/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_hold);

static float inverse_or_zero(float x) {
    return x > 0.0f ? 1.0f / x : 0.0f;
}

static void prepare_lane(const thud_world *w, td_block *block, int lane) {
    const td_joint *joint = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
    td_joint_place place = td_joint_place_of(w, joint);
    td_hold_rows *rows = td_hold_rows_of(block);
    unsigned locked = td_joint_locked(joint);
    /* What holds both ways stays in the world's axes, so that impulses that carry a weight go on
     * doing so. */
    bool turns = (locked & 3u) != 3u;
    float x = turns ? place.axis_x : 1.0f, y = turns ? place.axis_y : 0.0f;
    td_joint_set_frame(block, lane, &place, x, y);
    float gap[2] = {place.x * x + place.y * y, place.y * x - place.x * y};
    for (int k = 0; k < 2; k++) {
        td_point *p = &block->point[k];
        bool holds = locked >> k & 1u;
        float k_inverse =
            td_joint_inverse_mass(w, block, lane, 1.0f, p->cross_a[lane], p->cross_b[lane]);
        p->base[lane] = gap[k];
        p->separation[lane] = holds ? gap[k] : 0.0f;
        p->normal_mass[lane] = holds ? inverse_or_zero(k_inverse) : 0.0f;
        p->normal_impulse[lane] = holds ? p->normal_impulse[lane] : 0.0f;
    }
    bool holds = locked >> THUD_TURN & 1u;
    rows->frame[lane] = turns ? 1.0f : 0.0f;
    rows->turn_sign[lane] = place.turn_sign;
    rows->turn_base[lane] = rows->turn_apart[lane] = place.turn;
    float k_inverse = td_joint_inverse_mass(w, block, lane, 0.0f, place.turn_sign, place.turn_sign);
    block->tangent_mass[lane] = holds ? inverse_or_zero(k_inverse) : 0.0f;
    block->tangent_cross_a[lane] = block->tangent_cross_b[lane] = holds ? place.turn_sign : 0.0f;
    block->tangent_impulse[lane] = holds ? block->tangent_impulse[lane] : 0.0f;
}

static void prepare(thud_world *w, td_block *const *blocks, int count,
                    const td_collide_context *context) {
    (void)context;
    td_joint_prepare(w, blocks, count, prepare_lane);
}

static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = block->point;
    const td_hold_rows *rows = td_hold_rows_at(block);
    float turn = td_max_float(block->inv_inertia_a[lane], block->inv_inertia_b[lane]);
    float linear =
        td_joint_size(p[0].normal_impulse[lane]) + td_joint_size(p[1].normal_impulse[lane]);
    float gap = td_joint_size(p[0].separation[lane]) + td_joint_size(p[1].separation[lane]);
    float apart =
        block->tangent_mass[lane] > 0.0f ? td_joint_size(rows->turn_apart[lane]) * size : 0.0f;
    *off = td_max_float(gap, apart);
    return linear * td_joint_lighter(w, block, lane) +
           td_joint_size(block->tangent_impulse[lane]) * turn * size;
}

/* What is locked misses what it wants by its speed, either way. */
static void count(thud_world *w, const td_block *block) {
    const td_hold_rows *rows = td_hold_rows_at(block);
    const td_point *p = block->point;
    for (int lane = 0; lane < block->used; lane++) {
        double a[3], b[3], sign = (double)rows->turn_sign[lane];
        td_joint_motion(w, block, lane, a, b);
        td_joint_frame f =
            td_joint_frame_after(block, lane, (double)p[0].base[lane], (double)p[1].base[lane],
                                 rows->frame[lane] > 0.0f, a, b);
        float missed[] = {td_joint_speed(w, block, lane, f.x, f.y, f.a_u, f.b_u),
                          td_joint_speed(w, block, lane, -f.y, f.x, f.a_v, f.b_v),
                          td_joint_speed(w, block, lane, 0.0, 0.0, sign, sign)};
        bool locked[] = {p[0].normal_mass[lane] > 0.0f, p[1].normal_mass[lane] > 0.0f, false};
        for (int k = 0; k < 3; k++) {
            float speed = locked[k] ? td_joint_size(missed[k]) : 0.0f;
            w->errors.residual = td_max_float(speed, w->errors.residual);
        }
    }
}

static const td_lane_ops lanes = {.fill = td_joint_fill,
                                  .clear = td_joint_let_be,
                                  .renew = td_joint_let_be,
                                  .count = count,
                                  .load = load,
                                  .take_rows = td_hold_take_rows,
                                  .turn_rows = td_hold_turn_rows};

const td_constraint_ops *td_hold_ops(const thud_world *w) {
    static const td_constraint_ops base =
        TD_JOINT_OPS(TD_FORM_HOLD, lanes, prepare, td_solve_hold_base);
#if defined(TD_HAS_AVX2)
    static const td_constraint_ops avx2 =
        TD_JOINT_OPS(TD_FORM_HOLD, lanes, prepare, td_solve_hold_avx2);
    return w->wide ? &avx2 : &base;
#else
    (void)w;
    return &base;
#endif
}
