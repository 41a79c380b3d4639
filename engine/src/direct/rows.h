/* rows.h: reads the one to three rows of direct.h (points and tangent) from a constraint's lane,
 * its place in a block of eight constraints (constraint/block.h). */
#ifndef TD_ROWS_H
#define TD_ROWS_H

#include "constraint/lanes.h"
#include "direct/direct.h"

/* contact_rows.c. A td_take_rows_fn fills kinds, Jacobians, warm-start impulses and target speeds
 * of the rows, for the mean velocity of the step. `impulses` are those of the last step, each
 * summed over all substeps. The caller sets the bodies of *c before, and the rows' known_speed
 * afterwards. True if the soft solver lets the contact bounce in this step. */
td_take_rows_fn td_contact_take_rows;

/* The td_take_rows_fn of a kind of constraint. */
static inline td_take_rows_fn *td_take_rows_of(const thud_world *w, int kind) {
    const td_lane_ops *lanes = w->kinds[kind]->lanes;
    return lanes ? lanes->take_rows : td_contact_take_rows;
}

/* Sets a row along (x, y) between the sides of a lane; cross_a and cross_b are the lever arms
 * crossed with (x, y). */
static inline void td_row_set(td_direct_row *row, td_row_kind kind, double x, double y,
                              double cross_a, double cross_b) {
    *row =
        (td_direct_row){.kind = kind, .a = {-x, -y, -cross_a}, .b = {x, y, cross_b}, .used = true};
}

#endif
