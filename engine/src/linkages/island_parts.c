/* island_parts.c: see island_parts.h. */
#include "linkages/island_parts.h"

/* Arms and lines that turn by more than this in a part of a step, rad, get more parts. What turns
 * faster than the most parts can follow is left to the soft solver. */
#define TURN_PART 0.1
enum { PARTS = 64 };
/* The phase of a spring by which a part of the step may take it, rad: its frequency is low by the
 * square of that over 12, as the implicit midpoint rule has it, here by 2 %. Springs of more than
 * half the rate of steps, whose phase is PHASE_MAX in a step, cannot be told from slower ones from
 * outside, and get no more parts. */
#define PHASE_PART 0.5
#define PHASE_MAX TD_PI
/* Where nothing but joints acts, a part of the step is no longer than so many substeps, and there
 * are as many times more of those that springs get: more substeps are to err less. Four are those
 * of default, which has islands solved directly where they would give way, and not for their phase.
 * It is so in islands of up to FEW_BODIES: a pendulum, a vehicle, a doll. Longer chains would pay
 * as many times their time for a phase that their many ways of swinging hide. */
enum { SUBSTEPS_OF_PART = 4, FEW_BODIES = 16 };

/* How fast the line of a rod turns, as it came; 0 of other kinds. */
static double line_rate(const td_island_work *work, int i) {
    const td_constraint *constraint = td_constraint_at(work->w, work->constraints[i]);
    const td_direct_constraint *c = &work->problem.constraints[i];
    td_lane at = td_island_lane(work, i);
    double length = 0.0, speed = 0.0;
    if (constraint->kind == TD_CONSTRAINT_ROD) {
        length = (double)td_hold_rows_at(at.block)->turn_base[at.lane];
    } else if (constraint->kind == TD_CONSTRAINT_DRIVE_LINE) {
        length = (double)td_drive_rows_at(at.block)->value_base[at.lane];
    }
    for (int k = 0; k < 2 && length > 0.0; k++) {
        double a = c->a == TD_NONE ? 0.0 : work->problem.bodies[c->a].before[k];
        double b = c->b == TD_NONE ? 0.0 : work->problem.bodies[c->b].before[k];
        speed += (b - a) * (b - a);
    }
    return length > 0.0 ? __builtin_sqrt(speed) / length : 0.0;
}

static bool is_drive(int kind) {
    return kind == TD_CONSTRAINT_DRIVE_LINE || kind == TD_CONSTRAINT_DRIVE_AXIS ||
           kind == TD_CONSTRAINT_DRIVE_TURN;
}

/* The greatest phase by which a spring goes on in the step, rad. */
static double spring_phase(const td_island_work *work) {
    double fastest = 0.0;
    for (int i = 0; i < work->island->constraints; i++) {
        if (is_drive(td_constraint_at(work->w, work->constraints[i])->kind)) {
            td_lane at = td_island_lane(work, i);
            double frequency = (double)td_drive_rows_at(at.block)->frequency[at.lane];
            fastest = td_max_double(fastest, frequency);
        }
    }
    return td_min_double(2.0 * TD_PI * fastest * work->time, PHASE_MAX);
}

/* A joint's anchor is nowhere but in the body's centre of mass. */
#define CENTRED 1e-5 /* length scales */

static bool is_centred(const td_island_work *work, float cross_u, float cross_v) {
    double most = CENTRED * (double)work->w->unit;
    return td_abs((double)cross_u) <= most && td_abs((double)cross_v) <= most;
}

/* Whether a joint moves as a side turns, which its frame may turn with. */
static void note_sweeps(td_island_work *work, int i) {
    const td_direct_constraint *c = &work->problem.constraints[i];
    int kind = td_constraint_at(work->w, work->constraints[i])->kind;
    td_lane at = td_island_lane(work, i);
    const td_point *p = &at.block->point[0], *q = &at.block->point[1];
    bool turns = kind == TD_CONSTRAINT_DRIVE_AXIS || kind == TD_CONSTRAINT_GEAR ||
                 (kind == TD_CONSTRAINT_HOLD && td_hold_rows_at(at.block)->frame[at.lane] > 0.0f);
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

/* Whose turn matters, and to what. */
static void note_turns(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        work->problem.bodies[i].rubs = false;
    }
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &work->problem.constraints[i];
        const int sides[] = {c->a, c->b};
        if (!td_is_contact(td_constraint_at(work->w, work->constraints[i]))) {
            note_sweeps(work, i);
            continue;
        }
        for (int side = 0; side < 2; side++) {
            if (sides[side] != TD_NONE) {
                work->problem.bodies[sides[side]].rubs |= !td_island_is_disc(work, sides[side]);
            }
        }
    }
}

int td_island_parts(td_island_work *work) {
    note_turns(work);
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
    double parts = td_max_double(fastest * work->time / TURN_PART, 1.0);
    if (!(parts < 2 * PARTS)) {
        return 0;
    }
    if (td_island_is_joints(work)) {
        bool few = work->island->bodies <= FEW_BODIES;
        double finer = few ? (double)work->w->substeps / SUBSTEPS_OF_PART : 1.0;
        double phase = td_max_double(spring_phase(work) / PHASE_PART, 1.0);
        parts = td_max_double(parts, finer * phase);
    }
    int whole = parts < PARTS ? (int)parts : PARTS;
    return whole < PARTS && whole < parts ? whole + 1 : whole;
}

bool td_island_rubs(const td_island_work *work) {
    bool any = false;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        any |= b->rubs && td_abs(b->moved[2]) > work->turn_most;
    }
    return any;
}
