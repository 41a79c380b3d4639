/* rod.h: a rod holds two places of two bodies at a distance from each other, and lets everything
 * turn. It is the smallest constraint that is no contact, and shows what another kind needs: a
 * number (contact/pair_kinds.h), a record, its row for the soft solver (wide_rod.c) and for the
 * direct one (rod_rows.c). It stands behind the engine's own door: nothing in include/thud leads
 * here yet, and a program that makes no rod links none. */
#ifndef TD_ROD_H
#define TD_ROD_H

#include "constraint/constraint.h"

typedef struct td_rod_def {
    thud_body_id body_a, body_b;  /* two, of which one is dynamic */
    thud_vec2 anchor_a, anchor_b; /* from the bodies' origins, in their frames */
    float length;                 /* > 0 */
} td_rod_def;

/* Takes effect with the next step; sleeping bodies wake. *rod, which may be null, gets its index in
 * the world's constraints. Destroying a body takes its rods away; one that is disabled lets go
 * until it is enabled again. Not inside a callback. */
thud_result td_rod_create(thud_world *w, const td_rod_def *def, int *rod);
thud_result td_rod_destroy(thud_world *w, int rod);

/* How much longer than it should be the rod is now; negative: shorter. */
double td_rod_stretch(const thud_world *w, int rod);

/* rod_rows.c */
td_take_rows_fn td_rod_take_rows;

#endif
