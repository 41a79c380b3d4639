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
    double (*moved)[3];
    double time;   /* of a step, or of the part of it that is being solved */
    bool bounces;  /* something closes in so fast that it is going to bounce */
    double pushed; /* greatest speed at which something is pushed apart */
    int joints;    /* so many constraints are no contacts */
} td_island_work;

/* island_rows.c: notes velocities and impulses, before the soft solver changes them. */
void td_island_note(thud_world *w);
/* How many matrices it may take. */
int td_island_patience(const thud_world *w, const td_island *island);
/* The free velocity of a body from `before`, for one of so many parts of the step. */
void td_island_free(td_island_work *work, int body, int parts);
/* The problem as it was then. */
td_island_work td_island_take(thud_world *w, const td_island *island);

static inline int td_island_points(const thud_world *w, const td_constraint *constraint) {
    return td_form_points(w->kinds[constraint->kind]->form);
}

#endif
