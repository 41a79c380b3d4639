/* wide_place.c: computes the rows of eight joints at the start of a step: frames, cross products of
 * lever arms, gaps and effective masses from the present poses. td_joint_place_of (joint.c)
 * computes the geometry of one joint by the same operations, so that both give the same bits. */
#include "joints/joint.h"
#include "joints/wide_joint.h"

#include "base/rotation.h"

#include <stddef.h>

/* Eight td_joint_place. */
typedef struct place8 {
    f8 ax, ay, bx, by; /* lever arms of a and b */
    f8 x, y;           /* from a's anchor to b's */
    /* turn: the bits of an int32, a relative angle of which 2^32 is a full turn; the axis is the
     * direction `along`. */
    f8 turn, axis_x, axis_y;
} place8;

/* Converts 64-bit integers to the nearest doubles: the halves of each become the mantissas of
 * doubles with exponents of 2^84 and 2^52, whose sum, less those powers, is the value. */
TD_INLINE d4 doubles_of(l4 x) {
    l4 upper = (l4)((v4)x >> 32) ^ 0x4530000080000000;
    l4 lower = (x & 0xffffffffll) | 0x4330000000000000;
    return ((d4)upper - (0x1p84 + 0x1p63 + 0x1p52)) + (d4)lower;
}

/* From a's centre of mass to b's, in lanes i and i + 4: x, y, x, y. */
TD_INLINE f4 centre_offset(const td_pose *const *a, const td_pose *const *b, int i,
                           double to_fixed) {
    int j = i + 4;
    l4 apart = {b[i]->center.x - a[i]->center.x, b[i]->center.y - a[i]->center.y,
                b[j]->center.x - a[j]->center.x, b[j]->center.y - a[j]->center.y};
    return __builtin_convertvector(doubles_of(apart) / to_fixed, f4);
}

/* Rotations of eight poses: x angle (bits of an int32), y cosine, z sine. */
TD_INLINE td_rows rotations_of(const td_pose *const *pose) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)((const char *)pose[i] + offsetof(td_pose, angle));
    }
    return td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                        f8_two(r[3], r[7]));
}

/* td_angle_radians of eight angles: radians in (-pi, pi]. */
TD_INLINE f8 radians_of(i8 angle) {
    i4 low = __builtin_shufflevector(angle, angle, 0, 1, 2, 3);
    i4 high = __builtin_shufflevector(angle, angle, 4, 5, 6, 7);
    f4 a = __builtin_convertvector(__builtin_convertvector(low, d4) * TD_RADIANS_A_QUANTUM, f4);
    f4 b = __builtin_convertvector(__builtin_convertvector(high, d4) * TD_RADIANS_A_QUANTUM, f4);
    f8 radians = __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
    return f8_flip(radians, angle == i8_all(INT32_MIN));
}

/* The anchors, axes and relative angles of a block's joints, from the present poses; zeros in lanes
 * that are not `used`. */
TD_INLINE place8 place_of(const thud_world *w, const td_anchor_rows *r, i8 used) {
    const td_pose *a[TD_LANES], *b[TD_LANES];
    f4 apart[4];
    place8 p;
    for (int i = 0; i < TD_LANES; i++) {
        a[i] = (const td_pose *)w->pose.data + r->body_a[i];
        b[i] = (const td_pose *)w->pose.data + r->body_b[i];
    }
    for (int i = 0; i < 4; i++) {
        apart[i] = centre_offset(a, b, i, w->to_fixed);
    }
    f8 r01 = __builtin_shufflevector(apart[0], apart[1], 0, 4, 1, 5, 2, 6, 3, 7);
    f8 r23 = __builtin_shufflevector(apart[2], apart[3], 0, 4, 1, 5, 2, 6, 3, 7);
    td_rows ta = rotations_of(a), tb = rotations_of(b);
    p.ax = f8_keep(used, ta.y * r->a_x - ta.z * r->a_y);
    p.ay = f8_keep(used, ta.z * r->a_x + ta.y * r->a_y);
    p.bx = f8_keep(used, tb.y * r->b_x - tb.z * r->b_y);
    p.by = f8_keep(used, tb.z * r->b_x + tb.y * r->b_y);
    f8 x = __builtin_shufflevector(r01, r23, 0, 1, 8, 9, 4, 5, 12, 13);
    f8 y = __builtin_shufflevector(r01, r23, 2, 3, 10, 11, 6, 7, 14, 15);
    p.x = f8_keep(used, x) + p.bx - p.ax;
    p.y = f8_keep(used, y) + p.by - p.ay;
    p.axis_x = f8_keep(used, ta.y * r->axis_c - ta.z * r->axis_s);
    p.axis_y = f8_keep(used, ta.z * r->axis_c + ta.y * r->axis_s);
    p.turn = f8_keep(used, (f8)i8_wrap_sub(i8_wrap_sub((i8)tb.x, (i8)ta.x), r->turn));
    return p;
}

/* The coordinate of turn, rad, for the caller's order of sides: negated where turn_sign is -1. */
TD_INLINE f8 turn_of(const place8 *p, f8 turn_sign) {
    i8 swapped = turn_sign < f8_all(0.0f), turn = (i8)p->turn;
    return radians_of(i8_wrap_sub(turn ^ swapped, swapped));
}

/* td_joint_line of eight joints; (0, 0) in empty lanes. */
TD_INLINE f8 line_of(const place8 *p, i8 used, f8 *x, f8 *y) {
    f8 one = f8_all(1.0f), length = f8_sqrt(p->x * p->x + p->y * p->y);
    i8 apart = length > f8_all(0.0f);
    f8 divisor = f8_pick(apart, length, one);
    *x = f8_keep(apart, p->x / divisor);
    *y = f8_keep(used, f8_pick(apart, p->y / divisor, one));
    return length;
}

/* Sets the axis u = (x, y) of the frames, and the lever arms crossed with the axes: with u in
 * point[0], with v in point[1]. */
TD_INLINE void set_frame(td_block *block, const place8 *p, f8 x, f8 y) {
    td_point *u = &block->point[0], *v = &block->point[1];
    block->nx = x;
    block->ny = y;
    u->cross_a = p->ax * y - p->ay * x;
    u->cross_b = p->bx * y - p->by * x;
    v->cross_a = p->ax * x + p->ay * y;
    v->cross_b = p->bx * x + p->by * y;
}

/* J M^-1 J' of a row, the inverse of its effective mass. `linear`: inverse masses of both sides, or
 * 0 for a row of turn. */
TD_INLINE f8 inverse_mass(const td_block *block, f8 linear, f8 cross_a, f8 cross_b) {
    return linear + block->inv_inertia_a * cross_a * cross_a +
           block->inv_inertia_b * cross_b * cross_b;
}

/* Sums of the inverse masses of both sides. */
TD_INLINE f8 inverse_masses(const thud_world *w, const td_block *block) {
    const float(*velocity)[4] = w->velocity.data;
    return td_gather(velocity, block->a).w + td_gather(velocity, block->b).w;
}

/* The mask of the lanes in use. All of them are marked as touching. */
TD_INLINE i8 used_lanes(td_block *block) {
    block->touching = (1u << block->used) - 1u;
    return (i8){0, 1, 2, 3, 4, 5, 6, 7} < i8_all(block->used);
}

/* Whether a bit of td_joint.locked is set. */
TD_INLINE i8 is_locked(i8 locked, int direction) {
    return (locked & i8_all(1 << direction)) != i8_all(0);
}

/* Sets the rows of locked directions. Where both along and across are locked, the frame has the
 * world's axes, so that an impulse that carries a weight keeps its components from step to step. */
TD_INLINE void place_lock(const thud_world *w, td_block *block) {
    td_lock_rows *rows = td_lock_rows_of(block);
    f8 zero = f8_all(0.0f), one = f8_all(1.0f), mass = inverse_masses(w, block);
    rows->closing_factor = f8_all(TD_JOINT_CLOSING_FACTOR);
    place8 p = place_of(w, &rows->anchor, used_lanes(block));
    i8 stays = is_locked(rows->locked, THUD_DIRECTION_ALONG) &
               is_locked(rows->locked, THUD_DIRECTION_ACROSS);
    f8 x = f8_pick(stays, one, p.axis_x), y = f8_pick(stays, zero, p.axis_y);
    set_frame(block, &p, x, y);
    f8 gap[2] = {p.x * x + p.y * y, p.y * x - p.x * y};
    for (int k = 0; k < 2; k++) {
        td_point *q = &block->point[k];
        i8 here = is_locked(rows->locked, k);
        q->start_separation = gap[k];
        q->separation = f8_keep(here, gap[k]);
        q->normal_mass =
            f8_keep(here, inverse_or_zero(inverse_mass(block, mass, q->cross_a, q->cross_b)));
        q->normal_impulse = f8_keep(here, q->normal_impulse);
    }
    i8 here = is_locked(rows->locked, THUD_DIRECTION_TURN);
    f8 sign = rows->turn_sign;
    rows->start_turn_gap = rows->turn_gap = turn_of(&p, sign);
    block->tangent_mass = f8_keep(here, inverse_or_zero(inverse_mass(block, zero, sign, sign)));
    block->tangent_impulse = f8_keep(here, block->tangent_impulse);
}

/* Sets the row of a locked distance; rows->rest_length is that distance. */
TD_INLINE void place_rod(const thud_world *w, td_block *block) {
    td_lock_rows *rows = td_lock_rows_of(block);
    td_point *q = &block->point[0];
    rows->closing_factor = f8_all(TD_JOINT_CLOSING_FACTOR);
    f8 x, y, mass = inverse_masses(w, block);
    i8 used = used_lanes(block);
    place8 p = place_of(w, &rows->anchor, used);
    f8 length = line_of(&p, used, &x, &y);
    set_frame(block, &p, x, y);
    q->normal_mass = inverse_or_zero(inverse_mass(block, mass, q->cross_a, q->cross_b));
    q->start_separation = q->separation = length - rows->rest_length;
}

/* Sets the rows of a driven direction with coordinate `value`: the nearer limit, which the solver
 * passes may still change, the spring and the motor. The impulse of a limit becomes 0 if another
 * limit was nearer in the last step, and so do impulses of springs and motors that do not act. */
TD_INLINE void set_values(td_block *block, td_drive_rows *rows, f8 value) {
    td_point *p = &block->point[0], *q = &block->point[1];
    f8 zero = f8_all(0.0f), one = f8_all(1.0f);
    i8 lower = value - rows->lower <= rows->upper - value, springs = rows->frequency > zero;
    f8 side = f8_keep(rows->limited, f8_pick(lower, one, -one));
    p->normal_impulse = f8_keep(side == rows->limit_side, p->normal_impulse);
    rows->limit_side = side;
    rows->limit = f8_pick(lower, rows->lower, rows->upper);
    p->start_separation = p->separation = side * (value - rows->limit);
    rows->start_value = value;
    q->start_separation = q->separation = f8_keep(springs, value - rows->target);
    q->normal_impulse = f8_keep(springs, q->normal_impulse);
    block->tangent_impulse = f8_keep(rows->max_motor_force > zero, block->tangent_impulse);
}

/* Sets the rows of a driven direction. */
TD_INLINE void place_drive(const thud_world *w, td_block *block, int kind) {
    td_drive_rows *rows = td_drive_rows_of(block);
    i8 used = used_lanes(block);
    place8 p = place_of(w, &rows->anchor, used);
    f8 x = f8_pick(rows->across, -p.axis_y, p.axis_x);
    f8 y = f8_pick(rows->across, p.axis_x, p.axis_y);
    f8 length = kind == TD_CONSTRAINT_DRIVE_LINE ? line_of(&p, used, &x, &y) : f8_all(0.0f);
    set_frame(block, &p, x, y);
    rows->gap_u = p.x * x + p.y * y;
    rows->gap_v = p.y * x - p.x * y;
    set_values(block, rows,
               kind == TD_CONSTRAINT_DRIVE_LINE   ? length
               : kind == TD_CONSTRAINT_DRIVE_AXIS ? rows->gap_u
                                                  : turn_of(&p, rows->turn_sign));
}

void TD_WIDE(td_place_joints)(thud_world *w, td_block *const *blocks, int count,
                              const td_collide_context *context) {
    (void)context;
    int kind = td_constraint_at(w, blocks[0]->constraint[0])->kind;
    for (int i = 0; i < count; i++) {
        if (blocks[i]->anchors_stale) {
            td_joint_update_anchors(w, blocks[i]);
        }
        if (kind == TD_CONSTRAINT_LOCK) {
            place_lock(w, blocks[i]);
        } else if (kind == TD_CONSTRAINT_ROD) {
            place_rod(w, blocks[i]);
        } else {
            place_drive(w, blocks[i], kind);
        }
    }
}
