/* joint_subsystems.c: joints of islands that are left to the soft solver, because the whole island
 * is too expensive for the quality, is in its cooldown, or because one of its contacts bounces.
 *
 * A linkage is a set of bodies that joints connect. Where joints of a linkage are overloaded, its
 * bodies are solved directly by themselves. Contacts act on them by the impulses that the soft
 * solver found, as known forces; and each contact is also a unilateral row that keeps its gap from
 * closing further than in the soft solver's result; bodies outside of the linkage move as in that
 * result. So a body on a bridge does not sink into it while the gaps of the bridge's joints close.
 * Where no velocities are found that satisfy both joints and contacts, or there are no contacts,
 * the joints are solved alone with the known forces, if they are hinges and welds that form a tree;
 * otherwise the soft solver's result is kept.
 *
 * This is for machines beside or on a heap. A linkage with more contacts than bodies stays with the
 * soft solver: there the contacts, whose impulses are taken as known, determine the motion. */
#include "direct/joint_islands.h"

#include "constraint/constraint.h"
#include "direct/elimination_order.h"
#include "direct/lock_tree.h"

/* Budget of factorisations of a linkage, in place of what island_work allows; island_step_joints.c
 * multiplies it by BUDGET_WITH_CONTACTS, or in a linkage without contacts by TD_BUDGET_OF_JOINTS.
 * Measured: with a third of it, the joints of the wrecking ball's chain open by over 10 mm as the
 * ball hits the wall. */
enum { LINKAGE_FACTORINGS = 32 };
/* A linkage that has failed n times in succession is tried in one of 2^n steps, but never more
 * seldom than in one of 2^BACKOFF_MAX (32). Chosen. */
enum { BACKOFF_MAX = 5 };
/* If more joints than this are overloaded in the world, no linkage is solved: in a crowd of
 * ragdolls the solves would cost much and improve little. Chosen. */
enum { OVERLOADED_MAX = 64 };
/* A linkage is solved if at least one in OVERLOADED_PART of its joints is overloaded: the soft
 * solver corrects a few overloaded joints by itself. In a linkage of hinges and welds alone, such
 * as a chain, one in OVERLOADED_PART_OF_LOCKS is enough. Chosen. Measured on the wrecking ball with
 * 30 to 100 bricks, at the quality `default`: with 4 the widest gap of its chain is three quarters
 * of that with 2 (geometric mean). Machines with limits and motors need the higher share: while
 * such a machine is solved directly, the friction of its contacts is taken as known, and its feet
 * slide (seen in the walker, on rock). */
enum { OVERLOADED_PART = 2, OVERLOADED_PART_OF_LOCKS = 4 };

bool td_joint_subsystems_expected(const thud_world *w) {
    const uint8_t *direct_steps = w->direct_steps.data;
    const uint16_t *slow_steps = w->slow_steps.data;
    int any = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        any |= (direct_steps[slot.at] > TD_DIRECT_COOLDOWN) | TD_SLOW_LEFT(slow_steps[slot.at]);
    }
    return any != 0;
}

/* ---- which linkages are solved ---- */

/* Whether the body's linkage is skipped in this step, because it has failed in earlier ones
 * (BACKOFF_MAX). The number of failures is in slow_steps, which is otherwise unused while an island
 * is in its cooldown. */
static bool backs_off(const thud_world *w, td_awake_slot slot) {
    int failures = *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN
                       ? *td_slow_steps_at(w, slot) % TD_SLOW_ONCE
                       : 0;
    return w->steps % (1ull << td_min_int(failures, BACKOFF_MAX)) != 0;
}

/* Adds 1 to the number of failures of the linkage, which slow_steps of its bodies hold (backs_off),
 * or sets it to 0 if the linkage was solved. */
static void note_outcome(thud_world *w, const td_island *linkage, bool solved) {
    for (int i = 0; i < linkage->bodies; i++) {
        td_awake_slot slot = td_slot_in(&w->islands.slots, i);
        if (*td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN) {
            uint16_t *slow_steps = td_slow_steps_at(w, slot);
            int failures = *slow_steps % TD_SLOW_ONCE, left = *slow_steps - failures;
            *slow_steps = (uint16_t)(left + (solved ? 0 : td_min_int(failures + 1, BACKOFF_MAX)));
        }
    }
}

/* Whether the body is dynamic, not unfit, in no linkage yet, and its island is in its cooldown or
 * was refused. */
static bool is_soft(const thud_world *w, td_awake_slot slot) {
    int local = *td_island_local_at(w, slot);
    bool left = *td_direct_steps_at(w, slot) > TD_DIRECT_COOLDOWN && local != TD_ISLAND_UNFIT;
    bool tried = local == TD_ISLAND_REFUSED || local == TD_ISLAND_COOLING;
    return td_inv_mass_of(w, slot) > 0.0f && local <= 0 && (left || tried);
}

/* Whether the load of a joint is above its threshold (td_islands_load_max). */
static bool is_overloaded(const thud_world *w, const td_block *block, int lane, int kind) {
    td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
    float size = td_islands_size(w, a, b), off = 0.0f;
    float load = w->kinds[kind]->lanes->load(w, block, lane, size, &off);
    return load > td_islands_load_max(&w->islands, size);
}

/* The counts of add_joints_of: contacts with moving bodies, overloaded constraints of joints, and
 * constraints of kind TD_CONSTRAINT_LOCK, the only kind that hinges and welds have. */
typedef struct linkage_counts {
    int contacts, overloaded, locks;
} linkage_counts;

/* Adds the joints of a body to the linkage, each once, and the bodies at their other ends. False if
 * the linkage is too large, or contains a body that is marked as unfit. */
static bool add_joints_of(thud_world *w, td_island *linkage, td_awake_slot slot,
                          linkage_counts *counts) {
    td_body_index body = td_body_of(w, slot);
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state != TD_TOUCHING) {
            continue;
        }
        td_awake_slot other = td_island_neighbour(w, constraint, td_edge_side(e));
        if (td_is_contact(constraint)) {
            counts->contacts += other.at > 0;
            continue;
        }
        if (other.at && *td_island_local_at(w, other) == TD_ISLAND_UNFIT) {
            return false;
        }
        if (other.at && *td_island_local_at(w, other) <= 0) {
            td_island_add(w, linkage, other);
        }
        if (!other.at || !td_edge_side(e)) {
            td_lane at = td_lane_of(w, constraint);
            td_push_int(&w->islands.constraints, td_edge_constraint(e));
            linkage->constraints++;
            counts->overloaded += is_overloaded(w, at.block, at.lane, constraint->kind);
            counts->locks += constraint->kind == TD_CONSTRAINT_LOCK;
        }
    }
    return linkage->bodies <= TD_RESOLVE_BODIES_MAX &&
           linkage->constraints <= TD_RESOLVE_CONSTRAINTS_MAX;
}

/* Collects the linkage of a body, breadth first. False, with its bodies marked as unfit, where it
 * is too large, has more contacts than bodies, or few of its joints are overloaded. */
static bool collect(thud_world *w, td_awake_slot seed, td_island *linkage) {
    td_islands *s = &w->islands;
    bool whole = true;
    linkage_counts counts = {0};
    s->slots.count = s->constraints.count = 0;
    *linkage = (td_island){0};
    td_island_add(w, linkage, seed);
    for (int i = 0; whole && i < s->slots.count; i++) {
        whole = add_joints_of(w, linkage, td_slot_in(&s->slots, i), &counts);
    }
    bool locks = counts.locks == linkage->constraints;
    int part = locks ? OVERLOADED_PART_OF_LOCKS : OVERLOADED_PART;
    whole = whole && counts.contacts <= linkage->bodies &&
            part * counts.overloaded >= linkage->constraints;
    for (int i = 0; !whole && i < s->slots.count; i++) {
        *td_island_local_at(w, td_slot_in(&s->slots, i)) = TD_ISLAND_UNFIT;
    }
    return whole;
}

/* ---- contacts ---- */

/* Adds to the mean velocity that a body has without joints (`free`) what an impulse along (x, y)
 * gives that is spread evenly over the step: half of the change of velocity by its end. */
static void add_impulse(td_direct_body *b, double x, double y, double cross, double impulse) {
    b->free[0] += 0.5 * b->inverse_mass * x * impulse;
    b->free[1] += 0.5 * b->inverse_mass * y * impulse;
    b->free[2] += 0.5 * b->inverse_inertia * cross * impulse;
}

/* Adds the impulses that the soft solver found for a contact of a body. */
static void add_contact(td_direct_body *b, td_awake_slot slot, td_lane at, int points) {
    td_block *block = at.block;
    bool first = td_slot_of_side(block->a[at.lane]).at == slot.at;
    double sign = first ? -1.0 : 1.0;
    double x = sign * (double)block->nx[at.lane], y = sign * (double)block->ny[at.lane];
    for (int k = 0; k < points; k++) {
        const td_point *p = &block->point[k];
        double cross = sign * (double)(first ? p->cross_a[at.lane] : p->cross_b[at.lane]);
        bool acts = p->normal_mass[at.lane] > 0.0f;
        double impulse = (double)td_history_of(block, points)[k].total[at.lane];
        add_impulse(b, x, y, cross, acts ? impulse : 0.0);
    }
    double cross =
        sign * (double)(first ? block->tangent_cross_a : block->tangent_cross_b)[at.lane];
    bool has_friction = block->friction[at.lane] > 0.0f;
    double impulse = (double)td_surface_at(block, points)->total[at.lane];
    add_impulse(b, y, -x, cross, has_friction ? impulse : 0.0);
}

/* Appends the touching contacts of a linkage's bodies, each once, to its list of constraints, after
 * its joints. False where there are more constraints than TD_RESOLVE_CONSTRAINTS_MAX. */
static bool list_contacts(thud_world *w, td_island *linkage) {
    for (int i = 0; i < linkage->bodies; i++) {
        td_body_index body = td_body_of(w, td_slot_in(&w->islands.slots, i));
        for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            td_awake_slot other = td_island_neighbour(w, constraint, td_edge_side(e));
            bool first =
                !td_edge_side(e) || !other.at || td_island_number(w, linkage, other) == TD_NONE;
            if (constraint->state == TD_TOUCHING && td_is_contact(constraint) && first) {
                if (linkage->constraints == TD_RESOLVE_CONSTRAINTS_MAX) {
                    return false;
                }
                td_push_int(&w->islands.constraints, td_edge_constraint(e));
                linkage->constraints++;
            }
        }
    }
    return true;
}

/* Sets up the rows that keep contacts from closing further. Their impulses start from 0 and are
 * added to the known ones. They have no friction, since that of the known impulses already acts. */
static void set_contact_rows(td_island_work *work) {
    for (int i = 0; i < work->island->constraints; i++) {
        td_direct_constraint *c = &work->problem.constraints[i];
        if (!td_is_contact(td_constraint_at(work->w, work->constraints[i]))) {
            continue;
        }
        td_lane at = td_island_lane(work, i);
        c->from_soft = true;
        for (int k = 0; k < TD_DIRECT_TANGENT; k++) {
            double gap = (double)at.block->point[k].start_separation[at.lane];
            c->row[k].impulse = 0.0;
            c->row[k].target_speed = gap > 0.0 ? -gap / work->time : 0.0;
        }
        c->row[TD_DIRECT_TANGENT].used = false;
    }
}

/* Adds the known impulses of all contacts to the free velocities. */
static void add_contacts(td_island_work *work) {
    const thud_world *w = work->w;
    for (int i = 0; i < work->island->bodies; i++) {
        td_awake_slot slot = work->slots[i];
        int e = td_body_at(w, td_body_of(w, slot))->first_constraint;
        for (; e != TD_NONE; e = td_next_edge(w, e)) {
            const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
            if (constraint->state == TD_TOUCHING && td_is_contact(constraint)) {
                add_contact(&work->problem.bodies[i], slot, td_lane_of(w, constraint),
                            td_island_points(w, constraint));
            }
        }
    }
}

/* ---- the solution ---- */

static double energy_of(const td_direct_body *b, const double v[3]) {
    double turning = b->own_inverse_inertia > 0.0 ? v[2] * v[2] / b->own_inverse_inertia : 0.0;
    return (v[0] * v[0] + v[1] * v[1]) / b->inverse_mass + turning;
}

/* Whether the result has more energy than both the start of the step and the soft solver's result,
 * beyond what closing gaps adds. The known impulses of contacts do not depend on the joints'
 * solution, and could add energy again in each step. */
static bool gains_energy(const td_island_work *work, double pushed) {
    double before = 0.0, soft = 0.0, after = 0.0, mass = 0.0;
    for (int i = 0; i < work->island->bodies; i++) {
        const td_direct_body *b = &work->problem.bodies[i];
        const float *v = td_row(&work->w->velocity, work->slots[i]);
        const float *start = td_row(&work->w->islands.start_velocity, work->slots[i]);
        before += energy_of(b, (double[]){(double)start[0], (double)start[1], (double)start[2]});
        soft += energy_of(b, (double[]){(double)v[0], (double)v[1], (double)v[2]});
        after += energy_of(b, b->velocity);
        mass += 1.0 / b->inverse_mass;
    }
    return after > td_max_double(before, soft) + mass * pushed * pushed;
}

/* Solves the joints of a linkage alone, as a tree of locks, under the known impulses of its
 * contacts. A contact may then overlap further than in the soft solver's result, since its impulse
 * is that of other velocities; the next step pushes it apart. False where the joints form no such
 * tree, or that fails. */
static bool solve_as_tree(td_island_work *work, thud_world *w, const td_island *joints) {
    *work = td_island_set_up(w, joints);
    add_contacts(work);
    td_direct_body *bodies = work->problem.bodies;
    if (w->joint_hooks->solve_tree(w, joints, bodies) != TD_TREE_SOLVED) {
        return false;
    }
    const td_lock_result *results = w->islands.results.data;
    for (int i = 0; i < joints->bodies; i++) {
        td_direct_body *b = &bodies[td_island_number(w, joints, results[i].slot)];
        b->own_inverse_inertia = b->inverse_inertia;
        for (int k = 0; k < 3; k++) {
            b->velocity[k] = (double)results[i].velocity[k];
            b->moved[k] = (double)results[i].moved[k];
        }
    }
    return true;
}

/* Solves the joints of a linkage with rows for its contacts. False where that fails. Sets *pushed:
 * the speed that closing gaps and overlaps may add (gains_energy). */
static bool solve_with_contacts(td_island_work *work, thud_world *w, const td_island *linkage,
                                double *pushed) {
    *work = td_island_set_up(w, linkage);
    *pushed = work->correction_speed + work->problem.unit_speed;
    work->problem.factoring_budget = LINKAGE_FACTORINGS;
    add_contacts(work);
    set_contact_rows(work);
    return td_island_compute(work);
}

/* Solves the linkage of a body. Velocities and motions are overwritten; the joints' impulses stay
 * the soft solver's, since they are its warm start in the next step. */
static void solve_one(thud_world *w, td_awake_slot seed) {
    td_island linkage;
    bool counted =
        *td_island_local_at(w, seed) == TD_ISLAND_REFUSED; /* the bodies of a refused island are in
                                                              stats.direct_bodies already */
    if (!collect(w, seed, &linkage)) {
        return;
    }
    td_island joints = linkage;
    if (!list_contacts(w, &linkage) || !td_joint_island_begin(w, &linkage)) {
        return;
    }
    joints.system = linkage.system;
    td_island_work work;
    double pushed;
    bool alone = joints.constraints == linkage.constraints; /* the linkage has no contacts */
    bool solved =
        (alone && solve_as_tree(&work, w, &joints)) ||
        (solve_with_contacts(&work, w, &linkage, &pushed) && !gains_energy(&work, pushed)) ||
        (!alone && solve_as_tree(&work, w, &joints) && !gains_energy(&work, pushed));
    note_outcome(w, &linkage, solved);
    if (solved) {
        td_island_write_bodies(&work);
        w->stats.direct_islands++;
        w->stats.direct_bodies += counted ? 0 : linkage.bodies;
    }
}

/* Lists one body of each overloaded joint. False where there are more than OVERLOADED_MAX. */
static bool list_seeds(thud_world *w, td_awake_slot *seeds, int *count) {
    *count = 0;
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int kind = block->used ? td_constraint_at(w, block->constraint[0])->kind : 0;
        for (int lane = 0; kind >= TD_PAIR_COUNT && lane < block->used; lane++) {
            td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
            td_awake_slot seed = is_soft(w, a) ? a : b;
            if (is_soft(w, seed) && is_overloaded(w, block, lane, kind)) {
                if (*count == OVERLOADED_MAX) {
                    return false;
                }
                seeds[(*count)++] = seed;
            }
        }
    }
    return true;
}

void td_joint_subsystems_solve(thud_world *w, td_system last) {
    td_islands *s = &w->islands;
    int rows = s->matrix.row.count, count = 0;
    td_awake_slot seeds[OVERLOADED_MAX];
    bool few = list_seeds(w, seeds, &count);
    for (int i = 0; few && i < count; i++) {
        if (is_soft(w, seeds[i]) && !backs_off(w, seeds[i])) {
            s->matrix.current = last;
            solve_one(w, seeds[i]);
            s->matrix.row.count = rows;
        }
    }
}
