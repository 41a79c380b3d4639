/* joint_hooks.h: the functions of joints that a step calls: a table that a world gets with its
 * first joint (joints/joint_make.c), so that a program without joints does not link them. */
#ifndef TD_JOINT_HOOKS_H
#define TD_JOINT_HOOKS_H

#include "constraint/block.h"
#include "state/jobs.h"
#include "state/world.h"

struct td_island_work;
struct td_drawing;

/* Gaps of joints (displacement in locked directions, and excess over limits), as thud_step_error
 * reports them: the greatest and the mean length, and the greatest angle (rad). All are >= 0. */
typedef struct td_joint_gaps {
    double worst, mean, angle;
} td_joint_gaps;

/* What bracing (joints/joint_brace.c) needs of the solver. Each worker has one of its own. */
typedef struct td_bracing {
    thud_world *w;
    td_worker *worker;
    /* Runs a pass of bracing over all blocks of locks and rods; `solver` is its argument. */
    void (*pass)(void *solver, td_brace stage);
    void *solver;
    atomic_bool *
        adds;   /* flag of the next bracing, common to all workers: impulses may have added energy.
                   The flags of the bracings after it follow in memory. Each bracing has a flag of its
                   own, since a worker that is late may still read the flag of the bracing before */
    bool first; /* the present substep is the first one of the step */
    bool relaxed; /* the present bracing is the one after the substep's relax pass, not the one
                     before its solve pass */
} td_bracing;

typedef struct td_joint_hooks {
    /* ---- joint_engage.c ---- */
    /* Gives lanes to the parts of joints that wait for one, where both bodies are in the world and
     * enabled. False when memory is short; the others keep waiting. */
    bool (*engage)(thud_world *w);
    /* Takes the lanes of a body's joints away; they wait until the body is enabled again. */
    void (*suspend)(thud_world *w, td_body_index body);
    /* After the caller moved a body or its centre of mass: makes locks of single axes
     * (edits/locks.c) hold it at its new position. */
    void (*move_locks)(thud_world *w, td_body_index body);
    /* Whether a joint of both bodies excludes contacts between them. */
    bool (*exclude_contact)(const thud_world *w, td_body_index a, td_body_index b);
    /* A constraint (`part`) of a joint has been destroyed; with the last one the joint's record is
     * freed. */
    void (*remove_part)(thud_world *w, int joint, int part);

    /* ---- joint_tied.c, see tied_bodies.h ---- */
    /* Finds the groups of tied bodies, unless they are already known in this step. */
    void (*tie)(thud_world *w);
    /* Detection stopped a body at a share `time` (0 .. 1) of its motion: stops the other bodies of
     * its group at the same time. */
    void (*hold_back)(thud_world *w, td_awake_slot slot, double time);

    /* joint_brace.c, between passes of the solver, in steps with a torn joint (flag_torn,
     * joints/wide_joint.h): scales down the impulses of locks and rods to the share that adds no
     * energy. All workers call it. Returns whether it may have changed impulses. */
    bool (*brace)(td_bracing *bracing);

    /* ---- joint_caps.c, before the solver ---- */
    /* Sets the force bounds of springs and motors that act both along and across, so that the
     * resultant of both directions stays within the maximum force. */
    void (*share_caps)(thud_world *w);

    /* ---- joint_yield.c ---- */
    /* Before the solver: clears the impulses of joints that yielded in the last step. */
    void (*clear_yielded)(thud_world *w);
    /* After the solver: moves bodies back that joints have pressed into static shapes. */
    void (*yield)(thud_world *w);

    /* joint_break.c, after the epilogue: adds events of joints whose force or torque exceeds their
     * maximum, and destroys those that break. */
    void (*break_up)(thud_world *w);
    /* joint_measure.c: computes the gaps of all joints that have lanes, asleep or awake. Adds to
     * *gaps, which starts as zeros. */
    void (*measure)(const thud_world *w, td_joint_gaps *gaps);
    /* joint_draw.c; td_drawing: api/debug_draw.h. */
    void (*draw)(const struct td_drawing *drawing);
    /* direct/island_step_joints.c: a step of an island with joints; see island_step.h. */
    double (*solve)(struct td_island_work *work, double tolerance);
    /* joints/lock_tree_step.c, for islands of hinges and welds that form a tree. solve_tree solves
     * the step of one island, and keeps the result in td_islands.results. solve_trees does so for
     * all listed islands, and sets td_island.tree of each. write_tree writes a result to the world.
     */
    td_tree_outcome (*solve_tree)(thud_world *w, const struct td_island *island,
                                  const struct td_direct_body *known);
    void (*solve_trees)(thud_world *w);
    void (*write_tree)(thud_world *w, const struct td_island *island);
    /* direct/joint_islands.c: the direct solver that replaces thud_islands_direct in a world with
     * joints. */
    const thud_island_solver *islands;
} td_joint_hooks;

/* The direct solver of a world's islands. */
static inline const thud_island_solver *td_direct_solver_of(const thud_world *w) {
    return w->joint_hooks ? w->joint_hooks->islands : &thud_islands_direct;
}

/* The functions of that table; the comments there name their files. */
bool td_joints_engage(thud_world *w);
void td_joints_suspend(thud_world *w, td_body_index body);
void td_joints_move_locks(thud_world *w, td_body_index body);
void td_joints_tie(thud_world *w);
void td_joints_hold_back(thud_world *w, td_awake_slot slot, double time);
bool td_joints_brace(td_bracing *bracing);
void td_joints_share_caps(thud_world *w);
void td_joints_clear_yielded(thud_world *w);
void td_joints_yield(thud_world *w);
void td_joints_break_up(thud_world *w);
void td_joints_draw(const struct td_drawing *drawing);
void td_joints_measure(const thud_world *w, td_joint_gaps *gaps);
void td_joints_remove_part(thud_world *w, int joint, int part);
bool td_joints_exclude_contact(const thud_world *w, td_body_index a, td_body_index b);

/* The bit of a body in td_body.passes, a Bloom filter of the bodies that its joints exclude
 * contacts with: if contacts of two bodies are excluded, each has the bit of the other. Other pairs
 * may also have them, since many bodies share the 16 bits and bits are never cleared;
 * td_joints_exclude_contact gives the exact answer. */
static inline uint16_t td_passing_bit(td_body_index body) {
    return (uint16_t)(1u << (body.at & 15));
}

#endif
