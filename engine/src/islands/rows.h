/* rows.h: what a constraint brings to the direct solver: one to three rows, of its lane's points
 * and of its tangent. */
#ifndef TD_ROWS_H
#define TD_ROWS_H

#include "constraint/lanes.h"
#include "islands/direct.h"

/* contact_rows.c. A td_take_rows_fn fills kinds, directions, impulses and wanted speeds of the rows
 * for the mean velocity of the step; `impulses` are those of the step before, of a whole step, as
 * the rows are. The sides of *c are set, and what they know is added afterwards. True where the
 * soft solver has the lane bounce in this step. */
td_take_rows_fn td_contact_take_rows;

static inline td_take_rows_fn *td_take_rows_of(const thud_world *w, int kind) {
    const td_lane_ops *lanes = w->kinds[kind]->lanes;
    return lanes ? lanes->take_rows : td_contact_take_rows;
}

/* A row between the sides of a lane, along (x, y), with the crosses of the arms. */
static inline void td_row_set(td_direct_row *row, td_row_kind kind, double x, double y,
                              double cross_a, double cross_b) {
    *row =
        (td_direct_row){.kind = kind, .a = {-x, -y, -cross_a}, .b = {x, y, cross_b}, .used = true};
}

#endif
