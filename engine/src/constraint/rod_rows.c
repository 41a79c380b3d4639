/* rod_rows.c: a rod's one row for the direct solver, an equality. */
#include "constraint/rod.h"

#include "islands/rows.h"

/* What it is too long goes within the step, as far as the world's push_speed allows. */
bool td_rod_take_rows(const thud_world *w, td_block *block, int lane, const float *impulses,
                      td_direct_constraint *c) {
    const td_point *p = &block->point[0];
    double most = (double)(w->def.push_speed * w->unit);
    double speed = -(double)p->base[lane] / w->def.time_step;
    td_row_set(&c->row[0], TD_ROW_EQUAL, (double)block->nx[lane], (double)block->ny[lane],
               (double)p->cross_a[lane], (double)p->cross_b[lane]);
    c->row[0].impulse = 0.5 * (double)impulses[0];
    c->row[0].wanted = speed > most ? most : speed < -most ? -most : speed;
    return false;
}
