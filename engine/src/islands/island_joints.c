/* island_joints.c: islands with joints, solved directly.
 *
 * Their rows turn with the bodies, within a step as well. Directions are such that the work along
 * them over a part of the step is that of the joint's own coordinates (td_turn_rows_fn), and mean
 * velocities are sought by Newton's method, so that at the end of the part gaps are closed and
 * energy is what it was. Impulses that turn with a body count as its stiffness against turning. */
#include "islands/island_solve.h"

#include "constraint/joining.h"

/* A result is refused whose kinetic energy is so many times what was there or could come. */
#define ENERGY_MOST 16.0
/* Joints alone may take so many times the matrices: softly a chain under load would come apart. */
enum { MORE_WORK = 8 };
/* Rounds in which the rows of joints follow the motion that they make. */
enum { ROUNDS = 12 };
/* A body is not taken to turn more lightly than by so much of its inertia less. */
#define SOFTEST (-0.5)
/* What gaps may be left, in parts of the tolerance: where each island is direct, and elsewhere. */
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

/* Mean velocities with the rows of joints as the motion turns them. Returns what is missed. */
static double solve_turning(td_island_work *work, double start, double tolerance) {
    td_direct *d = &work->problem;
    double missing = __builtin_inf();
    double fine = (work->w->quality.sag_limit == 0.0f ? FINE : FINE_ENOUGH) * tolerance;
    for (int round = 0; round < ROUNDS; round++) {
        turn_rows(work, start, false);
        if (round && td_direct_miss(d) <= fine) {
            return missing;
        }
        stiffen(work);
        missing = td_direct_solve(d, tolerance);
        if (!td_finite(missing)) {
            break;
        }
    }
    return missing;
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

/* Velocities at the end. Of what swings they follow from the mean ones, and are
 * mended only where something else has set them amiss. */
static double end_turning(td_island_work *work, double start, double tolerance) {
    td_direct *d = &work->problem;
    td_island_carry_on(work);
    for (int i = 0; i < work->island->constraints; i++) {
        keep_drives(&d->constraints[i]);
    }
    turn_rows(work, start, true);
    if (swings(work) && td_direct_miss(d) <= AMISS * d->unit_speed) {
        return 0.0;
    }
    return td_direct_solve(d, tolerance);
}

/* Arms that turn by more than this in a part of a step, rad, get more parts. */
#define TURN_PART 0.1
enum { PARTS = 16 };

/* In how many parts a step of joints is solved: by how far anything turns, as it came and as the
 * soft solver has it. Contacts are taken as they are at the start of the step, in one part. */
static int parts_of(const td_island_work *work) {
    double fastest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        double soft = (double)td_row(&work->w->velocity, work->slots[i])[2];
        double before = work->problem.bodies[i].before[2];
        fastest = td_max_double(fastest, td_max_double(td_abs(soft), td_abs(before)));
    }
    double parts = fastest * work->time / TURN_PART;
    return !td_island_is_joints(work) || !(parts > 1.0) ? 1
           : parts < PARTS - 1                          ? (int)parts + 1
                                                        : PARTS;
}

/* What gravity, forces and damping give in one of so many parts. */
static void begin(td_island_work *work, int parts) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        for (int k = 0; k < 3; k++) {
            b->gain[k] = (b->free[k] - b->before[k]) / parts;
        }
        b->own_inverse_inertia = b->inverse_inertia;
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

/* Twice the kinetic energy at velocities that `of` gives. */
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

/* What only locks takes no energy, nor gives any but by closing gaps. */
static bool explodes(const td_island_work *work) {
    double mass = 0.0, pushed = work->pushed + work->problem.unit_speed;
    for (int i = 0; i < work->island->bodies; i++) {
        mass += 1.0 / work->problem.bodies[i].inverse_mass;
    }
    double most = energy_of(work, true) + mass * pushed * pushed * work->island->bodies;
    return !(energy_of(work, false) <= ENERGY_MOST * most);
}

double td_island_solve_joints(td_island_work *work, double tolerance) {
    double missing = 0.0, whole = work->time;
    int parts = parts_of(work);
    work->problem.patience *= td_island_is_joints(work) ? MORE_WORK : 1;
    work->time = whole / parts;
    scale_impulses(work, 1.0 / parts);
    begin(work, parts);
    for (int part = 0; part < parts && td_finite(missing); part++) {
        begin_part(work);
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
    work->time = whole;
    if (td_island_is_joints(work)) {
        missing = explodes(work) ? __builtin_inf() : missing;
        work->turn_most = work->pushed = __builtin_inf();
        /* They take as many matrices as they turn by, which is no sign of more to come. */
        work->w->stats.factorings += work->problem.factorings;
        work->w->stats.island_work += work->problem.factorings * td_island_cost(work->island);
        work->problem.factorings = 0;
    }
    return missing;
}
