/* joint_brace.c: bracing: an energy bound on the impulses that locks of widely open joints apply in
 * a substep.
 *
 * The soft solver begins a substep with the impulses of the one before (warm start). One
 * Gauss-Seidel pass corrects little of a mode that all rows of a mechanism share, where the rows
 * are stiff against it one by one: long lever arms, loops that cannot close. Such impulses then
 * oscillate, grow as directions turn, and add energy without bound. A row's own correction takes
 * energy out; the warm start can add energy, and so can the bias that closes gaps, of which one
 * relax pass takes back only a part.
 *
 * Take a group of tied bodies (constraint/tied_bodies.h): p are the impulses of all its locks, u
 * the relative speeds along them without these impulses, and u' = u + K p those with them, where
 * K = J M^-1 J'. A share s of the impulses changes the kinetic energy by
 *     E(s) = s p.u + s^2 p.(u' - u) / 2
 *     E(1) = p.(u + u') / 2
 * E has its minimum at s = -p.u / p.(u' - u), and is 0 again at twice that share.
 *
 * Warm start: where E(1) > 0, the group keeps the share of least energy, within 0 .. 1.
 *
 * After the relax pass: p is all that the locks applied in the substep. A group with a lock that is
 * wide open (is_wide_open) and E(1) > 0 keeps the share with E = 0; another relax pass of all rows,
 * contacts too, then corrects the velocities that the rows miss. In other groups the impulses may
 * add energy: a gap acts as a spring there, which returns what opened it.
 *
 * Gaps of a group that lost a share close at no more than TD_JOINT_CLOSING_SPEED for the rest of
 * the step (td_lock_rows.closing_factor is 1), since the bias of many rows that hardly move could
 * add as much again.
 *
 * solve.c runs this between its passes (TD_BRACE_ stages, block.h), in steps that begin with a
 * joint open by more than TD_JOINT_CLOSING_SPEED closes in a substep (flag_torn, wide_joint.h);
 * others do without. The lanes' part is td_brace_applied of wide_rod.c. */
#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "constraint/tied_bodies.h"
#include "joints/joint.h"

#include <string.h>

/* The three numbers of a group in scratch.powers: p.u, p.u' (energies, mass length^2 / s^2), and 1
 * where one of its locks is wide open, else 0. */
enum { POWER_BEFORE, POWER_AFTER, WIDE_OPEN };

/* The numbers of a group; `number` is a whole number, stored as a float in lanes. */
static double *group_sums(const thud_world *w, float number) {
    return (double *)w->scratch.powers.data + 3 * (size_t)number;
}

/* Calls `visit` for each block of locks and rods. Returns whether any call returned true. */
static bool for_each_lock_block(thud_world *w, bool (*visit)(thud_world *w, td_block *block)) {
    bool any = false;
    for (int i = 0; i < w->scratch.blocks.count; i++) {
        td_block *block = *TD_AT(td_block *, &w->scratch.blocks, i);
        int kind = block->used ? td_constraint_at(w, block->constraint[0])->kind : 0;
        if (kind == TD_CONSTRAINT_ROD || kind == TD_CONSTRAINT_LOCK) {
            any |= visit(w, block);
        }
    }
    return any;
}

/* The number of each lane's group. */
static float *group_numbers(td_block *block) {
    return (float *)&td_brace_rows_of(block)->group;
}

/* 1 where all lanes of the block belong to the same group, else 0. */
static float *same_group(td_block *block) {
    return (float *)&td_brace_rows_of(block)->same_group;
}

/* The number of the group of a body. A group gets the next free one when its first lane asks;
 * scratch.parents holds -1 - number for each of its bodies, and 0 for bodies without a number. */
static float group_number(thud_world *w, td_awake_slot slot) {
    td_awake_slot *number = w->scratch.parents.data;
    if (number[slot.at].at >= 0) {
        td_awake_slot assigned = {-1 - w->scratch.powers.count++};
        for (td_awake_slot i = slot; number[i.at].at >= 0; i = td_next_tied(w, i)) {
            number[i.at] = assigned;
        }
        group_sums(w, (float)(-1 - assigned.at))[WIDE_OPEN] = 0.0;
    }
    return (float)(-1 - number[slot.at].at);
}

/* Whether a lane's gap is so wide that its bias has reached its limit (TD_JOINT_CLOSING_FACTOR
 * times TD_JOINT_CLOSING_SPEED) in a substep: a length or an angle beyond which the speed of
 * closing no longer grows with the gap. Of a slider or wheel start_separation is the travel along
 * its free axis, which counts as well: it is the lever arm of what the joint locks. Measured:
 * without it, mechanisms with sliders gain more than 5 % of energy (test_joints_random). */
static bool is_wide_open(const thud_world *w, td_block *block, int lane) {
    float limit = TD_JOINT_CLOSING_FACTOR * TD_JOINT_CLOSING_SPEED / TD_JOINT_GAP_SHARE *
                  (float)(w->def.time_step / w->substeps);
    bool rod = td_constraint_at(w, block->constraint[0])->kind == TD_CONSTRAINT_ROD;
    bool turns = !rod && block->tangent_mass[lane] > 0.0f;
    float gap = td_max_float(td_joint_abs(block->point[0].start_separation[lane]),
                             rod ? 0.0f : td_joint_abs(block->point[1].separation[lane]));
    float turn = turns ? td_joint_abs(td_lock_rows_of(block)->start_turn_gap[lane]) : 0.0f;
    return gap > limit * w->unit || turn > limit;
}

/* Sets the group numbers of a block's lanes, each by its dynamic side, and notes groups that are
 * wide open. A visitor; returns false. */
static bool number_lanes(thud_world *w, td_block *block) {
    float *group = group_numbers(block);
    *same_group(block) = 1.0f;
    for (int lane = 0; lane < block->used; lane++) {
        td_awake_slot a = td_slot_of_side(block->a[lane]), b = td_slot_of_side(block->b[lane]);
        group[lane] = group_number(w, td_inv_mass_of(w, b) > 0.0f ? b : a);
        *same_group(block) = group[lane] == group[0] ? *same_group(block) : 0.0f;
        if (is_wide_open(w, block, lane)) {
            group_sums(w, group[lane])[WIDE_OPEN] = 1.0;
        }
    }
    return false;
}

/* Numbers the groups once a step: in the first substep, while gaps are those at its start. Later
 * calls do nothing. */
static void number_groups(thud_world *w) {
    td_awake_slot *number = w->scratch.parents.data;
    if (w->scratch.powers.count > 0) {
        return;
    }
    td_joints_tie(w);
    for (int i = 0; i < w->body_of.count; i++) {
        number[i] = (td_awake_slot){0};
    }
    for_each_lock_block(w, number_lanes);
}

/* Adds the products p.u (`which` POWER_BEFORE) or p.u' (POWER_AFTER) of a block's lanes to the sums
 * of their groups. */
static void add_powers(const thud_world *w, td_block *block, int which) {
    const float *group = group_numbers(block);
    td_brace_rows *rows = td_brace_rows_of(block);
    const float *power =
        (const float *)(which == POWER_AFTER ? &rows->power_after : &rows->power_before);
    if (*same_group(block) > 0.0f) {
        double sum = 0.0;
        for (int lane = 0; lane < block->used; lane++) {
            sum += (double)power[lane];
        }
        group_sums(w, group[0])[which] += sum;
        return;
    }
    for (int lane = 0; lane < block->used; lane++) {
        group_sums(w, group[lane])[which] += (double)power[lane];
    }
}

static bool add_powers_before(thud_world *w, td_block *block) {
    add_powers(w, block, POWER_BEFORE);
    return false;
}

static bool add_powers_after(thud_world *w, td_block *block) {
    add_powers(w, block, POWER_AFTER);
    return false;
}

/* The share of a group's impulses to keep, 0 .. 1; 1 where they add no energy. `multiple` of the
 * share with least energy: 1, or 2 for the share that leaves the energy as it was. */
static float share_to_keep(const double *group, double multiple) {
    double share = -multiple * group[POWER_BEFORE] / (group[POWER_AFTER] - group[POWER_BEFORE]);
    bool adds =
        group[POWER_BEFORE] + group[POWER_AFTER] > 0.0 && group[POWER_AFTER] > group[POWER_BEFORE];
    return !adds || share > 1.0 ? 1.0f : share > 0.0 ? (float)share : 0.0f;
}

/* Writes the shares to keep into a block's lanes, and limits the closing speed of lanes that keep
 * less than all. Returns whether any lane does. */
static bool set_shares(thud_world *w, td_block *block, bool relaxed) {
    const float *group = group_numbers(block);
    float *share = (float *)&td_brace_rows_of(block)->kept_share;
    float *closing_factor = (float *)&td_lock_rows_of(block)->closing_factor;
    bool any = false;
    for (int lane = 0; lane < block->used; lane++) {
        const double *sums = group_sums(w, group[lane]);
        share[lane] = !relaxed                ? share_to_keep(sums, 1.0)
                      : sums[WIDE_OPEN] > 0.0 ? share_to_keep(sums, 2.0)
                                              : 1.0f;
        closing_factor[lane] = share[lane] < 1.0f ? 1.0f : closing_factor[lane];
        any |= share[lane] < 1.0f;
    }
    return any;
}

static bool set_warm_start_shares(thud_world *w, td_block *block) {
    return set_shares(w, block, false);
}

static bool set_relaxed_shares(thud_world *w, td_block *block) {
    return set_shares(w, block, true);
}

/* Whether the impulses may add energy; cheaper than E(1), since it needs no speeds without them: K
 * is positive semidefinite, thus p.u <= p.u' and E(1) <= p.u'. `relaxed`: after the relax pass,
 * where only groups that are wide open count. */
bool td_joints_add_energy(thud_world *w, bool relaxed) {
    bool any = false;
    number_groups(w);
    for (int group = 0; group < w->scratch.powers.count; group++) {
        group_sums(w, (float)group)[POWER_BEFORE] = group_sums(w, (float)group)[POWER_AFTER] = 0.0;
    }
    for_each_lock_block(w, add_powers_after);
    for (int group = 0; group < w->scratch.powers.count && !any; group++) {
        const double *sums = group_sums(w, (float)group);
        any = sums[POWER_AFTER] > 0.0 && (!relaxed || sums[WIDE_OPEN] > 0.0);
    }
    return any;
}

/* Sets the shares to keep, once TD_BRACE_BEFORE has measured p.u. */
void td_joints_set_shares(thud_world *w, bool relaxed) {
    for_each_lock_block(w, add_powers_before);
    for_each_lock_block(w, relaxed ? set_relaxed_shares : set_warm_start_shares);
}

/* Whether any group is wide open. Known once td_joints_add_energy has judged the warm start. */
bool td_joints_wide_open(const thud_world *w) {
    bool any = false;
    for (int group = 0; group < w->scratch.powers.count; group++) {
        any |= group_sums(w, (float)group)[WIDE_OPEN] > 0.0;
    }
    return any;
}
