/* rod_rows.c: a rod's one row for the direct solver, an equality. */
#include "constraint/rod.h"

#include "islands/row_ops.h"

static void note(const thud_world *w, td_block *block, int lane, float kept, float *impulses) {
    impulses[0] = (float)w->substeps * block->point[0].normal_impulse[lane];
    block->point[0].normal_impulse[lane] *= kept;
}

/* What it is too long goes within the step, as far as the world's push_speed allows. */
static bool take(const thud_world *w, td_block *block, int lane, const float *impulses,
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

static bool holds(const td_block *block, int lane, int row) {
    (void)block, (void)lane, (void)row;
    return true;
}

static double gap(const td_block *block, int lane, int row) {
    return (double)block->point[row].base[lane];
}

static void put(const thud_world *w, td_block *block, int lane, const td_direct_constraint *c,
                const double *gaps) {
    block->point[0].normal_impulse[lane] = (float)c->row[0].impulse / (float)w->substeps;
    block->point[0].separation[lane] = (float)gaps[0];
}

static float size_of(float x) {
    return x < 0.0f ? -x : x;
}

static void load(const thud_world *w, const td_block *block, td_lane_load *loads) {
    (void)w;
    for (int lane = 0; lane < block->used; lane++) {
        loads[lane] = (td_lane_load){size_of(block->point[0].normal_impulse[lane]),
                                     size_of(block->point[0].separation[lane])};
    }
}

const td_row_ops td_rod_row_ops = {note, take, holds, gap, put, load};
