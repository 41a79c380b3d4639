/* island_solve.h: an island on its way through the direct solver. */
#ifndef TD_ISLAND_DIRECT_H
#define TD_ISLAND_DIRECT_H

#include "islands/rows.h"

/* The island at hand. */
typedef struct td_island_work {
    thud_world *w;
    const td_island *island;
    td_direct problem;
    const td_awake_slot *slots;
    const int *constraints;
    double time;      /* of a step, or of the part of it that is being solved */
    double elapsed;   /* of the step, by the end of the part */
    double next;      /* what comes after the part: another one, or a step */
    bool bounces;     /* something closes in so fast that it is going to bounce */
    double pushed;    /* greatest speed at which something is pushed apart */
    int joints;       /* so many constraints are no contacts */
    double turn_most; /* a body that turns by more in the step, rad, is a matter for substeps */
} td_island_work;

/* island_rows.c: notes velocities and impulses, before the soft solver changes them. */
void td_island_note(thud_world *w);
/* The impulses of a constraint as its lane has them, for a whole step, into td_islands.impulses;
 * `soft`: 1 where they are the soft solver's. */
void td_island_guess(thud_world *w, int i, float soft);
/* How many matrices it may take. */
int td_island_patience(const thud_world *w, const td_island *island);
/* The problem as it was then. */
td_island_work td_island_take(thud_world *w, const td_island *island);

/* island_solve.c: solves it directly; false where the soft solver's result is as good, and stands.
 */
bool td_island_solve(thud_world *w, const td_island *island);
/* The same of a problem that is there, with nothing written yet. */
bool td_island_work_out(td_island_work *work);
/* The speed by which rows may miss what they want. */
double td_island_tolerance(const thud_world *w);
/* Writes velocities and motions over. */
void td_island_write_bodies(const td_island_work *work);
/* What thud_islands_direct does before the soft solver. */
void td_islands_begin(thud_world *w);
/* By the motion of the part, at mean velocities. */
void td_island_move_on(td_island_work *work);
/* How far a row's gap is open once `elapsed` has passed; at its start it was `before`. */
double td_island_gap(const td_island_work *work, const td_direct_constraint *c, int k,
                     double before);
/* It is nothing but a circle about its centre of mass, whose arms stay as it turns. */
bool td_island_is_disc(const td_island_work *work, int body);
/* From mean velocities to those at the end: what went on evenly goes on so. */
void td_island_carry_on(td_island_work *work);

/* island_joints.c, which a world has from its first joint on: solves an island with joints as
 * td_direct_solve does one without. */
double td_island_solve_joints(td_island_work *work, double tolerance);

/* island_solve.c: where a constraint of it lives. */
td_lane td_island_lane(const td_island_work *work, int i);

/* It has no contacts. */
static inline bool td_island_is_joints(const td_island_work *work) {
    return work->joints == work->island->constraints;
}

static inline int td_island_points(const thud_world *w, const td_constraint *constraint) {
    return td_form_points(w->kinds[constraint->kind]->form);
}

#endif
