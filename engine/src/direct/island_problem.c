/* island_problem.c: sets up the problem of direct.h for an island: bodies, rows and warm-start
 * impulses.
 *
 * The unknown is the mean velocity over the step. A body's free mean velocity is half the sum of
 * its velocity before the step and that after all substeps without constraints, so that a body
 * without constraints ends the step with the same velocity as under the soft solver. */
#include "direct/elimination_order.h"
#include "direct/island_step.h"
#include "solver/damping.h"

#include <string.h>

/* Maximum of an island's budget of factorisations in a step, at any quality; island_step_joints.c
 * gives islands with joints a multiple of their budget. Chosen. */
enum { ISLAND_FACTORINGS_MAX = 200 };

/* Greatest rotation of a body in the step, rad, for which its contacts' lever arms of the start of
 * the step are good enough; beyond it the direct result is refused. Chosen: the arms then are
 * 1 - cos 0.4 = 8 % too long. */
#define TURN_MAX 0.4

/* Lanes whose impulses are the direct solver's start the soft solver without a warm start: where a
 * light body is between heavy ones, the soft solver could not reduce such an impulse within one
 * step. */
void td_island_store_start(thud_world *w) {
    td_islands *s = &w->islands;
    for (int i = 0; i < s->slots.count; i++) {
        memcpy(td_at(&s->island_start_velocity, i), td_row(&w->velocity, td_slot_in(&s->slots, i)),
               sizeof(float[4]));
    }
    for (int i = 0; i < s->constraints.count; i++) {
        const td_constraint *constraint = td_constraint_at(w, td_int_at(&s->constraints, i));
        td_lane at = td_lane_of(w, constraint);
        bool from_soft = !(at.block->mark[at.lane].loaded & TD_DIRECT);
        float kept = from_soft ? 1.0f : 0.0f;
        td_island_store_impulses(w, i, from_soft);
        for (int k = 0; k < td_island_points(w, constraint); k++) {
            at.block->point[k].normal_impulse[at.lane] *= kept;
        }
        at.block->tangent_impulse[at.lane] *= kept;
        at.block->mark[at.lane].loaded &= TD_DIRECT - 1;
    }
}

void td_island_store_impulses(thud_world *w, int i, bool from_soft) {
    const td_constraint *constraint = td_constraint_at(w, td_int_at(&w->islands.constraints, i));
    td_lane at = td_lane_of(w, constraint);
    float *impulses = td_at(&w->islands.impulses, i), steps = (float)w->substeps;
    for (int k = 0; k < td_island_points(w, constraint); k++) {
        impulses[k] = steps * at.block->point[k].normal_impulse[at.lane];
    }
    impulses[TD_DIRECT_TANGENT] = steps * at.block->tangent_impulse[at.lane];
    impulses[TD_DIRECT_ROWS] = from_soft ? 1.0f : 0.0f;
}

/* ---- the problem ---- */

void td_island_free_velocity(const thud_world *w, const td_island *island, int i, double before[3],
                             double free[3]) {
    td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + i);
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    const float *start = td_at(&w->islands.island_start_velocity, island->first_body + i);
    const float *substep_gain = td_row(&w->substep_gain, slot);
    float h = (float)(w->def.time_step / w->substeps);
    td_damping linear = td_damping_of(h * body->linear_damping);
    td_damping angular = td_damping_of(h * body->angular_damping);
    for (int k = 0; k < 3; k++) {
        const td_damping *damping = k < 2 ? &linear : &angular;
        double kept = 1.0 - (double)damping->lost;
        double gain = (double)(damping->gained * substep_gain[k]);
        double after = before[k] = (double)start[k];
        for (int n = 0; n < w->substeps; n++) {
            after = after * kept + gain;
        }
        free[k] = 0.5 * (before[k] + after);
    }
}

/* Mass, velocity before the step, and free mean velocity of body i. */
static void take_body(td_island_work *work, int i) {
    const td_body *body = td_body_at(work->w, td_body_of(work->w, work->slots[i]));
    td_direct_body *b = &work->problem.bodies[i];
    *b = (td_direct_body){.inverse_mass = (double)body->inv_mass,
                          .inverse_inertia = (double)body->inv_inertia};
    td_island_free_velocity(work->w, work->island, i, b->before, b->free);
    for (int k = 0; k < 3; k++) {
        b->velocity[k] = b->before[k];
    }
}

/* The number in the island of a lane's body, or TD_NONE if it is outside of the problem. */
static int side_of(const td_island_work *work, uint32_t record) {
    td_awake_slot slot = td_slot_of_side(record);
    return td_inv_mass_of(work->w, slot) > 0.0f ? td_island_number(work->w, work->island, slot)
                                                : TD_NONE;
}

/* The speed that a lane's body gives a row with Jacobian j, if it is outside of the problem
 * (`body` is TD_NONE): at the present velocity of a static or kinematic body, and the mean velocity
 * of the soft solver's result for a body of another island. */
static double known_of(const td_island_work *work, int body, uint32_t record, const double j[3]) {
    const thud_world *w = work->w;
    td_awake_slot slot = td_slot_of_side(record);
    const float *v = td_row(&w->velocity, slot), *delta = td_row(&w->delta, slot);
    bool moves = td_inv_mass_of(w, slot) > 0.0f;
    double speed = 0.0;
    for (int k = 0; k < 3 && body == TD_NONE; k++) {
        speed += j[k] * (moves ? (double)delta[k] / work->time : (double)v[k]);
    }
    return speed;
}

void td_island_set_known(const td_island_work *work, td_direct_constraint *c) {
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        td_direct_row *r = &c->row[k];
        r->known_speed = known_of(work, c->a, c->block->a[c->lane], r->a) +
                         known_of(work, c->b, c->block->b[c->lane], r->b);
    }
}

/* Sets up the rows of constraint i. */
static void take_constraint(td_island_work *work, int i) {
    thud_world *w = work->w;
    const td_constraint *constraint = td_constraint_at(w, work->constraints[i]);
    td_lane at = td_lane_of(w, constraint);
    const float *impulses = td_at(&w->islands.impulses, work->island->first_constraint + i);
    td_direct_constraint *c = &work->problem.constraints[i];
    *c = (td_direct_constraint){.block = at.block,
                                .lane = at.lane,
                                .kind = constraint->kind,
                                .a = side_of(work, at.block->a[at.lane]),
                                .b = side_of(work, at.block->b[at.lane])};
    if (c->a != TD_NONE && c->b != TD_NONE) {
        c->entry = td_sparse_find(work->problem.matrix, c->a, c->b);
        c->b_later = td_sparse_is_later(work->problem.matrix, c->b, c->a);
    }
    work->joints += !td_is_contact(constraint);
    work->bounces |= td_take_rows_of(w, constraint->kind)(w, at.block, at.lane, impulses, c);
    td_island_set_known(work, c);
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        const td_direct_row *r = &c->row[k];
        if (r->used && r->kind < TD_ROW_FRICTION) {
            double speed = r->kind == TD_ROW_EQUALITY ? td_abs(r->target_speed) : r->target_speed;
            work->correction_speed = td_max_double(work->correction_speed, speed);
        }
    }
}

/* A time budget (solver/budget.c) may have lowered the number of substeps; island_work is then
 * lowered in proportion. */
int64_t td_island_work_left(const thud_world *w) {
    return w->quality.island_work / w->quality.substeps * w->substeps - w->stats.island_work;
}

int td_island_factoring_budget(const thud_world *w, int64_t cost) {
    int64_t left = td_island_work_left(w) / cost;
    return left < 0 ? 0 : left < ISLAND_FACTORINGS_MAX ? (int)left : ISLAND_FACTORINGS_MAX;
}

double td_gravity_speed(const thud_world *w) {
    double x = (double)w->def.gravity.x, y = (double)w->def.gravity.y;
    return w->def.time_step * __builtin_sqrt(x * x + y * y);
}

static td_direct problem_of(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    s->matrix.current = island->system;
    return (td_direct){.bodies = s->bodies.data,
                       .constraints = s->rows.data,
                       .matrix = &s->matrix,
                       .step = s->step.data,
                       .work = s->work.data,
                       .body_count = island->bodies,
                       .constraint_count = island->constraints,
                       .factoring_budget = td_island_factoring_budget(w, td_island_cost(island)),
                       .effort = INT64_MAX,
                       .unit_speed = td_gravity_speed(w)};
}

td_island_work td_island_set_up(thud_world *w, const td_island *island) {
    td_islands *s = &w->islands;
    td_island_work work = {.w = w,
                           .island = island,
                           .problem = problem_of(w, island),
                           .slots = (const td_awake_slot *)s->slots.data + island->first_body,
                           .constraints =
                               (const int *)s->constraints.data + island->first_constraint,
                           .time = w->def.time_step,
                           .elapsed = w->def.time_step,
                           .next = w->def.time_step,
                           .turn_max = TURN_MAX};
    for (int i = 0; i < island->bodies; i++) {
        take_body(&work, i);
    }
    int soft = 0;
    for (int i = 0; i < island->constraints; i++) {
        const float *impulses = td_at(&s->impulses, island->first_constraint + i);
        soft += impulses[TD_DIRECT_ROWS] > 0.0f;
        take_constraint(&work, i);
    }
    /* At qualities that solve every island directly (overlap_limit 0), the direct solver has found
     * all impulses since a contact began, so that none comes from the soft solver. */
    work.problem.soft_warm_start =
        w->quality.overlap_limit > 0.0f && 2 * soft > island->constraints;
    return work;
}
