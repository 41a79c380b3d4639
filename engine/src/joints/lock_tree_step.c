/* lock_tree_step.c: the steps of direct islands whose constraints are hinges and welds, without
 * limits, springs or motors, that form a tree joined to the world at one body at most.
 *
 * The method is that of direct/island_step_joints.c, which solves any island; in a tree of locks
 * the rows need no matrix (lock_tree.h), and islands that are trees of the same shape are solved
 * side by side (wide_lock_tree_parts.c). This file turns islands into such trees, and writes the
 * results of trees to the islands' bodies and joints. Islands that are refused here are solved by
 * island_step_joints.c. */
#include "direct/island_step.h"

#include "constraint/joint_hooks.h"
#include "direct/elimination_order.h"
#include "direct/joint_parts.h"
#include "direct/lock_tree.h"
#include "direct/step_parts.h"
#include "joints/joint.h"

#include <string.h>

/* The work that solving a tree once takes for each of its bodies, in operations on 3 x 3 blocks,
 * the unit of thud_quality.island_work. Measured by counting the instructions that a tree takes
 * that is alone in the lanes of its vectors. */
enum { TREE_COST = 1 };
/* Number of solutions that a part is expected to take. take_trees counts the expected cost of each
 * tree; where the budget of the step does not suffice, the trees that are left over stay with the
 * soft solver. Measured on swinging chains at the quality `default`. */
enum { SOLUTIONS_OF_PART = 3 };

/* Islands that are solved side by side. */
typedef struct tree_group {
    thud_world *w;
    td_lock_trees trees;
    td_lock_step step;
    const td_island *island[TD_TREES];
    const td_listed_body *list[TD_TREES];
    bool kept[TD_TREES]; /* the tree is solved, and its result kept */
    int used;            /* number of islands */
} tree_group;

/* ---- an island as a tree ---- */

/* The number in the island of a lane's body, or TD_NONE if it is not dynamic. */
static int number_of(const thud_world *w, const td_island *island, uint32_t side) {
    td_awake_slot slot = td_slot_of_side(side);
    return td_inv_mass_of(w, slot) > 0.0f ? td_island_number(w, island, slot) : TD_NONE;
}

/* The constraint of the island's joint number `link`. */
static const td_constraint *joint_at(const thud_world *w, const td_island *island, int link) {
    int index = td_int_at(&w->islands.constraints, island->first_constraint + link);
    return td_constraint_at(w, index);
}

/* Sets, for every body, the body with a smaller number to which a joint connects it (`before`), and
 * that joint's number in the island (`link`). Sets *held to the body that a joint connects to a
 * body outside of the island, and *hold to that joint's number; TD_NONE if there is none. False
 * where a constraint does not lock both directions of a frame that does not turn, or the joints
 * form no tree. */
static bool list_joints(const thud_world *w, const td_island *island, td_listed_body *list,
                        int *held, int *hold) {
    for (int i = 0; i < island->bodies; i++) {
        list[i].before = list[i].link = list[i].place = TD_NONE;
    }
    *held = *hold = TD_NONE;
    for (int i = 0; i < island->constraints; i++) {
        const td_constraint *constraint = joint_at(w, island, i);
        if (constraint->kind != TD_CONSTRAINT_LOCK) {
            return false;
        }
        td_lane at = td_lane_of(w, constraint);
        const td_point *p = at.block->point;
        bool is_point = p[0].normal_mass[at.lane] > 0.0f && p[1].normal_mass[at.lane] > 0.0f &&
                        td_lock_rows_at(at.block)->frame_turns[at.lane] <= 0.0f;
        int a = number_of(w, island, at.block->a[at.lane]);
        int b = number_of(w, island, at.block->b[at.lane]);
        int later = td_max_int(a, b), before = td_min_int(a, b);
        if (!is_point || (before != TD_NONE ? list[later].link : *held) != TD_NONE) {
            return false;
        }
        if (before != TD_NONE) {
            list[later].before = before;
            list[later].link = i;
        } else {
            *held = later;
            *hold = i;
        }
    }
    return true;
}

/* Puts a body at an index of the tree. `number`: the body's number in the island; `parent`: the
 * index of its parent in the tree; `joint`: the number of the joint to the parent in the island, or
 * TD_NONE. */
static void place(td_listed_body *list, int number, int index, int parent, int joint) {
    list[number].place = index;
    list[index].number = number;
    list[index].parent = parent;
    list[index].joint = joint;
}

/* Numbers the bodies so that each comes after its parent. The root is the body that is joined to
 * the outside, or else the first of the list. Links (`before`) lead from each body towards the
 * first body of the list. On the path from the root to that body they have to be reversed: there
 * body n is the parent of list[n].before. */
static void set_order(td_listed_body *list, int count, int held, int hold) {
    int placed = 0, joint = hold;
    for (int n = held == TD_NONE ? 0 : held; n != TD_NONE; n = list[n].before) {
        place(list, n, placed, placed ? placed - 1 : TD_NONE, joint);
        joint = list[n].link;
        placed++;
    }
    for (int n = 0; n < count; n++) {
        if (list[n].place == TD_NONE) {
            place(list, n, placed++, list[list[n].before].place, list[n].link);
        }
    }
}

/* What forces, damping and the known impulses of contacts add to the mean velocity of a body in the
 * step. Without damping and contacts it is half of what forces add in all substeps, which needs no
 * loop over substeps; td_island_free_velocity would give the same, up to rounding. */
static void take_gain(const thud_world *w, const td_island *island, const td_direct_body *known,
                      td_listed_body *t) {
    td_awake_slot slot = td_slot_in(&w->islands.slots, island->first_body + t->number);
    const td_body *body = td_body_at(w, td_body_of(w, slot));
    const float *substep_gain = td_row(&w->substep_gain, slot);
    bool damped = body->linear_damping > 0.0f || body->angular_damping > 0.0f;
    double before[3], free[3];
    if (known) {
        memcpy(free, known[t->number].free, sizeof free);
    } else if (damped) {
        td_island_free_velocity(w, island, t->number, before, free);
    }
    for (int k = 0; k < 3; k++) {
        double gain = 0.5 * w->substeps * (double)substep_gain[k];
        t->gain[k] = known || damped ? free[k] - t->velocity[k] : gain;
    }
    t->turns = body->inv_inertia > 0.0f;
    t->mass = 1.0 / (double)body->inv_mass;
    t->inertia = t->turns ? 1.0 / (double)body->inv_inertia : 1.0;
}

/* Sets mass and velocities of a body. */
static void take_body(const thud_world *w, const td_island *island, const td_direct_body *known,
                      td_listed_body *t) {
    const float *start = td_at(&w->islands.island_start_velocity, island->first_body + t->number);
    for (int k = 0; k < 3; k++) {
        t->velocity[k] = (double)start[k];
        t->outside[k] = 0.0;
    }
    take_gain(w, island, known, t);
    t->block = NULL;
    t->sweeps = t->weld = false;
}

/* A lever arm from its crosses with the directions u and v of a joint's frame. */
static void arm_of(double x, double y, float cross_u, float cross_v, bool turns, double arm[2]) {
    double u = turns ? (double)cross_u : 0.0, v = turns ? (double)cross_v : 0.0;
    arm[0] = x * v + y * u;
    arm[1] = y * v - x * u;
}

/* Sets the joint of a body. False where it is a weld and one of its bodies does not turn. */
static bool take_joint(const thud_world *w, const td_island *island, td_listed_body *list, int i) {
    td_listed_body *t = &list[i], *parent = t->parent == TD_NONE ? NULL : &list[t->parent];
    td_lane at = td_lane_of(w, joint_at(w, island, t->joint));
    const td_point *p = &at.block->point[0], *q = &at.block->point[1];
    const td_lock_rows *rows = td_lock_rows_at(at.block);
    const float *impulses = td_at(&w->islands.impulses, island->first_constraint + t->joint);
    int lane = at.lane;
    bool is_b = number_of(w, island, at.block->b[lane]) == t->number;
    bool holder_turns = !parent || parent->turns;
    double x = t->axis[0] = (double)at.block->nx[lane], y = t->axis[1] = (double)at.block->ny[lane];
    double sign = t->sign = is_b ? 1.0 : -1.0;
    double half = 0.5; /* the impulses of the mean velocity are half of those of the step */
    t->block = at.block;
    t->lane = lane;
    double u = sign * (double)p->start_separation[lane],
           v = sign * (double)q->start_separation[lane];
    arm_of(x, y, p->cross_a[lane], q->cross_a[lane], is_b ? holder_turns : t->turns,
           is_b ? t->holder : t->arm);
    arm_of(x, y, p->cross_b[lane], q->cross_b[lane], is_b ? t->turns : holder_turns,
           is_b ? t->arm : t->holder);
    t->gap[0] = x * u - y * v;
    t->gap[1] = y * u + x * v;
    t->impulse[0] = half * sign * (x * (double)impulses[0] - y * (double)impulses[1]);
    t->impulse[1] = half * sign * (y * (double)impulses[0] + x * (double)impulses[1]);
    t->weld = at.block->tangent_mass[lane] > 0.0f;
    double turn_sign = sign * (double)rows->turn_sign[lane];
    t->turn_gap = t->weld ? turn_sign * (double)rows->start_turn_gap[lane] : 0.0;
    t->impulse[2] = t->weld ? half * turn_sign * (double)impulses[TD_DIRECT_TANGENT] : 0.0;
    t->sweeps |= !td_arm_is_centred(w, t->arm[0], t->arm[1]);
    if (parent) {
        parent->sweeps |= !td_arm_is_centred(w, t->holder[0], t->holder[1]);
    } else {
        const float *outside =
            td_row(&w->velocity, td_slot_of_side((is_b ? at.block->a : at.block->b)[lane]));
        for (int k = 0; k < 3; k++) {
            t->outside[k] = (double)outside[k];
        }
    }
    return !t->weld || (t->turns && holder_turns);
}

/* Reads the island as a tree of bodies and joints, into `list`. False where it is no tree of locks
 * that can be solved. */
static bool take_tree(const thud_world *w, const td_island *island, const td_direct_body *known,
                      td_listed_body *list) {
    int held, hold;
    if (!list_joints(w, island, list, &held, &hold)) {
        return false;
    }
    set_order(list, island->bodies, held, hold);
    bool sound = true;
    for (int i = 0; i < island->bodies; i++) {
        take_body(w, island, known, &list[i]);
        if (list[i].joint != TD_NONE) {
            sound &= take_joint(w, island, list, i);
        }
    }
    return sound;
}

/* The number of parts that the step has to be divided into, by the angular velocities before the
 * step; 0: too many. */
static int parts_before(const thud_world *w, const td_island *island, const td_listed_body *list) {
    double fastest = 0.0;
    for (int i = 0; i < island->bodies; i++) {
        double rate = td_abs(list[i].velocity[2]);
        fastest = list[i].sweeps ? td_max_double(fastest, rate) : fastest;
    }
    return td_parts_of(w, island, fastest, true, 0.0);
}

/* ---- a group ---- */

static tree_group group_of(thud_world *w) {
    double tolerance = td_island_tolerance(w);
    bool everywhere = w->quality.overlap_limit == 0.0f;
    return (tree_group){.w = w,
                        .trees = {.bodies = w->islands.locks.data},
                        .step = {.world = w,
                                 .time = w->def.time_step,
                                 .tolerance = tolerance,
                                 .enough = (everywhere ? TD_RESIDUAL_EXACT : 1.0) * tolerance,
                                 .gravity_speed = td_gravity_speed(w),
                                 .end_enough = TD_END_ERROR_MAX * td_gravity_speed(w),
                                 .speed_max = (double)(w->def.maximum_speed * w->length_scale)}};
}

/* Whether two trees of `count` bodies have the same shape. */
static bool are_alike(const td_listed_body *one, const td_listed_body *other, int count) {
    bool alike = true;
    for (int i = 0; i < count && alike; i++) {
        const td_listed_body *t = &one[i], *u = &other[i];
        alike = t->parent == u->parent && (t->joint == TD_NONE) == (u->joint == TD_NONE) &&
                t->weld == u->weld && t->turns == u->turns;
    }
    return alike;
}

/* Sets the shape of the trees from the list of one of them, and clears the fields that set_body
 * does not set. */
static void set_shape(tree_group *g, const td_listed_body *list) {
    td_reals zero = {0.0};
    memset(g->trees.used, 0, sizeof g->trees.used);
    for (int i = 0; i < g->trees.count; i++) {
        td_lock_body *t = &g->trees.bodies[i];
        if (!i) {
            *t = (td_lock_body){0};
        }
        for (int k = 0; k < 3; k++) {
            t->moved[k] = t->g[k] = zero;
        }
        for (int k = 0; k < 6; k++) {
            t->a[k] = zero;
        }
        t->turn_target = t->turn_impulse = t->stiff = zero;
        t->parent = list[i].parent;
        t->joined = list[i].joint != TD_NONE;
        t->weld = list[i].weld;
        t->turns = list[i].turns;
    }
}

/* Sets a body in the lane of a tree from that tree's list. Returns the wider component of its
 * joint's gap. */
static double set_body(const tree_group *g, int i, int tree) {
    const td_listed_body *from = &g->list[tree][i];
    td_lock_body *t = &g->trees.bodies[i];
    double widest = 0.0;
    t->mass[tree] = from->mass;
    t->inertia[tree] = from->inertia;
    t->sweeps[tree] = from->sweeps;
    for (int k = 0; k < 3; k++) {
        t->velocity[k][tree] = from->velocity[k];
        t->gain[k][tree] = from->gain[k];
    }
    for (int k = 0; k < 3 && !i; k++) {
        t->outside[k][tree] = from->outside[k];
    }
    for (int k = 0; k < 2 && t->joined; k++) {
        t->arm[k][tree] = from->arm[k];
        t->holder[k][tree] = from->holder[k];
        t->axis[k][tree] = from->axis[k];
        t->gap[k][tree] = from->gap[k];
        t->impulse[k][tree] = from->impulse[k];
        widest = td_max_double(widest, td_abs(from->gap[k]));
    }
    if (t->weld) {
        t->turn_gap[tree] = from->turn_gap;
        t->turn_impulse[tree] = from->impulse[2];
    }
    return widest;
}

/* Sets the lanes of all trees, body by body. */
static void set_lanes(tree_group *g) {
    double speed_max = (double)(TD_JOINT_CLOSING_SPEED * g->w->length_scale),
           widest[TD_TREES] = {0.0};
    for (int i = 0; i < g->trees.count; i++) {
        for (int tree = 0; tree < g->used; tree++) {
            widest[tree] = td_max_double(widest[tree], set_body(g, i, tree));
        }
    }
    for (int tree = 0; tree < g->used; tree++) {
        g->trees.closing[tree] = td_min_double(widest[tree] / g->step.time, speed_max);
        g->trees.used[tree] = true;
    }
}

/* Component k (2: the turn) of a joint's gap after the step, by the motions of both bodies and of
 * the lever arms. */
static double gap_after(const td_lock_trees *trees, const td_lock_body *t, int k, int tree,
                        double time) {
    double held =
        t->parent == TD_NONE ? time * t->outside[k][tree] : trees->bodies[t->parent].moved[k][tree];
    double moved = t->moved[k][tree] - held;
    return k == 2 ? t->turn_gap[tree] + moved
                  : t->gap[k][tree] + moved + (t->arm_now[k][tree] - t->arm[k][tree]) -
                        (t->holder_now[k][tree] - t->holder[k][tree]);
}

/* Stores the result of a body and of its joint. `of_substep`: the factor from the impulses of the
 * last part to those of a substep, 1 / (share of the part in the step * substeps). */
static void keep_result(const tree_group *g, int i, int tree, double of_substep,
                        td_lock_result *result) {
    const td_listed_body *from = &g->list[tree][i];
    const td_lock_body *t = &g->trees.bodies[i];
    const thud_world *w = g->w;
    *result = (td_lock_result){.slot = td_slot_in(&w->islands.slots,
                                                  g->island[tree]->first_body + from->number),
                               .block = from->block,
                               .lane = from->lane};
    for (int k = 0; k < 3; k++) {
        result->velocity[k] = (float)t->velocity[k][tree];
        result->moved[k] = (float)t->moved[k][tree];
    }
    if (!t->joined) {
        return;
    }
    double x = from->axis[0], y = from->axis[1], sign = from->sign;
    double turn_sign = sign * (double)td_lock_rows_at(from->block)->turn_sign[from->lane];
    double along = t->impulse[0][tree], across = t->impulse[1][tree];
    double gap_x = gap_after(&g->trees, t, 0, tree, g->step.time);
    double gap_y = gap_after(&g->trees, t, 1, tree, g->step.time);
    result->impulse[0] = (float)(of_substep * sign * (x * along + y * across));
    result->impulse[1] = (float)(of_substep * sign * (x * across - y * along));
    result->impulse[TD_DIRECT_TANGENT] = (float)(of_substep * turn_sign * t->turn_impulse[tree]);
    result->separation[0] = (float)(sign * (x * gap_x + y * gap_y));
    result->separation[1] = (float)(sign * (x * gap_y - y * gap_x));
    if (t->weld) {
        result->turn_gap = (float)(turn_sign * gap_after(&g->trees, t, 2, tree, g->step.time));
    }
}

/* Keeps the results of the trees that are solved, body by body. */
static void keep_results(const tree_group *g) {
    td_islands *s = &g->w->islands;
    double of_substep[TD_TREES];
    for (int tree = 0; tree < TD_TREES; tree++) {
        of_substep[tree] = 1.0 / (g->trees.share[tree] * g->w->substeps);
    }
    for (int i = 0; i < g->trees.count; i++) {
        for (int tree = 0; tree < g->used; tree++) {
            if (g->trees.solved[tree]) {
                keep_result(g, i, tree, of_substep[tree],
                            td_at(&s->results, g->island[tree]->first_body + i));
            }
        }
    }
}

/* Solves the trees of the group, and keeps their results. */
static void solve_group(tree_group *g) {
    g->trees.count = g->island[0]->bodies;
    g->step.island = g->island[0];
    set_shape(g, g->list[0]);
    set_lanes(g);
    TD_PICK_WIDE(g->w, td_lock_tree_parts)(&g->trees, &g->step);
    keep_results(g);
    for (int tree = 0; tree < g->used; tree++) {
        int solutions = g->trees.factorings[tree];
        g->w->stats.factorings += solutions;
        g->w->stats.island_work += (int64_t)solutions * TREE_COST * g->trees.count;
        g->kept[tree] = g->trees.solved[tree];
    }
}

td_tree_outcome td_lock_tree_step(thud_world *w, const td_island *island,
                                  const td_direct_body *known) {
    td_listed_body *list = w->islands.listed.data;
    if (!known && td_island_work_left(w) <= 0) {
        return TD_TREE_SPENT;
    }
    int parts = take_tree(w, island, known, list) ? parts_before(w, island, list) : 0;
    if (parts == 0) {
        return TD_TREE_REFUSED;
    }
    tree_group g = group_of(w);
    g.island[0] = island;
    g.list[0] = list;
    g.used = 1;
    solve_group(&g);
    return g.kept[0] ? TD_TREE_SOLVED : TD_TREE_REFUSED;
}

/* The list of an island, in td_islands.listed. */
static td_listed_body *list_at(const thud_world *w, const td_island *island) {
    return TD_AT(td_listed_body, &w->islands.listed, island->first_body);
}

/* Reads all listed islands as trees, into td_islands.listed. Sets td_island.parts of those that are
 * to be solved, and td_island.tree of the others to the reason why they are not. The budget is
 * reduced by the expected cost of each tree, not by its actual cost: so which trees are within the
 * budget does not depend on which of them are solved side by side. */
static void take_trees(thud_world *w) {
    int64_t left = td_island_work_left(w);
    for (int i = 0; i < w->islands.island.count; i++) {
        td_island *island = TD_AT(td_island, &w->islands.island, i);
        td_listed_body *list = list_at(w, island);
        island->parts = 0;
        island->tree = left > 0 ? TD_TREE_REFUSED : TD_TREE_SPENT;
        if (left > 0 && take_tree(w, island, NULL, list)) {
            island->parts = parts_before(w, island, list);
            left -= (int64_t)island->parts * SOLUTIONS_OF_PART * TREE_COST * island->bodies;
        }
    }
}

/* Trees for a group are searched among this many islands after its first one. Chosen. */
enum { ISLANDS_AHEAD = 64 };

/* Adds islands to the group, from island `first` on, until it is full: those whose trees have the
 * shape of the group's first tree (any shape, while the group is empty) and that require `parts`
 * parts, or with `any_parts` any number of parts. */
static void join_alike(tree_group *g, td_island *members[TD_TREES], int first, int parts,
                       bool any_parts) {
    thud_world *w = g->w;
    int end = td_min_int(first + ISLANDS_AHEAD, w->islands.island.count);
    for (int j = first; j < end && g->used < TD_TREES; j++) {
        td_island *island = TD_AT(td_island, &w->islands.island, j);
        const td_listed_body *list = list_at(w, island);
        bool fits = island->parts == parts || (any_parts && island->parts > 0);
        if (fits && (!g->used || (island->bodies == members[0]->bodies &&
                                  are_alike(g->list[0], list, island->bodies)))) {
            g->island[g->used] = members[g->used] = island;
            g->list[g->used++] = list;
            island->parts = 0;
        }
    }
}

/* Groups trees of the same shape. Trees that require the same number of parts are grouped first,
 * since they mostly end together, so that no lane waits for another. Lanes that are left over are
 * filled with trees that require other numbers, since a vector takes as long with one tree as with
 * TD_TREES. */
void td_lock_trees_step(thud_world *w) {
    tree_group g = group_of(w);
    take_trees(w);
    for (int i = 0; i < w->islands.island.count; i++) {
        td_island *members[TD_TREES];
        int parts = TD_AT(td_island, &w->islands.island, i)->parts;
        if (parts == 0) {
            continue;
        }
        g.used = 0;
        join_alike(&g, members, i, parts, false);
        join_alike(&g, members, i, parts, true);
        solve_group(&g);
        for (int tree = 0; tree < g.used; tree++) {
            members[tree]->tree = g.kept[tree] ? TD_TREE_SOLVED : TD_TREE_REFUSED;
            if (g.kept[tree]) {
                float *worst = &w->islands.trees_residual;
                *worst = td_max_float((float)g.trees.residual[tree], *worst);
            }
        }
    }
}

/* ---- the result ---- */

/* Writes the result of a joint to its lane. Returns whether its load keeps the island direct, or
 * `known`: whether that of an earlier joint does. */
static bool write_joint(thud_world *w, const td_lock_result *result, bool known) {
    td_lane at = {result->block, result->lane};
    for (int k = 0; k < 2; k++) {
        at.block->point[k].normal_impulse[at.lane] = result->impulse[k];
        at.block->point[k].separation[at.lane] = result->separation[k];
    }
    at.block->tangent_impulse[at.lane] = result->impulse[TD_DIRECT_TANGENT];
    if (at.block->tangent_mass[at.lane] > 0.0f) {
        td_lock_rows_of(at.block)->turn_gap[at.lane] = result->turn_gap;
    }
    at.block->mark[at.lane].loaded |= TD_DIRECT;
    double load = 0.0;
    for (int k = 0; k < TD_DIRECT_ROWS; k++) {
        load += td_abs((double)result->impulse[k]);
    }
    return known || td_island_load_stays(w, at, load * w->substeps);
}

void td_lock_tree_write(thud_world *w, const td_island *island) {
    const td_lock_result *results = w->islands.results.data;
    results += island->first_body;
    bool loaded = false;
    for (int i = 0; i < island->bodies; i++) {
        const td_lock_result *result = &results[i];
        memcpy(td_row(&w->velocity, result->slot), result->velocity, sizeof result->velocity);
        memcpy(td_row(&w->delta, result->slot), result->moved, sizeof result->moved);
        *td_slow_steps_at(w, result->slot) = 0;
        loaded = result->block ? write_joint(w, result, loaded) : loaded;
    }
    td_island_keep_direct(w, island, loaded);
}
