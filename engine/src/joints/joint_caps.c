/* joint_caps.c: maximum forces (caps) of springs and motors that act both along and across.
 *
 * Each direction is a row of its own with its own bound, so that both forces together could exceed
 * the greater cap R by a factor of sqrt(2). To keep their resultant within R, the bounds are the
 * sides of a rectangle with its corner on the circle of radius R. The corner is chosen once a step
 * by the force F = (F_u, F_v) that the drive would apply without a cap:
 *     |F| >= R: R F / |F|, so that the drive pulls with R in the direction of F;
 *     |F| <  R: (|F_u| + s, |F_v| + s), with the s >= 0 that puts it on the circle.
 * Both agree where |F| = R, so that the corner is a continuous function of F. Where the corner
 * exceeds a direction's own cap, it moves along the circle to that cap. */
#include "constraint/joint_hooks.h"
#include "joints/joint.h"

/* The force that a lane's motor or spring would apply without a cap. That of the spring is returned
 * with the opposite sign, since the caller uses its magnitude only. With m the effective mass of
 * the direction:
 *     spring: m omega (omega x + 2 damping v), for its displacement x and speed v;
 *     motor: the mean force of the last substep's impulse, plus m (target speed - v) / dt, which
 *            would reach its target speed by the end of the step. */
static double uncapped_force(const thud_world *w, td_lane at, bool motor) {
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
        double missing = mass * ((double)r->motor_speed[at.lane] - speed);
        return (w->substeps * (double)block->tangent_impulse[at.lane] + missing) / w->def.time_step;
    }
    double omega = td_spring_omega(w, r->frequency[at.lane]);
    return mass * omega *
           (omega * (double)block->point[1].start_separation[at.lane] +
            2.0 * (double)r->damping[at.lane] * speed);
}

/* The cap of a direction's motor, or, where `motor` is false, of its spring; 0 where the direction
 * has none. */
static double cap_of(const td_drive *d, bool motor) {
    return (double)(motor ? d->motor_force : d->frequency > 0.0f ? d->spring_force : 0.0f);
}

/* The row of the lane's block that bounds the force of its motor or spring. */
static f8 *bounds_of(td_lane at, bool motor) {
    td_drive_rows *r = td_drive_rows_of(at.block);
    return motor ? &r->max_motor_force : &r->max_spring_force;
}

/* Sets the bounds of both directions of a joint's springs or motors. Bounds stay equal to the caps
 * where one direction has no spring (or motor), or where the greater cap is unlimited. */
static void share_cap(const thud_world *w, const td_joint *joint, td_lane along, td_lane across,
                      bool motor) {
    double cap_u = cap_of(&joint->drive[THUD_DIRECTION_ALONG], motor);
    double cap_v = cap_of(&joint->drive[THUD_DIRECTION_ACROSS], motor);
    double radius = td_max_double(cap_u, cap_v);
    if (!(cap_u > 0.0 && cap_v > 0.0 && radius < (double)THUD_JOINT_FORCE_MAX)) {
        return;
    }
    double u = td_abs(uncapped_force(w, along, motor)) / radius;
    double v = td_abs(uncapped_force(w, across, motor)) / radius;
    double length = __builtin_sqrt(u * u + v * v);
    if (!td_finite(length)) {
        u = v = length = 0.0;
    }
    double scale = length > 1.0 ? 1.0 / length : 1.0;
    double room = length < 1.0 ? 0.5 * (__builtin_sqrt(2.0 - (u - v) * (u - v)) - (u + v)) : 0.0;
    u = scale * u + room;
    v = scale * v + room;
    if (radius * u > cap_u) {
        u = cap_u / radius;
        v = __builtin_sqrt(1.0 - u * u);
    } else if (radius * v > cap_v) {
        v = cap_v / radius;
        u = __builtin_sqrt(1.0 - v * v);
    }
    (*bounds_of(along, motor))[along.lane] = (float)(radius * u);
    (*bounds_of(across, motor))[across.lane] = (float)(radius * v);
}

/* Calls share_cap for the joints of lanes that drive `across` and also have a drive `along`. */
static void share_caps_of_block(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        const td_joint *joint = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
        bool across = td_drive_rows_of(block)->across[lane] != 0;
        if (across && joint->part[THUD_DIRECTION_ALONG] != TD_NONE) {
            td_lane along = td_lane_of(w, td_constraint_at(w, joint->part[THUD_DIRECTION_ALONG]));
            share_cap(w, joint, along, (td_lane){block, lane}, false);
            share_cap(w, joint, along, (td_lane){block, lane}, true);
        }
    }
}

void td_joints_share_caps(thud_world *w) {
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        for (int k = 0; run->kind == TD_CONSTRAINT_DRIVE_AXIS && k < run->count; k++) {
            share_caps_of_block(w, *TD_AT(td_block *, &w->scratch.blocks, run->first + k));
        }
    }
}
