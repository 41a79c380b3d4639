/* island_step.c: solves direct islands directly, between the soft solver's start and its end.
 *
 * The soft solver has done them as well: where the direct result is no better, because its numbers
 * failed or it ran out of patience, the soft one stands. Otherwise velocities, motions and impulses
 * of the island are written over. Two problems a step: the first is for the mean velocity, which
 * brings the bodies to where nothing overlaps, and is exact to second order; the second for the
 * velocities to go on with. Where nothing hits or is pushed apart the second one's solution follows
 * from the first. A bounce is left to the soft solver: several at once, each with its share of the
 * speed back, would gain energy. */
#include "direct/island_step.h"

#include "constraint/joint_hooks.h"
#include "solver/error.h"
#include "solver/motion.h"
#include "state/shape.h"

/* An island that took no more matrices in a step than this was easy. */
#define EASY 8
/* A calm island may be slow for so many times as many steps as the quality allows others. */
#define CALM_PATIENCE 20
/* A result is refused where a body that does not roll by itself turns by more than
 * td_island_work.turn_most radians in the step, where one is faster than SPEED_MOST times the
 * greatest speed that is there or wanted, or where a contact presses harder than LEVERAGE_MOST
 * times all the momentum that is there or wanted.
 */
#define SPEED_MOST 4.0
#define LEVERAGE_MOST 10.0
/* The speed that may be missing, in multiples of what gravity gives in a step, and at least so many
 * length scales a second. */
#define TOLERANCE 1e-3
#define TOLERANCE_LEAST 1e-6

/* ---- the result ---- */

static void limit(const thud_world *w, double velocity[3]) {
    double most = (double)(w->def.maximum_speed * w->unit);
    for (int k = 0; k < 3; k++) {
        double m = k < 2 ? most : (double)THUD_SPIN_MAX;
        velocity[k] = velocity[k] > m ? m : velocity[k] < -m ? -m : velocity[k];
    }
}

double td_island_gap(const td_island_work *work, const td_direct_constraint *c, int k,
                     double before) {
    const td_direct_row *r = &c->row[k];
    double gap = before + work->elapsed * r->known_speed;
    for (int j = 0; j < 3; j++) {
        gap += c->a == TD_NONE ? 0.0 : r->a[j] * work->problem.bodies[c->a].moved[j];
        gap += c->b == TD_NONE ? 0.0 : r->b[j] * work->problem.bodies[c->b].moved[j];
    }
    return gap;
}

td_lane td_island_lane(const td_island_work *work, int i) {
    return td_lane_of(work->w, td_constraint_at(work->w, work->constraints[i]));
}

/* The speed along a row as the soft solver has left it. */
static double soft_speed(const td_island_work *work, const td_direct_constraint *c,
                         const td_direct_row *r) {
    const thud_world *w = work->w;
    double speed = r->known_speed;
    for (int j = 0; j < 3; j++) {
        speed +=
            c->a == TD_NONE ? 0.0 : r->a[j] * (double)td_row(&w->velocity, work->slots[c->a])[j];
        speed +=
            c->b == TD_NONE ? 0.0 : r->b[j] * (double)td_row(&w->velocity, work->slots[c->b])[j];
    }
    return speed;
}

/* The speed at which a point may close by the end of the step, where it did at its start and falls.
 * What is going to bounce in the next step does so with all of it: slowed down to meet no earlier
 * than that ends, a gas would lose energy with each impact. */
static double approach_of(const td_island_work *work, td_lane at, int k) {
    int points =
        td_island_points(work->w, td_constraint_at(work->w, at.block->constraint[at.lane]));
    double closing = -(double)td_history_of(at.block, points)[k].approach[at.lane];
    return td_max_double(closing, 0.0) + work->problem.unit_speed;
}

/* Sets the speeds that a constraint wants of the velocities at the end of the step. */
static void want_velocity(td_island_work *work, int i) {
    td_direct_constraint *c = &work->problem.constraints[i];
    td_lane at = td_island_lane(work, i);
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        if (r->used && r->kind == TD_ROW_UNILATERAL) {
            double gap = td_island_gap(work, c, k, (double)at.block->point[k].base[at.lane]);
            r->target_speed = gap > 0.0 ? -gap / work->next : 0.0;
            if (gap > 0.0 && at.block->restitution[at.lane] > 0.0f) {
                r->target_speed -= approach_of(work, at, k);
            }
            if (c->keeps) {
                r->target_speed = td_min_double(r->target_speed, soft_speed(work, c, r));
            }
        }
    }
}

static bool is_apart(const td_direct_row *r, td_lane at, int k) {
    return r->kind == TD_ROW_UNILATERAL && at.block->point[k].separation[at.lane] > 0.0f;
}

/* The greatest speed by which the soft solver has missed what holds. */
static double soft_miss(const td_island_work *work) {
    double worst = 0.0;
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &work->problem.constraints[i];
        td_lane at = td_island_lane(work, i);
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &c->row[k];
            if (!r->used || r->kind >= TD_ROW_FRICTION || is_apart(r, at, k)) {
                continue;
            }
            double speed = soft_speed(work, c, r);
            worst = td_max_double(worst, r->kind == TD_ROW_EQUALITY ? td_abs(speed) : -speed);
        }
    }
    return worst;
}

static double speed_of(const double velocity[3]) {
    return __builtin_sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1]);
}

bool td_island_is_disc(const td_island_work *work, int body) {
    int topology = td_int_at(&work->w->lone, work->slots[body].at);
    return topology >= 0 && td_kind_is_round(td_shape_at(work->w, topology)->kind);
}

/* By itself, as it rolls, it has nobody to turn past. */
static bool rolls_alone(const td_island_work *work) {
    return work->island->bodies == 1 && td_island_is_disc(work, 0);
}

/* Contacts are taken as they are at the start of the step; arms that swing far by its end, and most
 * of all a body that spins, are a matter for substeps. So is what is wedged in where it cannot be
 * pushed apart: it would leave sideways, at any speed. */
static bool goes_too_far(const td_island_work *work) {
    double fastest = 0.0, furthest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        double turn = work->problem.bodies[i].moved[2];
        if (td_abs(turn) > work->turn_most && !rolls_alone(work)) {
            return true;
        }
        fastest = td_max_double(fastest, speed_of(work->problem.bodies[i].free));
        furthest = td_max_double(furthest, speed_of(work->problem.bodies[i].moved));
    }
    /* A column whose contacts all open grows by all of that at its top. */
    double pushed = work->pushed * work->island->bodies;
    return furthest > SPEED_MOST * work->time * (fastest + pushed);
}

/* A wedge may press harder than all that is there could, even with some leverage. Such impulses are
 * refused, since the soft solver would begin with them should the wedge open. */
static bool presses_too_hard(const td_island_work *work) {
    const td_direct *d = &work->problem;
    double fastest = d->unit_speed + work->pushed * work->island->bodies, mass = 0.0;
    double greatest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        fastest = td_max_double(fastest, speed_of(d->bodies[i].free));
        mass += 1.0 / d->bodies[i].inverse_mass;
    }
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            bool pushes = r->used && r->kind == TD_ROW_UNILATERAL;
            greatest = td_max_double(greatest, pushes ? r->impulse : 0.0);
        }
    }
    return greatest > LEVERAGE_MOST * mass * fastest;
}

void td_island_carry_on(td_island_work *work) {
    td_direct *d = &work->problem;
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &d->bodies[i];
        for (int k = 0; k < 3; k++) {
            b->free[k] = 2.0 * b->free[k] - b->before[k];
            b->velocity[k] = 2.0 * b->velocity[k] - b->before[k];
        }
    }
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &d->constraints[i];
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            c->row[k].impulse *= 2.0;
        }
        want_velocity(work, i);
    }
    td_direct_update_speeds(d);
    td_direct_update_friction(d);
}

void td_island_move_on(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        limit(work->w, b->velocity);
        for (int k = 0; k < 3; k++) {
            b->moved[k] += work->time * b->velocity[k];
        }
    }
}

static double solve_contacts(td_island_work *work, double tolerance) {
    td_direct *d = &work->problem;
    double missing = td_direct_solve(d, tolerance);
    td_island_move_on(work);
    if (td_finite(missing)) {
        td_island_carry_on(work);
        double then =
            td_direct_again(d, tolerance) ? td_direct_residual(d) : td_direct_solve(d, tolerance);
        missing = td_max_double(missing, then);
    }
    return missing;
}

double td_island_tolerance(const thud_world *w) {
    double x = (double)w->def.gravity.x, y = (double)w->def.gravity.y;
    double falls = w->def.time_step * __builtin_sqrt(x * x + y * y);
    return td_max_double(TOLERANCE * falls, TOLERANCE_LEAST * (double)w->unit);
}

bool td_island_work_out(td_island_work *work) {
    td_direct *d = &work->problem;
    double tolerance = td_island_tolerance(work->w);
    double missing = work->joints ? work->w->joint_hooks->solve(work, tolerance)
                                  : solve_contacts(work, tolerance);
    for (int i = 0; i < work->island->bodies; i++) {
        limit(work->w, d->bodies[i].velocity);
    }
    work->w->stats.factorings += d->factorings;
    work->w->stats.island_work += d->factorings * td_island_cost(work->island);
    if (goes_too_far(work) || presses_too_hard(work)) {
        return false;
    }
    return missing <= tolerance || (td_finite(missing) && missing < soft_miss(work));
}

static void write_constraint(const td_island_work *work, int i) {
    thud_world *w = work->w;
    const td_direct_constraint *c = &work->problem.constraints[i];
    const td_direct_row *tangent = &c->row[TD_DIRECT_TANGENT];
    td_lane at = td_island_lane(work, i);
    int points = td_island_points(w, td_constraint_at(w, work->constraints[i]));
    float part = 1.0f / (float)w->substeps;
    for (int k = 0; k < points; k++) {
        if (c->row[k].used) {
            td_point *p = &at.block->point[k];
            float impulse = (float)c->row[k].impulse;
            p->normal_impulse[at.lane] = part * impulse;
            p->separation[at.lane] = (float)td_island_gap(work, c, k, (double)p->base[at.lane]);
            td_history_of(at.block, points)[k].total[at.lane] = impulse;
        }
    }
    float along = tangent->used ? (float)tangent->impulse : 0.0f;
    at.block->tangent_impulse[at.lane] = part * along;
    at.block->mark[at.lane].loaded |= TD_DIRECT;
    td_surface_at(at.block, points)->total[at.lane] = along;
}

/* Whether a constraint still carries so much that the island is to stay. */
static bool is_loaded(const td_island_work *work, const td_direct_constraint *c) {
    thud_world *w = work->w;
    double impulse = td_direct_load(c), inverse = 0.0;
    float size = 3e38f;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        impulse += c->row[k].kind == TD_ROW_EQUALITY ? td_abs(c->row[k].impulse) : 0.0;
    }
    const int sides[2] = {c->a, c->b};
    for (int side = 0; side < 2; side++) {
        if (sides[side] != TD_NONE) {
            inverse = td_max_double(inverse, work->problem.bodies[sides[side]].inverse_mass);
            size = td_min_float(size, 2.0f * td_row(&w->reach, work->slots[sides[side]])[0]);
        }
    }
    return impulse / w->substeps * inverse > TD_DIRECT_LEAVE * (double)td_islands_most(w, size);
}

static bool is_calm(const td_island_work *work) {
    float fastest = 0.0f, most = td_calm_speed(work->w);
    for (int i = 0; i < work->island->bodies; i++) {
        const float *v = td_row(&work->w->velocity, work->slots[i]);
        fastest = td_max_float(fastest, v[0] * v[0] + v[1] * v[1]);
    }
    return fastest <= most * most;
}

/* An island that takes many matrices step after step moves, and would do so for long; one that is
 * calm may be just being pushed apart, and gets more time. */
static bool is_slow(const td_island_work *work) {
    int factoring_budget = work->w->quality.island_patience * (is_calm(work) ? CALM_PATIENCE : 1);
    bool easy = work->problem.factorings <= EASY || factoring_budget == 0;
    int most = 0;
    for (int i = 0; i < work->island->bodies; i++) {
        uint16_t *slow_steps = td_slow_steps_at(work->w, work->slots[i]);
        int steps = *slow_steps % TD_SLOW_ONCE;
        *slow_steps = easy ? 0 : steps < TD_SLOW_STEPS ? *slow_steps + 1 : *slow_steps;
        most = easy ? 0 : td_max_int(most, steps + 1);
    }
    return factoring_budget > 0 && most > td_min_int(factoring_budget, TD_SLOW_STEPS);
}

/* An island with joints that could not be solved in so many steps in succession is jammed: limbs
 * that are caught in each other, which no velocities part. */
enum { JAMMED_STEPS = 8 };

/* Counts a step in which it could not be solved, where no patience counts them. Once it was left
 * alone for that, and was not solved since, one such step will do. */
static bool is_jammed(const td_island_work *work) {
    bool jammed = false;
    for (int i = 0; i < work->island->bodies; i++) {
        uint16_t *slow_steps = td_slow_steps_at(work->w, work->slots[i]);
        int steps = *slow_steps % TD_SLOW_ONCE;
        jammed |= TD_SLOW_LEFT(*slow_steps) > 0 || steps + 1 >= JAMMED_STEPS;
        *slow_steps = (uint16_t)(*slow_steps + (steps < TD_SLOW_STEPS));
    }
    return jammed;
}

void td_island_write_bodies(const td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        float *velocity = td_row(&work->w->velocity, work->slots[i]);
        float *delta = td_row(&work->w->delta, work->slots[i]);
        for (int k = 0; k < 3; k++) {
            velocity[k] = (float)work->problem.bodies[i].velocity[k];
            delta[k] = (float)work->problem.bodies[i].moved[k];
        }
    }
}

static void write(const td_island_work *work) {
    bool loaded = false;
    for (int i = 0; i < work->island->constraints; i++) {
        write_constraint(work, i);
        loaded |= is_loaded(work, &work->problem.constraints[i]);
    }
    td_island_write_bodies(work);
    for (int i = 0; i < work->island->bodies; i++) {
        uint8_t *direct_steps = td_direct_steps_at(work->w, work->slots[i]);
        *direct_steps = loaded ? TD_DIRECT_STEPS : *direct_steps ? *direct_steps - 1 : 0;
    }
}

/* Small islands that joints hold are tried again soon. */
enum { FEW_BODIES = 128 };

/* An island for which even a few matrices cost more than the work of a whole step is left alone for
 * long; one that has spent its effort of the step, or is jammed, rests at any quality. */
static void leave(thud_world *w, const td_island *island, bool joints, bool rests) {
    if (w->quality.island_patience > 0 || rests) {
        bool dear = EASY * td_island_cost(island) > w->quality.island_work;
        td_islands_leave(w, island, joints ? TD_PAUSE_STEPS : TD_COOLDOWN_STEPS, !joints && dear);
    }
}

bool td_island_solve(thud_world *w, const td_island *island) {
    bool bounces = false, joints = false, rests = false;
    w->stats.direct_islands++;
    w->stats.direct_bodies += island->bodies;
    if (td_island_factoring_budget(w, island) > 0) {
        td_island_work work = td_island_take(w, island);
        bounces = work.bounces;
        joints = work.joints > 0 && island->bodies <= FEW_BODIES;
        /* What joints hold goes on however slow it is: softly they would give way. */
        if (!bounces && td_island_work_out(&work) && (!is_slow(&work) || joints)) {
            write(&work);
            return true;
        }
        bool jammed =
            w->quality.island_patience == 0 && work.joints > 0 && !bounces && is_jammed(&work);
        joints |= jammed;
        rests = work.problem.spent || jammed;
    }
    w->stats.soft_islands++;
    if (!bounces) {
        leave(w, island, joints, rests);
    }
    return false;
}

void td_islands_begin(thud_world *w) {
    td_islands_settle(w);
    td_island_note(w);
}

static void end(thud_world *w) {
    for (int i = 0; i < w->islands.island.count; i++) {
        td_island_solve(w, TD_AT(td_island, &w->islands.island, i));
    }
    td_islands_watch(w);
    if (w->stats.direct_islands > w->stats.soft_islands) {
        td_error_recount(w);
    }
}

const thud_island_solver thud_islands_direct = {td_islands_find, td_islands_begin, end};
