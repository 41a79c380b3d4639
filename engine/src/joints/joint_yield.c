/* joint_yield.c: joints yield where they press a body into a static shape: a correction of the
 * step's motions and velocities after the solver, by projected Gauss-Seidel.
 *
 * Where a joint pulls a body against a static shape (a rope that is shortened, a motor without a
 * maximum force), no motion satisfies both the joint and the contact. The solver's impulses of both
 * then grow from substep to substep, and with each step the overlap of the soft contact grows,
 * which is proportional to the contact's impulse. So the result of a step is checked after the
 * solver. A group of tied bodies (bodies that joints with locked directions connect:
 * constraint/tied_bodies.h; a body without such joints is a group of its own) is corrected
 * - where a contact of one of its bodies with a static shape overlaps more than before the step and
 *   more than DEPTH_SHARE_DETECT allows, and a joint acts on that body; or
 * - where one of its motors misses its target speed although its force is below its maximum, a
 *   contact with a static shape touches, and a lock has opened or such a contact is too deep; or
 * - where a limit of length was far exceeded as the step began (a rope that is much too short), and
 *   a contact with a static shape touches. The soft solver's result of such a step has a fault: the
 *   contact turns a part of the speed at which the rope closes into another direction, and the
 *   relax passes, which take closing speeds out of the velocities, leave this part there.
 *
 * A row's value is J x, where J is its Jacobian and x first the motions of the group's bodies in
 * this step (thud_world.delta), then their velocities. Where the value has to change by c, with the
 * masses and moments of inertia M,
 *     x += M^-1 J' c / (J M^-1 J').
 * Targets of the motions: the gap of a lock is 0, or the width that a step may leave of a gap that
 * was already open (excess_gap); the separation of a contact is at least min_separation. Targets of
 * the velocities: 0 along a lock, and >= 0 along a contact point that touches. GROUP_PASSES passes
 * solve motors, locks and contacts in this order, and then CONTACT_PASSES passes the contacts
 * alone, so that where rows contradict each other the contacts are satisfied: a rope stays too
 * long, and a motor stalls. The velocities are scaled down if they have more kinetic energy than
 * the group had before the step and can gain from gravity and forces (limit_energy).
 *
 * The next step starts without the impulses of the joints that yielded and of their static contacts
 * (td_joints_clear_yielded), which would otherwise grow without bound. step.c calls
 * td_joints_clear_yielded before the solver and td_joints_yield after it.
 *
 * The rule for motions is the projection of M. Mueller et al., "Position Based Dynamics" (2006). */
#include "constraint/joint_hooks.h"
#include "constraint/tied_bodies.h"
#include "detection/trajectory.h"
#include "direct/elimination_order.h"
#include "joints/joint.h"
#include "solver/error.h"
#include "state/kinds.h"
#include "state/shape.h"

/* Overlaps are limited to shares of an extent: the smallest half extent of the body, or half the
 * thickness of the static shape where that is less (min_separation).
 *
 * Share that a contact may overlap once its joint has yielded. Chosen; thud_joint.h states it, and
 * floor_bears_what_is_reeled_in (test_distances.c) and
 * motor_stalls_at_a_wall_and_its_hinge_stays_closed (test_joints_held.c) test it. */
#define DEPTH_SHARE_MAX 0.1f
/* A joint yields if the overlap is above this share of that extent; if its group yielded in the
 * last step, DEPTH_SHARE_MAX is used instead. DEPTH_SHARE_DETECT is larger because impacts press
 * limbs of ragdolls in further than DEPTH_SHARE_MAX for a few steps, where their joints must not
 * yield. Chosen; thud_joint.h states it, and floor_bears_what_is_reeled_in fails at twice this. */
#define DEPTH_SHARE_DETECT 0.4f
/* A contact that overlaps by more than the limit as a step begins, such as that of a body created
 * inside of a shape, has to separate at this share of the world's push_speed. Measured: at half and
 * at double, an arm of motor_stalls_at_a_wall_and_its_hinge_stays_closed ends within the block that
 * it meets (beyond 0.18 rad). */
#define RECOVERY_SHARE 0.2

enum {
    /* Gauss-Seidel passes over all rows of a group, for motions and again for velocities. Measured:
     * at half of them the hinge of motor_stalls_at_a_wall_and_its_hinge_stays_closed opens by more
     * than 0.002; twice as many change no test. */
    GROUP_PASSES = 24,
    /* Passes over contacts alone, after the GROUP_PASSES. Chosen, with a margin: with 1 the tests
       of yielding joints pass as well (test_joints_held.c, test_distances.c). */
    CONTACT_PASSES = 8
};

struct finding;

/* A group of tied bodies, and the state of its check or correction. */
typedef struct tied_group {
    thud_world *w;
    td_awake_slot first;   /* any of its bodies */
    bool on_velocities;    /* rows act on velocities; false: on the motions of the step */
    struct finding *found; /* out: what inspect_constraint found */
    float min_half_extent; /* of its bodies, a length */
    float depth_share;     /* DEPTH_SHARE_DETECT, or DEPTH_SHARE_MAX after a step in which one of
                              its joints yielded */
} tied_group;

/* Calls `visit` once for each acting constraint of the group's bodies. A constraint with a dynamic
 * body outside of the group (a contact, or a joint that locks nothing) is left out if that body is
 * its side a, so that it is visited for one group only. */
static void for_each_constraint(const tied_group *g,
                                void (*visit)(const tied_group *g,
                                              const td_constraint *constraint)) {
    const thud_world *w = g->w;
    td_awake_slot slot = g->first;
    do {
        int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            bool first =
                !td_edge_side(e) || !td_island_neighbour(w, constraint, td_edge_side(e)).at;
            if (constraint->state == TD_TOUCHING && first) {
                visit(g, constraint);
            }
        }
        slot = td_next_tied(w, slot);
    } while (slot.at != g->first.at);
}

/* ---- rows ---- */

/* The motion of a lane's side, or with on_velocities its velocity: x, y, turn. */
static float *record_of(const tied_group *g, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return g->on_velocities ? td_row(&g->w->velocity, slot) : td_row(&g->w->delta, slot);
}

/* A row's Jacobian: a direction n from side a to side b, and the lever arms crossed with it.
 * J x = n . (x_b - x_a) + cross_b turn_b - cross_a turn_a. */
typedef struct row_direction {
    double x, y, cross_a, cross_b;
} row_direction;

/* The value J x of a row (head of this file): with the motions of both sides in the step, or with
 * on_velocities with their velocities. */
static double row_value(const tied_group *g, const td_lane *at, const row_direction *n) {
    const float *a = record_of(g, at->block->a[at->lane]),
                *b = record_of(g, at->block->b[at->lane]);
    return n->x * ((double)b[0] - (double)a[0]) + n->y * ((double)b[1] - (double)a[1]) +
           n->cross_b * (double)b[2] - n->cross_a * (double)a[2];
}

/* Adds an impulse times the inverse mass and inertia of one side to its record. */
static void add_to_record(float *record, double mass, double inertia, const row_direction *n,
                          double cross, double impulse) {
    record[0] += (float)(mass * n->x * impulse);
    record[1] += (float)(mass * n->y * impulse);
    record[2] += (float)(inertia * cross * impulse);
}

/* Changes J x of a row by `change`. Static and kinematic sides have inverse masses of 0, and do not
 * change. */
static void change_row_value(const tied_group *g, const td_lane *at, const row_direction *n,
                             double change) {
    const td_block *block = at->block;
    uint32_t a = block->a[at->lane], b = block->b[at->lane];
    double mass_a = (double)td_inv_mass_of(g->w, td_slot_of_side(a));
    double mass_b = (double)td_inv_mass_of(g->w, td_slot_of_side(b));
    double inertia_a = (double)block->inv_inertia_a[at->lane];
    double inertia_b = (double)block->inv_inertia_b[at->lane];
    double k = (mass_a + mass_b) * (n->x * n->x + n->y * n->y) +
               inertia_a * n->cross_a * n->cross_a + inertia_b * n->cross_b * n->cross_b;
    if (k > 0.0 && change != 0.0) {
        add_to_record(record_of(g, b), mass_b, inertia_b, n, n->cross_b, change / k);
        if (mass_a + inertia_a > 0.0) {
            add_to_record(record_of(g, a), mass_a, inertia_a, n, n->cross_a, -change / k);
        }
    }
}

/* ---- contacts with static shapes ---- */

/* Static sides are side a, and have slot 0. */
static bool is_static_contact(const td_constraint *constraint, const td_lane *at) {
    return td_is_contact(constraint) && constraint->kind != TD_PAIR_SENSOR &&
           at->block->a[at->lane] == 0;
}

/* The row of a contact's point. */
static row_direction contact_normal(const td_lane *at, int k) {
    const td_point *p = &at->block->point[k];
    return (row_direction){(double)at->block->nx[at->lane], (double)at->block->ny[at->lane],
                           (double)p->cross_a[at->lane], (double)p->cross_b[at->lane]};
}

/* The least separation that a contact point may have at the end of the step, a length: minus
 * `share` times the extent that is described above DEPTH_SHARE_MAX. If the step began so far below
 * that that RECOVERY_SHARE of push_speed does not reach it in one step, it is the separation that
 * this speed reaches. */
static double min_separation(const thud_world *w, const td_lane *at, int k, float share) {
    const td_block *block = at->block;
    float min_half_extent = td_row(&w->reach, td_slot_of_side(block->b[at->lane]))[0];
    const td_shape *shape = td_shape_at(w, block->shape_a[at->lane]);
    float half_thickness =
        td_kind_is_line(shape->kind) ? min_half_extent : td_half_thickness(shape);
    double limit = -(double)(share * td_min_float(min_half_extent, half_thickness));
    double recovery =
        RECOVERY_SHARE * (double)(w->def.push_speed * w->length_scale) * w->def.time_step;
    return td_min_double(limit, (double)block->point[k].start_separation[at->lane] + recovery);
}

/* Whether a contact point overlaps more than at the start of the step, and more than min_separation
 * allows. */
static bool sank_too_deep(const thud_world *w, const td_lane *at, int k, float share) {
    const td_point *p = &at->block->point[k];
    double now = (double)p->separation[at->lane];
    return p->normal_mass[at->lane] > 0.0f && now < (double)p->start_separation[at->lane] &&
           now < min_separation(w, at, k, share);
}

/* Corrects the points of a contact with a static shape: motions to the least separation, velocities
 * of points that touch to >= 0. */
static void correct_contact(const tied_group *g, const td_constraint *constraint) {
    if (!td_is_contact(constraint)) {
        return;
    }
    td_lane at = td_lane_of(g->w, constraint);
    int points = td_form_points(g->w->kinds[constraint->kind]->form);
    for (int k = 0; k < points && is_static_contact(constraint, &at); k++) {
        td_point *p = &at.block->point[k];
        row_direction n = contact_normal(&at, k);
        double speed = row_value(g, &at, &n);
        if (p->normal_mass[at.lane] == 0.0f) {
            continue;
        }
        if (!g->on_velocities) {
            double now = (double)p->start_separation[at.lane] + speed;
            change_row_value(g, &at, &n,
                             td_max_double(min_separation(g->w, &at, k, DEPTH_SHARE_MAX) - now,
                                           0.0));
        } else if (p->separation[at.lane] <= 0.0f) {
            change_row_value(g, &at, &n, td_max_double(-speed, 0.0));
        }
    }
}

/* ---- locked directions ---- */

/* The part of the gap `now` that has to be closed, with its sign. A gap that was `before` wide as
 * the step began closes at TD_JOINT_CLOSING_SPEED at most, and may stay as wide as that leaves it.
 * `unit`: td_gap_unit. */
static double excess_gap(const thud_world *w, double before, double now, double unit) {
    double closed = (double)TD_JOINT_CLOSING_SPEED * unit * w->def.time_step;
    double left = td_max_double(td_abs(before) - closed, 0.0);
    return now > left ? now - left : now < -left ? now + left : 0.0;
}

/* Corrects a locked row with gaps `before` the step and `now`: its gap, or its speed to 0. `unit`:
 * td_gap_unit of the row. */
static void correct_row(const tied_group *g, const td_lane *at, const row_direction *n,
                        double before, double now, double unit) {
    double change = g->on_velocities ? -row_value(g, at, n) : -excess_gap(g->w, before, now, unit);
    change_row_value(g, at, n, change);
}

/* A locked distance: one row along the line between the anchors as it is after the motion. */
static void correct_rod(const tied_group *g, const td_lane *at) {
    double a[3], b[3], target = (double)td_lock_rows_at(at->block)->rest_length[at->lane];
    double before = (double)at->block->point[0].start_separation[at->lane];
    td_joint_motion(g->w, at->block, at->lane, a, b);
    td_joint_frame f = td_joint_line_after(at->block, at->lane, before + target, 0.0, a, b);
    correct_row(g, at, &(row_direction){f.x, f.y, f.a_u, f.b_u}, before, f.gap_u - target,
                td_gap_unit(g->w, false));
}

/* The frame of a lock's lane after the motion of the step with the corrections made so far. */
static td_joint_frame frame_of(const tied_group *g, const td_lane *at) {
    double a[3], b[3];
    const td_point *p = at->block->point;
    td_joint_motion(g->w, at->block, at->lane, a, b);
    return td_joint_frame_after(at->block, at->lane, (double)p[0].start_separation[at->lane],
                                (double)p[1].start_separation[at->lane],
                                td_lock_rows_at(at->block)->frame_turns[at->lane] > 0.0f, a, b);
}

/* The locked directions of a lane: turn, along, across. Each correction starts from the motion that
 * the one before it has corrected. */
static void correct_lock(const tied_group *g, const td_lane *at) {
    const td_block *block = at->block;
    const td_point *p = block->point;
    const td_lock_rows *rows = td_lock_rows_at(block);
    if (block->tangent_mass[at->lane] > 0.0f) {
        double a[3], b[3], sign = (double)rows->turn_sign[at->lane];
        double before = (double)rows->start_turn_gap[at->lane];
        td_joint_motion(g->w, block, at->lane, a, b);
        correct_row(g, at, &(row_direction){0.0, 0.0, sign, sign}, before,
                    before + sign * (b[2] - a[2]), td_gap_unit(g->w, true));
    }
    for (int k = 0; k < 2; k++) {
        if (p[k].normal_mass[at->lane] > 0.0f) {
            td_joint_frame f = frame_of(g, at);
            row_direction along = {f.x, f.y, f.a_u, f.b_u}, across = {-f.y, f.x, f.a_v, f.b_v};
            correct_row(g, at, k ? &across : &along, (double)p[k].start_separation[at->lane],
                        k ? f.gap_v : f.gap_u, td_gap_unit(g->w, false));
        }
    }
}

static void correct_lock_or_rod(const tied_group *g, const td_constraint *constraint) {
    if (constraint->kind == TD_CONSTRAINT_ROD || constraint->kind == TD_CONSTRAINT_LOCK) {
        td_lane at = td_lane_of(g->w, constraint);
        if (constraint->kind == TD_CONSTRAINT_ROD) {
            correct_rod(g, &at);
        } else {
            correct_lock(g, &at);
        }
    }
}

/* ---- motors ---- */

static bool is_drive(int kind) {
    return kind >= TD_CONSTRAINT_DRIVE_LINE && kind <= TD_CONSTRAINT_DRIVE_TURN;
}

/* The row of a drive's direction, as it was at the start of the step. The direction of an axis
 * drive turns with body a, so that a's rotation moves the axis at b's anchor: a's lever arm reaches
 * to that anchor, not to its own. */
static row_direction drive_direction(const td_lane *at, int kind) {
    const td_block *block = at->block;
    const td_point *p = &block->point[0];
    const td_drive_rows *rows = td_drive_rows_at(block);
    double sign = (double)rows->turn_sign[at->lane];
    if (kind == TD_CONSTRAINT_DRIVE_TURN) {
        return (row_direction){0.0, 0.0, sign, sign};
    }
    double lever = kind == TD_CONSTRAINT_DRIVE_AXIS ? (double)rows->gap_v[at->lane] : 0.0;
    return (row_direction){(double)block->nx[at->lane], (double)block->ny[at->lane],
                           (double)p->cross_a[at->lane] - lever, (double)p->cross_b[at->lane]};
}

/* Whether a motor's impulse in the last substep was below its maximum force. False for drives
 * without a motor. */
static bool motor_below_max_force(const thud_world *w, const td_lane *at) {
    float max_force = td_drive_rows_at(at->block)->max_motor_force[at->lane];
    return td_joint_abs(at->block->tangent_impulse[at->lane]) <
           max_force * (float)(w->def.time_step / w->substeps);
}

/* Corrects a motor whose force is below its maximum: if the coordinate moves against the motor's
 * target speed, that motion (or speed) becomes 0. Locks and contacts, which are corrected after it,
 * may still move its bodies that way. */
static void correct_motor(const tied_group *g, const td_constraint *constraint) {
    if (!is_drive(constraint->kind)) {
        return;
    }
    td_lane at = td_lane_of(g->w, constraint);
    row_direction n = drive_direction(&at, constraint->kind);
    double target = (double)td_drive_rows_at(at.block)->motor_speed[at.lane];
    double speed = row_value(g, &at, &n);
    if (motor_below_max_force(g->w, &at) && speed * target <= 0.0) {
        change_row_value(g, &at, &n, -speed);
    }
}

/* ---- impulses and separations ---- */

/* Recomputes the separations of a contact with a static shape for the corrected motion. */
static void update_separations(const tied_group *g, const td_constraint *constraint) {
    td_lane at = td_lane_of(g->w, constraint);
    int points = td_form_points(g->w->kinds[constraint->kind]->form);
    for (int k = 0; k < points && is_static_contact(constraint, &at); k++) {
        row_direction n = contact_normal(&at, k);
        at.block->point[k].separation[at.lane] =
            at.block->point[k].start_separation[at.lane] + (float)row_value(g, &at, &n);
    }
}

static void clear_impulses(const thud_world *w, const td_constraint *constraint) {
    td_lane at = td_lane_of(w, constraint);
    int points = td_form_points(w->kinds[constraint->kind]->form);
    for (int k = 0; k < points; k++) {
        at.block->point[k].normal_impulse[at.lane] = 0.0f;
    }
    at.block->tangent_impulse[at.lane] = 0.0f;
}

/* Marks the lane of a joint's constraint as yielded (TD_LANE_LOST). Its impulses are kept until the
 * next step, since reports of forces and joint_break.c read them. */
static void mark_yielded(const tied_group *g, const td_constraint *constraint) {
    if (!td_is_contact(constraint)) {
        td_lane at = td_lane_of(g->w, constraint);
        at.block->mark[at.lane].rule = TD_LANE_LOST;
    }
}

/* Sets the impulses of a body's contacts with static shapes to 0. */
static void clear_static_contacts(const thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state == TD_TOUCHING && td_is_contact(constraint)) {
            td_lane at = td_lane_of(w, constraint);
            if (is_static_contact(constraint, &at)) {
                clear_impulses(w, constraint);
            }
        }
    }
}

/* Clears the impulses of the lanes that yielded in the last step, and updates their marks:
 * TD_LANE_LOST (yielded in the step that has just ended) becomes TD_LANE_WAS_LOST (yielded in the
 * step before the one that now begins). */
static void clear_yielded_lanes(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        bool yielded = block->mark[lane].rule & TD_LANE_LOST;
        block->mark[lane].rule = yielded ? TD_LANE_WAS_LOST : 0;
        if (yielded) {
            const td_constraint *constraint = td_constraint_at(w, block->constraint[lane]);
            clear_impulses(w, constraint);
            clear_static_contacts(w, constraint->body[0]);
            clear_static_contacts(w, constraint->body[1]);
        }
    }
}

void td_joints_clear_yielded(thud_world *w) {
    memcpy(w->scratch.before.data, w->velocity.data, (size_t)w->body_of.count * sizeof(float[4]));
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        for (int k = 0; k < run->count && run->kind >= TD_PAIR_COUNT; k++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + k);
            if (td_any_lane_marked(block,
                                   (td_lane_marks){.rule = TD_LANE_LOST | TD_LANE_WAS_LOST})) {
                clear_yielded_lanes(w, block);
            }
        }
    }
}

/* All passes over a group, for the motions or for the velocities. Motions are corrected for motors
 * only in the first half of the passes, so that locks can close again in the second half. */
static void run_passes(const tied_group *g) {
    for (int pass = 0; pass < GROUP_PASSES; pass++) {
        if (g->on_velocities || pass < GROUP_PASSES / 2) {
            for_each_constraint(g, correct_motor);
        }
        for_each_constraint(g, correct_lock_or_rod);
        for_each_constraint(g, correct_contact);
    }
    for (int pass = 0; pass < CONTACT_PASSES; pass++) {
        for_each_constraint(g, correct_contact);
    }
}

/* Twice the kinetic energy of a body with the speeds |velocity| + |`gain` * `times`| (component by
 * component): an upper bound for a body at `velocity` to which `gain` is added `times` times. */
static double twice_energy(const thud_world *w, td_awake_slot slot, const float *velocity,
                           const float *gain, float times) {
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    double v[3];
    for (int k = 0; k < 3; k++) {
        v[k] = td_abs((double)velocity[k]) + td_abs((double)(gain[k] * times));
    }
    double turning = body->inv_inertia > 0.0f ? v[2] * v[2] / (double)body->inv_inertia : 0.0;
    return (v[0] * v[0] + v[1] * v[1]) / (double)body->inv_mass + turning;
}

/* Scales the group's velocities down to the kinetic energy that it had before the step plus what
 * gravity and forces may have added. Rows with nearly opposite directions do not converge within
 * the passes, and leave velocities that are too large. */
static void limit_energy(const tied_group *g) {
    const thud_world *w = g->w;
    double before = 0.0, after = 0.0;
    td_awake_slot slot = g->first;
    do {
        const float *substep_gain = td_row(&w->substep_gain, slot);
        before += twice_energy(w, slot, td_row(&w->scratch.before, slot), substep_gain,
                               (float)w->substeps);
        after += twice_energy(w, slot, td_row(&w->velocity, slot), substep_gain, 0.0f);
        slot = td_next_tied(w, slot);
    } while (slot.at != g->first.at);
    float scale = after > before ? (float)__builtin_sqrt(before / after) : 1.0f;
    do {
        float *velocity = td_row(&w->velocity, slot);
        for (int k = 0; k < 3; k++) {
            velocity[k] *= scale;
        }
        slot = td_next_tied(w, slot);
    } while (slot.at != g->first.at);
}

/* Clamps the group's motions to the range that poses can represent (td_motion_held): corrections at
 * long lever arms may exceed it. */
static void clamp_motions(const tied_group *g) {
    td_awake_slot slot = g->first;
    do {
        float *delta = td_row(&g->w->delta, slot);
        for (int k = 0; k < 3; k++) {
            delta[k] = (float)td_motion_held(g->w, k, (double)delta[k]);
        }
        slot = td_next_tied(g->w, slot);
    } while (slot.at != g->first.at);
}

/* Corrects the motions and velocities of the group of `slot`, and marks its joints as yielded. */
static void correct_group(thud_world *w, td_awake_slot slot) {
    tied_group g = {.w = w, .first = slot};
    run_passes(&g);
    clamp_motions(&g);
    for_each_constraint(&g, update_separations);
    g.on_velocities = true;
    run_passes(&g);
    limit_energy(&g);
    for_each_constraint(&g, mark_yielded);
}

/* ---- which groups yield ---- */

/* Bits that mark a body, in scratch.parents by awake slot. */
enum {
    MARK_PRESSED = 1, /* a contact with a static shape is too deep, and a joint acts on the body */
    MARK_STALLED = 2, /* a motor misses its target speed, below its maximum force */
    MARK_EXCEEDED = 4 /* a limit was far exceeded as the step began */
};

/* Sets bits of the mark of a body. Slot 0, which stands for all static bodies, is never marked. */
static void mark_body(thud_world *w, td_awake_slot slot, int mark) {
    td_awake_slot *marks = w->scratch.parents.data;
    marks[slot.at].at |= slot.at > 0 ? mark : 0;
}

/* Whether a drive has a limit of length and no spring, and the limit was exceeded, as the step
 * began, by so much that its bias (TD_JOINT_GAP_SHARE of the gap in a substep) would close it
 * faster than TD_JOINT_CLOSING_SPEED: a rope that is much too short. The soft solver closes such a
 * limit slowly (max_limit_bias in wide_drive.c). Without limits the start_separation of point 0 is
 * 0. */
static bool limit_far_exceeded(const thud_world *w, const td_lane *at, int kind) {
    const td_drive_rows *rows = td_drive_rows_at(at->block);
    float far = TD_JOINT_CLOSING_SPEED / TD_JOINT_GAP_SHARE * w->length_scale *
                (float)(w->def.time_step / w->substeps);
    return kind != TD_CONSTRAINT_DRIVE_TURN &&
           at->block->point[0].start_separation[at->lane] < -far &&
           rows->frequency[at->lane] == 0.0f;
}

/* Whether a joint acts on a body. *yielded: whether one of the body's joints yielded in the step
 * before. */
static bool has_joints(const thud_world *w, td_awake_slot slot, bool *yielded) {
    bool any = false;
    *yielded = false;
    int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state == TD_TOUCHING && !td_is_contact(constraint)) {
            td_lane at = td_lane_of(w, constraint);
            any = true;
            *yielded |= (at.block->mark[at.lane].rule & TD_LANE_WAS_LOST) != 0;
        }
    }
    return any;
}

/* A motor that misses its target speed by no more than this share of it counts as not stalled.
 * Chosen; half and double change no test of yielding joints. */
#define STALL_SHARE 0.05f

/* Whether a drive lane has a motor that misses its target speed below its maximum force. */
static bool motor_stalls(const thud_world *w, const td_lane *at, int kind) {
    const tied_group g = {.w = (thud_world *)w, .on_velocities = true};
    row_direction n = drive_direction(at, kind);
    float target = td_drive_rows_at(at->block)->motor_speed[at->lane];
    return motor_below_max_force(w, at) &&
           td_joint_abs((float)row_value(&g, at, &n) - target) > STALL_SHARE * td_joint_abs(target);
}

/* The MARK_ bit that a lane gives its bodies, or 0. The lane is a drive, or a contact with a static
 * shape. */
static int lane_mark(const thud_world *w, const td_lane *at, const td_run *run) {
    if (run->kind >= TD_PAIR_COUNT) {
        return (motor_stalls(w, at, run->kind) ? MARK_STALLED : 0) |
               (limit_far_exceeded(w, at, run->kind) ? MARK_EXCEEDED : 0);
    }
    bool deep = false, far = false, yielded = false;
    for (int k = 0; k < td_form_points(w->kinds[run->kind]->form); k++) {
        deep |= sank_too_deep(w, at, k, DEPTH_SHARE_MAX);
        far |= sank_too_deep(w, at, k, DEPTH_SHARE_DETECT);
    }
    deep = deep && has_joints(w, td_slot_of_side(at->block->b[at->lane]), &yielded);
    return deep && (far || yielded) ? MARK_PRESSED : 0;
}

/* Sets the marks of all bodies. False if no body is marked; the marks are then not initialised. */
static bool mark_bodies(thud_world *w) {
    bool any = false;
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        bool contacts = run->kind < TD_PAIR_COUNT && run->kind != TD_PAIR_SENSOR && run->a_static;
        for (int k = 0; k < run->count * TD_LANES && (contacts || is_drive(run->kind)); k++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + k / TD_LANES);
            td_lane at = {block, k % TD_LANES};
            int mark = at.lane < block->used ? lane_mark(w, &at, run) : 0;
            if (mark && !any) {
                any = true;
                td_joints_tie(w);
                memset(w->scratch.parents.data, 0,
                       (size_t)w->body_of.count * sizeof(td_awake_slot));
            }
            if (mark) {
                mark_body(w, td_slot_of_side(block->a[at.lane]), mark);
                mark_body(w, td_slot_of_side(block->b[at.lane]), mark);
            }
        }
    }
    return any;
}

/* Results of inspecting the constraints of a group. */
typedef struct finding {
    bool touches_static; /* a contact with a static shape has an impulse or overlaps */
    /* A lock's gap is wider than depth_share of the group's smallest half extent, and wider than at
     * the start of the step. */
    bool locks_open;
    bool deep; /* a contact with a static shape overlaps more than it may (min_separation) */
} finding;

/* Whether a gap is wider than `tolerance`, and than before. */
static bool opened_wider(float now, float before, float tolerance) {
    return td_joint_abs(now) > td_max_float(tolerance, td_joint_abs(before));
}

/* Updates the group's finding by one of its constraints: sets the members that are true of the
 * constraint. */
static void inspect_constraint(const tied_group *g, const td_constraint *constraint) {
    finding *found = g->found;
    td_lane at = td_lane_of(g->w, constraint);
    const td_block *block = at.block;
    int lane = at.lane, points = td_form_points(g->w->kinds[constraint->kind]->form);
    bool on_static = is_static_contact(constraint, &at);
    bool locks = constraint->kind == TD_CONSTRAINT_ROD || constraint->kind == TD_CONSTRAINT_LOCK;
    for (int k = 0; k < points && on_static; k++) {
        const td_point *p = &block->point[k];
        found->touches_static |= p->normal_mass[lane] > 0.0f &&
                                 (p->normal_impulse[lane] > 0.0f || p->separation[lane] < 0.0f);
        found->deep |= p->normal_mass[lane] > 0.0f &&
                       (double)p->separation[lane] < min_separation(g->w, &at, k, g->depth_share);
    }
    for (int k = 0; k < points && locks; k++) {
        const td_point *p = &block->point[k];
        found->locks_open |= p->normal_mass[lane] > 0.0f &&
                             opened_wider(p->separation[lane], p->start_separation[lane],
                                          g->depth_share * g->min_half_extent);
    }
}

/* Whether the group of a marked body is to be corrected: see the head of the file. */
static bool group_must_yield(thud_world *w, td_awake_slot slot) {
    const td_awake_slot *marks = w->scratch.parents.data;
    finding found = {false, false, false};
    tied_group g = {.w = w,
                    .first = slot,
                    .found = &found,
                    .min_half_extent = 3e38f,
                    .depth_share = DEPTH_SHARE_DETECT};
    int mark = 0;
    td_awake_slot i = slot;
    do {
        bool yielded;
        mark |= marks[i.at].at;
        g.min_half_extent = td_min_float(g.min_half_extent, td_row(&w->reach, i)[0]);
        g.depth_share = has_joints(w, i, &yielded) && yielded ? DEPTH_SHARE_MAX : g.depth_share;
        i = td_next_tied(w, i);
    } while (i.at != slot.at);
    if (!(mark & MARK_PRESSED)) {
        for_each_constraint(&g, inspect_constraint);
    }
    return mark & MARK_PRESSED ||
           (found.touches_static && (found.locks_open || found.deep || mark & MARK_EXCEEDED));
}

void td_joints_yield(thud_world *w) {
    if (!mark_bodies(w)) {
        return;
    }
    td_awake_slot *marks = w->scratch.parents.data;
    bool any = false;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (!marks[slot.at].at) {
            continue;
        }
        if (group_must_yield(w, slot)) {
            any = true;
            correct_group(w, slot);
        }
        td_awake_slot i = slot;
        do {
            marks[i.at].at = 0;
            i = td_next_tied(w, i);
        } while (i.at != slot.at);
    }
    if (any) {
        td_errors_recount(w);
    }
}
