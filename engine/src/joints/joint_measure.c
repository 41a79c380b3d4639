/* joint_measure.c: measurements of joints: coordinates, gaps, forces, and the sums of the step's
 * error report.
 *
 * Forces are the impulses of the last substep over its length, s. An impulse of a part's lane acts
 * on side b along its Jacobian: J' impulse. */
#include "constraint/joint_hooks.h"
#include "joints/gear.h"

/* The signed error of a coordinate: the coordinate itself if the direction is locked, else by how
 * much it exceeds a limit, else 0. */
static double error_of(const td_joint *joint, int direction, double value) {
    const td_drive *d = &joint->drive[direction];
    if (joint->locked >> direction & 1u) {
        return value;
    }
    if (!d->limited || !(td_joint_drivable(joint->kind) >> direction & 1u)) {
        return 0.0;
    }
    return td_max_double(value - (double)d->upper, 0.0) +
           td_min_double(value - (double)d->lower, 0.0);
}

/* A gear's coordinate and gap are those of its equation (gear.c): a length, or rad. */
static td_joint_reading read_gear(const thud_world *w, const td_joint *joint) {
    if (!td_gear_has_joints(w, joint) || joint->gear.apart) {
        return (td_joint_reading){0};
    }
    double gap = td_gear_gap(w, joint);
    bool turns = td_gear_by_angle(td_joint_at(w, joint->gear.joint[0]));
    td_joint_reading r = {.gap = turns ? 0.0 : td_abs(gap), .angle_gap = turns ? td_abs(gap) : 0.0};
    r.value[turns ? THUD_DIRECTION_TURN : THUD_DIRECTION_ALONG] = gap;
    return r;
}

td_joint_reading td_joint_read(const thud_world *w, const td_joint *joint) {
    if (joint->kind == THUD_JOINT_GEAR) {
        return read_gear(w, joint);
    }
    td_joint_place place = td_joint_place_of(w, joint);
    double x = (double)place.x, y = (double)place.y;
    double u = (double)place.axis_x, v = (double)place.axis_y;
    td_joint_reading r = {.value = {x * u + y * v, y * u - x * v, (double)place.turn}};
    if (joint->kind == THUD_JOINT_DISTANCE) {
        r.value[THUD_DIRECTION_ALONG] = __builtin_sqrt(x * x + y * y);
        r.value[THUD_DIRECTION_ACROSS] = 0.0;
        double off = joint->locked
                         ? r.value[THUD_DIRECTION_ALONG] - (double)joint->length
                         : error_of(joint, THUD_DIRECTION_ALONG, r.value[THUD_DIRECTION_ALONG]);
        r.gap = td_abs(off);
        return r;
    }
    double along = error_of(joint, THUD_DIRECTION_ALONG, r.value[THUD_DIRECTION_ALONG]);
    double across = error_of(joint, THUD_DIRECTION_ACROSS, r.value[THUD_DIRECTION_ACROSS]);
    r.gap = __builtin_sqrt(along * along + across * across);
    r.angle_gap = td_abs(error_of(joint, THUD_DIRECTION_TURN, r.value[THUD_DIRECTION_TURN]));
    return r;
}

/* Adds the impulse (x, y, and the moment of turn) of a part on side b in the last substep. Of gears
 * the moment about b's centre of mass is complete; of all other parts the moment of (x, y) about
 * that centre is left out. */
static void add_impulse(const thud_world *w, const td_constraint *part, double impulse[3]) {
    if (part->state != TD_TOUCHING) {
        return;
    }
    td_lane at = td_lane_of(w, part);
    double first = (double)at.block->point[0].normal_impulse[at.lane];
    double x = (double)at.block->nx[at.lane], y = (double)at.block->ny[at.lane];
    double third = (double)at.block->tangent_impulse[at.lane];
    if (part->kind == TD_CONSTRAINT_ROD) {
        impulse[0] += x * first;
        impulse[1] += y * first;
        return;
    }
    if (part->kind == TD_CONSTRAINT_GEAR) {
        impulse[0] += x * first;
        impulse[1] += y * first;
        impulse[2] += (double)at.block->point[0].cross_b[at.lane] * first;
        return;
    }
    double second = (double)at.block->point[1].normal_impulse[at.lane];
    if (part->kind == TD_CONSTRAINT_LOCK) {
        impulse[0] += x * first - y * second;
        impulse[1] += y * first + x * second;
        impulse[2] += (double)td_lock_rows_at(at.block)->turn_sign[at.lane] * third;
        return;
    }
    const td_drive_rows *rows = td_drive_rows_at(at.block);
    double along = (double)rows->limit_side[at.lane] * first + second + third;
    bool turns = part->kind == TD_CONSTRAINT_DRIVE_TURN;
    impulse[0] += turns ? 0.0 : x * along;
    impulse[1] += turns ? 0.0 : y * along;
    impulse[2] += turns ? (double)rows->turn_sign[at.lane] * along : 0.0;
}

/* Clamps a force to THUD_JOINT_FORCE_MAX: with a time step near 0 it may be infinite. Not-a-number
 * becomes 0. */
static float bounded_force(double x) {
    double max_force = (double)THUD_JOINT_FORCE_MAX;
    return x > max_force    ? (float)max_force
           : x < -max_force ? (float)-max_force
           : x == x         ? (float)x
                            : 0.0f;
}

/* Substeps per second: the factor from an impulse in a substep to its mean force. */
static double force_per_impulse(const thud_world *w) {
    return w->substeps / w->def.time_step;
}

td_joint_load td_joint_load_of(const thud_world *w, const td_joint *joint) {
    double impulse[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        if (joint->part[i] != TD_NONE) {
            add_impulse(w, td_constraint_at(w, joint->part[i]), impulse);
        }
    }
    double rate = (joint->swapped ? -1.0 : 1.0) * force_per_impulse(w);
    return (td_joint_load){{bounded_force(rate * impulse[0]), bounded_force(rate * impulse[1])},
                           bounded_force(rate * impulse[2])};
}

/* Positive forces increase the coordinate. Swapped sides make no difference, as coordinates are for
 * the caller's order of bodies. */
thud_drive_forces td_joint_drive_forces(const thud_world *w, const td_joint *joint, int direction) {
    int index = joint->part[direction];
    const td_constraint *part = index == TD_NONE ? NULL : td_constraint_at(w, index);
    if (!part || part->state != TD_TOUCHING) {
        return (thud_drive_forces){0};
    }
    td_lane at = td_lane_of(w, part);
    double side = (double)td_drive_rows_at(at.block)->limit_side[at.lane],
           rate = force_per_impulse(w);
    return (thud_drive_forces){
        .limit = bounded_force(rate * side * (double)at.block->point[0].normal_impulse[at.lane]),
        .spring = bounded_force(rate * (double)at.block->point[1].normal_impulse[at.lane]),
        .motor = bounded_force(rate * (double)at.block->tangent_impulse[at.lane])};
}

/* The number of a joint's parts that have lanes, asleep or awake; *awake: how many are awake. */
static int count_lanes(const thud_world *w, const td_joint *joint, int *awake) {
    int lanes = 0;
    *awake = 0;
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        const td_constraint *part =
            joint->part[i] == TD_NONE ? NULL : td_constraint_at(w, joint->part[i]);
        bool has_lane = part && part->state == TD_TOUCHING;
        lanes += has_lane;
        *awake += has_lane && part->bin != TD_SLEEPING;
    }
    return lanes;
}

bool td_joint_acts(const thud_world *w, const td_joint *joint) {
    int awake;
    count_lanes(w, joint, &awake);
    return awake > 0;
}

void td_joints_measure(const thud_world *w, td_joint_gaps *gaps) {
    int count = 0, awake;
    for (int i = 0; i < w->joints.count; i++) {
        const td_joint *joint = td_joint_at(w, i);
        if (joint->live && count_lanes(w, joint, &awake) > 0) {
            td_joint_reading r = td_joint_read(w, joint);
            gaps->worst = td_max_double(gaps->worst, r.gap);
            gaps->angle = td_max_double(gaps->angle, r.angle_gap);
            gaps->mean += r.gap;
            count++;
        }
    }
    gaps->mean /= count ? count : 1;
}
