/* joint_hooks.h: when constraints that are no contacts take effect, and when they let go. A world
 * has it from its first joint on, so that a program without joints does not link it. */
#ifndef TD_JOINT_HOOKS_H
#define TD_JOINT_HOOKS_H

#include "state/world.h"

struct td_island_work;
struct td_drawing;

/* As thud_step_error has them. */
typedef struct td_joint_gaps {
    double worst, mean, angle;
} td_joint_gaps;

typedef struct td_joint_hooks {
    /* Gives lanes to those that wait, where their bodies are in the world and enabled. False when
     * memory is short: the rest goes on waiting. */
    bool (*engage)(thud_world *w);
    /* The joints of a body give their lanes back, and wait until it is enabled. */
    void (*suspend)(thud_world *w, td_body_index body);
    /* A body was put elsewhere, or its centre of mass was: its locks hold it there. */
    void (*follow)(thud_world *w, td_body_index body);
    /* Whether a joint of both has their shapes pass through each other. */
    bool (*keeps_apart)(const thud_world *w, td_body_index a, td_body_index b);
    /* A part is no more; the joint is gone with its last one. */
    void (*leave)(thud_world *w, int joint, int part);
    /* Makes the rings of this step, if nobody has; tied_bodies.h. */
    void (*tie)(thud_world *w);
    /* A body was held at a part of its motion: those that joints tie to it go back as far. */
    void (*hold_back)(thud_world *w, td_awake_slot slot, double time);
    /* joint_brace.c: between passes of the solver that brace joints: whether the warm start, or
     * what was given by the end of the relax pass, may have added energy; the share of it that each
     * ring keeps; and whether a ring gapes, which is known once the warm start was judged. */
    bool (*adds_energy)(thud_world *w, bool relaxed);
    void (*weigh)(thud_world *w, bool relaxed);
    bool (*gape)(const thud_world *w);
    /* joint_caps.c, before solving: bounds of springs and motors whose cap is of both directions.
     */
    void (*share_caps)(thud_world *w);
    /* joint_yield.c: before the solver, impulses are forgotten of what was put back in the step
     * before; after it, what joints have pressed into static shapes is put back. */
    void (*forget)(thud_world *w);
    void (*yield)(thud_world *w);
    /* After the epilogue: events of the joints that bear too much, which are destroyed. */
    void (*break_up)(thud_world *w);
    /* Adds up how far joints are open that are in force, asleep or awake. */
    void (*measure)(const thud_world *w, td_joint_gaps *gaps);
    /* joint_draw.c; of a td_drawing: api/debug_draw.h */
    void (*draw)(const struct td_drawing *drawing);
    /* island_step_joints.c: see island_step.h. */
    double (*solve)(struct td_island_work *work, double tolerance);
    const thud_island_solver
        *islands; /* joint_islands.c: where the quality has one, in its place */
} td_joint_hooks;

/* What solves a world's islands directly. */
static inline const thud_island_solver *td_direct_solver_of(const thud_world *w) {
    return w->joint_hooks ? w->joint_hooks->islands : &thud_islands_direct;
}

/* joint_engage.c */
bool td_joints_engage(thud_world *w);
void td_joints_suspend(thud_world *w, td_body_index body);
void td_joints_follow(thud_world *w, td_body_index body);
void td_joints_tie(thud_world *w);
void td_joints_hold_back(thud_world *w, td_awake_slot slot, double time);
bool td_joints_add_energy(thud_world *w, bool relaxed);
void td_joints_weigh(thud_world *w, bool relaxed);
bool td_joints_gape(const thud_world *w);
void td_joints_share_caps(thud_world *w);
void td_joints_forget(thud_world *w);
void td_joints_yield(thud_world *w);
void td_joints_break_up(thud_world *w);
void td_joints_draw(const struct td_drawing *drawing);
void td_joints_measure(const thud_world *w, td_joint_gaps *gaps);
void td_joints_leave(thud_world *w, int joint, int part);
bool td_joints_keep_apart(const thud_world *w, td_body_index a, td_body_index b);

/* The bit of a body in td_body.passes. Sixteen bits are few, and none is ever cleared: both bodies
 * have the bit of the other if they pass through each other, and seldom else. */
static inline uint16_t td_passing_bit(td_body_index body) {
    return (uint16_t)(1u << (body.at & 15));
}

#endif
