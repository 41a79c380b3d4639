/* joint_rows.c: the rows of joints for the direct solver (direct/direct.h): Jacobians, target
 * speeds and warm starts.
 *
 * td_*_take_rows fills a constraint's rows at the start of the step, and returns false, since the
 * soft solver never lets a joint bounce (direct/rows.h). The direct solver divides a step of an
 * island with joints into parts, since directions turn (direct/step_parts.c). td_*_update_rows
 * recomputes the rows for a part of duration h, from the motions of both sides since the start of
 * the step: up to the start of the part (a[0], b[0]) and, by the present iteration, up to its end
 * (a[1], b[1]): td_span. With h = 0 the rows are ordinary Jacobians, the derivatives of q, for the
 * poses at the end of a part.
 *
 * With the poses x[0] and x[1] of both bodies at the start and at the end of the part, the
 * Jacobians J of a part are discrete gradients of the joint's coordinate q, so that locked rows do
 * no work (O. Gonzalez, "Time integration and discrete Hamiltonian systems", 1996):
 *     J (x[1] - x[0]) = q(x[1]) - q(x[0])
 * This is exact for distances, for turn, and for frames that do not turn. For a frame that turns
 * with body a, J is that in the middle of the motion, and the equation holds to second order. The
 * target speed corrects the remaining error, so that gaps close in either case
 * (target_speed_for_gap).
 *
 * The velocity at the end of a part is 2 v - v_before, where v is the mean velocity that the
 * problem solves for. An impulse of the part changes the mean velocity by half of what it changes
 * the velocity at the end. So the impulses of the problem are half of those of the part: hence the
 * factors 0.5.
 *
 * turn_sign is -1 where the block's sides are the caller's b and a, so that coordinates of turn are
 * those of the caller's order (joint.h). Lengths and masses are in the caller's units, times in
 * seconds, turn in radians. Bounds of gaps are in length scales or radians: `unit` is a length
 * scale for a row of lengths, and 1 for a row of turn (td_gap_unit). */
#include "joints/joint.h"

#include "direct/rows.h"

/* Warm start and target speed of an equality row: half of `impulse`, the impulse of the last step,
 * and the speed that closes `gap` in this step. */
static void set_equality(const thud_world *w, td_direct_row *row, float impulse, double gap,
                         double unit) {
    row->impulse = 0.5 * (double)impulse;
    row->target_speed = td_joint_closing_speed(gap, unit, w->def.time_step);
}

/* ---- a part of the step ---- */

/* Sets a row's Jacobian: direction (x, y) from a to b; cross_a, cross_b: lever arms crossed with
 * it. */
static void set_direction(td_direct_row *row, double x, double y, double cross_a, double cross_b) {
    double a[3] = {-x, -y, -cross_a}, b[3] = {x, y, cross_b};
    for (int k = 0; k < 3; k++) {
        row->a[k] = a[k];
        row->b[k] = b[k];
    }
}

/* J (x[1] - x[0]): the displacement along a row by the motion of the part, a length or rad. */
static double displacement_along(const td_direct_row *row, const td_span *s) {
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        sum += row->a[k] * (s->a[1][k] - s->a[0][k]) + row->b[k] * (s->b[1][k] - s->b[0][k]);
    }
    return sum;
}

double td_joint_part_closing(const thud_world *w, double gap, double unit, double time) {
    double width = td_abs(gap), change = 0.0;
    if (width > TD_GAP_IGNORED * unit) {
        double max_change = (double)TD_JOINT_CLOSING_SPEED * unit * time;
        change =
            width * (TD_GAP_SHARE_PER_STEP * time / w->def.time_step) + TD_GAP_CLOSED_MIN * unit;
        change = td_min_double(td_min_double(max_change, change), width);
    }
    return gap > 0.0 ? -change / time : change / time;
}

/* td_joint_part_closing for a row whose gap is `before` at the start of the part. Sets row->closing
 * to the magnitude of that speed. At h = 0 row->closing is kept, and the result is 0: the gap is
 * not closed. */
static double closing_of(const thud_world *w, td_direct_row *row, const td_span *s, double before,
                         double unit) {
    if (s->time == 0.0) {
        return 0.0;
    }
    double speed = td_joint_part_closing(w, before, unit, s->time);
    row->closing = td_abs(speed);
    return speed;
}

/* The mean speed along a row by which its gap closes as in closing_of, where the motion of the
 * present iteration changes the gap from `before` to `after`, and the row's Jacobian gives that
 * change to second order only:
 *     (J (x[1] - x[0]) - (after - before)) / h + closing_of. */
static double target_speed_for_gap(const thud_world *w, td_direct_row *row, const td_span *s,
                                   double before, double after, double unit) {
    double closing = closing_of(w, row, s, before, unit);
    return s->time == 0.0 ? 0.0
                          : (displacement_along(row, s) - (after - before)) / s->time + closing;
}

/* A lever arm, by its cross products with u and v, averaged over a rotation by `angle`: the arm
 * after half of it, shortened by the ratio of chord to arc, sin(half) / half. Multiplied by the
 * rotation, it gives the chord by which its end moves. */
static void average_arm(double angle, double *u, double *v) {
    double half = 0.5 * angle, s, c, x = *u, y = *v;
    td_joint_sincos(half, &s, &c);
    double shorter = half * half >= TD_CHORD_IS_ARC ? s / half : 1.0;
    *u = shorter * (c * x - s * y);
    *v = shorter * (c * y + s * x);
}

/* The frame of a part whose axes do not turn: u and v of the block, the lever arms averaged over
 * the part, and the gap at its start; gap_u, gap_v: the gap at the start of the step. */
static td_joint_frame average_frame(const td_block *block, int lane, double gap_u, double gap_v,
                                    const td_span *s) {
    td_joint_frame f =
        s->start > 0.0 ? td_joint_frame_after(block, lane, gap_u, gap_v, false, s->a[0], s->b[0])
                       : td_joint_frame_at(block, lane, gap_u, gap_v);
    average_arm(s->a[1][2] - s->a[0][2], &f.a_u, &f.a_v);
    average_arm(s->b[1][2] - s->b[0][2], &f.b_u, &f.b_v);
    return f;
}

/* The joint's frame at the middle of the part of the step. Its axes turn with body a. */
static td_joint_frame middle_frame(const td_block *block, int lane, double gap_u, double gap_v,
                                   const td_span *s) {
    double a[3], b[3];
    for (int k = 0; k < 3; k++) {
        a[k] = 0.5 * (s->a[0][k] + s->a[1][k]);
        b[k] = 0.5 * (s->b[0][k] + s->b[1][k]);
    }
    return td_joint_frame_after(block, lane, gap_u, gap_v, true, a, b);
}

/* The direction of a distance for a part: the mean d of the gap vectors at its start and end, over
 * the mean length, so that (d / length) . (d1 - d0) = length1 - length0 exactly. length: both
 * lengths. */
static td_joint_frame midpoint_line(const td_block *block, int lane, double gap_u, double gap_v,
                                    const td_span *s, double length[2]) {
    td_joint_frame f = average_frame(block, lane, gap_u, gap_v, s), end[2];
    for (int i = 0; i < 2; i++) {
        end[i] = td_joint_frame_after(block, lane, gap_u, gap_v, false, s->a[i], s->b[i]);
        length[i] = __builtin_sqrt(end[i].gap_u * end[i].gap_u + end[i].gap_v * end[i].gap_v);
    }
    double lengths = length[0] + length[1];
    double u = lengths > 0.0 ? (end[0].gap_u + end[1].gap_u) / lengths : 1.0;
    double v = lengths > 0.0 ? (end[0].gap_v + end[1].gap_v) / lengths : 0.0;
    return (td_joint_frame){.x = u * f.x - v * f.y,
                            .y = u * f.y + v * f.x,
                            .a_u = u * f.a_u + v * f.a_v,
                            .a_v = u * f.a_v - v * f.a_u,
                            .b_u = u * f.b_u + v * f.b_v,
                            .b_v = u * f.b_v - v * f.b_u};
}

/* Geometric stiffness of the rows' impulses along u and v, as a moment of inertia for each side.
 * When a side turns, its lever arm turns with it, and the moment of the impulses about its centre
 * of mass changes: the stiffness is minus this change per angular velocity of the side, for the
 * time h / 2 up to the middle of the part. */
static void set_geometric_stiffness(td_direct_constraint *c, const td_joint_frame *f,
                                    const td_span *s, double impulse_u, double impulse_v) {
    double half = 0.5 * s->time;
    c->stiff[0] = -half * (f->a_v * impulse_u - f->a_u * impulse_v);
    c->stiff[1] = half * (f->b_v * impulse_u - f->b_u * impulse_v);
}

/* Geometric stiffness of a distance. A distance under tension (impulse < 0) also resists rotation
 * of its line, by a soft row across the line. Its weight is h / 2 times the magnitude of the
 * distance's impulse over the length. Its target is the speed of the present iteration, at which
 * the row has no impulse. */
static void set_line_stiffness(td_direct_constraint *c, const td_joint_frame *f, const td_span *s,
                               double impulse, double length, td_direct_row *across) {
    set_geometric_stiffness(c, f, s, impulse, 0.0);
    set_direction(across, -f->y, f->x, f->a_v, f->b_v);
    across->kind = TD_ROW_SOFT;
    across->used = impulse < 0.0 && length > 0.0 && s->time > 0.0;
    across->weight = across->used ? -0.5 * s->time * impulse / length : 0.0;
    across->target_speed = s->time > 0.0 ? displacement_along(across, s) / s->time : 0.0;
    across->max_impulse = __builtin_inf();
    across->impulse = 0.0;
}

/* ---- locked directions ---- */

/* td_take_rows_fn of a locked distance: row 0. (Row 1 is its stiffness across the line, in parts of
 * a step only.) */
bool td_rod_take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                      td_direct_constraint *c) {
    const td_point *p = &block->point[0];
    td_row_set(&c->row[0], TD_ROW_EQUALITY, (double)block->nx[lane], (double)block->ny[lane],
               (double)p->cross_a[lane], (double)p->cross_b[lane]);
    set_equality(w, &c->row[0], impulses[0], (double)p->start_separation[lane],
                 (double)w->length_scale);
    return false;
}

void td_rod_update_rows(const thud_world *w, const td_block *block, int lane, const td_span *s,
                        td_direct_constraint *c) {
    double rest_length = (double)td_lock_rows_at(block)->rest_length[lane], length[2];
    td_joint_frame f =
        midpoint_line(block, lane, (double)block->point[0].start_separation[lane] + rest_length,
                      0.0, s, length);
    set_direction(&c->row[0], f.x, f.y, f.a_u, f.b_u);
    c->row[0].target_speed = target_speed_for_gap(w, &c->row[0], s, length[0] - rest_length,
                                                  length[1] - rest_length, (double)w->length_scale);
    set_line_stiffness(c, &f, s, c->row[0].impulse, length[0], &c->row[1]);
}

/* Rows along u and v of a frame, with the geometric stiffness of their impulses. */
static void set_lock_directions(td_direct_constraint *c, const td_joint_frame *f,
                                const td_span *s) {
    set_direction(&c->row[0], f->x, f->y, f->a_u, f->b_u);
    set_direction(&c->row[1], -f->y, f->x, f->a_v, f->b_v);
    set_geometric_stiffness(c, f, s, c->row[0].impulse, c->row[1].impulse);
}

/* td_update_rows_fn of locked directions whose frame turns with body a. */
static void update_turning_lock(const thud_world *w, const td_block *block, int lane,
                                const td_span *s, td_direct_constraint *c, double unit) {
    double u = (double)block->point[0].start_separation[lane],
           v = (double)block->point[1].start_separation[lane];
    td_joint_frame end = td_joint_frame_after(block, lane, u, v, true, s->a[1], s->b[1]);
    td_joint_frame start = {.gap_u = u, .gap_v = v};
    if (s->start > 0.0) {
        start = td_joint_frame_after(block, lane, u, v, true, s->a[0], s->b[0]);
    }
    td_joint_frame f = s->time == 0.0 ? end : middle_frame(block, lane, u, v, s);
    set_lock_directions(c, &f, s);
    c->row[0].target_speed = target_speed_for_gap(w, &c->row[0], s, start.gap_u, end.gap_u, unit);
    c->row[1].target_speed = target_speed_for_gap(w, &c->row[1], s, start.gap_v, end.gap_v, unit);
}

/* td_update_rows_fn of locked directions: rows 0 along, 1 across, 2 turn. The Jacobian of turn is
 * constant. Where the frame does not turn, the Jacobian gives the change of the gap exactly. */
void td_lock_update_rows(const thud_world *w, const td_block *block, int lane, const td_span *s,
                         td_direct_constraint *c) {
    const td_lock_rows *rows = td_lock_rows_at(block);
    double unit = (double)w->length_scale;
    if (rows->frame_turns[lane] > 0.0f) {
        update_turning_lock(w, block, lane, s, c, unit);
    } else {
        double u = (double)block->point[0].start_separation[lane],
               v = (double)block->point[1].start_separation[lane];
        td_joint_frame f = average_frame(block, lane, u, v, s);
        set_lock_directions(c, &f, s);
        c->row[0].target_speed = closing_of(w, &c->row[0], s, f.gap_u, unit);
        c->row[1].target_speed = closing_of(w, &c->row[1], s, f.gap_v, unit);
    }
    if (c->row[2].used) {
        double gap = (double)rows->start_turn_gap[lane], sign = (double)rows->turn_sign[lane];
        c->row[2].target_speed =
            closing_of(w, &c->row[2], s, gap + sign * (s->b[0][2] - s->a[0][2]), 1.0);
    }
}

/* td_take_rows_fn of locked directions: rows 0 along, 1 across, 2 turn, as in td_lock_update_rows.
 * Rows of directions that are not locked have an effective mass of 0, and are not used. */
bool td_lock_take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                       td_direct_constraint *c) {
    const td_lock_rows *rows = td_lock_rows_of(block);
    const td_point *p = block->point;
    double no_motion[3] = {0.0, 0.0, 0.0}, sign = (double)rows->turn_sign[lane];
    td_joint_frame f = td_joint_frame_after(block, lane, (double)p[0].start_separation[lane],
                                            (double)p[1].start_separation[lane],
                                            rows->frame_turns[lane] > 0.0f, no_motion, no_motion);
    td_row_set(&c->row[0], TD_ROW_EQUALITY, f.x, f.y, f.a_u, f.b_u);
    td_row_set(&c->row[1], TD_ROW_EQUALITY, -f.y, f.x, f.a_v, f.b_v);
    td_row_set(&c->row[2], TD_ROW_EQUALITY, 0.0, 0.0, sign, sign);
    set_equality(w, &c->row[0], impulses[0], f.gap_u, (double)w->length_scale);
    set_equality(w, &c->row[1], impulses[1], f.gap_v, (double)w->length_scale);
    set_equality(w, &c->row[2], impulses[2], (double)rows->start_turn_gap[lane], 1.0);
    c->row[0].used = p[0].normal_mass[lane] > 0.0f;
    c->row[1].used = p[1].normal_mass[lane] > 0.0f;
    c->row[2].used = block->tangent_mass[lane] > 0.0f;
    return false;
}

/* ---- driven directions ---- */

/* Chooses the limit (lower or upper) for which a step is solved: the one that is nearer at the
 * start of the step, or the other one if the soft solver has chosen that, and ended nearer to it
 * than the coordinate was to the nearer limit at the start, or with an impulse. In the second case
 * the lane stays on the side to which the soft solver's impulse belongs, since that impulse is used
 * if the direct result is refused. Sets limit_side (1 lower, -1 upper, 0 no limits), limit, and
 * start_separation, the separation from it at the start of the step. Returns whether the nearer one
 * was chosen: only then the impulse of the last step is a warm start. */
static bool choose_limit(td_block *block, int lane) {
    td_drive_rows *r = td_drive_rows_of(block);
    td_point *p = &block->point[0];
    float value = r->start_value[lane];
    float above_lower = value - r->lower[lane], below_upper = r->upper[lane] - value;
    float nearer_side = above_lower <= below_upper ? 1.0f : -1.0f;
    float nearer_gap = td_min_float(above_lower, below_upper);
    bool other = r->limit_side[lane] != nearer_side &&
                 (p->separation[lane] < nearer_gap || p->normal_impulse[lane] != 0.0f);
    float side = r->limited[lane] == 0 ? 0.0f : other ? -nearer_side : nearer_side;
    r->limit_side[lane] = side;
    r->limit[lane] = side > 0.0f ? r->lower[lane] : r->upper[lane];
    p->start_separation[lane] = side * (value - r->limit[lane]);
    return !other;
}

/* The row of a limit; `along` is the driven direction. If the limit is not reached yet, the row's
 * target speed is the one that just reaches it at the end of the step (as for a contact whose
 * shapes are still apart). If the lower and the upper limit are equal, it is an equality row.
 * `unit`: td_gap_unit of the direction. */
static void take_limit(const thud_world *w, td_block *block, int lane, const float *impulses,
                       td_direct_row *row, const td_direct_row *along, double unit) {
    const td_drive_rows *r = td_drive_rows_at(block);
    bool has_warm_start = choose_limit(block, lane);
    double side = (double)r->limit_side[lane], gap = (double)block->point[0].start_separation[lane];
    bool locked = r->locked[lane] > 0.0f;
    *row = *along;
    for (int k = 0; k < 3; k++) {
        row->a[k] *= side;
        row->b[k] *= side;
    }
    row->kind = locked ? TD_ROW_EQUALITY : TD_ROW_UNILATERAL;
    row->used = side != 0.0;
    set_equality(w, row, impulses[0], gap, unit);
    row->impulse *= has_warm_start ? 1.0 : 0.0;
    row->target_speed = gap > 0.0 && !locked ? -gap / w->def.time_step : row->target_speed;
}

/* The effective mass of a driven direction, at the start of the step. The frame of an axis turns
 * with body a, whose lever arm then ends at b's anchor: its cross product with u is cross_a - gap_v
 * (joint.h). */
static double mass_of(const thud_world *w, const td_block *block, int lane) {
    const td_drive_rows *r = td_drive_rows_at(block);
    int kind = td_constraint_at(w, block->constraint[lane])->kind;
    bool turns = kind == TD_CONSTRAINT_DRIVE_TURN;
    float gap_v = kind == TD_CONSTRAINT_DRIVE_AXIS ? r->gap_v[lane] : 0.0f;
    float cross_a = turns ? r->turn_sign[lane] : block->point[0].cross_a[lane] - gap_v;
    float cross_b = turns ? r->turn_sign[lane] : block->point[0].cross_b[lane];
    float inverse = td_joint_inverse_mass(w, block, lane, turns ? 0.0f : 1.0f, cross_a, cross_b);
    return inverse > 0.0f ? 1.0 / (double)inverse : 0.0;
}

/* A spring for a part of duration h = `time`, by the implicit midpoint rule, which keeps its
 * energy. Its displacement at the start of the part is x, its mean speed v, its stiffness k and its
 * damping c. Its mean force is
 *     -k (x + h v / 2) - c v,
 * which is a soft row, impulse = weight * (target - v), with
 *     weight = h / 2 (h k / 2 + c),  target = -k x / (h k / 2 + c).
 * x is start_separation of point 1, the displacement at the start of the step, plus `moved`, the
 * motion from there to the start of the part. Sets weight and max_impulse of the row; returns the
 * target speed. */
static double update_spring(const thud_world *w, const td_block *block, int lane,
                            td_direct_row *row, double moved, double time) {
    const td_drive_rows *r = td_drive_rows_at(block);
    double omega = td_spring_omega(w, r->frequency[lane]), mass = mass_of(w, block, lane);
    double stiffness = mass * omega * omega,
           damping = 2.0 * (double)r->damping[lane] * mass * omega;
    double resistance = 0.5 * time * stiffness + damping;
    row->weight = 0.5 * time * resistance;
    bool capped = r->max_spring_force[lane] < THUD_JOINT_FORCE_MAX;
    row->max_impulse = capped ? 0.5 * time * (double)r->max_spring_force[lane] : __builtin_inf();
    return resistance > 0.0
               ? -stiffness * ((double)block->point[1].start_separation[lane] + moved) / resistance
               : 0.0;
}

/* The row of a spring, for the whole step. */
static void take_spring(const thud_world *w, const td_block *block, int lane, const float *impulses,
                        td_direct_row *row) {
    row->kind = TD_ROW_SOFT;
    row->impulse = 0.5 * (double)impulses[1];
    row->target_speed = update_spring(w, block, lane, row, 0.0, w->def.time_step);
    row->used = row->weight > 0.0;
}

/* td_take_rows_fn of a driven direction: rows 0 limit, 1 spring, 2 motor (a friction row whose
 * bound is the motor's maximum impulse). */
bool td_drive_take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                        td_direct_constraint *c) {
    const td_drive_rows *r = td_drive_rows_of(block);
    bool turns = td_constraint_at(w, block->constraint[lane])->kind == TD_CONSTRAINT_DRIVE_TURN;
    bool line = td_constraint_at(w, block->constraint[lane])->kind == TD_CONSTRAINT_DRIVE_LINE;
    double no_motion[3] = {0.0, 0.0, 0.0}, sign = (double)r->turn_sign[lane];
    double gap_u = (double)r->gap_u[lane], gap_v = (double)r->gap_v[lane];
    td_joint_frame f = {.a_u = sign, .b_u = sign};
    if (!turns) {
        f = line ? td_joint_line_after(block, lane, gap_u, gap_v, no_motion, no_motion)
                 : td_joint_frame_after(block, lane, gap_u, gap_v, true, no_motion, no_motion);
    }
    td_direct_row along;
    td_row_set(&along, TD_ROW_FRICTION, f.x, f.y, f.a_u, f.b_u);
    c->row[1] = c->row[2] = along;
    take_limit(w, block, lane, impulses, &c->row[0], &along, td_gap_unit(w, turns));
    take_spring(w, block, lane, impulses, &c->row[1]);
    c->bound = 0.5 * w->def.time_step * (double)r->max_motor_force[lane];
    c->row[2].used = c->bound > 0.0;
    c->row[2].target_speed = (double)r->motor_speed[lane];
    c->row[2].impulse = 0.5 * (double)impulses[TD_DIRECT_TANGENT];
    return false;
}

/* The direction of a drive for a part, and its coordinates at the start and end: value[0], [1]. */
static td_joint_frame midpoint_drive(const thud_world *w, const td_block *block, int lane,
                                     const td_span *s, double value[2]) {
    const td_drive_rows *r = td_drive_rows_at(block);
    int kind = td_constraint_at(w, block->constraint[lane])->kind;
    double u = (double)r->gap_u[lane], v = (double)r->gap_v[lane];
    double sign = (double)r->turn_sign[lane];
    if (kind == TD_CONSTRAINT_DRIVE_LINE) {
        return midpoint_line(block, lane, u, v, s, value);
    }
    for (int i = 0; i < 2; i++) {
        value[i] = kind == TD_CONSTRAINT_DRIVE_TURN
                       ? (double)r->start_value[lane] + sign * (s->b[i][2] - s->a[i][2])
                       : td_joint_frame_after(block, lane, u, v, true, s->a[i], s->b[i]).gap_u;
    }
    return kind == TD_CONSTRAINT_DRIVE_TURN ? (td_joint_frame){.a_u = sign, .b_u = sign}
                                            : middle_frame(block, lane, u, v, s);
}

/* td_update_rows_fn of a driven direction. A limit that is not reached at the start of the part
 * gets the target speed that just reaches it at the end of the part; with h = 0, within the time of
 * a step. Drives have no geometric stiffness: Newton's method neglects the change of their
 * directions. */
void td_drive_update_rows(const thud_world *w, const td_block *block, int lane, const td_span *s,
                          td_direct_constraint *c) {
    const td_drive_rows *r = td_drive_rows_at(block);
    double side = (double)r->limit_side[lane], value[2], gap[2];
    td_joint_frame f = midpoint_drive(w, block, lane, s, value);
    set_direction(&c->row[1], f.x, f.y, f.a_u, f.b_u);
    set_direction(&c->row[2], f.x, f.y, f.a_u, f.b_u);
    set_direction(&c->row[0], side * f.x, side * f.y, side * f.a_u, side * f.b_u);
    for (int i = 0; i < 2; i++) {
        gap[i] = side * (value[i] - (double)r->limit[lane]);
    }
    td_direct_row *limit = &c->row[0];
    bool turns = td_constraint_at(w, block->constraint[lane])->kind == TD_CONSTRAINT_DRIVE_TURN;
    if (!(gap[0] > 0.0 && limit->kind == TD_ROW_UNILATERAL)) {
        limit->target_speed =
            target_speed_for_gap(w, limit, s, gap[0], gap[1], td_gap_unit(w, turns));
    } else {
        limit->target_speed = s->time > 0.0 ? (displacement_along(limit, s) - gap[1]) / s->time
                                            : -gap[1] / w->def.time_step;
    }
    if (s->time > 0.0) {
        c->bound = 0.5 * s->time * (double)r->max_motor_force[lane];
        double moved = value[0] - (double)r->start_value[lane];
        c->row[1].target_speed = update_spring(w, block, lane, &c->row[1], moved, s->time);
    }
}
