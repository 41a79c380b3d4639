/* joint_brace.c: bracing: an energy bound on the impulses that locks and rods apply in a substep,
 * for groups of tied bodies that begin the step with a torn joint: one whose gap is wider than
 * TD_JOINT_CLOSING_SPEED closes in a substep (opening). Other groups do without.
 *
 * The soft solver begins a substep with the impulses of the one before (warm start). One
 * Gauss-Seidel pass corrects little of a mode q of all rows together where q.K q is small beside
 * the diagonal of K = J M^-1 J', by which each row divides what it corrects: in mechanisms with
 * long lever arms, and in loops that cannot close. Impulses of such a mode then oscillate, grow as
 * directions turn, and add energy without bound. A row's own correction takes energy out; the warm
 * start can add energy, and so can the bias that closes gaps, of which one relax pass takes back
 * only a part.
 *
 * For a group, p are the impulses of all its locks and rods in a substep, u the relative speeds
 * along them without these impulses, and u' = u + K p those with them. A share s of the impulses
 * changes the kinetic energy by
 *     E(s) = s p.u + s^2 p.(u' - u) / 2
 *     E(1) = p.(u + u') / 2.
 * E has its minimum at s = -p.u / p.(u' - u) = (p.u' / 2 - E(1)) / (p.u' - E(1)), and is 0 again at
 * twice that share.
 *
 * After a relax pass, a group with E(1) > 0 keeps the share with E = 0, or none; a second relax
 * pass of all rows, those of contacts too, then corrects the speeds that the rows miss without the
 * impulses taken. Gaps of such a group close at no more than BRACED_CLOSING times
 * TD_JOINT_CLOSING_SPEED for the rest of the step (td_lock_rows.closing_factor), since the bias of
 * many rows that hardly move could add as much again.
 *
 * After the warm start of a step, a group with E(1) > 0 keeps the share of least energy.
 *
 * In groups that touch a static shape and have a joint that is wide open (WIDE_OPEN), gaps close at
 * PRESSED_CLOSING times that speed in the whole step: contacts against which such joints press take
 * over impulses that E does not count, and throw the bodies off.
 *
 * Measured, in 4,200 runs of test_joints_random (900 mechanisms in the air and 300 on the ground,
 * at draft and default): to brace after the warm start of every substep, too, lets 8 more runs gain
 * energy, and with slow closing after it a lattice of 100 by 100 circles that hangs and swings
 * opens 4.6 times as wide: the impulses that turn its bodies add energy to begin with, which the
 * solve pass takes back. Without that of the first substep a bridge under load opens twice as wide
 * (test_joints_held), and one of the stiff chains of test_joints_stiff gains four times the energy
 * that was exchanged.
 *
 * solve.c runs this between its passes. The passes TD_BRACE_... of wide_rod.c do what is done
 * lane by lane. E(1) comes from TD_BRACE_REMOVE: taken back lane by lane, each lane's impulses
 * change the kinetic energy by their product with the mean of its speeds before and after. */
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "islands/label.h"
#include "joints/joint.h"

#include <string.h>

/* The numbers of a group in scratch.brace_groups: while groups are found, 1 where one of its joints
 * is wide open, and 1 where one of its bodies touches a static shape; then energies (mass
 * length^2 / s^2), p.u' and E(1). td_joints_engage has reserved them for as many groups as there
 * are bodies. */
enum { WIDE, TOUCHES, WORK = WIDE, ENERGY = TOUCHES, GROUP_NUMBERS = 2 };

/* `group` is the index of the group, stored as a float in lanes. */
static double *group_numbers(const thud_world *w, float group) {
    return (double *)w->scratch.brace_groups.data + GROUP_NUMBERS * (size_t)group;
}

/* What visitors of blocks get beside the block. */
typedef struct bracing {
    thud_world *w;
    bool rods;                   /* the block is of rods, else of locks */
    bool relaxed;                /* after a relax pass, else after the warm start */
    int number;                  /* WORK or ENERGY */
    float per_length, per_angle; /* 1 over the gap of a torn joint, see opening */
} bracing;

/* Visits a block of locks or rods; returns whether it found what it looks for. */
typedef bool visit_fn(const bracing *b, td_block *block);

/* Visits all of them. Returns whether any call returned true. */
static bool for_each_block(bracing b, visit_fn *visit) {
    bool any = false;
    for (int i = 0; i < b.w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &b.w->scratch.runs, i);
        td_block *const *blocks = (td_block **)b.w->scratch.blocks.data + run->first;
        b.rods = run->kind == TD_CONSTRAINT_ROD;
        for (int k = 0; k < run->count && (b.rods || run->kind == TD_CONSTRAINT_LOCK); k++) {
            any |= visit(&b, blocks[k]);
        }
    }
    return any;
}

/* The index of each lane's group, or TD_NOT_BRACED. */
static float *lane_groups(td_block *block) {
    return (float *)&td_brace_rows_of(block)->group;
}

/* The group of all lanes of the block, or TD_MIXED_GROUPS. */
static float *common_group(td_block *block) {
    return (float *)&td_brace_rows_of(block)->common_group;
}

/* ---- the groups ---- */

/* Joins the trees of the dynamic bodies that the lanes of a block tie together. */
static bool join_lanes(const bracing *b, td_block *block) {
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot from = td_slot_of_side(block->a[lane]), to = td_slot_of_side(block->b[lane]);
        if (td_inv_mass_of(b->w, from) > 0.0f && td_inv_mass_of(b->w, to) > 0.0f) {
            td_join_trees(b->w->scratch.parents.data, from, to);
        }
    }
    return false;
}

/* The mark of the group of a body: the parent of its tree's root, once td_joints_find_torn has made
 * each root the parent of its slots. It is the root itself until the group is found to be torn;
 * then -1 - i for the group with index i. */
static td_awake_slot *mark_of(const thud_world *w, td_awake_slot slot) {
    td_awake_slot *parents = w->scratch.parents.data, *parent = &parents[slot.at];
    return parent->at < 0 ? parent : &parents[parent->at];
}

/* The mark of the group of a lane of locks, by its dynamic side. */
static td_awake_slot *mark_of_lane(const thud_world *w, const td_block *block, int lane) {
    td_awake_slot b = td_slot_of_side(block->b[lane]);
    return mark_of(w, td_inv_mass_of(w, b) > 0.0f ? b : td_slot_of_side(block->a[lane]));
}

/* The gap of a lane as the step began, as a multiple of what TD_JOINT_CLOSING_SPEED (length scales
 * or radians a second) closes in a substep: above 1 its joint is torn. start_separation of point 0
 * has the gap along u also where that direction is free: it is then the travel of a slider or
 * wheel, which counts as well, since it is the lever arm of what the joint locks. separation of
 * point 1 is 0 where across is free. */
static float opening(const bracing *b, const td_block *block, int lane) {
    float gap = td_joint_abs(block->point[0].start_separation[lane]) * b->per_length;
    if (!b->rods) {
        gap = td_max_float(gap, td_joint_abs(block->point[1].separation[lane]) * b->per_length);
        if (block->tangent_mass[lane] > 0.0f) {
            float turn = td_joint_abs(td_lock_rows_at(block)->start_turn_gap[lane]);
            gap = td_max_float(gap, turn * b->per_angle);
        }
    }
    return gap;
}

/* A joint counts as wide open from half the gap at which the bias that closes it is at its limit,
 * as a multiple of the gap of a torn one. Chosen: the runs above gain no energy with 0.1 to 1 times
 * that gap. */
#define WIDE_OPEN (0.5f * TD_JOINT_CLOSING_FACTOR)
/* td_lock_rows.closing_factor of joints that are wide open and press against a static shape.
 * Measured: at 1, a rod that is reeled in at draft holds a box of half extent 0.3 in the floor by
 * 0.06, and by 0.03 at one half (test_distances). */
#define PRESSED_CLOSING 0.5f
/* That of groups that lost a share of their impulses. Measured: with 1 to 8 the runs above gain no
 * energy, and the widest gaps on the ground are 6 to 9 times the size of a mechanism; without a
 * bound more runs gain energy. */
#define BRACED_CLOSING 2.0f

/* Numbers the groups of torn lanes. Finds lanes that are wide open. */
static bool number_torn(const bracing *b, td_block *block) {
    bool any = false;
    for (int lane = 0; lane < block->used; lane++) {
        float multiple = opening(b, block, lane);
        if (multiple > 1.0f) {
            td_awake_slot *mark = mark_of_lane(b->w, block, lane);
            if (mark->at >= 0) {
                mark->at = -1 - b->w->scratch.brace_groups.count++;
            }
            if (multiple > WIDE_OPEN) {
                group_numbers(b->w, (float)(-1 - mark->at))[WIDE] = 1.0;
                any = true;
            }
        }
    }
    return any;
}

/* Sets TOUCHES of the groups that touch a static shape. */
static void find_touching(const thud_world *w) {
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        td_block *const *blocks = (td_block **)w->scratch.blocks.data + run->first;
        for (int k = 0; k < run->count && run->kind < TD_PAIR_COUNT && run->a_static; k++) {
            for (int lane = 0; lane < blocks[k]->used; lane++) {
                int mark = mark_of(w, td_slot_of_side(blocks[k]->b[lane]))->at;
                if (mark < 0) {
                    group_numbers(w, (float)(-1 - mark))[TOUCHES] = 1.0;
                }
            }
        }
    }
}

/* Writes the groups of a block's lanes, and the closing speed of those that press against a static
 * shape. */
static bool write_groups(const bracing *b, td_block *block) {
    float *group = lane_groups(block);
    float *closing_factor = (float *)&td_lock_rows_of(block)->closing_factor;
    for (int lane = 0; lane < TD_LANES; lane++) {
        int mark = lane < block->used ? mark_of_lane(b->w, block, lane)->at : 0;
        group[lane] = TD_NOT_BRACED;
        if (mark < 0) {
            group[lane] = (float)(-1 - mark);
            const double *numbers = group_numbers(b->w, group[lane]);
            bool presses = numbers[WIDE] > 0.0 && numbers[TOUCHES] > 0.0;
            closing_factor[lane] = presses ? PRESSED_CLOSING : closing_factor[lane];
        }
    }
    *common_group(block) = group[0];
    for (int lane = 1; lane < block->used; lane++) {
        if (group[lane] != group[0]) {
            *common_group(block) = TD_MIXED_GROUPS;
        }
    }
    return false;
}

/* After the warm start of the first substep, while gaps are those of the start of the step. */
void td_joints_find_torn(thud_world *w) {
    td_awake_slot *parents = w->scratch.parents.data;
    float per_angle = TD_JOINT_GAP_SHARE / TD_JOINT_CLOSING_SPEED / (float)(w->def.time_step) *
                      (float)w->substeps;
    bracing b = {.w = w, .per_length = per_angle / w->unit, .per_angle = per_angle};
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parents[slot.at] = slot;
    }
    for_each_block(b, join_lanes);
    for (td_awake_slot slot = {0}; slot.at < w->body_of.count; slot.at++) {
        parents[slot.at] = td_root_of(parents, slot);
    }
    memset(w->scratch.brace_groups.data, 0,
           (size_t)w->body_of.count * sizeof(double[GROUP_NUMBERS]));
    if (for_each_block(b, number_torn)) {
        find_touching(w);
    }
    for_each_block(b, write_groups);
}

/* ---- their energy ---- */

/* Adds up b->number of the lanes of each group. */
static bool add_up(const bracing *b, td_block *block) {
    td_brace_rows *rows = td_brace_rows_of(block);
    const float *value = (const float *)(b->number == WORK ? &rows->work : &rows->energy);
    const float *group = lane_groups(block);
    double sum = 0.0;
    for (int lane = 0; lane < block->used; lane++) {
        sum += (double)value[lane];
        if (*common_group(block) < 0.0f && group[lane] >= 0.0f) {
            group_numbers(b->w, group[lane])[b->number] += (double)value[lane];
        }
    }
    if (*common_group(block) >= 0.0f) {
        group_numbers(b->w, group[0])[b->number] += sum;
    }
    return false;
}

/* After TD_BRACE_WORK: K is positive semidefinite, thus p.u <= p.u' and E(1) <= p.u'. */
bool td_joints_may_add_energy(thud_world *w) {
    int groups = w->scratch.brace_groups.count;
    bool any = false;
    memset(w->scratch.brace_groups.data, 0, (size_t)groups * sizeof(double[GROUP_NUMBERS]));
    for_each_block((bracing){.w = w, .number = WORK}, add_up);
    for (int group = 0; group < groups; group++) {
        any |= group_numbers(w, (float)group)[WORK] > 0.0;
    }
    return any;
}

/* The share of its impulses that a group keeps, 0 .. 1. */
static float share_to_keep(const double *group, bool relaxed) {
    double rest = group[WORK] - group[ENERGY]; /* p.(u' - u) / 2 */
    if (!(group[ENERGY] > 0.0 && rest > 0.0)) {
        return 1.0f;
    }
    float share = (float)((0.5 * group[WORK] - group[ENERGY]) / rest);
    return td_min_float(td_max_float(relaxed ? 2.0f * share : share, 0.0f), 1.0f);
}

/* Writes the shares to keep, which are the groups' first numbers now, into a block's lanes; after a
 * relax pass it limits the closing speed of lanes that keep less than all. Finds such lanes. */
static bool write_shares(const bracing *b, td_block *block) {
    const float *group = lane_groups(block);
    float *share = (float *)&td_brace_rows_of(block)->kept_share;
    float *closing_factor = (float *)&td_lock_rows_of(block)->closing_factor;
    bool any = false;
    for (int lane = 0; lane < TD_LANES; lane++) {
        share[lane] = group[lane] >= 0.0f ? (float)*group_numbers(b->w, group[lane]) : 1.0f;
        if (share[lane] < 1.0f) {
            any = true;
            if (b->relaxed) {
                closing_factor[lane] = td_min_float(closing_factor[lane], BRACED_CLOSING);
            }
        }
    }
    return any;
}

/* After TD_BRACE_REMOVE. */
bool td_joints_set_shares(thud_world *w, bool relaxed) {
    bracing b = {.w = w, .number = ENERGY, .relaxed = relaxed};
    for_each_block(b, add_up);
    for (int group = 0; group < w->scratch.brace_groups.count; group++) {
        double *sums = group_numbers(w, (float)group);
        sums[0] = (double)share_to_keep(sums, relaxed);
    }
    return for_each_block(b, write_shares);
}
