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
#include "constraint/joining.h"
#include "joints/joint.h"

/* The forces that a lane's spring and motor would give if they had no caps. */
typedef struct wants {
    double spring, motor;
} wants;

/* The spring's force is that of where it is and how fast; the motor goes on with the force of the
 * last substep, and with what would take its bodies to its speed by the end of the step. */
static wants wants_of(const thud_world *w, td_lane at) {
    const td_block *block = at.block;
    const td_drive_rows *r = td_drive_rows_at(block);
    const double still[3] = {0.0, 0.0, 0.0};
    td_joint_frame f = td_joint_frame_after(block, at.lane, (double)r->gap_u[at.lane],
                                            (double)r->gap_v[at.lane], true, still, still);
    double speed = (double)td_joint_speed(w, block, at.lane, f.x, f.y, f.a_u, f.b_u);
    float inverse = td_joint_inverse_mass(w, block, at.lane, 1.0f, (float)f.a_u, (float)f.b_u);
    double mass = inverse > 0.0f ? 1.0 / (double)inverse : 0.0;
    double omega = td_spring_omega(w, r->frequency[at.lane]);
    double drag = 2.0 * (double)r->damping[at.lane] * speed;
    double lack = mass * ((double)r->motor_speed[at.lane] - speed);
    return (wants){mass * omega * (omega * (double)block->point[1].base[at.lane] + drag),
                   (w->substeps * (double)block->tangent_impulse[at.lane] + lack) /
                       w->def.time_step};
}

/* Whether two caps are of one vector: both directions act, and both have a cap. */
static bool is_shared(bool both, float most_u, float most_v) {
    float most = td_max_float(most_u, most_v);
    return both && most > 0.0f && most < THUD_JOINT_FORCE_MAX;
}

typedef struct bounds {
    float u, v;
} bounds;

/* For wanted forces (u, v), whose directions have these caps. */
static bounds share(double u, double v, float most_u, float most_v) {
    double most = (double)td_max_float(most_u, most_v);
    u = td_abs(u) / most;
    v = td_abs(v) / most;
    double length = __builtin_sqrt(u * u + v * v);
    if (!td_finite(length)) {
        u = v = length = 0.0;
    }
    double scale = length > 1.0 ? 1.0 / length : 1.0;
    double room = length < 1.0 ? 0.5 * (__builtin_sqrt(2.0 - (u - v) * (u - v)) - (u + v)) : 0.0;
    u = scale * u + room;
    v = scale * v + room;
    if (most * u > (double)most_u) {
        u = (double)most_u / most;
        v = __builtin_sqrt(1.0 - u * u);
    } else if (most * v > (double)most_v) {
        v = (double)most_v / most;
        u = __builtin_sqrt(1.0 - v * v);
    }
    return (bounds){(float)(most * u), (float)(most * v)};
}

static void share_of_joint(const thud_world *w, const td_joint *joint, td_lane u, td_lane v) {
    td_drive_rows *rows_u = td_drive_rows_of(u.block), *rows_v = td_drive_rows_of(v.block);
    const td_drive *along = &joint->drive[THUD_ALONG], *across = &joint->drive[THUD_ACROSS];
    bool springs = is_shared(along->frequency > 0.0f && across->frequency > 0.0f,
                             along->spring_force, across->spring_force);
    bool motors = is_shared(along->motor_force > 0.0f && across->motor_force > 0.0f,
                            along->motor_force, across->motor_force);
    if (!springs && !motors) {
        return;
    }
    wants want_u = wants_of(w, u), want_v = wants_of(w, v);
    if (springs) {
        bounds b = share(want_u.spring, want_v.spring, along->spring_force, across->spring_force);
        rows_u->spring_most[u.lane] = b.u;
        rows_v->spring_most[v.lane] = b.v;
    }
    if (motors) {
        bounds b = share(want_u.motor, want_v.motor, along->motor_force, across->motor_force);
        rows_u->motor_most[u.lane] = b.u;
        rows_v->motor_most[v.lane] = b.v;
    }
}

static void share_of_block(const thud_world *w, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        const td_joint *joint = td_joint_of(w, td_constraint_at(w, block->constraint[lane]));
        bool across = td_drive_rows_of(block)->across[lane] != 0;
        if (across && joint->part[THUD_ALONG] != TD_NONE) {
            td_lane along = td_lane_of(w, td_constraint_at(w, joint->part[THUD_ALONG]));
            share_of_joint(w, joint, along, (td_lane){block, lane});
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
