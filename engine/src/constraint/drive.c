/* drive.c: the lanes of what drives joints. */
#include "constraint/joint.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_line);
TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_axis);
TD_DECLARE_WIDE(const td_solve_ops, td_solve_drive_turn);

/* The direction of the part that drives it. */
static int direction_of(const td_joint *joint, int constraint) {
    int direction = 0;
    while (joint->part[direction] != constraint) {
        direction++;
    }
    return direction;
}

/* The nearer limit; impulses of the other one mean nothing to it. */
static void set_limit(td_block *block, int lane, const td_drive *d, float value) {
    td_drive_rows *rows = td_drive_rows_of(block);
    td_point *p = &block->point[0];
    bool lower = value - d->lower <= d->upper - value;
    float side = !d->limited ? 0.0f : lower ? 1.0f : -1.0f;
    p->normal_impulse[lane] = side == rows->limit_side[lane] ? p->normal_impulse[lane] : 0.0f;
    rows->limit_side[lane] = side;
    rows->limit[lane] = lower ? d->lower : d->upper;
    rows->locked[lane] = d->limited && d->lower == d->upper ? 1.0f : 0.0f;
    p->base[lane] = p->separation[lane] = side * (value - rows->limit[lane]);
}

static void set_drive(td_block *block, int lane, const td_drive *d, float value) {
    td_drive_rows *rows = td_drive_rows_of(block);
    td_point *q = &block->point[1];
    set_limit(block, lane, d, value);
    rows->value_base[lane] = value;
    rows->target[lane] = d->target;
    rows->frequency[lane] = d->frequency;
    rows->damping[lane] = d->damping;
    rows->spring_most[lane] = d->spring_force;
    rows->motor_speed[lane] = d->motor_speed;
    rows->motor_most[lane] = d->motor_force;
    q->base[lane] = q->separation[lane] = d->frequency > 0.0f ? value - d->target : 0.0f;
    q->normal_impulse[lane] = d->frequency > 0.0f ? q->normal_impulse[lane] : 0.0f;
    block->tangent_impulse[lane] = d->motor_force > 0.0f ? block->tangent_impulse[lane] : 0.0f;
}

static void prepare_lane(const thud_world *w, td_block *block, int lane) {
    int index = block->constraint[lane], kind = td_constraint_at(w, index)->kind;
    const td_joint *joint = td_joint_of(w, td_constraint_at(w, index));
    td_joint_place place = td_joint_place_of(w, joint);
    td_drive_rows *rows = td_drive_rows_of(block);
    int direction = direction_of(joint, index);
    float x = place.axis_x, y = place.axis_y, value = place.turn;
    if (direction == THUD_ACROSS) {
        x = -place.axis_y;
        y = place.axis_x;
    }
    if (kind == TD_CONSTRAINT_DRIVE_LINE) {
        value = __builtin_sqrtf(place.x * place.x + place.y * place.y);
        x = value > 0.0f ? place.x / value : 0.0f;
        y = value > 0.0f ? place.y / value : 1.0f;
    }
    td_joint_set_frame(block, lane, &place, x, y);
    rows->gap_u[lane] = place.x * x + place.y * y;
    rows->gap_v[lane] = place.y * x - place.x * y;
    rows->turn_sign[lane] = place.turn_sign;
    if (kind == TD_CONSTRAINT_DRIVE_AXIS) {
        value = rows->gap_u[lane];
    }
    set_drive(block, lane, &joint->drive[direction], value);
}

static void prepare(thud_world *w, td_block *const *blocks, int count,
                    const td_collide_context *context) {
    (void)context;
    td_joint_prepare(w, blocks, count, prepare_lane);
}

/* Springs and motors give way as they should; limits should not. */
static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = &block->point[0];
    bool turns = td_constraint_at(w, block->constraint[lane])->kind == TD_CONSTRAINT_DRIVE_TURN;
    float mass = td_joint_lighter(w, block, lane);
    float turn = td_max_float(block->inv_inertia_a[lane], block->inv_inertia_b[lane]);
    float beyond = td_max_float(-p->separation[lane], 0.0f);
    float impulse = td_joint_size(p->normal_impulse[lane]);
    *off = turns ? beyond * size : beyond;
    return impulse * (turns ? turn * size : mass);
}

/* Nothing of it is in the residual: springs and motors give way as they should, and limits are
 * judged by their gaps. */
static void count(thud_world *w, const td_block *block) {
    (void)w, (void)block;
}

static const td_lane_ops lanes = {.fill = td_joint_fill,
                                  .clear = td_joint_let_be,
                                  .renew = td_joint_let_be,
                                  .count = count,
                                  .load = load,
                                  .take_rows = td_drive_take_rows,
                                  .turn_rows = td_drive_turn_rows};

#define DRIVE_OPS(way, isa) \
    TD_JOINT_OPS(TD_FORM_DRIVE, lanes, prepare, td_solve_drive_##way##_##isa)

const td_constraint_ops *td_drive_ops(const thud_world *w, int kind) {
    static const td_constraint_ops base[] = {DRIVE_OPS(line, base), DRIVE_OPS(axis, base),
                                             DRIVE_OPS(turn, base)};
#if defined(TD_HAS_AVX2)
    static const td_constraint_ops avx2[] = {DRIVE_OPS(line, avx2), DRIVE_OPS(axis, avx2),
                                             DRIVE_OPS(turn, avx2)};
    return (w->wide ? avx2 : base) + (kind - TD_CONSTRAINT_DRIVE_LINE);
#else
    (void)w;
    return base + (kind - TD_CONSTRAINT_DRIVE_LINE);
#endif
}
