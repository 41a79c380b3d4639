/* joint_caps.c: greatest forces of springs and motors that act both along and across.
 *
 * Both directions are rows of their own, each with a bound. So that the two forces together are no
 * longer than the greater cap R, the bounds are the sides of a rectangle with its corner on the
 * circle of radius R. Once a step the corner is chosen by the force F = (F_u, F_v) that the drive
 * would give without a cap:
 *     |F| >= R: in the direction of F, so that the pull is R towards where it is wanted;
 *     |F| < R:  (|F_u| + s, |F_v| + s), with the same room s >= 0 in both directions.
 * Both agree where |F| = R, and the corner follows F continuously. No direction passes its own cap,
 * and the other one has the room that this leaves. */
#include "constraint/joint_hooks.h"
#include "joints/joint.h"

/* The force that a lane's motor or spring would give if it had no cap, of either sign. The spring's
 * is that of where it is and how fast; the motor goes on with the force of the last substep, and
 * with what would take its bodies to its speed by the end of the step. */
static double wanted(const thud_world *w, td_lane at, bool motor) {
    const td_block *block = at.block;
    const td_drive_rows *r = td_drive_rows_at(block);
    float cross_a = block->point[0].cross_a[at.lane] - r->gap_v[at.lane];
    float cross_b = block->point[0].cross_b[at.lane];
    float inverse = td_joint_inverse_mass(w, block, at.lane, 1.0f, cross_a, cross_b);
    double mass = inverse > 0.0f ? 1.0 / (double)inverse : 0.0;
    double speed =
        (double)td_joint_speed(w, block, at.lane, (double)block->nx[at.lane],
                               (double)block->ny[at.lane], (double)cross_a, (double)cross_b);
    if (motor) {
        double lack = mass * ((double)r->motor_speed[at.lane] - speed);
        return (w->substeps * (double)block->tangent_impulse[at.lane] + lack) / w->def.time_step;
    }
    double omega = td_spring_omega(w, r->frequency[at.lane]);
    return mass * omega *
           (omega * (double)block->point[1].base[at.lane] +
            2.0 * (double)r->damping[at.lane] * speed);
}

static double cap_of(const td_drive *d, bool motor) {
    return (double)(motor ? d->motor_force : d->frequency > 0.0f ? d->spring_force : 0.0f);
}

static f8 *bounds_of(td_lane at, bool motor) {
    td_drive_rows *r = td_drive_rows_of(at.block);
    return motor ? &r->motor_most : &r->spring_most;
}

/* Nothing is shared where only one direction acts, or one has no cap. */
static void share(const thud_world *w, const td_joint *joint, td_lane along, td_lane across,
                  bool motor) {
    double cap_u = cap_of(&joint->drive[THUD_ALONG], motor);
    double cap_v = cap_of(&joint->drive[THUD_ACROSS], motor);
    double most = td_max_double(cap_u, cap_v);
    if (!(cap_u > 0.0 && cap_v > 0.0 && most < (double)THUD_JOINT_FORCE_MAX)) {
        return;
    }
    double u = td_abs(wanted(w, along, motor)) / most;
    double v = td_abs(wanted(w, across, motor)) / most;
    double length = __builtin_sqrt(u * u + v * v);
    if (!td_finite(length)) {
        u = v = length = 0.0;
    }
    double scale = length > 1.0 ? 1.0 / length : 1.0;
    double room = length < 1.0 ? 0.5 * (__builtin_sqrt(2.0 - (u - v) * (u - v)) - (u + v)) : 0.0;
    u = scale * u + room;
    v = scale * v + room;
    if (most * u > cap_u) {
        u = cap_u / most;
        v = __builtin_sqrt(1.0 - u * u);
    } else if (most * v > cap_v) {
        v = cap_v / most;
        u = __builtin_sqrt(1.0 - v * v);
    }
    (*bounds_of(along, motor))[along.lane] = (float)(most * u);
    (*bounds_of(across, motor))[across.lane] = (float)(most * v);
}

static void share_of_block(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        const td_joint *joint = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
        bool across = td_drive_rows_of(block)->across[lane] != 0;
        if (across && joint->part[THUD_ALONG] != TD_NONE) {
            td_lane along = td_lane_of(w, td_constraint_at(w, joint->part[THUD_ALONG]));
            share(w, joint, along, (td_lane){block, lane}, false);
            share(w, joint, along, (td_lane){block, lane}, true);
        }
    }
}

void td_joints_share_caps(thud_world *w) {
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        for (int k = 0; run->kind == TD_CONSTRAINT_DRIVE_AXIS && k < run->count; k++) {
            share_of_block(w, *TD_AT(td_block *, &w->scratch.blocks, run->first + k));
        }
    }
}
