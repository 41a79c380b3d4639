/* error.c: sums of the error statistics; see error.h. */
#include "solver/error.h"

#include "state/kinds.h"
#include "constraint/lanes.h"
#include "state/handles.h"

static void resum_kinetic(thud_world *w) {
    double kinetic = TD_PICK_WIDE(w, td_kinetic_energy)(w);
    w->errors.energy_change += kinetic - w->kinetic;
    w->kinetic = kinetic;
}

/* The kinetic energy at the end of the last step is stale where a body has woken, fallen asleep or
 * been edited since. */
static void begin(thud_world *w) {
    if (w->kinetic_stale) {
        resum_kinetic(w);
    }
    w->errors =
        (td_errors){.energy_change = -w->kinetic, .energy_decided = w->errors.energy_decided};
}

static void add_tally(thud_world *w, const td_tally *tally) {
    td_errors *e = &w->errors;
    for (int i = 0; i < TD_LANES; i++) {
        e->points += tally->points[i];
        e->overlaps += tally->overlaps[i];
        e->deepest = td_max_float(e->deepest, -tally->min_distance[i]);
        e->residual = td_max_float(e->residual, -tally->min_speed[i]);
    }
    e->depth += tally->depth[0] + tally->depth[1] + tally->depth[2] + tally->depth[3];
}

/* Normal speed of a point; negative where it closes. */
static float speed_of(const thud_world *w, const td_block *block, const td_point *p, int lane) {
    const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
    const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
    return (b[0] - a[0]) * block->nx[lane] + (b[1] - a[1]) * block->ny[lane] +
           b[2] * p->cross_b[lane] - a[2] * p->cross_a[lane];
}

/* Adds the points of one block to the statistics. */
static void count_block(thud_world *w, const td_block *block, int points) {
    td_errors *e = &w->errors;
    float inv_h = (float)(w->substeps / w->def.time_step);
    for (int lane = 0; lane < block->used; lane++) {
        for (int k = 0; k < points; k++) {
            const td_point *p = &block->point[k];
            if (p->normal_mass[lane] == 0.0f) {
                continue;
            }
            float separation = p->separation[lane];
            float depth = td_max_float(-(separation + w->skin), 0.0f);
            /* As in the relax pass (wide_solve.h): an open gap may close within a substep. */
            float speed = speed_of(w, block, p, lane) + td_max_float(separation, 0.0f) * inv_h;
            e->points++;
            e->overlaps += depth > td_overlap_depth_min(w);
            e->depth += (double)depth * w->to_fixed;
            e->deepest = td_max_float(e->deepest, depth);
            /* The order of operands leaves out not-a-number, as of a body that will be quarantined.
             */
            e->residual = td_max_float(-speed, e->residual);
        }
    }
}

/* td_errors_recount, of contacts and of joints. What detection has found of this step, such as the
 * shortfall, is not known yet and begins at 0. */
static void recount(thud_world *w) {
    w->errors = (td_errors){.energy_change = w->errors.energy_change,
                            .energy_decided = w->errors.energy_decided};
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        int points = td_form_points(w->kinds[run->kind]->form);
        for (int k = 0; k < run->count; k++) {
            td_block *block = *TD_AT(td_block *, &w->scratch.blocks, run->first + k);
            if (run->kind < TD_PAIR_COUNT) {
                count_block(w, block, points);
            } else {
                w->kinds[run->kind]->lanes->count(w, block);
            }
        }
    }
}

const td_error_hooks td_error_report = {.begin = begin,
                                        .tally = TD_BOTH_WIDE(td_tally_points),
                                        .add = add_tally,
                                        .resum_kinetic = resum_kinetic,
                                        .recount = recount};

thud_result thud_world_use_step_error(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "use step error: not inside a callback");
    }
    w->error_hooks = &td_error_report;
    return THUD_OK;
}
