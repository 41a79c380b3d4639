/* joint_brace.c: bracing: an energy bound on the impulses that locks and rods apply in a substep,
 * in groups of bodies with a torn joint. A joint is torn if its gap, at the start of the step, is
 * so wide that its bias would close it faster than TD_JOINT_CLOSING_SPEED (flag_torn,
 * wide_joint.h). Steps without a torn joint do no bracing. A lock is wide open if its gap is so
 * wide that its bias is at its maximum (opening_of).
 *
 * The soft solver begins a substep with the impulses of the one before (warm start). Each row
 * divides its correction by its own diagonal entry of K = J M^-1 J'. In mechanisms with long lever
 * arms, and in loops that cannot close, there are modes q (vectors of length 1 of the impulses of
 * all rows) for which q.K q is small beside these entries. One Gauss-Seidel pass corrects little of
 * such a mode: its impulses oscillate, grow as directions turn, and add energy without bound. The
 * correction of a row removes energy. The warm start can add energy, and so can the bias that
 * closes gaps: one relax pass removes only a part of the speed that the bias adds.
 *
 * Consider a group of bodies that locks and rods connect. p are the impulses of all its locks, u
 * the relative speeds along them without these impulses, and u' = u + K p the speeds with them.
 * Applying the share s of the impulses changes the kinetic energy by
 *     E(s) = s p.u + s^2 p.(u' - u) / 2
 *     E(1) = p.(u + u') / 2
 * E has its minimum at s = -p.u / p.(u' - u), and is 0 again at twice that share.
 *
 * After the warm start, p are the impulses of the substep before. Where E(1) > 0, they would add
 * energy: the group keeps the share at which E has its minimum, clamped to 0 .. 1. Large groups may
 * add some energy (tolerated_gain): one share for all of their impulses also takes away those by
 * which each lock carries a load, and joints would come apart faster than the passes can build
 * these impulses up again.
 *
 * After the relax pass, p are all impulses that the locks applied in the substep. A group with a
 * lock that is wide open and E(1) > 0 keeps the share with E = 0; a second relax pass over all
 * rows, contacts included, then corrects the speed errors that the removed impulses leave. In
 * groups without such a lock the impulses are not scaled down, though they add energy: there a gap
 * acts as a spring, which returns the energy that opened it.
 *
 * Once a group has kept less than all of its impulses, its gaps close more slowly for the rest of
 * the step: at no more than TD_JOINT_CLOSING_SPEED (td_lock_rows.closing_factor is 1), and by a
 * smaller share in a substep (GAP_SHARE_BRACED, wide_joint.h). Otherwise the bias could add the
 * energy again, in modes of many rows that each move little.
 *
 * solve.c calls td_joints_brace between its passes. td_brace_applied of wide_rod.c does the work of
 * each lane: it measures p.u and p.u', removes impulses, and applies the share to keep (the passes
 * TD_BRACE_..., block.h). */
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "islands/label.h"
#include "joints/joint.h"

/* Which work add_work adds: that of a group's impulses p at the speeds without them (p.u at the
 * head of this file), or with them (p.u'). */
enum { WORK_WITHOUT, WORK_WITH };

/* A group; `index` is stored as a float in lanes. td_joints_engage has reserved room for one group
 * for each body. */
static td_brace_group *group_at(const thud_world *w, float index) {
    return TD_AT(td_brace_group, &w->scratch.brace_groups, (int)index);
}

/* Visits a block of locks or rods; `which`: an argument of the visitor's own. */
typedef void visit_fn(thud_world *w, td_block *block, int which);

/* Blocks lie anywhere in memory. So that the data of bracing are in the cache when a loop comes to
 * a block, it prefetches those of the block this many places ahead. Chosen. */
enum { FETCH_AHEAD = 6 };

/* Calls `visit` for each block of locks and rods. */
static void for_each_lock_block(thud_world *w, visit_fn *visit, int which) {
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        td_block *const *blocks = (td_block **)w->scratch.blocks.data + run->first;
        bool locks = run->kind == TD_CONSTRAINT_ROD || run->kind == TD_CONSTRAINT_LOCK;
        for (int k = 0; k < run->count && locks; k++) {
            if (TD_HAS_PREFETCH && k + FETCH_AHEAD < run->count) {
                td_brace_rows *ahead = td_brace_rows_of(blocks[k + FETCH_AHEAD]);
                __builtin_prefetch(&ahead->group, 1);
                __builtin_prefetch(&ahead->work_with, 1);
            }
            visit(w, blocks[k], which);
        }
    }
}

/* The index of each lane's group. */
static float *lane_groups(td_block *block) {
    return (float *)&td_brace_rows_of(block)->group;
}

/* Joins the union-find trees (islands/label.h) of the dynamic bodies that the lanes of a block
 * connect. */
static void join_lanes(thud_world *w, td_block *block, int unused) {
    (void)unused;
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        if (td_inv_mass_of(w, a) > 0.0f && td_inv_mass_of(w, b) > 0.0f) {
            td_join_trees(w->scratch.parents.data, a, b);
        }
    }
}

/* The index of the group of a body, once each slot has the root of its tree as its parent. A group
 * gets the next free index when the first of its lanes is numbered: the root's parent is then
 * -1 - index. */
static float group_index(thud_world *w, td_awake_slot slot) {
    td_awake_slot *parents = w->scratch.parents.data, *parent = &parents[slot.at];
    td_awake_slot *mark = parent->at < 0 ? parent : &parents[parent->at];
    if (mark->at >= 0) {
        mark->at = -1 - w->scratch.brace_groups.count++;
        *group_at(w, (float)(-1 - mark->at)) = (td_brace_group){0};
    }
    return (float)(-1 - mark->at);
}

/* The widest gap of a lane at the start of the step, as a multiple of that of a joint that is just
 * torn. With h the duration of a substep, its bias TD_JOINT_GAP_SHARE / h times the gap is
 * TD_JOINT_CLOSING_SPEED, length scales or radians a second. At TD_JOINT_CLOSING_FACTOR times that
 * gap the lock is wide open: beyond it the closing speed no longer grows with the gap. Along u
 * start_separation is read, which is set even if that direction is free: the travel of a slider or
 * wheel then counts as well, since it is the lever arm of the impulses across. Measured: if it did
 * not count, mechanisms with sliders would gain more than 5 % of energy (test_joints_random). Along
 * v separation is read, which is 0 where across is free, and in rods, as tangent_mass is. */
static float opening_of(const thud_world *w, td_block *block, int lane) {
    float torn =
        TD_JOINT_CLOSING_SPEED / TD_JOINT_GAP_SHARE * (float)(w->def.time_step / w->substeps);
    float gap = td_max_float(td_joint_abs(block->point[0].start_separation[lane]),
                             td_joint_abs(block->point[1].separation[lane]));
    float turn = block->tangent_mass[lane] > 0.0f
                     ? td_joint_abs(td_lock_rows_of(block)->start_turn_gap[lane])
                     : 0.0f;
    return td_max_float(gap / w->length_scale, turn) / torn;
}

/* Sets the groups of a block's lanes, each by its dynamic side, counts the lanes of each group, and
 * finds its widest gap. */
static void number_lanes(thud_world *w, td_block *block, int unused) {
    (void)unused;
    float *group = lane_groups(block);
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        group[lane] = group_index(w, td_inv_mass_of(w, b) > 0.0f ? b : a);
        td_brace_group *of = group_at(w, group[lane]);
        of->lanes++;
        of->opening = td_max_float(of->opening, opening_of(w, block, lane));
    }
}

/* Whether a group has a torn joint, or, if `relaxed`, a lock that is wide open: only there bracing
 * acts. */
static bool is_torn(const td_brace_group *group, bool relaxed) {
    return group->opening > (relaxed ? TD_JOINT_CLOSING_FACTOR : 1.0f);
}

/* Numbers the groups once in a step: in the first substep, where the gaps are those at the start of
 * the step. Later calls do nothing. */
static void number_groups(thud_world *w) {
    td_awake_slot *parents = w->scratch.parents.data;
    if (w->scratch.brace_groups.count > 0) {
        return;
    }
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parents[slot.at] = slot;
    }
    for_each_lock_block(w, join_lanes, 0);
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parents[slot.at] = td_root_of(parents, slot);
    }
    for_each_lock_block(w, number_lanes, 0);
}

/* Adds the work of a block's lanes to the sums of their groups: impulse times the speed without the
 * impulses (`which` WORK_WITHOUT: p.u at the head of this file), or times the speed with them
 * (WORK_WITH: p.u'). With p.u' it also adds the energy that the lanes exchange, |p.u'|. Marks
 * blocks with a lane whose group is torn (td_brace_rows.torn). The passes of bracing skip all other
 * blocks: the values of work in those are out of date, but are added only to groups that are not
 * braced. */
static void add_work(thud_world *w, td_block *block, int which) {
    const float *group = lane_groups(block);
    td_brace_rows *rows = td_brace_rows_of(block);
    const float *work =
        (const float *)(which == WORK_WITH ? &rows->work_with : &rows->work_without);
    rows->torn = 0.0f;
    for (int lane = 0; lane < block->used;) {
        td_brace_group *of = group_at(w, group[lane]);
        double sum = 0.0, exchanged = 0.0;
        int first = lane;
        for (; lane < block->used && group[lane] == group[first]; lane++) {
            sum += (double)work[lane];
            exchanged += (double)td_joint_abs(work[lane]);
        }
        if (which == WORK_WITH) {
            of->work_with += sum;
            of->exchanged += exchanged;
        } else {
            of->work_without += sum;
        }
        rows->torn = is_torn(of, false) ? 1.0f : rows->torn;
    }
}

/* The two shares of the impulses that a braced group may keep, as multiples of the share at which
 * the energy E that they add has its minimum (head of this file): that share itself, and the one
 * with E = 0. */
#define MIN_ENERGY 1.0
#define ZERO_ENERGY 2.0

/* The energy that the warm start of a group may add: none in groups of up to STRICT_LANES lanes, in
 * larger ones EXCHANGED_SHARE of the energy that their locks exchange. Where an unstable mode
 * grows, most locks add energy: E(1) is 0.2 to 0.8 times the energy exchanged (measured: three
 * quarters of the bracings of random mechanisms, test_joints_random). In a plate of 20,000 hinges
 * that hangs, about as many locks add energy as take it: 0.003 to 0.08 times. Without this
 * tolerance the uppermost hinges of that plate come apart by 19 lengths in ten seconds, with it by
 * one (a smaller plate: plate_of_hinges_hangs_together, test_joint_scenes). Both values are chosen;
 * the tests pass at half and at 1.5 times the share. */
#define EXCHANGED_SHARE 0.2
enum { STRICT_LANES = 64 };

static double tolerated_gain(const td_brace_group *group) {
    return group->lanes > STRICT_LANES ? EXCHANGED_SHARE * group->exchanged : 0.0;
}

/* Whether a group is braced if its impulses add this much energy. */
static bool is_braced(const td_brace_group *group, bool relaxed, double energy) {
    return is_torn(group, relaxed) && energy > (relaxed ? 0.0 : tolerated_gain(group));
}

/* The share of a group's impulses to keep, 0 .. 1; 1 where the group is not braced (its impulses
 * add no energy that matters). */
static float share_to_keep(const td_brace_group *group, bool relaxed) {
    double growth = group->work_with - group->work_without;
    double energy = 0.5 * (group->work_without + group->work_with);
    double share = -(relaxed ? ZERO_ENERGY : MIN_ENERGY) * group->work_without / growth;
    bool scaled = growth > 0.0 && is_braced(group, relaxed, energy);
    return scaled ? (float)td_min_double(td_max_double(0.0, share), 1.0) : 1.0f;
}

/* Writes the shares to keep into a block's lanes, and limits the closing speed of lanes whose share
 * is below 1. `relaxed`: after the relax pass; else after the warm start. */
static void set_shares(thud_world *w, td_block *block, int relaxed) {
    const float *group = lane_groups(block);
    float *share = (float *)&td_brace_rows_of(block)->kept_share;
    float *closing_factor = (float *)&td_lock_rows_of(block)->closing_factor;
    for (int lane = 0; lane < block->used; lane++) {
        share[lane] = share_to_keep(group_at(w, group[lane]), relaxed);
        closing_factor[lane] = share[lane] < 1.0f ? 1.0f : closing_factor[lane];
    }
}

/* Measures whether the impulses of a group may add so much energy that it is braced, and sets the
 * flag of this bracing. TD_BRACE_WORK_WITH has measured p.u' of the lanes, which bounds E(1) and
 * needs no speeds without the impulses: K is positive semidefinite, thus p.u <= p.u' and
 * E(1) <= p.u'. Finds the groups if this step has not done so yet. This function and set_all_shares
 * are given to the workers as one chunk, so that exactly one of them runs it. */
static void judge_energy(void *argument, int chunk) {
    const td_bracing *b = argument;
    thud_world *w = b->w;
    bool any = false;
    (void)chunk;
    number_groups(w);
    for (int group = 0; group < w->scratch.brace_groups.count; group++) {
        td_brace_group *g = group_at(w, (float)group);
        g->work_without = g->work_with = g->exchanged = 0.0;
    }
    for_each_lock_block(w, add_work, WORK_WITH);
    for (int group = 0; group < w->scratch.brace_groups.count && !any; group++) {
        const td_brace_group *g = group_at(w, (float)group);
        any = is_braced(g, b->relaxed, g->work_with);
    }
    atomic_store_explicit(b->adds, any, memory_order_relaxed);
}

/* Sets the shares to keep, once TD_BRACE_WORK_WITHOUT has measured p.u of the lanes. */
static void set_all_shares(void *argument, int chunk) {
    const td_bracing *b = argument;
    (void)chunk;
    for_each_lock_block(b->w, add_work, WORK_WITHOUT);
    for_each_lock_block(b->w, set_shares, b->relaxed);
}

/* Whether a lock is wide open, once the groups have been found. */
static bool is_any_wide_open(const thud_world *w) {
    bool any = false;
    for (int group = 0; group < w->scratch.brace_groups.count; group++) {
        any |= is_torn(group_at(w, (float)group), true);
    }
    return any;
}

bool td_joints_brace(td_bracing *b) {
    if (b->relaxed && !is_any_wide_open(b->w)) {
        return false;
    }
    if (!b->relaxed && !b->first) {
        b->pass(b->solver, TD_BRACE_WARM_START);
    }
    b->pass(b->solver, TD_BRACE_WORK_WITH);
    td_worker_walk(b->worker, 1, judge_energy, b);
    bool adds = atomic_load_explicit(b->adds++, memory_order_relaxed);
    if (adds) {
        b->pass(b->solver, TD_BRACE_REMOVE);
        b->pass(b->solver, TD_BRACE_WORK_WITHOUT);
        td_worker_walk(b->worker, 1, set_all_shares, b);
        b->pass(b->solver, TD_BRACE_APPLY_SHARE);
    }
    return adds;
}
