/* error.h: the error statistics of a step (td_errors, which thud_world_get_step_error returns):
 * overlaps of contacts, the speeds by which constraints miss their targets (residual), the change
 * of energy, and the longest motion that detection cut off (shortfall).
 *
 * The solver counts contact points in its last relax pass, and td_finalize sums up energies.
 * Detection (continuous.c, impacts.c), which runs after both, corrects the energy change and sets
 * the shortfall; the contact points are then out of date, and counted anew when the caller reads
 * the statistics (step_error.c). */
#ifndef TD_ERROR_H
#define TD_ERROR_H

#include "solver/motion.h"
#include "state/world.h"

/* The statistics that are collected while a step is solved.
 *
 * A world has them by its def (thud_parts), or is given them by thud_world_use_step_error or a
 * snapshot, so that a program that does not read them does not link them. */
typedef struct td_error_hooks {
    /* Before the solver: resets all statistics except energy_decided, to which prologues have added
     * already. The energy change begins at minus the kinetic energy that bodies had before
     * prologues decided velocities. At the end of the step td_finalize adds the kinetic energy that
     * they have then, less the work of gravity. */
    void (*begin)(thud_world *w);
    td_tally_fn *tally[2];         /* td_tally_points, by thud_world.wide */
    td_tally_speeds_fn *speeds[2]; /* td_tally_speeds, likewise */
    /* Adds the statistics of the contact points and joints that one worker has solved. */
    void (*add)(thud_world *w, const td_tally *tally);
    void (*resum_kinetic)(thud_world *w); /* td_errors_resum_kinetic */
    void (*recount)(thud_world *w);       /* td_errors_recount */
} td_error_hooks;

/* error.c */
extern const td_error_hooks td_error_report;

/* The energy change is the gain of kinetic energy less the work of gravity along the whole motion
 * of the step. (x, y) is the part of a body's motion that detection has cut off, in world axes:
 * adds the work of gravity along it, which was not done. */
static inline void td_errors_undo_gravity_work(thud_world *w, td_awake_slot slot, float x,
                                               float y) {
    float work_per_mass = w->def.gravity.x * x + w->def.gravity.y * y;
    float undone_work = *TD_AT(float, &w->gravity_mass, slot.at) * work_per_mass;
    w->errors.energy_change +=
        (double)td_max_float(td_min_float(undone_work, TD_ENERGY_MAX), -TD_ENERGY_MAX);
}

/* After detection has changed velocities: sums up the kinetic energy anew, and adds its change to
 * the energy change. The corrections of td_errors_undo_gravity_work stay, whichever is called
 * first. */
static inline void td_errors_resum_kinetic(thud_world *w) {
    if (w->error_hooks) {
        w->error_hooks->resum_kinetic(w);
    }
}

/* Detection stopped a body (x, y) before the end of its motion: keeps the longest such distance,
 * squared. */
static inline void td_errors_note_shortfall(thud_world *w, float x, float y) {
    float missed_squared = x * x + y * y;
    if (missed_squared > w->errors.shortfall_squared) {
        w->errors.shortfall_squared = missed_squared;
    }
}

/* Whether detection changed motions after the solver counted contact points, so that their
 * statistics and the separations of lanes are out of date: gaps.c projected the motions so that
 * touching shapes do not overlap (errors.projected), a body was held back (held_bodies), or an
 * impact changed velocities within the step (impacts). */
static inline bool td_errors_points_stale(const thud_world *w) {
    return w->errors.projected || w->stats.held_bodies > 0 || w->stats.impacts > 0;
}

/* step_error.c: the separation of a point of a touching contact for the poses at the end of the
 * step. Unless td_errors_points_stale, the lane's separation is that already. */
float td_errors_separation(const thud_world *w, const td_constraint *contact, int point);
/* step_error.c: the statistics of the step; if td_errors_points_stale, with contact points counted
 * anew, which is a pass over all contacts. */
td_errors td_errors_of_step(const thud_world *w);

/* Counts all contact points and joints anew from the present separations of their lanes and the
 * present velocities: after the direct solver, or yielding joints (joint_yield.c), have replaced
 * results of the soft solver. It is a pass over all blocks. The residual is final then:
 * td_errors_of_step does not count it anew. */
static inline void td_errors_recount(thud_world *w) {
    if (w->error_hooks) {
        w->error_hooks->recount(w);
    }
}

/* The penetration depth above which a contact point counts as an overlap, length: max_error, or
 * TD_SLOP length scales where that is 0. */
static inline float td_overlap_depth_min(const thud_world *w) {
    return w->def.max_error > 0.0 ? (float)w->def.max_error : TD_SLOP * w->length_scale;
}

#endif
