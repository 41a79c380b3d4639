/* island_joints.c: islands with joints, solved directly.
 *
 * Their rows turn with the bodies, within a step as well. Directions are such that the work along
 * them over a part of the step is that of the joint's own coordinates (td_turn_rows_fn), and mean
 * velocities are sought by Newton's method, so that at the end of the part gaps are closed and
 * energy is what it was. Impulses that turn with a body count as its stiffness against turning. */
#include "islands/island_solve.h"

#include "constraint/joining.h"
#include "linkages/island_contacts.h"
#include "linkages/island_parts.h"

/* A result is refused whose kinetic energy is so many times what was there or could come. */
#define ENERGY_MOST 16.0
/* They may take so many times the matrices: softly a chain under load would come apart. */
enum { WORK_OF_JOINTS = 8, WORK_WITH_CONTACTS = 2 };
/* Rounds in which the rows of joints follow the motion that they make. */
enum { ROUNDS = 12 };
/* A body is not taken to turn more lightly than by so much of its inertia less. */
#define SOFTEST (-0.5)
/* What gaps may be left, in parts of the tolerance: where each island is direct, and elsewhere.
 * With contacts, which change their minds from round to round, they may be all of it. */
#define FINE 1e-3
#define FINE_ENOUGH 0.05
/* Velocities at the end that miss what joints want by no more than so many times what gravity gives
 * in a step are left as they are: to take that out would take energy from whatever swings. */
#define AMISS 4.0

/* How far a side has moved by the start of a part of the step, and by its end at mean velocities.
 */
static void span_of_side(const td_island_work *work, int body, uint32_t record, double start,
                         double motion[2][3]) {
    const float *v = td_row(&work->w->velocity, td_slot_of_side(record));
    for (int k = 0; k < 3; k++) {
        const td_direct_body *b = body == TD_NONE ? NULL : &work->problem.bodies[body];
        double speed = b ? b->velocity[k] : (double)v[k];
        motion[0][k] = b ? b->moved[k] : start * (double)v[k];
        motion[1][k] = motion[0][k] + work->time * speed;
    }
}

/* Bodies that do not turn feel no arms. */
static void forget_arms(const td_direct *d, td_direct_constraint *c) {
    bool turns_a = c->a == TD_NONE || d->bodies[c->a].inverse_inertia > 0.0;
    bool turns_b = c->b == TD_NONE || d->bodies[c->b].inverse_inertia > 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        c->row[k].a[2] *= turns_a;
        c->row[k].b[2] *= turns_b;
    }
}

/* Turns the rows of joints to where the velocities as known take them; in an instant at the end of
 * the part, where `ended` is set. */
static void turn_rows(td_island_work *work, double start, bool ended) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        int kind = td_constraint_at(work->w, work->constraints[i])->kind;
        if (kind < TD_PAIR_COUNT) {
            continue;
        }
        td_lane at = td_island_lane(work, i);
        td_span span = {.time = ended ? 0.0 : work->time};
        span_of_side(work, c->a, at.block->a[at.lane], start, span.a);
        span_of_side(work, c->b, at.block->b[at.lane], start, span.b);
        for (int k = 0; k < 3 && ended; k++) {
            span.a[1][k] = span.a[0][k];
            span.b[1][k] = span.b[0][k];
        }
        work->w->kinds[kind]->lanes->turn_rows(work->w, at.block, at.lane, &span, c);
        forget_arms(&work->problem, c);
    }
    td_direct_measure(&work->problem);
}

/* Impulses that turn with a body resist its turn, or help it, by so much about the turn that is
 * known: as if it were so much harder to turn away from there. Without that a light link between
 * heavy ones would turn too far, and back, in each round. */
static void stiffen(td_island_work *work) {
    td_direct *d = &work->problem;
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &d->constraints[i];
        const int side[2] = {c->a, c->b};
        for (int k = 0; k < 2; k++) {
            if (side[k] != TD_NONE) {
                d->bodies[side[k]].stiff += c->stiff[k];
            }
        }
    }
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        if (b->inverse_inertia > 0.0) {
            double own = 1.0 / b->own_inverse_inertia;
            double more = td_max_double(b->stiff, SOFTEST * own);
            b->inverse_inertia = 1.0 / (own + more);
            b->free[2] =
                (own * (b->before[2] + b->gain[2]) + more * b->velocity[2]) * b->inverse_inertia;
        }
        b->stiff = 0.0;
    }
}

static void loosen(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        b->inverse_inertia = b->own_inverse_inertia;
        b->free[2] = (b->before[2] + b->gain[2]);
    }
}

static double fine_of(const td_island_work *work) {
    bool everywhere = work->w->quality.sag_limit == 0.0f;
    return !td_island_is_joints(work) ? 1.0 : everywhere ? FINE : FINE_ENOUGH;
}

/* All velocities are numbers, and turns small enough to have a sine. */
static bool turns_count(const td_island_work *work) {
    bool all = true;
    for (int i = 0; i < work->island->bodies; i++) {
        const double *v = work->problem.bodies[i].velocity;
        all &= td_finite(v[0]) && td_finite(v[1]) && td_abs(v[2]) <= (double)THUD_SPIN_MAX;
    }
    return all;
}

/* Mean velocities with the rows of joints as the motion turns them. Returns what is missed;
 * infinite where numbers failed. */
static double solve_turning(td_island_work *work, double start, double tolerance) {
    td_direct *d = &work->problem;
    double missing = __builtin_inf();
    double fine = fine_of(work) * tolerance;
    for (int round = 0; round < ROUNDS && turns_count(work); round++) {
        turn_rows(work, start, false);
        if (round && td_direct_miss(d) <= fine) {
            return missing;
        }
        stiffen(work);
        missing = td_direct_solve(d, tolerance);
        if (!td_finite(missing)) {
            return missing;
        }
        d->fresh = false; /* the next round goes on from this one */
    }
    if (!turns_count(work)) {
        return __builtin_inf();
    }
    turn_rows(work, start, false);
    return td_max_double(missing, td_direct_miss(d));
}

/* A spring goes on pushing as it did on the way, and bounds are those of the whole part. */
static void keep_drives(td_direct_constraint *c) {
    c->bound *= 2.0;
    c->row[TD_DIRECT_TANGENT].most +=
        c->row[TD_DIRECT_TANGENT].kind == TD_ROW_FRICTION ? 0.5 * c->bound : 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        if (r->used && r->kind == TD_ROW_SOFT) {
            r->most *= 2.0;
            r->wanted = r->speed + r->impulse / r->weight;
        }
    }
}

static void take_back(td_direct_body *b, const double *j, double impulse) {
    b->free[0] -= b->inverse_mass * j[0] * impulse;
    b->free[1] -= b->inverse_mass * j[1] * impulse;
    b->free[2] -= b->inverse_inertia * j[2] * impulse;
}

/* A gap closes in this part, at a speed that tells beside those of the bodies: that moves them, and
 * must not go on as speed. */
#define TELLS 1e-3

static bool closes(const td_island_work *work, double tolerance) {
    double worst = 0.0, fastest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const double *v = work->problem.bodies[i].before;
        fastest = td_max_double(fastest, v[0] * v[0] + v[1] * v[1]);
    }
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            bool locks = r->used && r->kind == TD_ROW_EQUAL;
            worst = locks ? td_max_double(worst, r->closing) : worst;
        }
    }
    return worst > tolerance + TELLS * __builtin_sqrt(fastest);
}

/* What locks have given on the way they gave in the directions of the way, and it stays: solved
 * anew at the end it would take the square of what a direction turns from what swings. Only what is
 * still amiss then is theirs to mend. What pushes and drives is solved anew. */
static void keep_locks(td_island_work *work) {
    td_direct *d = &work->problem;
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        for (int k = 0; k < 3; k++) {
            b->free[k] = b->velocity[k];
        }
    }
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &c->row[k];
            bool locks = r->used && r->kind == TD_ROW_EQUAL;
            r->given = locks ? r->impulse : 0.0;
            r->impulse -= r->given;
            if (r->used && !locks && c->a != TD_NONE) {
                take_back(&d->bodies[c->a], r->a, r->impulse);
            }
            if (r->used && !locks && c->b != TD_NONE) {
                take_back(&d->bodies[c->b], r->b, r->impulse);
            }
        }
    }
}

static void return_locks(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            td_direct_row *r = &work->problem.constraints[i].row[k];
            r->impulse += r->given;
        }
    }
}

/* Nothing pushes or drives: all there is locks, or springs. */
static bool swings(const td_island_work *work) {
    bool any = false;
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            any |= r->used && (r->kind == TD_ROW_PUSH || r->kind == TD_ROW_FRICTION);
        }
    }
    return !any;
}

/* Velocities at the end. Of what swings they follow from the mean ones, and are mended only where
 * something else has set them amiss. */
static double end_turning(td_island_work *work, double start, double tolerance) {
    td_direct *d = &work->problem;
    td_island_carry_on(work);
    for (int i = 0; i < work->island->constraints; i++) {
        keep_drives(&d->constraints[i]);
    }
    if (closes(work, tolerance)) {
        turn_rows(work, start, true);
        return td_direct_solve(d, tolerance);
    }
    keep_locks(work);
    turn_rows(work, start, true);
    bool fine = swings(work) && td_direct_miss(d) <= AMISS * d->unit_speed;
    double missing = fine ? 0.0 : td_direct_solve(d, tolerance);
    return_locks(work);
    return missing;
}

/* What gravity, forces and damping give in one of so many parts. */
static void begin(td_island_work *work, int parts) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            td_direct_row *r = &work->problem.constraints[i].row[k];
            r->closing = td_max_double(r->wanted, 0.0);
        }
    }
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        for (int k = 0; k < 3; k++) {
            b->gain[k] = (b->free[k] - b->before[k]) / parts;
        }
        b->own_inverse_inertia = b->inverse_inertia;
    }
}

/* The speeds that contacts want in the part, by their gaps at its start. Directions and arms are as
 * they were at the start of the step, and so is what is pushed apart. */
static void want_part(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        td_lane at = td_island_lane(work, i);
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            td_direct_row *r = &c->row[k];
            if (r->used && td_is_contact(td_constraint_at(work->w, work->constraints[i]))) {
                double gap = td_island_gap(work, c, k, (double)at.block->point[k].base[at.lane]);
                r->wanted = gap > 0.0 ? -gap / work->time : r->closing;
            }
        }
    }
}

/* The next part begins with the velocities, and guesses the impulses, of the one before. */
static void begin_part(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        for (int k = 0; k < 3; k++) {
            b->before[k] = b->velocity[k];
            b->free[k] = b->before[k] + b->gain[k];
        }
    }
}

static void scale_impulses(td_island_work *work, double by) {
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            work->problem.constraints[i].row[k].impulse *= by;
        }
    }
}

/* Twice the kinetic energy; `free`: of what there was, or would be without joints. */
static double energy_of(const td_island_work *work, bool free) {
    double sum = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        double v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = free ? td_max_double(td_abs(b->free[k]), td_abs(b->before[k])) : b->velocity[k];
        }
        sum += (v[0] * v[0] + v[1] * v[1]) / b->inverse_mass;
        sum += b->inverse_inertia > 0.0 ? v[2] * v[2] / b->inverse_inertia : 0.0;
    }
    return sum;
}

/* Twice the energy that springs and motors may give: what a spring holds, and what is there once
 * all goes at the speed of a motor. */
static double energy_of_drives(const td_island_work *work) {
    double sum = 0.0;
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &work->problem.constraints[i].row[k];
            bool drives = r->used && r->kind >= TD_ROW_FRICTION;
            double mass = r->kind == TD_ROW_SOFT ? r->weight : r->mass;
            sum += drives ? mass * r->wanted * r->wanted : 0.0;
        }
    }
    return sum;
}

/* What only locks takes no energy, nor gives any but by closing gaps. `there`: twice the energy
 * that there was as the step began, or could come. A motor may move more than its own two bodies,
 * so that what there was as the last part began counts as well. */
static bool explodes(const td_island_work *work, double there) {
    double mass = 0.0, pushed = work->pushed + work->problem.unit_speed;
    for (int i = 0; i < work->island->bodies; i++) {
        mass += 1.0 / work->problem.bodies[i].inverse_mass;
    }
    there = td_max_double(there, energy_of(work, true));
    double most = there + mass * pushed * pushed * work->island->bodies;
    return !(energy_of(work, false) <= ENERGY_MOST * most);
}

double td_island_solve_joints(td_island_work *work, double tolerance) {
    double missing = 0.0, whole = work->time;
    double there = energy_of(work, true) + energy_of_drives(work);
    int parts = td_island_parts(work);
    if (parts == 0) {
        return __builtin_inf();
    }
    work->problem.effort = work->w->islands.effort;
    work->problem.patience *= td_island_is_joints(work) ? WORK_OF_JOINTS : WORK_WITH_CONTACTS;
    work->time = whole / parts;
    scale_impulses(work, 1.0 / parts);
    begin(work, parts);
    for (int part = 0; part < parts && td_finite(missing); part++) {
        begin_part(work);
        work->elapsed = part * work->time;
        if (parts > 1) {
            want_part(work);
        }
        work->elapsed = (part + 1) * work->time;
        work->next = part + 1 < parts ? work->time : whole;
        double then = solve_turning(work, part * work->time, tolerance);
        loosen(work);
        td_island_move_on(work);
        missing = td_max_double(missing, then);
        if (td_finite(missing)) {
            then = end_turning(work, (part + 1) * work->time, tolerance);
            missing = td_max_double(missing, then);
        }
        scale_impulses(work, part + 1 < parts ? 0.5 : (double)parts);
    }
    work->w->islands.effort = work->problem.effort;
    work->time = work->elapsed = whole;
    /* What is tied from afar may pull beyond all numbers. */
    missing =
        td_finite(energy_of(work, false)) && !td_island_rubs(work) ? missing : __builtin_inf();
    work->turn_most = __builtin_inf();
    if (td_finite(missing) && missing > tolerance && !td_island_is_joints(work) &&
        td_island_sinks(work, tolerance * whole)) {
        missing = __builtin_inf();
    }
    if (td_island_is_joints(work)) {
        missing = explodes(work, there) ? __builtin_inf() : missing;
        work->pushed = __builtin_inf();
        /* They take as many matrices as they turn by, which is no sign of more to come. */
        work->w->stats.factorings += work->problem.factorings;
        work->w->stats.island_work += work->problem.factorings * td_island_cost(work->island);
        work->problem.factorings = 0;
    }
    return missing;
}
