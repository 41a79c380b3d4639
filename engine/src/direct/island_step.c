/* island_step.c: solves one step of a direct island, after the soft solver has also solved it.
 *
 * Two problems of direct.h are solved, over a step of length h:
 * 1. The mean velocity v of the step, so that the motion is h v. Its target speeds end the step
 *    with contacts that just touch: overlaps are corrected, and gaps close no further than to
 *    contact. With a constant acceleration h v is the exact motion, as in the implicit midpoint
 *    rule (second order).
 * 2. The velocity at the end of the step, which starts from 2 v - v_before. Its target speeds leave
 *    out the correction of overlaps, so that correction adds no velocity. Where no contact corrects
 *    an overlap or closes a gap, the extrapolated velocity solves it already, and no further
 *    factorisation is needed (td_direct_solve_same_active_set).
 * Islands with joints are solved by island_step_joints.c instead.
 *
 * The result is checked. The result is refused, and the soft solver's kept, if bodies move or turn
 * too far for the first-order rows, if an impulse is implausibly large, or if the residual is above
 * the tolerance and no smaller than the soft solver's. Otherwise velocities, motions and impulses
 * of the island are overwritten. Islands in which a contact bounces in this step are left to the
 * soft solver: it resolves bounces one after the other. Bounces that are solved simultaneously,
 * each with its own restitution, can gain energy. */
#include "direct/island_step.h"

#include "constraint/joint_hooks.h"
#include "solver/error.h"
#include "solver/motion.h"
#include "state/shape.h"

/* A step of an island is slow if it took more factorisations than this. A warm-started active set
 * takes one or two, an interior point ten to twenty. Chosen. */
#define EASY_FACTORINGS_MAX 8
/* An island whose bodies hardly move against each other may be slow for this many times
 * thud_quality.island_slow_steps steps in succession: bodies that are still being pushed apart need
 * the time before they rest. Chosen. A box of 1000 times the mass of two small ones that carry it
 * needs between 5 and 10 such steps; with 5 it sinks in. */
#define CALM_SLOW_STEPS_FACTOR 4
/* A result is refused where a body's motion is longer than SPEED_RATIO_MAX times the greatest speed
 * without constraints times h, corrections of overlaps included (moves_too_far). Chosen; not tuned.
 * A lever may multiply a speed several times; a body that is squeezed out of a wedge exceeds any
 * factor. */
#define SPEED_RATIO_MAX 4.0
/* A result is refused where a contact's impulse is larger than IMPULSE_RATIO_MAX times the mass of
 * the whole island times the greatest speed without constraints, g h and corrections of overlaps
 * included (impulses_too_large). Chosen; not tuned. A wedge of half angle a multiplies its load by
 * 1 / (2 sin a), which is 10 at 3 degrees. */
#define IMPULSE_RATIO_MAX 10.0
/* Tolerance of residuals: TOLERANCE_SHARE times g h, the speed that gravity gives in a step, and at
 * least TOLERANCE_MIN length scales a second, for worlds without gravity. Chosen. */
#define TOLERANCE_SHARE 1e-3
#define TOLERANCE_MIN 1e-6

/* ---- the result ---- */

void td_island_clamp_velocity(const thud_world *w, double velocity[3]) {
    double speed_max = (double)(w->def.maximum_speed * w->length_scale);
    for (int k = 0; k < 3; k++) {
        double max = k < 2 ? speed_max : (double)THUD_ANGULAR_SPEED_MAX;
        velocity[k] = velocity[k] > max ? max : velocity[k] < -max ? -max : velocity[k];
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

/* The speed along a row in the soft solver's result, length/s. */
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

/* The speed at which a point that has restitution may close at the end of the step, length/s: its
 * approach speed at the start of the step, and g h. It is allowed on top of gap / h, so that a pair
 * that will bounce in the next step keeps its speed until then. Otherwise the row would slow the
 * pair down so that it meets at the end of the next step, and each bounce would lose energy. */
static double approach_max(const td_island_work *work, td_lane at, int k) {
    int points =
        td_island_points(work->w, td_constraint_at(work->w, at.block->constraint[at.lane]));
    double closing = -(double)td_history_of(at.block, points)[k].normal_velocity[at.lane];
    return td_max_double(closing, 0.0) + work->problem.unit_speed;
}

/* Sets the target speeds of contact i for the velocity at the end of the part: 0 for a point that
 * touches or overlaps then, and -gap / (length of the next part or step) for one that is apart. A
 * contact of joint_subsystems.c (`from_soft`) may also close as fast as in the soft solver's
 * result. */
static void set_end_targets(td_island_work *work, int i) {
    td_direct_constraint *c = &work->problem.constraints[i];
    td_lane at = td_island_lane(work, i);
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        if (r->used && r->kind == TD_ROW_UNILATERAL) {
            double gap =
                td_island_gap(work, c, k, (double)at.block->point[k].start_separation[at.lane]);
            r->target_speed = gap > 0.0 ? -gap / work->next : 0.0;
            if (gap > 0.0 && at.block->restitution[at.lane] > 0.0f) {
                r->target_speed -= approach_max(work, at, k);
            }
            if (c->from_soft) {
                r->target_speed = td_min_double(r->target_speed, soft_speed(work, c, r));
            }
        }
    }
}

/* Whether row k belongs to a contact point that does not touch in the soft solver's result. */
static bool is_apart(const td_direct_row *r, td_lane at, int k) {
    return r->kind == TD_ROW_UNILATERAL && at.block->point[k].separation[at.lane] > 0.0f;
}

/* The residual of the soft solver's result: the greatest speed by which it misses a unilateral row
 * that touches, or an equality row, both with a target speed of 0. */
static double soft_residual(const td_island_work *work) {
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

/* The length of the linear part of a velocity or motion. */
static double speed_of(const double velocity[3]) {
    return __builtin_sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1]);
}

bool td_island_is_disc(const td_island_work *work, int body) {
    int shape = td_int_at(&work->w->lone, work->slots[body].at);
    return shape >= 0 && td_kind_is_round(td_shape_at(work->w, shape)->kind);
}

/* Whether the island is a single disc, whose contacts are then all with static and kinematic
 * bodies. It may roll by any angle, since rotation does not move its contacts. */
static bool is_lone_disc(const td_island_work *work) {
    return work->island->bodies == 1 && td_island_is_disc(work, 0);
}

/* Whether a body turns by more than turn_max in the step, or moves further than SPEED_RATIO_MAX
 * allows. The rows have the lever arms of the start of the step, which are wrong after a large
 * rotation; the soft solver's substeps follow it better. And a body in a wedge whose overlap the
 * rows cannot correct would be squeezed out sideways, at any speed. */
static bool moves_too_far(const td_island_work *work) {
    double fastest = 0.0, furthest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        double turn = work->problem.bodies[i].moved[2];
        if (td_abs(turn) > work->turn_max && !is_lone_disc(work)) {
            return true;
        }
        fastest = td_max_double(fastest, speed_of(work->problem.bodies[i].free));
        furthest = td_max_double(furthest, speed_of(work->problem.bodies[i].moved));
    }
    /* Corrections add up: the top body of a column moves by those of all contacts below it. */
    double corrected = work->correction_speed * work->island->bodies;
    return furthest > SPEED_RATIO_MAX * work->time * (fastest + corrected);
}

/* Whether a unilateral impulse is larger than IMPULSE_RATIO_MAX times the greatest momentum that
 * the island could have: its mass times the greatest speed of a body without constraints. In a
 * wedge, impulses of any size can give the same motion. Large ones are refused, since they would be
 * the soft solver's warm start when the wedge opens. */
static bool impulses_too_large(const td_island_work *work) {
    const td_direct *d = &work->problem;
    double fastest = d->unit_speed + work->correction_speed * work->island->bodies, mass = 0.0;
    double greatest = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        fastest = td_max_double(fastest, speed_of(d->bodies[i].free));
        mass += 1.0 / d->bodies[i].inverse_mass;
    }
    for (int i = 0; i < work->island->constraints; i++) {
        for (int k = 0; k < TD_DIRECT_ROWS; k++) {
            const td_direct_row *r = &d->constraints[i].row[k];
            bool unilateral = r->used && r->kind == TD_ROW_UNILATERAL;
            greatest = td_max_double(greatest, unilateral ? r->impulse : 0.0);
        }
    }
    return greatest > IMPULSE_RATIO_MAX * mass * fastest;
}

void td_island_extrapolate(td_island_work *work) {
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
        set_end_targets(work, i);
    }
    td_direct_update_speeds(d);
    td_direct_update_friction(d);
}

void td_island_add_motion(td_island_work *work) {
    for (int i = 0; i < work->island->bodies; i++) {
        td_direct_body *b = &work->problem.bodies[i];
        td_island_clamp_velocity(work->w, b->velocity);
        for (int k = 0; k < 3; k++) {
            b->moved[k] += work->time * b->velocity[k];
        }
    }
}

/* Solves both problems of an island without joints. Returns the greater residual, a speed; infinite
 * where no method converged for one of them. */
static double solve_contacts(td_island_work *work, double tolerance) {
    td_direct *d = &work->problem;
    double residual = td_direct_solve(d, tolerance);
    td_island_add_motion(work);
    if (td_finite(residual)) {
        td_island_extrapolate(work);
        double end_residual = td_direct_solve_same_active_set(d, tolerance)
                                  ? td_direct_residual(d)
                                  : td_direct_solve(d, tolerance);
        residual = td_max_double(residual, end_residual);
    }
    return residual;
}

double td_island_tolerance(const thud_world *w) {
    return td_max_double(TOLERANCE_SHARE * td_gravity_speed(w),
                         TOLERANCE_MIN * (double)w->length_scale);
}

bool td_island_compute(td_island_work *work) {
    td_direct *d = &work->problem;
    double tolerance = td_island_tolerance(work->w);
    double residual = work->joints ? work->w->joint_hooks->solve(work, tolerance)
                                   : solve_contacts(work, tolerance);
    for (int i = 0; i < work->island->bodies; i++) {
        td_island_clamp_velocity(work->w, d->bodies[i].velocity);
    }
    work->w->stats.factorings += d->factorings;
    work->w->stats.island_work += d->factorings * td_island_cost(work->island);
    if (moves_too_far(work) || impulses_too_large(work)) {
        return false;
    }
    return residual <= tolerance || (td_finite(residual) && residual < soft_residual(work));
}

/* Writes the impulses and separations of constraint i to its lane: `normal_impulse` and
 * `tangent_impulse` are those of a substep, as the soft solver's warm start, `total` those of the
 * step. */
static void write_constraint(const td_island_work *work, int i) {
    thud_world *w = work->w;
    const td_direct_constraint *c = &work->problem.constraints[i];
    const td_direct_row *tangent = &c->row[TD_DIRECT_TANGENT];
    td_lane at = td_island_lane(work, i);
    int points = td_island_points(w, td_constraint_at(w, work->constraints[i]));
    float per_substep = 1.0f / (float)w->substeps;
    for (int k = 0; k < points; k++) {
        if (c->row[k].used) {
            td_point *p = &at.block->point[k];
            float impulse = (float)c->row[k].impulse;
            p->normal_impulse[at.lane] = per_substep * impulse;
            p->separation[at.lane] =
                (float)td_island_gap(work, c, k, (double)p->start_separation[at.lane]);
            td_history_of(at.block, points)[k].total[at.lane] = impulse;
        }
    }
    float along = tangent->used ? (float)tangent->impulse : 0.0f;
    at.block->tangent_impulse[at.lane] = per_substep * along;
    at.block->mark[at.lane].loaded |= TD_DIRECT;
    td_surface_at(at.block, points)->total[at.lane] = along;
}

bool td_island_load_stays(const thud_world *w, td_lane at, double impulse) {
    td_awake_slot a = td_slot_of_side(at.block->a[at.lane]);
    td_awake_slot b = td_slot_of_side(at.block->b[at.lane]);
    float inverse = td_max_float(td_inv_mass_of(w, a), td_inv_mass_of(w, b));
    return impulse / w->substeps * (double)inverse >
           TD_DIRECT_LEAVE * (double)td_islands_load_max(&w->islands, td_islands_size(w, a, b));
}

/* td_island_load_stays for constraint i of the problem, with the impulses of its unilateral and
 * equality rows. */
static bool is_loaded(const td_island_work *work, int i) {
    const td_direct_constraint *c = &work->problem.constraints[i];
    double impulse = td_direct_load(c);
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        impulse += c->row[k].kind == TD_ROW_EQUALITY ? td_abs(c->row[k].impulse) : 0.0;
    }
    return td_island_load_stays(work->w, td_island_lane(work, i), impulse);
}

/* Whether bodies of the island move against each other, or against static and kinematic bodies, in
 * the soft solver's result (td_nearly_at_rest). */
static bool is_in_motion(const td_island_work *work) {
    bool moves = false;
    for (int i = 0; i < work->island->constraints; i++) {
        const td_direct_constraint *c = &work->problem.constraints[i];
        moves |= !td_nearly_at_rest(work->w, td_slot_of_side(c->block->a[c->lane]),
                                    td_slot_of_side(c->block->b[c->lane]));
    }
    return moves;
}

/* Counts the slow steps of the island in succession, in slow_steps of its bodies, and returns
 * whether there were more than island_slow_steps of the quality, or CALM_SLOW_STEPS_FACTOR times
 * that. An island that needs many factorisations in each step is usually in motion, and would go on
 * needing them. With island_slow_steps 0 any number is allowed. */
static bool is_slow(const td_island_work *work) {
    int allowed =
        work->w->quality.island_slow_steps * (is_in_motion(work) ? 1 : CALM_SLOW_STEPS_FACTOR);
    bool easy = work->problem.factorings <= EASY_FACTORINGS_MAX || allowed == 0;
    int steps_max = 0;
    for (int i = 0; i < work->island->bodies; i++) {
        uint16_t *slow_steps = td_slow_steps_at(work->w, work->slots[i]);
        int steps = *slow_steps % TD_SLOW_ONCE;
        *slow_steps = easy ? 0 : steps < TD_SLOW_STEPS ? *slow_steps + 1 : *slow_steps;
        steps_max = easy ? 0 : td_max_int(steps_max, steps + 1);
    }
    return allowed > 0 && steps_max > td_min_int(allowed, TD_SLOW_STEPS);
}

/* Whether the island gets no more than EASY_FACTORINGS_MAX factorisations: it consists of contacts
 * alone, is in motion, and is direct because a contact in it was overloaded. Its contacts change
 * from step to step, so that many factorisations in one step make none of the next ones easier.
 * Measured in collapsing heaps of 3,000 to 5,000 balls and boxes, whose sizes differ up to some
 * hundred times: with this limit or without it the overlap is that of the soft solver alone, while
 * the direct solver takes two thirds of the work with it. */
static bool has_motion_limit(const td_island_work *work) {
    const thud_quality *q = &work->w->quality;
    return work->joints == 0 && q->island_slow_steps > 0 && q->overlap_limit > 0.0f &&
           !q->detection->islands && is_in_motion(work);
}

/* An island with joints is jammed when its result was refused in JAMMED_STEPS steps in succession:
 * its bodies are entangled, and no velocities satisfy all rows. Chosen. Without this, 61 ragdolls
 * in a pit took 2983 ms in 300 steps instead of 1164, at the quality `exact`. */
enum { JAMMED_STEPS = 8 };

/* Counts a step without a usable result, at qualities whose island_slow_steps is 0, so that is_slow
 * counts none. Returns whether the island is jammed: after JAMMED_STEPS such steps in succession,
 * or after a single one if the island was not solved since its last cooldown. */
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

void td_island_keep_direct(thud_world *w, const td_island *island, bool loaded) {
    for (int i = 0; i < island->bodies; i++) {
        uint8_t *direct_steps =
            td_direct_steps_at(w, td_slot_in(&w->islands.slots, island->first_body + i));
        *direct_steps = loaded ? TD_DIRECT_STEPS : *direct_steps ? *direct_steps - 1 : 0;
    }
}

/* Writes the result of the island to the world, and keeps the island direct while it is loaded. */
static void write_result(const td_island_work *work) {
    bool loaded = false;
    for (int i = 0; i < work->island->constraints; i++) {
        write_constraint(work, i);
        loaded |= is_loaded(work, i);
    }
    td_island_write_bodies(work);
    td_island_keep_direct(work->w, work->island, loaded);
}

/* Islands with joints of up to this many bodies have the short cooldown TD_PAUSE_STEPS, and are
 * solved directly in each step even if they are slow: under the soft solver their joints would come
 * apart. Chosen; the same as TD_RESOLVE_BODIES_MAX. */
enum { SMALL_ISLAND_BODIES_MAX = 128 };

static bool is_small_with_joints(const td_island_work *work) {
    return work->joints > 0 && work->island->bodies <= SMALL_ISLAND_BODIES_MAX;
}

/* Steps of the cooldown after a result that was refused; 0: none.
 * `limited`: the island had the limit of has_motion_limit. */
static int cooldown_after(const td_island_work *work, bool limited) {
    bool has_cooldowns = work->w->quality.island_slow_steps > 0;
    if (work->bounces) {
        return 0;
    }
    if (!has_cooldowns && work->joints > 0 && is_jammed(work)) {
        return TD_PAUSE_STEPS;
    }
    if (!has_cooldowns && !work->problem.spent) {
        return 0;
    }
    return is_small_with_joints(work) ? TD_PAUSE_STEPS
           : limited                  ? TD_MOTION_PAUSE_STEPS
                                      : TD_COOLDOWN_STEPS;
}

/* Begins a cooldown of `steps` steps, or none for 0. If it is the full one, TD_COOLDOWN_STEPS, and
 * EASY_FACTORINGS_MAX factorisations of the island cost more than the quality's island_work, the
 * island has the longest cooldown at once. */
static void begin_cooldown(thud_world *w, const td_island *island, int steps) {
    bool dear = EASY_FACTORINGS_MAX * td_island_cost(island) > w->quality.island_work;
    if (steps > 0) {
        td_islands_begin_cooldown(w, island, steps, dear && steps == TD_COOLDOWN_STEPS);
    }
}

/* Solves an island as a tree, unless that was tried before the soft solver. */
static td_tree_outcome tree_outcome(thud_world *w, const td_island *island) {
    if (!w->joint_hooks) {
        return TD_TREE_REFUSED;
    }
    return island->tree == TD_TREE_UNTRIED ? w->joint_hooks->solve_tree(w, island, NULL)
                                           : island->tree;
}

bool td_island_solve(thud_world *w, const td_island *island) {
    /* Steps; also of an island for which nothing of the step's budget is left. */
    int cooldown = w->quality.island_slow_steps > 0 ? TD_COOLDOWN_STEPS : 0;
    w->stats.direct_islands++;
    w->stats.direct_bodies += island->bodies;
    td_tree_outcome tree = tree_outcome(w, island);
    if (tree == TD_TREE_SOLVED) {
        w->joint_hooks->write_tree(w, island);
        return true;
    }
    if (tree == TD_TREE_SPENT) {
        w->stats.soft_islands++; /* the next step tries it again */
        return false;
    }
    int factorings = td_island_factoring_budget(w, td_island_cost(island));
    if (factorings > 0) {
        td_island_work work = td_island_set_up(w, island);
        bool limited = has_motion_limit(&work);
        if (limited) {
            work.problem.factoring_budget = td_min_int(factorings, EASY_FACTORINGS_MAX);
        }
        if (!work.bounces && td_island_compute(&work) &&
            (!is_slow(&work) || is_small_with_joints(&work))) {
            write_result(&work);
            return true;
        }
        cooldown = cooldown_after(&work, limited);
    }
    w->stats.soft_islands++;
    begin_cooldown(w, island, cooldown);
    return false;
}

void td_islands_begin(thud_world *w) {
    td_islands_count_down(w);
    td_island_store_start(w);
}

/* thud_island_solver.end: solves all listed islands, marks those that are direct in the next step,
 * and counts the step's errors anew where at least one island has a direct result. */
static void end(thud_world *w) {
    for (int i = 0; i < w->islands.island.count; i++) {
        td_island_solve(w, TD_AT(td_island, &w->islands.island, i));
    }
    td_islands_mark_loaded(w);
    if (w->stats.direct_islands > w->stats.soft_islands) {
        td_errors_recount(w);
    }
}

const thud_island_solver thud_islands_direct = {td_islands_find, td_islands_begin, end};
