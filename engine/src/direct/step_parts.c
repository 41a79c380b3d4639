/* step_parts.c: chooses the number of parts of a step from the rotation of bodies, the phase of
 * springs and the number of substeps. */
#include "direct/step_parts.h"

/* Greatest rotation of a lever arm or rod in a part, rad. Newton's method converges well up to that
 * angle. Chosen. Islands that would need PARTS_MAX to twice PARTS_MAX parts are solved with
 * PARTS_MAX, those that would need more are left to the soft solver. */
#define TURN_PART 0.1
enum { PARTS_MAX = 64 };
/* Greatest phase of a spring in a part, rad: 2 pi frequency time. The implicit midpoint rule lowers
 * the frequency by phase^2 / 12, which is 2 % here. The phase in a whole step counts up to
 * PHASE_MAX: a spring with more than half the step rate cannot be told from a slower one by the
 * poses at the ends of steps (aliasing). */
#define PHASE_PART 0.5
#define PHASE_MAX TD_PI
/* In islands without contacts, a part is no longer than SUBSTEPS_OF_PART substeps, and the parts
 * that springs need are multiplied likewise, so that the error falls as the number of substeps
 * rises. The quality `default` has four substeps, so that its steps have one part where neither
 * rotation nor springs need more. This holds for islands of up to SMALL_ISLAND_BODIES bodies (a
 * pendulum, a vehicle, a ragdoll); finer parts for all islands made a chain of 100 links 2.2 times
 * as expensive at the quality `exact`, and a phase error is not visible among its many modes. */
enum { SUBSTEPS_OF_PART = 4, SMALL_ISLAND_BODIES = 16 };

/* Component k of the linear velocity before the step of a constraint's side, length/s. `body`: its
 * number in the island, or TD_NONE: it is static or kinematic. */
static double side_speed(const td_island_work *work, int body, uint32_t record, int k) {
    return body == TD_NONE ? (double)td_row(&work->w->velocity, td_slot_of_side(record))[k]
                           : work->problem.bodies[body].before[k];
}

/* The angular speed, rad/s, that the line between a distance's anchors has at most by the linear
 * velocities of its bodies before the step: |v_b - v_a| / length. The speeds of the anchors by the
 * bodies' rotation are not part of it: they count through `sweeps`. 0 for other kinds of joints. */
static double line_rate(const td_island_work *work, int i) {
    const td_direct_constraint *c = &work->problem.constraints[i];
    td_lane at = td_island_lane(work, i);
    double length = 0.0, speed = 0.0;
    if (c->kind == TD_CONSTRAINT_ROD) {
        length = (double)td_lock_rows_at(at.block)->rest_length[at.lane];
    } else if (c->kind == TD_CONSTRAINT_DRIVE_LINE) {
        length = (double)td_drive_rows_at(at.block)->start_value[at.lane];
    }
    for (int k = 0; k < 2 && length > 0.0; k++) {
        double gained = side_speed(work, c->b, at.block->b[at.lane], k) -
                        side_speed(work, c->a, at.block->a[at.lane], k);
        speed += gained * gained;
    }
    return length > 0.0 ? __builtin_sqrt(speed) / length : 0.0;
}

static bool is_drive(int kind) {
    return kind == TD_CONSTRAINT_DRIVE_LINE || kind == TD_CONSTRAINT_DRIVE_AXIS ||
           kind == TD_CONSTRAINT_DRIVE_TURN;
}

/* The greatest phase of a spring in the step, rad. */
static double spring_phase(const td_island_work *work) {
    double fastest = 0.0;
    for (int i = 0; i < work->island->constraints; i++) {
        if (is_drive(work->problem.constraints[i].kind)) {
            td_lane at = td_island_lane(work, i);
            double frequency = (double)td_drive_rows_at(at.block)->frequency[at.lane];
            fastest = td_max_double(fastest, frequency);
        }
    }
    return td_min_double(2.0 * TD_PI * fastest * work->time, PHASE_MAX);
}

/* An anchor nearer to the body's centre of mass than this, in length scales, counts as being at the
 * centre, so that rotation does not move it. More than a hundred times the rounding (2^-24) of a
 * float of one length scale. */
#define CENTRED 1e-5

bool td_arm_is_centred(const thud_world *w, double x, double y) {
    double arm_max = CENTRED * (double)w->length_scale;
    return td_abs(x) <= arm_max && td_abs(y) <= arm_max;
}

static bool is_centred(const td_island_work *work, float cross_u, float cross_v) {
    return td_arm_is_centred(work->w, (double)cross_u, (double)cross_v);
}

/* Sets `sweeps` of a joint's bodies: whether a rotation moves an anchor, or the axis of the joint's
 * frame, which turns with body a. */
static void set_sweeps(td_island_work *work, int i) {
    const td_direct_constraint *c = &work->problem.constraints[i];
    int kind = c->kind;
    td_lane at = td_island_lane(work, i);
    const td_point *p = &at.block->point[0], *q = &at.block->point[1];
    bool turns =
        kind == TD_CONSTRAINT_DRIVE_AXIS || kind == TD_CONSTRAINT_GEAR ||
        (kind == TD_CONSTRAINT_LOCK && td_lock_rows_at(at.block)->frame_turns[at.lane] > 0.0f);
    if (kind == TD_CONSTRAINT_DRIVE_TURN) {
        return;
    }
    if (c->a != TD_NONE) {
        work->problem.bodies[c->a].sweeps |=
            turns || !is_centred(work, p->cross_a[at.lane], q->cross_a[at.lane]);
    }
    if (c->b != TD_NONE) {
        work->problem.bodies[c->b].sweeps |=
            kind == TD_CONSTRAINT_GEAR ||
            !is_centred(work, p->cross_b[at.lane], q->cross_b[at.lane]);
    }
}

/* Sets `sweeps` and `turn_limited` of all bodies. */
static void set_turn_flags(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        work->problem.bodies[i].turn_limited = false;
    }
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &work->problem.constraints[i];
        const int sides[] = {c->a, c->b};
        if (c->kind >= TD_PAIR_COUNT) {
            set_sweeps(work, i);
            continue;
        }
        for (int side = 0; side < 2; side++) {
            if (sides[side] != TD_NONE) {
                work->problem.bodies[sides[side]].turn_limited |=
                    !td_island_is_disc(work, sides[side]);
            }
        }
    }
}

int td_parts_of(const thud_world *w, const td_island *island, double fastest, bool joints,
                double phase) {
    double parts = td_max_double(fastest * w->def.time_step / TURN_PART, 1.0);
    if (!(parts < 2 * PARTS_MAX)) {
        return 0;
    }
    if (joints) {
        bool small = island->bodies <= SMALL_ISLAND_BODIES;
        double finer = small ? (double)w->substeps / SUBSTEPS_OF_PART : 1.0;
        parts = td_max_double(parts, finer * td_max_double(phase / PHASE_PART, 1.0));
    }
    int whole = parts < PARTS_MAX ? (int)parts : PARTS_MAX;
    return whole < PARTS_MAX && whole < parts ? whole + 1 : whole;
}

int td_island_parts(td_island_work *work) {
    set_turn_flags(work);
    double fastest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        double soft = (double)td_row(&work->w->velocity, work->slots[i])[2];
        double before = work->problem.bodies[i].before[2];
        double rate = td_max_double(td_abs(soft), td_abs(before));
        fastest = work->problem.bodies[i].sweeps ? td_max_double(fastest, rate) : fastest;
    }
    for (int i = 0; i < work->island->constraints; i++) {
        fastest = td_max_double(fastest, line_rate(work, i));
    }
    double phase = td_island_is_joints(work) ? spring_phase(work) : 0.0;
    return td_parts_of(work->w, work->island, fastest, td_island_is_joints(work), phase);
}

bool td_island_turns_too_far(const td_island_work *work) {
    bool any = false;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        any |= b->turn_limited && td_abs(b->moved[2]) > work->turn_max;
    }
    return any;
}
