/* gear.c: gears. A gear couples the coordinates q0, q1 of two joints, each between a static body
 * and a dynamic one, by the equality row
 *     q0 + ratio q1 - rest = 0
 * where `rest` is the value of q0 + ratio q1 when the gear was made, or when it acts again after
 * it, one of the joints or of their bodies was disabled: then turns are not counted. The coordinate
 * of a hinge or wheel is its rotation, counted over any number of turns; of a slider, the
 * displacement along; of a distance, its length. The gear's sides are the dynamic bodies of both
 * joints. Its Jacobian is that of the start of a step. */
#include "joints/gear.h"

#include "base/rotation.h"
#include "direct/rows.h"
#include "state/handles.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_gear);

/* One of the gear's two joints. */
static const td_joint *member(const thud_world *w, const td_joint *gear, int i) {
    return td_joint_at(w, gear->gear.joint[i]);
}

bool td_gear_by_angle(const td_joint *joint) {
    return joint->kind == THUD_JOINT_HINGE || joint->kind == THUD_JOINT_WHEEL;
}

bool td_gear_has_joints(const thud_world *w, const td_joint *joint) {
    bool has = true;
    for (int i = 0; i < 2; i++) {
        const td_joint *of = member(w, joint, i);
        has &= of->live && of->generation == joint->gear.generation[i];
    }
    return has;
}

/* ---- coordinates ---- */

/* The rotation of a joint within a turn; 2^32 is a full turn. */
static uint32_t angle_of(const thud_world *w, const td_joint *joint) {
    uint32_t turn =
        td_pose_at(w, joint->body[1])->angle - td_pose_at(w, joint->body[0])->angle - joint->turn;
    return joint->swapped ? 0u - turn : turn;
}

/* The rotation of a joint since td_gear_set_rest, 2^32 a turn. Valid while the joint has turned by
 * less than half a turn since count_turns was called. */
static int64_t counted_rotation(const thud_world *w, const td_joint *gear, int i) {
    uint32_t since = angle_of(w, member(w, gear, i)) - gear->gear.last[i];
    return gear->gear.turned[i] + (int32_t)since;
}

/* The coordinate of one of the gear's joints, rad or length. */
static double coordinate_of(const thud_world *w, const td_joint *gear, int i) {
    const td_joint *joint = member(w, gear, i);
    if (td_gear_by_angle(joint)) {
        return (double)counted_rotation(w, gear, i) * (TD_PI / 2147483648.0);
    }
    td_joint_place place = td_joint_place_of(w, joint);
    double x = (double)place.x, y = (double)place.y;
    return joint->kind == THUD_JOINT_DISTANCE ? __builtin_sqrt(x * x + y * y)
                                              : x * (double)place.axis_x + y * (double)place.axis_y;
}

double td_gear_gap(const thud_world *w, const td_joint *gear) {
    double first = coordinate_of(w, gear, 0), second = coordinate_of(w, gear, 1);
    return first + (double)gear->gear.ratio * second - gear->gear.rest;
}

void td_gear_set_rest(const thud_world *w, td_joint *gear) {
    td_gear *g = &gear->gear;
    for (int i = 0; i < 2; i++) {
        g->turned[i] = 0;
        g->last[i] = angle_of(w, member(w, gear, i));
    }
    g->rest = 0.0;
    g->rest = td_gear_gap(w, gear);
}

/* Adds the rotation since the last call to `turned`, for both joints. Called once a step: the count
 * is right as long as a body turns by less than half a turn between two calls. */
static void count_turns(const thud_world *w, td_joint *gear) {
    for (int i = 0; i < 2; i++) {
        gear->gear.turned[i] = counted_rotation(w, gear, i);
        gear->gear.last[i] = angle_of(w, member(w, gear, i));
    }
}

/* ---- lanes ---- */

/* The gradient of a joint's coordinate with respect to the motion (x, y, turn) of its second
 * body. */
static void coordinate_gradient(const thud_world *w, const td_joint *joint, float out[3]) {
    td_joint_place place = td_joint_place_of(w, joint);
    float sign = joint->swapped ? -1.0f : 1.0f;
    out[0] = out[1] = 0.0f;
    out[2] = sign;
    if (td_gear_by_angle(joint)) {
        return;
    }
    float x = place.axis_x, y = place.axis_y;
    if (joint->kind == THUD_JOINT_DISTANCE) {
        td_joint_line(&place, &x, &y);
    }
    out[0] = x;
    out[1] = y;
    out[2] = td_cross(place.arm[1], x, y);
}

/* Sets and returns td_gear.apart: whether one of the gear's joints is disabled, so that the gear
 * does not act. When the gear acts again, sets `rest` from the present coordinates, so that it does
 * not jump back to the old ones. */
static bool update_apart(const thud_world *w, td_joint *gear) {
    bool apart = member(w, gear, 0)->disabled || member(w, gear, 1)->disabled;
    if (!apart && gear->gear.apart) {
        td_gear_set_rest(w, gear);
    }
    gear->gear.apart = apart;
    return apart;
}

/* Computes the row of a gear's lane. The row's effective mass is 0 if the gear does not act. */
static void prepare_lane(const thud_world *w, td_block *block, int lane) {
    td_joint *gear = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
    td_point *p = &block->point[0];
    td_gear_rows *rows = td_gear_rows_of(block);
    float a[3], b[3], ratio = gear->gear.ratio;
    coordinate_gradient(w, member(w, gear, 0), a);
    coordinate_gradient(w, member(w, gear, 1), b);
    rows->a_x[lane] = a[0];
    rows->a_y[lane] = a[1];
    p->cross_a[lane] = a[2];
    block->nx[lane] = ratio * b[0];
    block->ny[lane] = ratio * b[1];
    p->cross_b[lane] = ratio * b[2];
    float k = td_gear_inverse_mass(w, block, lane);
    count_turns(w, gear);
    bool acts = !update_apart(w, gear) && k > 0.0f;
    p->normal_mass[lane] = acts ? 1.0f / k : 0.0f;
    p->normal_impulse[lane] = acts ? p->normal_impulse[lane] : 0.0f;
    p->start_separation[lane] = p->separation[lane] = acts ? (float)td_gear_gap(w, gear) : 0.0f;
}

float td_gear_inverse_mass(const thud_world *w, const td_block *block, int lane) {
    const td_gear_rows *rows = td_gear_rows_of((td_block *)block);
    const td_point *p = &block->point[0];
    float a = td_inv_mass_of(w, td_slot_of_side(block->a[lane]));
    float b = td_inv_mass_of(w, td_slot_of_side(block->b[lane]));
    float x = rows->a_x[lane], y = rows->a_y[lane], u = block->nx[lane], v = block->ny[lane];
    return a * (x * x + y * y) + block->inv_inertia_a[lane] * p->cross_a[lane] * p->cross_a[lane] +
           b * (u * u + v * v) + block->inv_inertia_b[lane] * p->cross_b[lane] * p->cross_b[lane];
}

/* Whether the gap of a lane's gear, which is in units of the first coordinate, is an angle. */
static bool turns(const thud_world *w, const td_block *block, int lane) {
    const td_joint *gear = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
    return td_gear_by_angle(member(w, gear, 0));
}

/* td_lane_ops.load: the impulse of a substep over the effective mass, a speed. *off: the gap, a
 * length. Angles are multiplied by `size` to become lengths. */
static float load(const thud_world *w, const td_block *block, int lane, float size, float *off) {
    const td_point *p = &block->point[0];
    float length = turns(w, block, lane) ? size : 1.0f;
    *off = td_joint_abs(p->separation[lane]) * length;
    return td_joint_abs(p->normal_impulse[lane]) * td_gear_inverse_mass(w, block, lane) * length;
}

/* td_lane_ops.count: the residual is the speed of the row, in units of the first coordinate. */
static void count(thud_world *w, const td_block *block) {
    const td_gear_rows *rows = td_gear_rows_of((td_block *)block);
    const td_point *p = &block->point[0];
    for (int lane = 0; lane < block->used; lane++) {
        const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
        const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
        float speed = rows->a_x[lane] * a[0] + rows->a_y[lane] * a[1] + p->cross_a[lane] * a[2] +
                      block->nx[lane] * b[0] + block->ny[lane] * b[1] + p->cross_b[lane] * b[2];
        speed = p->normal_mass[lane] > 0.0f ? td_joint_abs(speed) : 0.0f;
        w->errors.residual = td_max_float(speed, w->errors.residual);
    }
}

/* ---- for the direct solver ---- */

/* td_take_rows_fn: one equality row. */
static bool take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                      td_direct_constraint *c) {
    const td_gear_rows *rows = td_gear_rows_of(block);
    const td_point *p = &block->point[0];
    c->row[0] = (td_direct_row){
        .kind = TD_ROW_EQUALITY,
        .a = {(double)rows->a_x[lane], (double)rows->a_y[lane], (double)p->cross_a[lane]},
        .b = {(double)block->nx[lane], (double)block->ny[lane], (double)p->cross_b[lane]},
        .impulse = 0.5 * (double)impulses[0],
        .target_speed =
            td_joint_closing_speed((double)p->start_separation[lane],
                                   td_gap_unit(w, turns(w, block, lane)), w->def.time_step),
        .used = p->normal_mass[lane] > 0.0f};
    return false;
}

/* td_update_rows_fn: the Jacobian is kept, and the gap changes by the motion along it. */
static void update_rows(const thud_world *w, const td_block *block, int lane, const td_span *s,
                        td_direct_constraint *c) {
    td_direct_row *row = &c->row[0];
    double gap = (double)block->point[0].start_separation[lane];
    for (int k = 0; k < 3; k++) {
        gap += row->a[k] * s->a[0][k] + row->b[k] * s->b[0][k];
    }
    row->target_speed =
        s->time > 0.0 ? td_joint_closing_speed(gap, td_gap_unit(w, turns(w, block, lane)), s->time)
                      : 0.0;
    row->closing = s->time > 0.0 ? td_abs(row->target_speed) : row->closing;
}

/* td_constraint_ops.collide_world: computes the rows from the present poses. All lanes stay in use,
 * unlike those of contacts that part. */
static void prepare(thud_world *w, td_block *const *blocks, int count,
                    const td_collide_context *context) {
    (void)context;
    for (int i = 0; i < count; i++) {
        for (int lane = 0; lane < blocks[i]->used; lane++) {
            prepare_lane(w, blocks[i], lane);
        }
        blocks[i]->touching = (1u << blocks[i]->used) - 1u;
        blocks[i]->anchors_stale = 0;
    }
}

/* `prepare` is compiled only once: both instruction sets use the same function. */
#define prepare_base prepare
#define prepare_avx2 prepare

TD_DEFINE_JOINT_LANES(take_rows, update_rows)
TD_DEFINE_JOINT_OPS(ops, TD_FORM_GEAR, prepare, td_solve_gear)

const td_constraint_ops *td_gear_ops(const thud_world *w) {
    (void)w;
    return &TD_PICK_WIDE(w, ops);
}
