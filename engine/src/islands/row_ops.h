/* row_ops.h: what the direct solver asks of a constraint. Contacts answer in contact_rows.c; other
 * kinds by the table in their td_lane_ops. Bodies, the matrix' entry and the speeds that come from
 * outside the island are filled in for all kinds alike, from the sides of the lane. */
#ifndef TD_ROW_OPS_H
#define TD_ROW_OPS_H

#include "constraint/lanes.h"
#include "islands/direct.h"

/* What the soft solver's lane tells of a constraint that may give way. */
typedef struct td_lane_load {
    float impulse; /* of a substep, all rows that hold */
    float depth;   /* by which it is off already */
} td_lane_load;

typedef struct td_row_ops {
    /* Copies the impulses of the step before, of a whole step, row by row, and leaves `kept` of
     * them, 0 or 1, to the soft solver. */
    void (*note)(const thud_world *w, td_block *block, int lane, float kept, float *impulses);
    /* Directions, kinds, impulses and wanted speeds of the rows for the mean velocity of the step.
     * True where the soft solver has it bounce in this step. */
    bool (*take)(const thud_world *w, td_block *block, int lane, const float *impulses,
                 td_direct_constraint *c);
    /* Whether the row holds something as the soft solver leaves it, rather than being apart. */
    bool (*holds)(const td_block *block, int lane, int row);
    /* What is left of the row's gap at the start of the step: > 0 is apart. */
    double (*gap)(const td_block *block, int lane, int row);
    /* Puts impulses, of a whole step, and gaps at its end back into the lane. */
    void (*put)(const thud_world *w, td_block *block, int lane, const td_direct_constraint *c,
                const double *gaps);
    /* Of every lane in use. */
    void (*load)(const thud_world *w, const td_block *block, td_lane_load *loads);
} td_row_ops;

/* contact_rows.c */
extern const td_row_ops td_contact_row_ops;

static inline const td_row_ops *td_row_ops_of(const thud_world *w, int kind) {
    const td_lane_ops *lanes = w->pairs[kind]->lanes;
    return lanes ? lanes->rows : &td_contact_row_ops;
}

/* A row between the sides of a lane, along (x, y), with the crosses of the arms. */
static inline void td_row_set(td_direct_row *row, td_row_kind kind, double x, double y,
                              double cross_a, double cross_b) {
    *row =
        (td_direct_row){.kind = kind, .a = {-x, -y, -cross_a}, .b = {x, y, cross_b}, .used = true};
}

#endif
